#include "game/rules/player.h"

#include "engine/physics/query.h"
#include "engine/scene/simulation/entity_lookup.h"
#include "game/rules/hands/aim.h"

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
constexpr Real kLowestSeat_m = 0.25_r;
constexpr Real kHighestSeat_m = 0.7_r;
constexpr Real kLevelSeat = 0.95_r;   // least height of its normal
constexpr Real kSeatStep_m = 0.05_r;  // between places that are tried, from what is looked at …
constexpr int kSeatSteps = 10;        // … half a metre towards the person: off the backrest
constexpr Real kSeatAir_m = 0.01_r;
constexpr Real kSittingLower_m = 0.2_r;  // than crouching
constexpr Real kSittingDown_mps = 0.8_r;
constexpr Real kSeatGone_mps = 1.5_r;  // who falls sits no more
constexpr Real kSeatGone_m = 0.8_r;    // and who is thrown off a swing
constexpr Real kPump_N = 80;           // of legs and back, on a swing

/// By which cloths and soft bodies push it.
Vec3 force_on(const scene::Simulation& simulation, physics::BodyId body) {
    Vec3d sum{0, 0, 0};
    for (const auto list : {simulation.cloths(), simulation.softs()}) {
        for (const scene::SceneDeformable& each : list) sum += each.body->force_on(body);
    }
    return Vec3(sum);
}

std::uint16_t surface_under(const scene::Simulation& simulation, physics::BodyId ground) {
    const ecs::Entity entity = entity_of(simulation, ground);
    if (!simulation.registry.alive(entity)) return 0;
    const auto* surface = simulation.registry.find<scene::SurfaceRef>(entity);
    return surface == nullptr ? std::uint16_t{0} : surface->surface;
}

/// A seat that swings: it moves, and a joint or a rope holds it.
bool is_hung(const scene::Simulation& simulation, physics::BodyId seat) {
    const physics::PhysicsWorld& world = simulation.physics;
    if (!world.contains(seat) || world.state(seat).kind != physics::BodyKind::Dynamic) return false;
    const bool has_joint = std::ranges::any_of(simulation.joints(), [&](const auto& joint) {
        if (!world.contains(joint.joint) || world.joint(joint.joint).state.broken) return false;
        const physics::JointDef& def = world.joint(joint.joint).def;
        return def.a == seat || def.b == seat;
    });
    return has_joint || std::ranges::any_of(simulation.ropes(), [&](const scene::Rope& rope) {
               return rope.ends[0] == seat || rope.ends[1] == seat;
           });
}

}  // namespace

Player::Player(scene::Simulation& simulation, const Vec3& feet_m) {
    physics::CharacterDef def;
    def.feet_position_m = feet_m;
    character_ = std::make_unique<physics::Character>(simulation.physics, def);
    const auto seated = simulation.physics.create_shape(
        physics::CapsuleShape{def.radius_m - kSeatAir_m, def.crouched_height_m - 2 * def.radius_m});
    PL_ASSERT(seated.ok(), "a capsule within the limits");
    seated_ = *seated;
    previous_eye_m_ = eye_now_m();
}

void Player::act(scene::Simulation& simulation,
                 const Actions& actions,
                 CameraLook& look,
                 bool walks) {
    previous_eye_m_ = eye_now_m();
    physics::CharacterInput input;
    const bool moves = actions.is_held(Action::Forward) || actions.is_held(Action::Back) ||
                       actions.is_held(Action::Left) || actions.is_held(Action::Right);
    const bool swings = sits_ && !drives_ && is_hung(simulation, seat_);
    const bool falls =
        swings ? seat_away_m(simulation) > kSeatGone_m : state().velocity_mps.y < -kSeatGone_mps;
    const bool leaves = (moves && !swings) || actions.presses(Action::Jump) > 0 ||
                        actions.presses(Action::Crouch) > 0;
    if (falls || !walks || (leaves && !drives_)) stand_up();
    const Real ahead = travel_of(actions, Action::Forward) - travel_of(actions, Action::Back);
    if (sits_) {
        input.crouch = true;
        if (swings && ahead != 0)
            simulation.physics.apply_force(seat_,
                                           level_forward(look.yaw_rad()) * (ahead * kPump_N));
    } else if (walks) {
        const Real aside = travel_of(actions, Action::Right) - travel_of(actions, Action::Left);
        input.direction_world =
            level_forward(look.yaw_rad()) * ahead + level_right(look.yaw_rad()) * aside;
        input.pace = pace_;
        input.run = actions.is_held(Action::Sprint);
        input.crouch = actions.is_held(Action::Crouch);
        input.jump = actions.presses(Action::Jump) > 0;
    }
    input.borne_N = force_on(simulation, body());
    character_->update(input);
    const Real change_m = kSittingDown_mps * static_cast<Real>(simulation.step_s());
    lowered_m_ += std::clamp((sits_ ? kSittingLower_m : Real{0}) - lowered_m_, -change_m, change_m);
    if (walks) look.turn_smoothly(state().ridden_yaw_rad, 0);
    listen_to_feet(simulation);
}

void Player::teleport(const Vec3& feet_m) {
    character_->teleport(feet_m);
    stand_up();
    previous_eye_m_ = eye_now_m();
}

std::optional<Vec3> Player::seat_at(const scene::Simulation& simulation,
                                    const Looked& looked) const {
    const physics::PhysicsWorld& world = simulation.physics;
    const Vec3 feet = state().feet_position_m;
    const physics::QueryFilter others{.ignored = body()};
    const auto face_under = [&](const Vec3& place, Real above_m) {
        const auto face = cast_ray(
            world, place + Vec3{0, above_m, 0}, place - Vec3{0, kHighestSeat_m, 0}, others);
        const bool is_seat = face && face->body == looked.body &&
                             face->normal_world.y > kLevelSeat &&
                             face->point_world.y > feet.y + kLowestSeat_m &&
                             face->point_world.y < feet.y + kHighestSeat_m;
        return is_seat ? std::optional(face->point_world) : std::nullopt;
    };
    const Vec3 way{feet.x - looked.point_m.x, 0, feet.z - looked.point_m.z};
    const Vec3 near = normalize_or(way, Vec3{0, 0, 0});
    const Real half_m = def().crouched_height_m / 2;
    for (int step = -1; step < kSeatSteps; ++step) {
        const Real aside_m = static_cast<Real>(step) * kSeatStep_m;
        const auto seat = face_under(looked.point_m + near * aside_m, kSeatAir_m);
        if (!seat) continue;
        const Pose room{.position = *seat + Vec3{0, half_m + kSeatAir_m, 0}};
        if (physics::overlaps(world, seated_, room, 0, others).empty()) return seat;
    }
    return {};
}

void Player::sit(const Vec3& seat_m, physics::BodyId seat, bool drives) {
    teleport(seat_m);
    sits_ = true;
    drives_ = drives;
    seat_ = seat;
}

Real Player::change_pace(int notches) {
    pace_ = std::clamp(pace_ * whole_power(kPaceNotch, notches), kSlowestPace, kFastestPace);
    return pace_ * def().walk_speed_mps;
}

Real Player::seat_away_m(const scene::Simulation& simulation) const {
    return glm::distance(simulation.physics.state(seat_).center_of_mass_world(),
                         state().feet_position_m);
}

Vec3 Player::eye_now_m() const {
    return character_->state().eye_position_m - Vec3{0, lowered_m_, 0};
}

Vec3 Player::eye_m(Real blend) const {
    return glm::mix(previous_eye_m_, eye_now_m(), blend);
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
