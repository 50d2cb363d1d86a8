#include "game/rules/hands/grab.h"

#include "engine/physics/query.h"
#include "engine/scene/simulation/entity_lookup.h"
#include "game/components.h"

#include <algorithm>

namespace plumbline::game {

namespace {

constexpr const char* kTooHeavy = "too heavy to lift";
constexpr Real kStiffness_radps = 18;  // of the spring: follows within about 0.15 s
constexpr Real kTurnStiffness_radps = 14;
constexpr Real kFastest_mps = 10;
constexpr Real kFastest_per_m = 4;  // by a pointer: m/s for each metre that it is away
constexpr Real kFastest_radps = 12;
constexpr Real kMostTorque_Nm = 120;
constexpr Real kHandleGain = 2;  // what is loaded is heavier than it says
constexpr Real kLevelStiffness_radps = 60;
constexpr Real kLost_m = 1.5_r;       // farther from where it should be: the hand opens …
constexpr Real kLostAfter_s = 0.4_r;  // … after this long

/// Velocity at the end of a step that a critically damped spring gives, solved implicitly: stable
/// at every step length.
Vec3 damped(const Vec3& velocity,
            const Vec3& offset,
            const Vec3& target_velocity,
            Real stiffness_radps,
            Real dt) {
    const Real w = stiffness_radps;
    const Vec3 pulled = velocity + (offset * (w * w) + target_velocity * (2 * w)) * dt;
    return pulled / (1 + 2 * w * dt + w * w * dt * dt);
}

Vec3 shortened(const Vec3& v, Real most) {
    const Real length = glm::length(v);
    return length > most ? v * (most / length) : v;
}

/// A wheel turns about the axis of its largest moment.
Vec3 axle_of(const Vec3& moments_kgm2) {
    Vec3 axle{1, 0, 0};
    if (moments_kgm2.y > std::max(moments_kgm2.x, moments_kgm2.z)) axle = {0, 1, 0};
    if (moments_kgm2.z > std::max(moments_kgm2.x, moments_kgm2.y)) axle = {0, 0, 1};
    return axle;
}

/// Axis times angle of a rotation, the short way round.
Vec3 rotation_vector(Quat rotation) {
    if (rotation.w < 0) rotation = -rotation;
    const Vec3 axis{rotation.x, rotation.y, rotation.z};
    const Real sine = glm::length(axis);
    if (sine < 1e-7_r) return {0, 0, 0};
    return axis * (2 * portable_atan2(sine, rotation.w) / sine);
}

}  // namespace

std::optional<Looked> looked_at(const scene::Simulation& simulation, const Aim& aim, Real arm_m) {
    const auto hit = cast_ray(simulation.physics,
                              aim.eye_m,
                              aim.eye_m + aim.forward * aim.reach_m(arm_m),
                              {.ignored = aim.own_body});
    if (!hit) return std::nullopt;
    return Looked{.entity = entity_of(simulation, hit->body),
                  .body = hit->body,
                  .point_m = hit->point_world,
                  .distance_m = hit->distance_m};
}

std::optional<Grab::Handle> Grab::handle_of(const scene::Simulation& simulation,
                                            const Looked& looked) {
    const Pose body_from_world = invert(simulation.physics.state(looked.body).world_from_body);
    Handle handle{.point_body = transform_point(body_from_world, looked.point_m)};
    int wheels = 0;
    for (const scene::SceneJoint& joint : simulation.joints()) {
        if (!simulation.physics.contains(joint.joint)) continue;
        const physics::JointView hinge = simulation.physics.joint(joint.joint);
        const physics::JointDef& def = hinge.def;
        const bool is_a = def.a == looked.body;
        const physics::BodyId wheel = is_a ? def.b : def.a;
        if (def.kind != physics::JointKind::Hinge || hinge.state.broken || def.limits || !wheel ||
            (!is_a && def.b != looked.body) ||
            simulation.physics.state(wheel).kind != physics::BodyKind::Dynamic)
            continue;
        ++wheels;
        // Both hands: on the plane in which the wheel rolls.
        const physics::BodyState turning = simulation.physics.state(wheel);
        const Vec3 axle_body =
            glm::normalize(body_from_world.orientation * turning.world_from_body.orientation *
                           axle_of(turning.mass.inertia_kgm2));
        const Vec3 hub_body = transform_point(body_from_world, turning.center_of_mass_world());
        handle.axle_body = axle_body;
        handle.point_body -= axle_body * glm::dot(handle.point_body - hub_body, axle_body);
    }
    for (const scene::Vehicle& vehicle : simulation.vehicles())
        wheels += vehicle.chassis == looked.body ? 2 : 0;
    if (wheels > 1) handle.axle_body = {0, 0, 0};
    return wheels > 0 ? std::optional(handle) : std::nullopt;
}

std::optional<std::string> Grab::take(scene::Simulation& simulation, const Aim& aim) {
    const auto looked = looked_at(simulation, aim, kReach_m);
    if (pinch_.take(simulation, aim, sight_m(looked, aim, kReach_m))) return std::nullopt;
    if (!looked || !simulation.registry.alive(looked->entity)) return "nothing within reach";
    physics::PhysicsWorld& world = simulation.physics;
    const physics::BodyState state = world.state(looked->body);
    if (state.kind != physics::BodyKind::Dynamic) return "this object is fixed";
    if (state.frozen) return "this object is frozen";
    if (state.mass.mass_kg > kMostMass_kg) return kTooHeavy;
    entity_ = looked->entity;
    body_ = looked->body;
    mass_kg_ = state.mass.mass_kg;
    Vec3 low{};
    Vec3 high{};
    physics::bounds(world, body_, low, high);
    radius_m_ = glm::length(high - low) / 2;
    const Vec3 middle = world.state(body_).center_of_mass_world();
    by_pointer_ = aim.by_pointer;
    distance_m_ = by_pointer_
                      ? looked->distance_m
                      : std::clamp(glm::length(middle - aim.eye_m), kNearest_m, kFarthest_m);
    const Quat view = portable_angle_axis(aim.yaw_rad, Vec3{0, 1, 0});
    middle_from_point_ =
        by_pointer_ ? glm::conjugate(view) * (looked->point_m - middle) : Vec3{0, 0, 0};
    view_from_body_ = glm::conjugate(view) * world.state(body_).world_from_body.orientation;
    handle_ = handle_of(simulation, *looked);
    if (handle_) {
        distance_m_ = std::max(looked->distance_m, kNearest_m);
        radius_m_ = 0;
        middle_from_point_ = {0, 0, 0};
    }
    last_target_.reset();
    stuck_s_ = 0;
    simulation.registry.add<Held>(entity_, state.mass.mass_kg);
    return std::nullopt;
}

void Grab::release(scene::Simulation& simulation) {
    pinch_.release(simulation);
    if (simulation.registry.alive(entity_) && simulation.registry.has<Held>(entity_)) {
        simulation.registry.remove<Held>(entity_);
    }
    entity_ = {};
    body_ = {};
}

void Grab::forget_gone(scene::Simulation& simulation) {
    const bool is_there = simulation.registry.alive(entity_) && simulation.physics.contains(body_);
    if (holds_thing() && !is_there) release(simulation);
}

void Grab::change_distance(Real by_m) {
    pinch_.change_distance(by_m);
    const Real farthest_m = by_pointer_ ? Aim::kSight_m : kFarthest_m;
    distance_m_ = std::clamp(distance_m_ + by_m, kNearest_m, farthest_m);
}

void Grab::rotate(Real yaw_rad, Real pitch_rad) {
    // About the view's own up and right, as the hand would turn it.
    view_from_body_ =
        glm::normalize(portable_angle_axis(yaw_rad, Vec3{0, 1, 0}) *
                       portable_angle_axis(pitch_rad, Vec3{1, 0, 0}) * view_from_body_);
}

Vec3 Grab::target_of(const scene::Simulation& simulation, const Aim& aim) const {
    Vec3 target = aim.eye_m + aim.forward * distance_m_ -
                  portable_angle_axis(aim.yaw_rad, Vec3{0, 1, 0}) * middle_from_point_;
    // Looking down must not press it into the person's own feet.
    const Vec3 aside{target.x - aim.eye_m.x, 0, target.z - aim.eye_m.z};
    const Real keep = aim.keep_away_m > 0 ? aim.keep_away_m + std::min(radius_m_, 0.5_r) : 0;
    if (glm::length(aside) < keep) {
        const Vec3 out = level_forward(aim.yaw_rad) * keep;
        target = {aim.eye_m.x + out.x, target.y, aim.eye_m.z + out.z};
    }
    // Not behind what the eye cannot see past.
    const Vec3 path = target - aim.eye_m;
    const Real length = glm::length(path);
    const auto wall = cast_ray(
        simulation.physics, aim.eye_m, target, {.ignored = aim.own_body, .also_ignored = body_});
    if (!wall || length < 1e-6_r) return target;
    const Real room = std::max(wall->distance_m - 0.5_r * radius_m_, Real{0});
    return aim.eye_m + path * (std::min(room, length) / length);
}

std::optional<std::string> Grab::pull(scene::Simulation& simulation, const Aim& aim) {
    if (holds_thing()) pull_thing(simulation, aim);
    return pinch_.pull(simulation, aim) ? std::nullopt : std::optional<std::string>(kTooHeavy);
}

void Grab::pull_thing(scene::Simulation& simulation, const Aim& aim) {
    physics::PhysicsWorld& world = simulation.physics;
    if (world.state(body_).frozen) return release(simulation);
    const Vec3 target = target_of(simulation, aim);
    const Real dt = static_cast<Real>(simulation.step_s());
    const physics::BodyState state = world.state(body_);
    const Vec3 held = handle_ ? transform_point(state.world_from_body, handle_->point_body)
                              : state.center_of_mass_world();
    const bool lost = !by_pointer_ && glm::length(target - held) > kLost_m;
    stuck_s_ = lost ? stuck_s_ + dt : Real{0};
    if (stuck_s_ > kLostAfter_s) return release(simulation);
    world.wake(body_);
    if (handle_) {
        pull_handle(simulation, target);
        keep_level(simulation, aim);
    } else {
        pull_straight(simulation, aim, target);
        pull_round(simulation, aim);
    }
    last_target_ = target;
}

/// Of what is held, at a point of it that is to be at `target`.
Vec3 Grab::next_velocity(const Vec3& velocity,
                         const Vec3& point,
                         const Vec3& target,
                         Real dt) const {
    // The farther away, the farther a pointer goes in the same time.
    const Real fastest_mps =
        by_pointer_ ? std::max(kFastest_mps, kFastest_per_m * distance_m_) : kFastest_mps;
    const Vec3 target_velocity =
        last_target_ ? shortened((target - *last_target_) / dt, fastest_mps) : Vec3{0, 0, 0};
    return shortened(damped(velocity, target - point, target_velocity, kStiffness_radps, dt),
                     fastest_mps);
}

void Grab::pull_straight(scene::Simulation& simulation, const Aim& aim, const Vec3& target) {
    physics::PhysicsWorld& world = simulation.physics;
    const Real dt = static_cast<Real>(simulation.step_s());
    const physics::BodyState state = world.state(body_);
    const Vec3 middle = state.center_of_mass_world();
    const Vec3 arm = middle - state.world_from_body.position;
    const Vec3 velocity = state.velocity_mps + glm::cross(state.angular_velocity_radps, arm);
    const Vec3 next = next_velocity(velocity, middle, target, dt);
    const Vec3 weight = world.def().gravity_mps2 * mass_kg_;
    Vec3 force = shortened((next - velocity) * (mass_kg_ / dt) - weight, kMostForce_N);
    // Nobody lifts what he stands on.
    if (body_ == aim.support) force.y = std::min(force.y, Real{0});
    world.apply_force(body_, force);
}

void Grab::pull_handle(scene::Simulation& simulation, const Vec3& target) {
    physics::PhysicsWorld& world = simulation.physics;
    const Real dt = static_cast<Real>(simulation.step_s());
    const physics::BodyState state = world.state(body_);
    const Vec3 point = transform_point(state.world_from_body, handle_->point_body);
    const Vec3 velocity = state.velocity_mps + glm::cross(state.angular_velocity_radps,
                                                          point - state.world_from_body.position);
    const Vec3 change = next_velocity(velocity, point, target, dt) - velocity;
    // As heavy as it is at that point, along that way.
    const Vec3 way = normalize_or(change, Vec3{0, 1, 0});
    const Vec3 lever = glm::conjugate(state.world_from_body.orientation) *
                       glm::cross(point - state.center_of_mass_world(), way);
    const Real felt_kg = 1 / (1 / mass_kg_ + glm::dot(lever, lever / state.mass.inertia_kgm2));
    const Vec3 force = change * (kHandleGain * felt_kg / dt);
    world.apply_force(body_, shortened(force, kMostForce_N), point);
}

/// Two hands keep the axle level, and across the view as it was when they took hold; it tilts as it likes.
void Grab::keep_level(scene::Simulation& simulation, const Aim& aim) {
    if (handle_->axle_body == Vec3{0, 0, 0}) return;
    physics::PhysicsWorld& world = simulation.physics;
    const Real dt = static_cast<Real>(simulation.step_s());
    const physics::BodyState state = world.state(body_);
    const Quat& now = state.world_from_body.orientation;
    const Vec3 axle = now * handle_->axle_body;
    const Vec3 across =
        portable_angle_axis(aim.yaw_rad, Vec3{0, 1, 0}) * (view_from_body_ * handle_->axle_body);
    const Vec3 wanted = normalize_or(Vec3{across.x, 0, across.z}, axle);
    const Vec3 off = glm::cross(axle, wanted);
    const Vec3 ahead = normalize_or(glm::cross(Vec3{0, 1, 0}, wanted), Vec3{0, 0, 0});
    const auto torque_about = [&](const Vec3& way) {
        const Real spin = glm::dot(state.angular_velocity_radps, way);
        const Vec3 next =
            damped(way * spin, way * glm::dot(off, way), Vec3{0, 0, 0}, kLevelStiffness_radps, dt);
        const Vec3 change = glm::conjugate(now) * ((next - way * spin) * (kHandleGain / dt));
        return shortened(now * (state.mass.inertia_kgm2 * change), kMostTorque_Nm);
    };
    world.apply_torque(body_, torque_about(ahead));
    world.apply_torque(body_, torque_about(Vec3{0, 1, 0}));
}

void Grab::pull_round(scene::Simulation& simulation, const Aim& aim) {
    physics::PhysicsWorld& world = simulation.physics;
    const Real dt = static_cast<Real>(simulation.step_s());
    const physics::BodyState state = world.state(body_);
    const Quat& now = state.world_from_body.orientation;
    const Quat wanted = portable_angle_axis(aim.yaw_rad, Vec3{0, 1, 0}) * view_from_body_;
    const Vec3 offset = rotation_vector(glm::normalize(wanted * glm::conjugate(now)));
    const Vec3 next = shortened(
        damped(state.angular_velocity_radps, offset, Vec3{0, 0, 0}, kTurnStiffness_radps, dt),
        kFastest_radps);
    const Vec3 change = glm::conjugate(now) * ((next - state.angular_velocity_radps) / dt);
    world.apply_torque(body_, shortened(now * (state.mass.inertia_kgm2 * change), kMostTorque_Nm));
}

void Grab::serialize(Archive& archive, scene::Simulation& simulation) {
    archive(entity_,
            body_,
            mass_kg_,
            radius_m_,
            distance_m_,
            middle_from_point_,
            by_pointer_,
            handle_,
            view_from_body_,
            last_target_,
            stuck_s_);
    pinch_.serialize(archive, simulation);
    if (!archive.reads() || !holds_thing()) return;
    const auto* ref = simulation.registry.find<scene::BodyRef>(entity_);
    const bool is_there = ref != nullptr && ref->body == body_ && mass_kg_ > 0 && radius_m_ > 0;
    if (archive.expect(is_there, "what is in the hand is not there"))
        simulation.registry.add<Held>(entity_, mass_kg_);
}

bool Grab::throw_it(scene::Simulation& simulation, const Aim& aim, const Vec3& velocity_mps) {
    if (pinch_.holding()) {
        pinch_.throw_it(simulation, velocity_mps);
        return true;
    }
    if (!holds_thing()) return false;
    physics::PhysicsWorld& world = simulation.physics;
    const Vec3 middle = world.state(body_).center_of_mass_world();
    const auto wall =
        cast_ray(world, aim.eye_m, middle, {.ignored = aim.own_body, .also_ignored = body_});
    if (wall && world.state(wall->body).kind != physics::BodyKind::Dynamic) return false;
    const physics::BodyId thrown = body_;
    release(simulation);
    const physics::BodyState state = world.state(thrown);
    world.wake(thrown);
    world.set_velocity(thrown, velocity_mps, state.angular_velocity_radps);
    return true;
}

}  // namespace plumbline::game
