#include "engine/app/controls/action_words.h"

#include <array>

namespace plumbline::app {
namespace {

constexpr auto kWords = [] {
    std::array<std::string_view, kActionCount> words{};
    const auto say = [&](Action action, std::string_view text) { words[index_of(action)] = text; };
    say(Action::Forward, "forward");
    say(Action::Back, "back");
    say(Action::Left, "left");
    say(Action::Right, "right");
    say(Action::Look, "look around");
    say(Action::Jump, "jump; flying: up");
    say(Action::Crouch, "crouch; flying: down");
    say(Action::Sprint, "run");
    say(Action::MoveMode, "switch between walking, flying and orbiting");
    say(Action::Select1, "choose crates");
    say(Action::Select2, "choose balls");
    say(Action::Select3, "choose barrels");
    say(Action::Select4, "choose bricks");
    say(Action::Select5, "choose planks");
    say(Action::Select6, "choose stones");
    say(Action::Select7, "choose dominoes");
    say(Action::Select8, "choose the 8th thing");
    say(Action::Select9, "choose the 9th thing");
    say(Action::NextThing, "choose the next thing");
    say(Action::PreviousThing, "choose the thing before");
    say(Action::Drop, "drop the chosen thing");
    say(Action::Throw, "throw; held: harder");
    say(Action::Grab, "take hold of what you look at");
    say(Action::RotateHeld, "turn what you hold instead of the view");
    say(Action::Push, "push what you hold away; else: move faster");
    say(Action::Pull, "pull what you hold near; else: move slower");
    say(Action::Freeze, "freeze what you look at, or free it");
    say(Action::Remove, "remove what you look at");
    say(Action::UndoDrop, "take the last drop back");
    say(Action::Shoot, "shoot a box of 1 kg at 25 m/s");
    say(Action::Lift, "held: lift what you point at with 20 N");
    say(Action::Explode, "an explosion where you point");
    say(Action::Flashlight, "flashlight on and off");
    say(Action::Fog, "fog on and off");
    say(Action::FogDenser, "denser fog");
    say(Action::FogThinner, "thinner fog");
    say(Action::FogColor, "the fog's next colour");
    say(Action::Filled, "filled surfaces");
    say(Action::Wireframe, "wires");
    say(Action::Points, "points");
    say(Action::CollisionShapes, "show what collides");
    say(Action::CollisionBoxes, "show the boxes round what collides");
    say(Action::DepthTest, "the next depth test: less, always, never, greater, off");
    say(Action::Hud, "hide or show all that is written");
    say(Action::Help, "this help");
    say(Action::Stats, "what a frame costs");
    say(Action::AccuracyPanel, "accuracy: settings, gauges, ghost");
    say(Action::Screenshot, "take an image");
    say(Action::Record, "save what was done so far");
    say(Action::Film, "take a film, or end it");
    say(Action::Fullscreen, "full screen");
    say(Action::ZoomIn, "zoom in; orbiting: nearer");
    say(Action::ZoomOut, "zoom out; orbiting: farther");
    say(Action::RotateLeft, "turn left; orbiting: about what you see");
    say(Action::RotateRight, "turn right; orbiting: about what you see");
    say(Action::Grid, "a model by itself: grid");
    say(Action::Axes, "a model by itself: axes");
    say(Action::Normals, "a model by itself: normals");
    say(Action::Turntable, "a model by itself: turn it slowly");
    say(Action::Ground, "a model by itself: ground or none");
    say(Action::Background, "a model by itself: next background");
    say(Action::AnimationPause, "stop the animations of models, or go on");
    say(Action::NextAnimation, "the model's next animation");
    say(Action::TurnModel, "a model by itself: held, the mouse turns it");
    say(Action::ShiftModel, "a model by itself: held, the mouse shifts it");
    say(Action::Shading, "lit by Blinn and Phong, or as the scene says");
    say(Action::Textures, "textures or none");
    say(Action::SunShadow, "the sun's shadows or none");
    say(Action::SunFaster, "move the sun, faster each time");
    say(Action::SunStop, "stop the sun");
    say(Action::LightBrighter, "brighter light");
    say(Action::LightDimmer, "dimmer light");
    say(Action::AimSpot, "held: aim the spotlight where you look");
    say(Action::CameraRecord, "record the camera's path, or end it");
    say(Action::CameraPlay, "play the camera's path, or end it");
    say(Action::CameraReload, "read the camera's path again");
    say(Action::Pause, "pause and go on");
    say(Action::Step, "one step");
    say(Action::Slower, "slower");
    say(Action::Faster, "faster");
    say(Action::Reset, "the scene from its start");
    say(Action::QuickSave, "save the game");
    say(Action::QuickLoad, "go back to the saved game");
    say(Action::Reload, "read the scene's file again");
    say(Action::Menu, "menu");
    say(Action::Accept, "choose");
    say(Action::BackOut, "back");
    return words;
}();

}  // namespace

std::string_view action_words(Action action) {
    return kWords[index_of(action)];
}

std::string_view group_words(ActionGroup group) {
    switch (group) {
        case ActionGroup::Walk:
            return "Moving";
        case ActionGroup::Things:
            return "Things";
        case ActionGroup::View:
            return "View";
        case ActionGroup::Light:
            return "Light";
        case ActionGroup::CameraPath:
            return "Camera path";
        case ActionGroup::Time:
            return "Time";
        case ActionGroup::Menu:
            return "Menu";
    }
    return {};
}

bool in_this_version(Action action) {
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
