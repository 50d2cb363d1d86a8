#include "game/rules/rules.h"

#include "engine/physics/query.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumbline::game {

namespace {

constexpr Real kPlayerFov_rad = radians_from_degrees(70.0_r);
constexpr Real kNarrowest_rad = radians_from_degrees(15.0_r);
constexpr Real kWidest_rad = radians_from_degrees(100.0_r);
constexpr Real kZoom_per_s = 1.6_r;
constexpr Real kZoomNotch = 0.1_r;
constexpr Real kKeyTurn_radps = 1.6_r;
constexpr Real kDefaultOrbit_m = 5;
constexpr Real kOrbitSight_m = 100;
constexpr Real kWalkedModel_m = 2;      // its radius
constexpr Real kModelGroundDepth = 60;  // of its radius; orbits go 50 of them away
constexpr Real kLostBelow_m = 100;      // under the start, where the scene says no other depth
constexpr Real kHandReach_m = 12;       // hand and eye aim at one point this far away
const Vec3 kHandFromEye{0.25_r, -0.25_r, -0.3_r};

/// Below and beside the eye, aimed at the far point that the eye aims at.
Pose hand_of(const Pose& world_from_camera) {
    const Vec3 hand = transform_point(world_from_camera, kHandFromEye);
    const Vec3 far_point = transform_point(world_from_camera, {0, 0, -kHandReach_m});
    const Vec3 up = world_from_camera.orientation * Vec3{0, 1, 0};
    return {.position = hand,
            .orientation = glm::quatLookAtRH(glm::normalize(far_point - hand), up)};
}

}  // namespace

PlaygroundGame::PlaygroundGame(scene::Simulation& simulation,
                               const std::filesystem::path& assets_folder)
    : step_s_(static_cast<Real>(simulation.step_s())),
      fov_{kPlayerFov_rad, kPlayerFov_rad, kPlayerFov_rad},
      things_(simulation, assets_folder) {
    const scene::SceneDescription& scene = simulation.description();
    begin_goal(simulation);
    if (scene.player) {
        look_.set(scene.player->yaw_rad, scene.player->pitch_rad);
        start_feet_m_ = scene.player->feet_position_m;
        player_.emplace(simulation, start_feet_m_);
        // On paving is where the scene meant it.
        const Vec3 feet_m = player_->state().feet_position_m;
        if (glm::length(feet_m - start_feet_m_) > player_->def().step_up_m)
            say("spawn point blocked: moved to the nearest free spot");
        start_feet_m_ = feet_m;
        return;
    }
    mode_ = MoveMode::Fly;
    const Quat world_from_upright = scene::upright(scene.camera.up);
    const Vec3 forward = scene.camera.target_m - scene.camera.position_m;
    look_.start_from(world_from_upright);
    look_.aim_along(glm::conjugate(world_from_upright) * forward);
    fly_.set_up(scene.camera.up);
    fly_.place(scene.camera.position_m);
    if (scene.camera.orbit) {
        mode_ = MoveMode::Orbit;
        orbit_.place(scene.camera.target_m, glm::length(forward), look_.pitch_rad());
        orbit_.go_by_steps(scene.camera.orbit->step_rad, scene.camera.orbit->step_m);
    }
    begin_view(scene);
    start_feet_m_ = scene.camera.position_m;
    fov_.base_rad = scene.camera.fov_y_rad;
    fov_.now_rad = fov_.base_rad;
    fov_.previous_rad = fov_.base_rad;
}

void PlaygroundGame::say(std::string message) {
    // One message a step is enough of the same.
    if (messages_.empty() || messages_.back() != message) messages_.push_back(std::move(message));
}

Vec3 PlaygroundGame::eye_m(Real blend, const Quat& orientation) const {
    switch (mode_) {
        case MoveMode::Walk:
            return player_->eye_m(blend);
        case MoveMode::Fly:
            return fly_.position_m(blend);
        case MoveMode::Orbit:
            break;
    }
    return orbit_.position_m(orientation, blend);
}

Vec3 PlaygroundGame::viewer_velocity_mps() const {
    if (mode_ == MoveMode::Walk) return player_->state().velocity_mps;
    return mode_ == MoveMode::Fly ? fly_.velocity_mps() : Vec3{0, 0, 0};
}

