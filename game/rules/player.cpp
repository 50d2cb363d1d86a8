#include "game/rules/player.h"

#include "engine/scene/simulation/entity_lookup.h"
#include "game/rules/aim.h"

#include <algorithm>
#include <cmath>

namespace plumbline::game {

namespace {

constexpr Real kWalkStride_m = 0.75_r;
constexpr Real kRunStride_m = 1.1_r;
constexpr Real kHeardLanding_mps = 1;
constexpr Real kPaceNotch = 1.25_r;
constexpr Real kSlowestPace = 0.25_r;
constexpr Real kFastestPace = 3;

std::uint16_t surface_under(const scene::Simulation& simulation, physics::BodyId ground) {
    const ecs::Entity entity = entity_of(simulation, ground);
    if (!simulation.registry.alive(entity)) return 0;
    const auto* surface = simulation.registry.find<scene::SurfaceRef>(entity);
    return surface == nullptr ? std::uint16_t{0} : surface->surface;
}

}  // namespace

Player::Player(scene::Simulation& simulation, const Vec3& feet_m) {
    physics::CharacterDef def;
    def.feet_position_m = feet_m;
    character_ = std::make_unique<physics::Character>(simulation.physics, def);
    previous_eye_m_ = character_->state().eye_position_m;
}

void Player::act(scene::Simulation& simulation,
                 const Actions& actions,
                 CameraLook& look,
                 bool walks) {
    previous_eye_m_ = character_->state().eye_position_m;
    physics::CharacterInput input;
    if (walks) {
        const Real ahead = travel_of(actions, Action::Forward) - travel_of(actions, Action::Back);
        const Real aside = travel_of(actions, Action::Right) - travel_of(actions, Action::Left);
        input.direction_world =
            level_forward(look.yaw_rad()) * ahead + level_right(look.yaw_rad()) * aside;
        input.pace = pace_;
        input.run = actions.is_held(Action::Sprint);
        input.crouch = actions.is_held(Action::Crouch);
        input.jump = actions.presses(Action::Jump) > 0;
    }
    character_->update(input);
    if (walks) look.turn_smoothly(state().ridden_yaw_rad, 0);
    listen_to_feet(simulation);
}

void Player::teleport(const Vec3& feet_m) {
    character_->teleport(feet_m);
    previous_eye_m_ = character_->state().eye_position_m;
}

Real Player::change_pace(int notches) {
    pace_ = std::clamp(pace_ * whole_power(kPaceNotch, notches), kSlowestPace, kFastestPace);
    return pace_ * def().walk_speed_mps;
}

Vec3 Player::eye_m(Real blend) const {
    return glm::mix(previous_eye_m_, character_->state().eye_position_m, blend);
}

void Player::listen_to_feet(const scene::Simulation& simulation) {
    footsteps_.clear();
    const physics::CharacterState& now = state();
    if (now.footing != physics::Footing::Ground) return;
    const auto heard = [&](Real speed_mps) {
        footsteps_.push_back({.position_m = now.feet_position_m,
                              .surface = surface_under(simulation, now.ground_body),
                              .speed_mps = speed_mps});
    };
    if (now.landing_speed_mps > kHeardLanding_mps) {
        heard(now.landing_speed_mps);
        stride_m_ = 0;
        return;
    }
    const Real speed = glm::length(now.walking_mps);
    const Real between =
        speed > (def().walk_speed_mps + def().run_speed_mps) / 2 ? kRunStride_m : kWalkStride_m;
    stride_m_ += speed * static_cast<Real>(simulation.step_s());
    if (speed < 0.1_r) stride_m_ = 0;
    if (stride_m_ < between) return;
    stride_m_ -= between;
    heard(speed);
}

}  // namespace plumbline::game
