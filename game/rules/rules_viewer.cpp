// What is only looked at. A model by itself: turned, shifted, lit and measured. A JSON scene: flown
// through.
#include "game/rules/rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace plumbline::game {
namespace {

constexpr Real kTurntable_radps = 0.5_r;
constexpr Real kFarthestOrbit_radii = 50;

/// Switched by a key at a model by itself.
struct Aid {
    Action action;
    bool scene::LiveSwitches::*on;
    std::string_view name;
};
constexpr std::array kAids{Aid{Action::Grid, &scene::LiveSwitches::grid, "grid"},
                           Aid{Action::Axes, &scene::LiveSwitches::axes, "axes"},
                           Aid{Action::Normals, &scene::LiveSwitches::normals, "normals"},
                           Aid{Action::Turntable, &scene::LiveSwitches::turntable, "turntable"},
                           Aid{Action::Ground, &scene::LiveSwitches::ground, "ground"}};

}  // namespace

void PlaygroundGame::begin_view(const scene::SceneDescription& scene) {
    if (scene.viewer) {
        viewed_.scene_radius_m = scene.viewer->radius_m;
        look_.start_from(scene::camera_pose(scene.camera).orientation);
        fly_.set_up(scene.viewer->up);
        fly_.suit(viewed_.scene_radius_m);
        orbit_.suit(viewed_.scene_radius_m);
    }
    viewed_.model_radius_m = scene.model_radius_m;
    if (viewed_.model_radius_m <= 0) return;
    mode_ = MoveMode::Orbit;
    orbit_.suit(viewed_.model_radius_m);
    orbit_.place(scene.camera.target_m,
                 glm::distance(scene.camera.position_m, scene.camera.target_m),
                 look_.pitch_rad());
    fly_.suit(viewed_.model_radius_m);
}

void PlaygroundGame::next_view(const scene::ViewerDescription& viewer) {
    const Quat orientation = look_.orientation();
    const Vec3 eye = eye_m(1, orientation);
    if (mode_ == MoveMode::Fly) {
        mode_ = MoveMode::Orbit;
        const Vec3 forward = orientation * Vec3{0, 0, -1};
        // What lies ahead, as far off as the middle of everything.
        const Real ahead = std::clamp(glm::dot(viewer.center_m - eye, forward),
                                      viewer.radius_m,
                                      viewer.radius_m * kFarthestOrbit_radii);
        orbit_.place(eye + forward * ahead, ahead, look_.pitch_rad());
        say("orbit mode");
    } else {
        mode_ = MoveMode::Fly;
        fly_.place(eye);
        say("fly mode (mouse wheel sets the speed)");
    }
}

void PlaygroundGame::turn_model(const Actions& actions) {
    const bool pans = actions.is_held(Action::ShiftModel) || actions.is_held(Action::RotateHeld);
    viewed_.is_dragged =
        !pans && (actions.is_held(Action::TurnModel) || actions.is_held(Action::Throw));
    const Real yaw = Real{actions.look_yaw_rad};
    const Real pitch = Real{actions.look_pitch_rad};
    if (pans) orbit_.pan(look_.orientation(), yaw, pitch);
    if (viewed_.is_dragged) look_.turn(yaw * Viewed::kDragGain, pitch * Viewed::kDragGain);
}

void PlaygroundGame::switch_aids(scene::Simulation& simulation, const Actions& actions) {
    scene::LiveSwitches& switches = simulation.switches;
    for (auto [entity, playing] : simulation.registry.view<scene::PlayingModel>()) {
        if (actions.presses(Action::AnimationPause) % 2 == 1) playing.paused = !playing.paused;
        const assets::MovingModel* model = simulation.library().moving(playing.model);
        if (model == nullptr || actions.presses(Action::NextAnimation) == 0) continue;
        const auto count = static_cast<std::uint32_t>(model->data.animations.size());
        playing.animation = (playing.animation + 1) % count;
        playing.time_s = 0;
        say(fmt::format("animation {} of {}: {}",
                        playing.animation + 1,
                        count,
                        model->data.animations[playing.animation].name));
    }
    show_lit(simulation, actions);
    for (const Aid& aid : kAids) {
        if (actions.presses(aid.action) == 0) continue;
        if (viewed_.model_radius_m <= 0) {
            say(fmt::format("{}: only available in the model viewer", aid.name));
            continue;
        }
        if (actions.presses(aid.action) % 2 == 1) switches.*aid.on = !(switches.*aid.on);
        say(fmt::format("{} {}", aid.name, switches.*aid.on ? "on" : "off"));
    }
    if (const int backgrounds = actions.presses(Action::Background); backgrounds > 0) {
        if (viewed_.model_radius_m > 0) switches.background += backgrounds;
        say(viewed_.model_radius_m > 0 ? "next background"
                                       : "background: only available in the model viewer");
    }
    if (viewed_.model_radius_m <= 0) return;
    if (switches.turntable && views_model()) look_.turn_smoothly(kTurntable_radps * step_s_, 0);
}

void PlaygroundGame::show_lit(scene::Simulation& simulation, const Actions& actions) {
    scene::LiveSwitches& switches = simulation.switches;
    if (actions.presses(Action::Shading) % 2 == 1) {
        const bool was_lit = switches.shading == assets::Shading::BlinnPhong;
        switches.shading = was_lit ? std::nullopt : std::optional(assets::Shading::BlinnPhong);
        say(was_lit ? "scene shading" : "Blinn-Phong shading");
    }
    if (actions.presses(Action::Textures) % 2 == 1) {
        switches.textures = !switches.textures;
        say(switches.textures ? "textures on" : "textures off");
    }
    if (actions.presses(Action::SunShadow) % 2 == 1) {
        const scene::SceneDescription& scene = simulation.description();
        if (!scene.sun || !scene.sun->shadow) return say("this scene has no shadow-casting sun");
        const bool on = !switches.is_on("sun_shadow", !scene.viewer);
        switches.turn("sun_shadow", on);
        say(on ? "sun shadows on" : "sun shadows off");
    }
}

}  // namespace plumbline::game
