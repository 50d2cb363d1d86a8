#include "engine/core/assert.h"
#include "engine/input/bindings.h"

#include <array>

namespace plumbline::input {
namespace {

struct DefaultRow {
    Action action;
    std::string_view words;  ///< with a space between two
};

// config/bindings.toml says the same in a form that people edit; a test holds the two together.
constexpr auto kDefaults = std::to_array<DefaultRow>({
    {Action::Forward, "w up pad.left_y-"},
    {Action::Back, "s down pad.left_y+"},
    {Action::Left, "a left pad.left_x-"},
    {Action::Right, "d right pad.left_x+"},
    {Action::Look, "mouse.move pad.right_stick"},
    {Action::Jump, "space pad.a"},
    {Action::Crouch, "left_control pad.b"},
    {Action::Sprint, "left_shift pad.left_thumb"},
    {Action::MoveMode, "m"},
    {Action::Select1, "1"},
    {Action::Select2, "2"},
    {Action::Select3, "3"},
    {Action::Select4, "4"},
    {Action::Select5, "5"},
    {Action::Select6, "6"},
    {Action::Select7, "7"},
    {Action::Select8, "8"},
    {Action::Select9, "9"},
    {Action::NextThing, ". alt+wheel.up pad.dpad_right"},
    {Action::PreviousThing, ", alt+wheel.down pad.dpad_left"},
    {Action::Drop, "q pad.right_bumper"},
    {Action::Throw, "mouse.left pad.right_trigger"},
    {Action::Grab, "e mouse.right pad.x"},
    {Action::Use, "c pad.left_trigger"},
    {Action::RotateHeld, "t mouse.middle pad.left_bumper"},
    {Action::Push, "wheel.up page_up pad.dpad_up"},
    {Action::Pull, "wheel.down page_down pad.dpad_down"},
    {Action::Freeze, "x pad.right_thumb"},
    {Action::Remove, "delete"},
    {Action::UndoDrop, "z"},
    {Action::Shoot, "alt+s"},
    {Action::Lift, "alt+j"},
    {Action::Explode, "alt+e"},
    {Action::Flashlight, "f pad.y"},
    {Action::Fog, "g"},
    {Action::FogDenser, "kp_multiply alt+]"},
    {Action::FogThinner, "kp_divide alt+["},
    {Action::FogColor, "kp_decimal alt+\\"},
    {Action::Filled, "n"},
    {Action::Wireframe, "v"},
    {Action::Points, "f4"},
    {Action::CollisionShapes, "b"},
    {Action::CollisionBoxes, "alt+b"},
    {Action::DepthTest, "alt+d"},
    {Action::Hud, "f1"},
    {Action::Help, "h"},
    {Action::Stats, "f3"},
    {Action::AccuracyPanel, "tab"},
    {Action::Screenshot, "f12"},
    {Action::Record, "alt+f12"},
    {Action::Film, "shift+f12"},
    {Action::Fullscreen, "f11 alt+enter"},
    {Action::ZoomIn, "="},
    {Action::ZoomOut, "-"},
    {Action::RotateLeft, "home"},
    {Action::RotateRight, "end"},
    {Action::Grid, "alt+g"},
    {Action::Axes, "alt+x"},
    {Action::Normals, "alt+n"},
    {Action::Turntable, "alt+t"},
    {Action::Ground, "f10"},
    {Action::Background, "f2"},
    {Action::AnimationPause, ";"},
    {Action::NextAnimation, "'"},
    {Action::TurnModel, ""},
    {Action::ShiftModel, ""},
    {Action::Shading, "alt+l"},
    {Action::Textures, "alt+u"},
    {Action::SunShadow, "alt+k"},
    {Action::SunFaster, "j"},
    {Action::SunStop, "l"},
    {Action::LightBrighter, "kp_add"},
    {Action::LightDimmer, "kp_subtract"},
    {Action::AimSpot, "y"},
    {Action::CameraRecord, "kp_0 f6"},
    {Action::CameraPlay, "f7"},
    {Action::CameraReload, "f8"},
    {Action::Pause, "p pause pad.back"},
    {Action::Step, "o"},
    {Action::Slower, "["},
    {Action::Faster, "]"},
    {Action::Reset, "r"},
    {Action::QuickSave, "f5"},
    {Action::QuickLoad, "f9"},
    {Action::Reload, "ctrl+r"},
    {Action::Menu, "escape pad.start"},
    {Action::Accept, "enter kp_enter pad.a"},
    {Action::BackOut, "backspace pad.b"},
});

void set(Bindings& bindings, const DefaultRow& row) {
    std::vector<Input>& inputs = bindings.inputs[static_cast<std::size_t>(row.action)];
    std::string_view rest = row.words;
    while (!rest.empty()) {
        const auto end = rest.find(' ');
        Result<Input> input = parse_input(rest.substr(0, end));
        PL_ASSERT(input.ok(), "a known word in the built-in table");
        input->origin = "built-in";
        inputs.push_back(*input);
        rest = end == std::string_view::npos ? std::string_view{} : rest.substr(end + 1);
    }
}

}  // namespace

Bindings built_in_bindings() {
    Bindings bindings;
    bindings.origin.fill("built-in");
    for (const DefaultRow& row : kDefaults) set(bindings, row);
    bindings.hold_mode[index_of(Action::Grab)] = HoldMode::Toggle;
    return bindings;
}

}  // namespace plumbline::input
