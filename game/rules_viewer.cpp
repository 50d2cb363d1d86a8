// A model by itself: turned, shifted, lit and measured.
#include "game/rules.h"

#include <fmt/format.h>

namespace plumbline::game {
namespace {

constexpr Real kTurntable_radps = 0.5_r;

}  // namespace

void PlaygroundGame::begin_view(const scene::SceneDescription& scene) {
    model_radius_m_ = scene.model_radius_m;
    if (model_radius_m_ <= 0) return;
    mode_ = MoveMode::Orbit;
    orbit_.suit(model_radius_m_);
    orbit_.place(scene.camera.target_m,
                 glm::distance(scene.camera.position_m, scene.camera.target_m),
                 look_.pitch_rad());
    fly_.suit(model_radius_m_);
}

void PlaygroundGame::turn_model(const Actions& actions) {
    const bool pans = actions.is_held(Action::ShiftModel) || actions.is_held(Action::RotateHeld);
    drags_view_ = !pans && (actions.is_held(Action::TurnModel) || actions.is_held(Action::Throw));
    const Real yaw = Real{actions.look_yaw_rad};
    const Real pitch = Real{actions.look_pitch_rad};
    if (pans) orbit_.pan(look_.orientation(), yaw, pitch);
    if (drags_view_) look_.turn(yaw * kDragGain, pitch * kDragGain);
}

void PlaygroundGame::switch_aids(scene::Simulation& simulation, const Actions& actions) {
    scene::LiveSwitches& switches = simulation.switches;
    const auto toggle = [&](Action action, bool& on) {
        if (actions.presses(action) % 2 == 1) on = !on;
    };
    for (auto [entity, playing] : simulation.registry.view<scene::PlayingModel>()) {
        toggle(Action::AnimationPause, playing.paused);
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
    if (model_radius_m_ <= 0) return;
    toggle(Action::Grid, switches.grid);
    toggle(Action::Axes, switches.axes);
    toggle(Action::Normals, switches.normals);
    toggle(Action::Turntable, switches.turntable);
    toggle(Action::Ground, switches.ground);
    switches.background += actions.presses(Action::Background);
    if (switches.turntable && views_model()) look_.turn_smoothly(kTurntable_radps * step_s_, 0);
}

}  // namespace plumbline::game
