// Flashlight, fog, sun.
#include "game/rules.h"

#include <algorithm>

namespace plumbline::game {

namespace {

constexpr float kSunNotch_radps = radians_from_degrees(2.0F);
constexpr float kLightNotch = 1.25F;
constexpr float kDimmest = 0.02F;
constexpr float kBrightest = 20.0F;

}  // namespace

void PlaygroundGame::light(scene::Simulation& simulation, const Actions& actions) {
    const scene::SceneDescription& scene = simulation.description();
    scene::LiveSwitches& switches = simulation.switches;
    if (actions.presses(Action::Flashlight) % 2 == 1) {
        if (scene.flashlight) {
            switches.turn("flashlight", !switches.is_on("flashlight", scene.flashlight->on));
        } else {
            say("no flashlight in this scene");
        }
    }
    if (actions.presses(Action::Fog) % 2 == 1)
        switches.turn("fog", !switches.is_on("fog", scene.fog.has_value()));
    const bool wants_sun =
        actions.presses(Action::SunFaster) + actions.presses(Action::SunStop) > 0;
    if (wants_sun && !scene.sun) say("no sun in this scene");
    switches.sun_rotation_radps +=
        kSunNotch_radps * static_cast<float>(actions.presses(Action::SunFaster));
    if (actions.presses(Action::SunStop) > 0) switches.sun_rotation_radps = 0.0F;
    const int brighter =
        actions.presses(Action::LightBrighter) - actions.presses(Action::LightDimmer);
    if (brighter != 0) {
        switches.light_scale =
            std::clamp(switches.light_scale * std::pow(kLightNotch, static_cast<float>(brighter)),
                       kDimmest,
                       kBrightest);
    }
}

}  // namespace plumbline::game