Aim PlaygroundGame::aim() const {
    const Quat orientation = look_.orientation();
    Aim aim{.eye_m = eye_m(1, orientation),
            .forward = orientation * Vec3{0, 0, -1},
            .yaw_rad = look_.yaw_rad(),
            .velocity_mps = viewer_velocity_mps(),
            .by_pointer = pointer_.has_value()};
    if (pointer_) {
        const Vec3 ahead{Real{(*pointer_)[0]}, Real{(*pointer_)[1]}, Real{-1}};
        aim.forward = orientation * glm::normalize(ahead);
    }
    if (player_) aim.own_body = player_->body();
    if (mode_ == MoveMode::Walk) {
        aim.support = player_->state().ground_body;
        aim.keep_away_m = player_->def().radius_m;
    }
    return aim;
}

void PlaygroundGame::forget_gone(scene::Simulation& simulation) {
    grab_.forget_gone(simulation);
    doors_.forget_gone(simulation);
    driver_.forget_gone(simulation);
    tying_.forget_gone(simulation);
    if (!simulation.physics.contains(keys_.lifted)) keys_.lifted = {};
}

void PlaygroundGame::act(scene::Simulation& simulation, const Actions& actions) {
    step_s_ = static_cast<Real>(simulation.step_s());  // play may have changed the rate
    forget_gone(simulation);
    pointer_ = actions.pointer;
    look_.begin_step();
    keys_.look_turns_held = grab_.holding() && actions.is_held(Action::RotateHeld);
    const Real yaw = Real{actions.look_yaw_rad};
    const Real pitch = Real{actions.look_pitch_rad};
    if (views_model()) {
        turn_model(actions);
    } else if (!keys_.look_turns_held) {
        look_.turn(yaw, pitch);
    } else if (std::isfinite(yaw) && std::isfinite(pitch)) {
        grab_.rotate(yaw, pitch);
    }
    for (int i = 0; i < actions.presses(Action::MoveMode) % 3; ++i) next_mode(simulation);
    move(simulation, actions);
    zoom(actions);
    switch_aids(simulation, actions);
    light(simulation, actions);
    if (views_model() || views_scene()) return;
    choose(actions);
    hold(simulation, actions);
    use(simulation, actions);
    charge_and_throw(simulation, actions);
    drop(simulation, actions);
    if (goal_) return;  // a game is won by hand
    shoot(simulation, actions);
    lift(simulation, actions);
    explode(simulation, actions);
    tie(simulation, actions);
}

void PlaygroundGame::move(scene::Simulation& simulation, const Actions& actions) {
    if (mode_ != MoveMode::Orbit) {
        const Real left =
            travel_of(actions, Action::RotateLeft) - travel_of(actions, Action::RotateRight);
        if (left != 0) look_.turn_smoothly(left * kKeyTurn_radps * step_s_, 0);
    }
    change_speed(actions);
    if (player_) player_->act(simulation, actions, look_, mode_ == MoveMode::Walk);
    GroundBelow ground{.world = simulation.physics,
                       .own_body = player_ ? player_->body() : physics::BodyId{},
                       .hidden = !simulation.switches.ground};
    if (viewed_.model_radius_m > 0) ground.deepest_m = viewed_.model_radius_m * kModelGroundDepth;
    if (mode_ == MoveMode::Fly) {
        fly_.act(actions, look_, ground, step_s_);
    } else if (mode_ == MoveMode::Orbit) {
        orbit_.act(actions, look_, ground, step_s_);
    }
}

void PlaygroundGame::change_speed(const Actions& actions) {
    const int notches = actions.presses(Action::Push) - actions.presses(Action::Pull);
    if (notches == 0 || grab_.holding() || mode_ == MoveMode::Orbit) return;
    if (mode_ == MoveMode::Walk) {
        say(fmt::format("walk speed {:.2g} m/s", player_->change_pace(notches)));
    } else {
        fly_.change_speed(notches);
        say(fmt::format("fly speed {:.2g} m/s", fly_.speed_mps()));
    }
}

