// Flashlight, fog, sun, the spotlight.
#include "engine/physics/query.h"
#include "engine/scene/environment/live_light.h"
#include "engine/scene/simulation/sun_hour.h"
#include "game/rules/rules.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumbline::game {

namespace {

constexpr float kSunNotch_radps = radians_from_degrees(2.0F);
constexpr Real kSpotReach_m = 200;

}  // namespace

void PlaygroundGame::light(scene::Simulation& simulation, const Actions& actions) {
    const scene::SceneDescription& described = simulation.description();
    scene::LiveSwitches& switches = simulation.switches;
    if (actions.presses(Action::Flashlight) % 2 == 1) {
        if (described.flashlight) {
            switches.turn("flashlight", !switches.is_on("flashlight", described.flashlight->on));
        } else {
            say("this scene has no flashlight");
        }
    }
    change_fog(simulation, actions);
    aim_spot(simulation, actions);
    const bool wants_sun =
        actions.presses(Action::SunFaster) + actions.presses(Action::SunStop) > 0;
    if (wants_sun && !described.sun) say("this scene has no sun");
    switches.sun_rotation_radps +=
        kSunNotch_radps * static_cast<float>(actions.presses(Action::SunFaster));
    if (actions.presses(Action::SunStop) > 0) switches.sun_rotation_radps = 0.0F;
    if (const auto hour = hour_of(simulation); hour && wants_sun) {
        const auto minutes = static_cast<int>(*hour * 60);
        say(fmt::format("time {}:{:02}, {:.0f} min per second",
                        minutes / 60,
                        minutes % 60,
                        degrees_from_radians(switches.sun_rotation_radps) * 4.0F));
    }
    const int brighter =
        actions.presses(Action::LightBrighter) - actions.presses(Action::LightDimmer);
    if (brighter != 0) {
        switches.light_scale =
            std::clamp(switches.light_scale * whole_power(scene::kLiveNotch, brighter),
                       scene::kDimmestLight,
                       scene::kBrightestLight);
        say(fmt::format("light: {:.0f} %", 100.0F * switches.light_scale));
    }
}

void PlaygroundGame::change_fog(scene::Simulation& simulation, const Actions& actions) {
    const auto& described = simulation.description().fog;
    scene::LiveSwitches& switches = simulation.switches;
    const bool was_on = switches.is_on("fog", described && described->on);
    if (actions.presses(Action::Fog) % 2 == 1) switches.turn("fog", !was_on);
    const int denser = actions.presses(Action::FogDenser) - actions.presses(Action::FogThinner);
    const int colors = actions.presses(Action::FogColor);
    if (denser == 0 && colors == 0) return;
    // Who changes it wants to see it.
    switches.turn("fog", true);
    switches.fog_density_scale =
        std::clamp(switches.fog_density_scale * whole_power(scene::kLiveNotch, denser),
                   scene::kThinnestFog,
                   scene::kDensestFog);
    switches.fog_color =
        (switches.fog_color + static_cast<std::size_t>(colors)) % scene::kFogColors.size();
    const float density_per_m = described.value_or(scene::FogDescription{}).density_per_m;
    say(fmt::format("fog: {:.2g} per m, {}",
                    density_per_m * switches.fog_density_scale,
                    scene::kFogColors[switches.fog_color].name));
}

void PlaygroundGame::aim_spot(scene::Simulation& simulation, const Actions& actions) {
    const int presses = actions.presses(Action::AimSpot);
    if (presses == 0 && !actions.is_held(Action::AimSpot)) return;
    const Aim now = aim();
    ecs::Entity nearest{};
    Real least_m = 0;
    for (auto [entity, light, transform] :
         simulation.registry.view<const scene::PointLight, const scene::Transform>()) {
        const Real distance_m = glm::distance(transform.world_from_body.position, now.eye_m);
        if (!light.is_spot || (nearest && distance_m >= least_m)) continue;
        nearest = entity;
        least_m = distance_m;
    }
    if (!nearest) {
        if (presses > 0) say("this scene has no spotlight");
        return;
    }
    const Vec3 far_point = now.eye_m + now.forward * kSpotReach_m;
    const auto seen = cast_ray(simulation.physics, now.eye_m, far_point, {.ignored = now.own_body});
    const Pose& stand = simulation.registry.get<scene::Transform>(nearest).world_from_body;
    const Vec3 path = (seen ? seen->point_world : far_point) - stand.position;
    auto& light = simulation.registry.get<scene::PointLight>(nearest);
    const Vec3 direction =
        glm::conjugate(stand.orientation) * normalize_or(path, Vec3{0, Real{-1}, 0});
    light.direction_body = Vec3f(direction);
    if (presses > 0) say("spotlight aimed");
}

}  // namespace plumbline::game
