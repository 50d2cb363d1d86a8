// Jumping, falling, sliding down what is too steep.
#include "engine/physics/character/character_state.h"

#include <algorithm>

namespace plumbline::physics {

namespace {

constexpr Real kAirAcceleration_mps2 = 8;
constexpr Real kWedgedAfter_s = 0.15_r;
constexpr Real kCoyoteTime_s = 0.08_r;
constexpr Real kBearing = 0.3_r;   ///< of the weight: what bears so much one can jump from
constexpr Real kKnees_per_s = 12;  ///< the share of a rebound that they take

}  // namespace

std::optional<Vec3> Character::Impl::jump_velocity() const {
    const bool wedged = wedged_s >= kWedgedAfter_s;
    if (footing != Footing::Ground && !wedged && since_ground_s > kCoyoteTime_s)
        return std::nullopt;
    const Vec3 riding = ride ? ride->velocity : Vec3{0, 0, 0};
    Vec3 start = velocity;
    if (footing == Footing::Ground) start += riding;
    // What gives way may be throwing the person up at the moment.
    const Real rising_mps = footing == Footing::Ground ? riding.y : velocity.y;
    start.y = std::max(rising_mps, Real{0}) +
              std::sqrt(2 * std::max(gravity_mps2, Real{0}) * def.jump_height_m);
    return start;
}

bool Character::Impl::try_land(const CapsuleContact& hit, const Vec3& fall_velocity) {
    const Vec3 under = point_velocity(hit.body, hit.point);
    const Vec3 relative = fall_velocity - under;
    if (hit.normal.y < 0.1_r || glm::dot(relative, hit.normal) >= 0 || relative.y > 1e-3_r) {
        return false;
    }
    const Support support = probe.support_of(hit, feet);
    if (!support.walkable) return false;
    state.landing_speed_mps = std::max(-relative.y, 1e-3_r);
    velocity = level(relative);
    stand_on(support);
    return true;
}

void Character::Impl::lie_on(const Vec3& borne_N) {
    const bool jumped = since_ground_s >= 1 && velocity.y > 0;
    since_ground_s += dt;
    if (!is_finite(borne_N)) return;
    velocity += borne_N * (dt / def.mass_kg);
    if (jumped || borne_N.y < kBearing * def.mass_kg * gravity_mps2) return;
    since_ground_s = 0;
    const Real still_mps = gravity_mps2 * dt / 2;  // what the fall of the coming step takes back
    const Real rebound_mps = std::max(velocity.y - still_mps, Real{0});
    velocity.y -= rebound_mps * (1 - portable_exp(-kKnees_per_s * dt));
}

void Character::Impl::fly(const Vec3& wish_velocity) {
    // In the air a person can steer a little, and brake, but not gain speed beyond a walk's.
    const Vec3 steer = wish_velocity - level(velocity);
    const Real steer_length = glm::length(steer);
    if (glm::length(wish_velocity) > 0 && steer_length > 1e-6_r) {
        velocity += steer * (std::min(kAirAcceleration_mps2 * dt, steer_length) / steer_length);
    }
    const Vec3 gravity{0, -gravity_mps2, 0};
    Vec3 displacement = velocity * dt + gravity * (0.5_r * dt * dt);  // exact for a constant pull
    velocity += gravity * dt;
    const Real wanted = glm::length(displacement);

    PlaneSet planes;
    footing = Footing::Air;
    BodyId pushed{};
    Real moved = 0;
    for (int i = 0; i < kSlides && glm::length(displacement) > 1e-6_r; ++i) {
        const auto hit = probe.sweep(feet, displacement, pushed);
        const Real length = glm::length(displacement);
        const Real share = hit ? hit->travel_m / length : Real{1};
        feet += Vec3d(displacement * share);
        moved += length * share;
        if (!hit) break;
        displacement *= 1 - share;
        if (try_land(*hit, velocity)) {
            slide_on_ground(level(displacement));
            if (!drop_to_ground()) leave_ground(velocity);
            return;
        }
        const Real away_mps = push(*hit, velocity);
        if (away_mps > 0) pushed = hit->body;
        if (hit->normal.y > 0.05_r) footing = Footing::SteepSlope;
        planes.add({hit->normal, away_mps * dt});
        if (displacement.y <= 0 && planes.limited(displacement).y > 0) {
            // Running against a steep face must not lift.
            planes.add({normalize_or(level(hit->normal), hit->normal), 0});
        }
        displacement = planes.limited(displacement);
        velocity = planes.limited(velocity * dt) / dt;
    }
    if (footing == Footing::Air) {
        for (const CapsuleContact& touch : probe.touches(feet, kTouch_m)) {
            if (touch.normal.y > 0.05_r) footing = Footing::SteepSlope;
        }
    }
    // Caught between steep faces: not falling any more, so there is something to jump from.
    const bool stuck = footing == Footing::SteepSlope && moved < 0.1_r * wanted;
    wedged_s = stuck ? wedged_s + dt : Real{0};
}

}  // namespace plumbline::physics