void PlaygroundGame::next_mode(scene::Simulation& simulation) {
    if (const auto& viewer = simulation.description().viewer) return next_view(*viewer);
    const Quat orientation = look_.orientation();
    const Vec3 eye = eye_m(1, orientation);
    const Vec3 forward = orientation * Vec3{0, 0, -1};
    // Nobody walks on what is smaller than he is.
    const bool is_small = viewed_.model_radius_m > 0 && viewed_.model_radius_m < kWalkedModel_m;
    if (mode_ == MoveMode::Walk || (mode_ == MoveMode::Orbit && is_small)) {
        mode_ = MoveMode::Fly;
        fly_.place(eye);
        say("fly mode (mouse wheel sets the speed)");
    } else if (mode_ == MoveMode::Fly) {
        mode_ = MoveMode::Orbit;
        const Aim now = aim();
        const bool is_model = viewed_.model_radius_m > 0;
        const Real sight_m = is_model ? viewed_.model_radius_m * kModelGroundDepth : kOrbitSight_m;
        const auto seen =
            cast_ray(simulation.physics, eye, eye + forward * sight_m, {.ignored = now.own_body});
        const Real unseen_m = is_model ? viewed_.model_radius_m : kDefaultOrbit_m;
        const Real distance = seen ? seen->distance_m : unseen_m;
        orbit_.place(eye + forward * distance, distance, look_.pitch_rad());
        say("orbit mode");
    } else {
        mode_ = MoveMode::Walk;
        const physics::CharacterDef def;
        const Vec3 feet = eye - Vec3{0, def.height_m - def.eye_below_top_m, 0};
        if (player_) {
            player_->teleport(feet);
        } else {
            player_.emplace(simulation, feet);
        }
        say("walk mode");
    }
}

void PlaygroundGame::zoom(const Actions& actions) {
    fov_.previous_rad = fov_.now_rad;
    if (mode_ == MoveMode::Orbit) return;
    const Real wider = travel_of(actions, Action::ZoomOut) - travel_of(actions, Action::ZoomIn);
    const auto notches = static_cast<Real>(notches_of(actions, Action::ZoomOut, Action::ZoomIn));
    const Real change = wider * kZoom_per_s * step_s_ + notches * kZoomNotch;
    if (change == 0) return;
    fov_.now_rad = std::clamp(fov_.now_rad * portable_exp(change), kNarrowest_rad, kWidest_rad);
}

void PlaygroundGame::judge(scene::Simulation& simulation) {
    for (std::string& message : simulation.messages) say(std::move(message));
    simulation.messages.clear();
    if (goal_) {
        if (const auto ended = goal_->judge(simulation, grab_.entity())) say(*ended);
    }
    if (!player_ || mode_ != MoveMode::Walk) return;
    const scene::SceneDescription& scene = simulation.description();
    const Real depth = scene.kill_below_m.value_or(start_feet_m_.y - kLostBelow_m);
    if (player_->state().feet_position_m.y >= depth) return;
    player_->teleport(start_feet_m_);
    say("fell out of the world: returned to the spawn point");
}

scene::ViewPoint PlaygroundGame::view(const scene::Simulation&,
                                      Real blend,
                                      float pending_yaw_rad,
                                      float pending_pitch_rad) const {
    const bool still = keys_.look_turns_held || (views_model() && !viewed_.is_dragged);
    const Real gain =
        still ? Real{0} : (viewed_.is_dragged && views_model() ? Viewed::kDragGain : Real{1});
    const Real yaw = Real{pending_yaw_rad} * gain;
    const Real pitch = Real{pending_pitch_rad} * gain;
    const Quat orientation = look_.orientation(blend, yaw, pitch);
    const Pose camera{.position = eye_m(blend, orientation), .orientation = orientation};
    return {.world_from_camera = camera,
            .world_from_hand = hand_of(camera),
            // To the bit the same where it stays: shadow maps are drawn anew for another one.
            .fov_y_rad = std::lerp(fov_.previous_rad, fov_.now_rad, blend),
            .velocity_mps = viewer_velocity_mps(),
            .has_player = mode_ == MoveMode::Walk,
            .blend = blend};
}

std::span<const scene::FootstepEvent> PlaygroundGame::footsteps() const {
    if (!player_) return {};
    return player_->footsteps();
}

}  // namespace plumbline::game
