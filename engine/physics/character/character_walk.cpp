// Walking: along the ground, up and down steps, never through anything.
#include "engine/physics/character/character_state.h"

#include <algorithm>

namespace plumbline::physics {

namespace {

constexpr Real kGroundAcceleration_mps2 = 40;
// Steps may be a little higher than asked: contact points are exact to about a millimetre.
constexpr Real kStepTolerance_m = 0.01_r;
constexpr Real kRaise_m = 0.01_r;
constexpr Real kLeastDisplacement_m = 2e-4_r;
constexpr Real kBeyondSkin_m = 0.006_r;
constexpr Real kTight_m = 2e-4_r;
constexpr Real kEdgeAside_m = 0.01_r;

/// A level way, tilted onto a plane.
Vec3 on_plane(const Vec3& level_way, const Vec3& normal) {
    return {
        level_way.x, -(normal.x * level_way.x + normal.z * level_way.z) / normal.y, level_way.z};
}

Vec3 approach_velocity(const Vec3& from, const Vec3& to, Real change) {
    const Vec3 difference = to - from;
    const Real length = glm::length(difference);
    return length <= change ? to : from + difference * (change / length);
}

/// Walls as a walker feels them: upright, whichever way they lean.
Vec3 upright(const Vec3& normal) {
    return normalize_or(level(normal), Vec3{0, 0, 0});
}

}  // namespace

void Character::Impl::walk(const Vec3& wish_velocity) {
    const Vec3 before = velocity;
    velocity = approach_velocity(velocity, wish_velocity, kGroundAcceleration_mps2 * dt);
    Vec3 displacement = (before + velocity) * (0.5_r * dt);
    const Real length = glm::length(displacement);
    const Vec3d start = feet;
    if (length > 1e-7_r) {
        // The pace is kept along the slope, not along the map.
        const Vec3 slope = on_plane(displacement, ground.face_normal);
        displacement *= length / glm::length(slope);
        slide_on_ground(displacement);
    }
    if (drop_to_ground()) {
        // Resting stays at rest to the last bit.
        const Vec3 moved = Vec3(feet - start);
        if (length <= 1e-7_r && glm::length(moved) < 2e-4_r) feet = start;
        return;
    }
    const Vec3 slope = on_plane(velocity, ground.face_normal);
    Vec3 leaving = velocity;
    leaving.y = std::min(slope.y, Real{0});
    leave_ground(leaving + (ride ? ride->velocity : Vec3{0, 0, 0}));
}

void Character::Impl::slide_on_ground(Vec3 displacement) {
    PlaneSet planes;
    Vec3 tread = ground.face_normal;
    BodyId pushed{};
    const Vec3 wanted = displacement / dt;
    for (const CapsuleContact& near :
         probe.touches(feet, 2 * glm::length(displacement) + kTouch_m)) {
        // Two people share the air between them; neither sees the other's step.
        if (near.user == kCharacterMark) {
            planes.add({upright(near.normal), std::max(near.gap_m, Real{0}) / 2});
        }
    }
    const Vec3 first = displacement;
    displacement = planes.limited(displacement);
    for (int i = 0; i < kSlides && glm::length(displacement) > 1e-6_r; ++i) {
        const Vec3 tilted = on_plane(displacement, tread);
        const auto hit = probe.sweep(feet, tilted, pushed);
        if (!hit) {
            feet += Vec3d(tilted);
            break;
        }
        const Real share = hit->travel_m / glm::length(tilted);
        feet += Vec3d(tilted * share);
        planes.consume(displacement * share);
        displacement *= 1 - share;
        if (glm::length(displacement) < kLeastDisplacement_m)
            break;  // the next step decides what this is
        const Support support = probe.support_of(*hit, feet);
        if (support.walkable && !support.edge && support.face_normal.y > 0.1_r &&
            may_step_on(hit->body, hit->point.y - ground.point.y)) {
            tread = support.face_normal;  // a ramp begins or ends
            continue;
        }
        if (hit->user != kCharacterMark && step_up(displacement)) return;
        const Real away_mps = push(*hit, wanted);
        const Vec3 wall = upright(hit->normal);
        if (wall == Vec3{0, 0, 0}) break;
        planes.add({wall, away_mps * dt});
        if (away_mps > 0) pushed = hit->body;
        displacement = planes.limited(displacement);
        velocity = planes.limited(wanted * dt) / dt;
        if (glm::dot(displacement, first) <= 0 || glm::dot(velocity, first) <= 0) {
            velocity = {0, 0, 0};  // caught in a corner: no swinging from wall to wall
            break;
        }
    }
}

bool Character::Impl::step_up(const Vec3& displacement) {
    // The pace is enough to roll over most edges. A foot that would fall back beside the riser has
    // to come out of the skin first.
    const Real length = glm::length(displacement);
    return try_step(displacement) || try_step(displacement * (1 + kBeyondSkin_m / length));
}

bool Character::Impl::try_step(const Vec3& displacement) {
    const Real length = glm::length(displacement);
    const Real below_tread = std::max(ground.point.y - static_cast<Real>(feet.y), Real{0});
    Real lift = def.step_up_m + below_tread + kStepTolerance_m;
    if (const auto ceiling = probe.sweep(feet, kUp * lift)) lift = ceiling->travel_m;
    if (lift < kTouch_m) return false;

    Vec3d high = feet + Vec3d(kUp * lift);
    const Vec3d before = high;
    PlaneSet planes;
    Vec3 rest = displacement;
    for (int i = 0; i < kSlides && glm::length(rest) > 1e-6_r; ++i) {
        const auto hit = probe.sweep(high, rest);
        const Real share = hit ? hit->travel_m / glm::length(rest) : Real{1};
        high += Vec3d(rest * share);
        if (!hit) break;
        const Vec3 wall = upright(hit->normal);
        if (wall == Vec3{0, 0, 0}) break;
        planes.add({wall, 0});
        rest = planes.limited(rest * (1 - share));
        if (glm::dot(rest, displacement) <= 0) break;
    }
    const Real progress = glm::dot(Vec3(high - before), displacement) / length;
    if (progress < std::min(0.05_r * length + 1e-4_r, kBeyondSkin_m / 2)) return false;

    Vec3d landed = high;
    const auto support = find_ground(landed, lift + kStepTolerance_m);
    if (!support || !support->walkable) return false;
    // On the same floor it was no step: walls and corners are for sliding.
    const bool rises = landed.y - feet.y > 1e-3;
    if (!rises && progress < 0.9_r * length) return false;
    const Real height = support->point.y - ground.point.y;
    if (height > def.step_up_m + kStepTolerance_m || !may_step_on(support->body, height)) {
        return false;
    }
    const auto tight = probe.touches(landed, -kTight_m);
    if (!tight.empty() && !gives_way_to_us(tight.front().body)) return false;
    // The round foot may be half-way up an edge; is there headroom for the rest?
    const Vec3 over = support->point + displacement * (kEdgeAside_m / length);
    if (probe.ray(over + kUp * kEdgeAside_m, over + kUp * probe.height_m())) return false;
    eye.offset_m -= static_cast<Real>(landed.y - feet.y);
    feet = landed;
    stand_on(*support);
    return true;
}

std::optional<Support> Character::Impl::find_ground(Vec3d& from,
                                                    Real reach_m,
                                                    BodyId ignored) const {
    // From a little above, so that a foot that sank a little comes up again.
    const Vec3d above = from + Vec3d(kUp * kRaise_m);
    const auto hit = probe.sweep(above, -kUp * (reach_m + kRaise_m), ignored);
    if (!hit) return std::nullopt;
    const Support support = probe.support_of(*hit, from);
    Real down = hit->raw_travel_m - kSkin_m / std::max(hit->normal.y, 0.3_r);
    if (support.edge) {
        // The round foot meets an edge where its own curve passes through the point.
        const Real aside = glm::length(level(support.point - Vec3(from)));
        const Real radius = def.radius_m;
        const Real rise =
            aside < radius ? radius - std::sqrt(radius * radius - aside * aside) : radius;
        down = static_cast<Real>(above.y) - (support.point.y - rise);
        down = std::min(down, hit->raw_travel_m + kSkin_m);
    }
    from.y = above.y - static_cast<double>(down);
    if (!support.walkable) return support;
    // The distance itself is known best at the place.
    for (const CapsuleContact& touch : probe.touches(from, kTouch_m)) {
        if (touch.body != support.body || touch.normal.y < 0.3_r) continue;
        const Real correction = std::clamp(touch.gap_m / touch.normal.y, -kTouch_m, kTouch_m);
        from.y -= static_cast<double>(correction);
        break;
    }
    return support;
}

/// A light round thing that has come to the feet, too high to step on: it lifts nobody.
bool Character::Impl::rolls_up(const Support& found) const {
    if (found.body == ground.body || !gives_way_to_us(found.body) || probe.is_flat(found))
        return false;
    Vec3 low{};
    Vec3 high{};
    bounds(world, found.body, low, high);
    return !may_step_on(found.body, high.y - ground.point.y);
}

bool Character::Impl::drop_to_ground() {
    // Measured from tread to tread: the round foot may already hang half-way down an edge.
    const Real most = def.step_up_m + kStepTolerance_m;
    Vec3d landed = feet;
    auto support = find_ground(landed, most);
    if (support && rolls_up(*support)) {
        landed = feet;
        support = find_ground(landed, most, support->body);
    }
    if (!support || ground.point.y - support->point.y > most) return false;
    if (!support->walkable) {
        // A steep face may be in the way while the other foot still stands.
        for (const CapsuleContact& touch : probe.touches(feet, kTouch_m)) {
            const Support other = probe.support_of(touch, feet);
            if (!other.walkable || touch.normal.y < 0.1_r) continue;
            stand_on(other);
            return true;
        }
        return false;
    }
    const Real drop = static_cast<Real>(feet.y - landed.y);
    if (drop > kSkin_m && ground.face_normal.y > 0.999_r) eye.offset_m += drop;
    feet = landed;
    stand_on(*support);
    return true;
}

void Character::Impl::stand_on(const Support& support) {
    footing = Footing::Ground;
    ground = support;
    since_ground_s = 0;
    wedged_s = 0;
}

void Character::Impl::leave_ground(const Vec3& world_velocity) {
    footing = Footing::Air;
    velocity = world_velocity;
    ground = {};
    ride.reset();
}

}  // namespace plumbline::physics
