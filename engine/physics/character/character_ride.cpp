// Going along with what one stands on, and weighing on it.
#include "engine/physics/character/character_state.h"

#include <algorithm>

namespace plumbline::physics {

namespace {

// A body that jumps farther than this in a step was put elsewhere; the person stays.
constexpr Real kLostRide_m = 0.5_r;
// A platform turns about level axes no faster than this.
constexpr Real kTumbling_radps = 0.5_r;
// A light thing that turns faster rolls away under the feet; a swing does not.
constexpr Real kRolling_radps = 6;

/// The turn about +Y within a rotation.
Real yaw_of(const Quat& rotation) {
    return std::remainder(2 * portable_atan2(rotation.y, rotation.w), 2 * kPi);
}

/// Where a body will be after the step, going on as it does.
Pose coast(const BodyState& state, Real dt) {
    const Real speed = glm::length(state.angular_velocity_radps);
    Pose next = state.world_from_body;
    next.position += state.velocity_mps * dt;
    if (speed > 1e-9_r) {
        next.orientation =
            glm::normalize(portable_angle_axis(speed * dt, state.angular_velocity_radps / speed) *
                           next.orientation);
    }
    return next;
}

/// The same motion once more.
Pose repeat(const Pose& before, const Pose& now) {
    const Quat turn = now.orientation * glm::conjugate(before.orientation);
    return {.position = now.position + (now.position - before.position),
            .orientation = glm::normalize(turn * now.orientation)};
}

}  // namespace

Real Character::Impl::follow_ride() {
    if (!ride) return 0;
    if (!world.contains(ride->body) || world.state(ride->body).frozen) {
        ride.reset();
        return 0;
    }
    // What really happened in the step, against what was expected of it.
    const BodyState found = world.state(ride->body);
    const Vec3 expected = transform_point(ride->next, ride->anchor_body);
    const Vec3 real = transform_point(found.world_from_body, ride->anchor_body);
    if (glm::length(real - expected) > kLostRide_m) {
        ride.reset();
        return 0;
    }
    const Real turned_rad = yaw_of(
        glm::normalize(found.world_from_body.orientation * glm::conjugate(ride->next.orientation)));
    slide_freely(real - expected, ride->body);
    const Pose before = ride->now;
    ride->now = found.world_from_body;
    ride->next = found.kind == BodyKind::Kinematic ? repeat(before, ride->now) : coast(found, dt);
    ride->velocity = (transform_point(ride->next, ride->anchor_body) - real) / dt;
    return turned_rad;
}

bool Character::Impl::is_on_a_platform() const {
    if (!ride) return false;
    const BodyState found = world.state(ride->body);
    if (found.kind == BodyKind::Kinematic) return true;
    const Vec3 tumbling = level(found.angular_velocity_radps);
    if (gives_way_to_us(ride->body) || glm::length(tumbling) > kTumbling_radps) return false;
    return probe.is_flat(ground);
}

/// What is too light to take the person along and rolls or tumbles.
bool Character::Impl::slips_away(const BodyState& below) const {
    const Vec3 turning_radps = level(below.angular_velocity_radps);
    return gives_way_to_us(ground.body) && glm::length(turning_radps) > kRolling_radps;
}

std::optional<Ride> Character::Impl::ride_on_ground() const {
    if (footing != Footing::Ground || !world.contains(ground.body)) return std::nullopt;
    const BodyState found = world.state(ground.body);
    if (found.kind == BodyKind::Static || found.frozen || slips_away(found)) return std::nullopt;
    if (ride && ride->body == ground.body) return ride;
    return Ride{.body = ground.body, .now = found.world_from_body, .next = coast(found, dt)};
}

Real Character::Impl::carry() {
    if (!ride) return 0;
    const Vec3 here = Vec3(feet);
    // Who stands still keeps the very same place on it: rounding must not make him wander.
    const bool still = glm::length(transform_point(ride->now, ride->anchor_body) - here) < 2e-5_r;
    const Vec3 anchor = still ? ride->anchor_body : transform_point(invert(ride->now), here);
    const Vec3 there = transform_point(ride->next, anchor);
    ride->velocity = (there - here) / dt;
    const Vec3 moved = slide_freely(there - here, ride->body);
    const bool carried = glm::length(moved - (there - here)) < 1e-5_r;
    ride->anchor_body = carried ? anchor : transform_point(invert(ride->next), Vec3(feet));
    return yaw_of(glm::normalize(ride->next.orientation * glm::conjugate(ride->now.orientation)));
}

void Character::Impl::press_down() const {
    if (footing != Footing::Ground || !world.contains(ground.body)) return;
    const BodyState below = world.state(ground.body);
    if (!below.pushable()) return;
    const Real mass = below.mass.mass_kg;
    const Real shared = def.mass_kg * mass / (def.mass_kg + mass);
    const Real impulse = def.mass_kg * gravity_mps2 * dt + shared * state.landing_speed_mps;
    world.wake(ground.body);
    push(ground.body, -kUp * impulse, ground.point);
}

/// As a force all through the step; for Bullet's solvers as an impact, because their friction does not
/// see the torque of forces off centre, and a crate with a person at its edge would creep away.
void Character::Impl::push(BodyId pushed, const Vec3& impulse_Ns, const Vec3& point_world) const {
    if (world.def().solver == Solver::SmallStep) {
        world.apply_force(pushed, impulse_Ns / dt, point_world);
    } else {
        world.apply_impulse(pushed, impulse_Ns, point_world);
    }
}

}  // namespace plumbline::physics
