#include "engine/app/controls/action_words.h"

#include <array>

namespace plumbline::app {
namespace {

constexpr auto kWords = [] {
    std::array<std::string_view, kActionCount> words{};
    const auto say = [&](Action action, std::string_view text) { words[index_of(action)] = text; };
    say(Action::Forward, "Move forward");
    say(Action::Back, "Move back");
    say(Action::Left, "Move left");
    say(Action::Right, "Move right");
    say(Action::Look, "Look around");
    say(Action::Jump, "Jump; when flying: up");
    say(Action::Crouch, "Crouch; when flying: down");
    say(Action::Sprint, "Sprint");
    say(Action::MoveMode, "Switch between walk, fly and orbit");
    say(Action::Select1, "Select crate");
    say(Action::Select2, "Select ball");
    say(Action::Select3, "Select barrel");
    say(Action::Select4, "Select brick");
    say(Action::Select5, "Select plank");
    say(Action::Select6, "Select stone");
    say(Action::Select7, "Select domino");
    say(Action::Select8, "Select object 8");
    say(Action::Select9, "Select object 9");
    say(Action::NextThing, "Next object");
    say(Action::PreviousThing, "Previous object");
    say(Action::Drop, "Drop the selected object");
    say(Action::Throw, "Throw (hold to throw harder)");
    say(Action::Grab, "Grab or release");
    say(Action::Use, "Open, close, switch or sit on the object");
    say(Action::RotateHeld, "Rotate the held object (hold)");
    say(Action::Push, "Push the held object away; otherwise: move faster");
    say(Action::Pull, "Pull the held object closer; otherwise: move slower");
    say(Action::Freeze, "Freeze or unfreeze the object");
    say(Action::Remove, "Delete the object");
    say(Action::UndoDrop, "Undo the last drop");
    say(Action::Shoot, "Shoot a 1 kg box at 25 m/s");
    say(Action::Lift, "Lift the object with 20 N (hold)");
    say(Action::Explode, "Explosion at the crosshair");
    say(Action::Flashlight, "Flashlight on/off");
    say(Action::Fog, "Fog on/off");
    say(Action::FogDenser, "Increase fog density");
    say(Action::FogThinner, "Decrease fog density");
    say(Action::FogColor, "Next fog colour");
    say(Action::Filled, "Solid view");
    say(Action::Wireframe, "Wireframe view");
    say(Action::Points, "Point view");
    say(Action::CollisionShapes, "Show collision shapes");
    say(Action::CollisionBoxes, "Show bounding boxes");
    say(Action::DepthTest, "Next depth test mode");
    say(Action::Hud, "Show or hide the HUD");
    say(Action::Help, "Help");
    say(Action::Stats, "Frame statistics");
    say(Action::AccuracyPanel, "Accuracy panel");
    say(Action::Screenshot, "Screenshot");
    say(Action::Record, "Save an input recording");
    say(Action::Film, "Start or stop video");
    say(Action::Fullscreen, "Fullscreen on/off");
    say(Action::ZoomIn, "Zoom in");
    say(Action::ZoomOut, "Zoom out");
    say(Action::RotateLeft, "Turn left");
    say(Action::RotateRight, "Turn right");
    say(Action::Grid, "Model viewer: grid");
    say(Action::Axes, "Model viewer: axes");
    say(Action::Normals, "Model viewer: normals");
    say(Action::Turntable, "Model viewer: turntable");
    say(Action::Ground, "Model viewer: ground on/off");
    say(Action::Background, "Model viewer: next background");
    say(Action::AnimationPause, "Pause or resume model animation");
    say(Action::NextAnimation, "Next model animation");
    say(Action::TurnModel, "Model viewer: rotate the model (hold)");
    say(Action::ShiftModel, "Model viewer: pan the model (hold)");
    say(Action::Shading, "Blinn-Phong shading on/off");
    say(Action::Textures, "Textures on/off");
    say(Action::SunShadow, "Sun shadows on/off");
    say(Action::SunFaster, "Speed up the sun");
    say(Action::SunStop, "Stop the sun");
    say(Action::LightBrighter, "Brighter light");
    say(Action::LightDimmer, "Dimmer light");
    say(Action::AimSpot, "Aim the spotlight (hold)");
    say(Action::CameraRecord, "Start or stop recording the camera path");
    say(Action::CameraPlay, "Play or stop the camera path");
    say(Action::CameraReload, "Reload the camera path");
    say(Action::Pause, "Pause or resume");
    say(Action::Step, "Advance one step");
    say(Action::Slower, "Slow down time");
    say(Action::Faster, "Speed up time");
    say(Action::Reset, "Reset scene");
    say(Action::QuickSave, "Quick save");
    say(Action::QuickLoad, "Quick load");
    say(Action::Reload, "Reload the scene file");
    say(Action::Menu, "Menu");
    say(Action::Accept, "Confirm");
    say(Action::BackOut, "Back");
    return words;
}();

}  // namespace

std::string_view action_words(Action action) {
    return kWords[index_of(action)];
}

std::string_view group_words(ActionGroup group) {
    switch (group) {
        case ActionGroup::Walk:
            return "Movement";
        case ActionGroup::Things:
            return "Objects";
        case ActionGroup::View:
            return "View";
        case ActionGroup::Light:
            return "Light";
        case ActionGroup::CameraPath:
            return "Camera path";
        case ActionGroup::Time:
            return "Simulation";
        case ActionGroup::Menu:
            return "Menu";
    }
    return {};
}

bool is_offered(Action action) {
    switch (action) {
        case Action::Select8:
        case Action::Select9:
            return false;
        default:
            return true;
    }
}

bool is_for_models(Action action) {
    switch (action) {
        case Action::Look:
        case Action::Jump:
        case Action::Crouch:
        case Action::Sprint:
            return false;
        default:
            return group_of(action) != ActionGroup::Things;
    }
}

bool is_for_play(Action action) {
    switch (action) {
        case Action::Grid:
        case Action::Axes:
        case Action::Normals:
        case Action::Turntable:
        case Action::Ground:
        case Action::Background:
        case Action::TurnModel:
        case Action::ShiftModel:
            return false;
        default:
            return true;
    }
}

}  // namespace plumbline::app
