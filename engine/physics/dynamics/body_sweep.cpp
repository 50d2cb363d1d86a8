#include "engine/physics/dynamics/body_sweep.h"

#include "engine/physics/bullet/body.h"
#include "engine/physics/bullet/cast.h"
#include "engine/physics/bullet/rotations.h"
#include "engine/physics/collision/pair_reach.h"
#include "engine/physics/dynamics/rotation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace plumbline::physics {
namespace {

/// Of a step's displacement: below it a body was at the impact when the step began.
constexpr Real kStuckShare = 0.02_r;

/// Where the body's path to where it is now begins.
const Transform& start_of(const BodyRecord& record) {
    return record.sweep.since > 0 ? record.sweep.from : record.before.at;
}

/// What the body did since then.
BodyPath path_of(const BodyRecord& record) {
    const auto since = static_cast<double>(record.sweep.since);
    const auto until = static_cast<double>(record.sweep.until);
    if (stands_still(record) || !(until > since)) return {.from = record.motion->at};
    const Transform& from = start_of(record);
    const SteadyMotion motion = motion_between(from, record.motion->at, 1);
    return {.from = from,
            .displacement_m = Vec3d(motion.velocity_mps) / (until - since),
            .turn_rad = Vec3d(motion.spin_radps) / (until - since),
            .since = since,
            .until = until};
}

/// The pair of two bodies; null: none.
Pair* pair_of(const BodyRecord& a, const BodyRecord& b) {
    const auto& pairs = a.small.pairs;
    const auto place =
        std::lower_bound(pairs.begin(), pairs.end(), b.id, [](const PairLink& link, BodyId id) {
            return link.other < id;
        });
    return place != pairs.end() && place->other == b.id ? place->pair : nullptr;
}

/// Whether the step found contact points between the two before it moved them.
bool are_in_contact(const BodyRecord& a, const BodyRecord& b) {
    const Pair* pair = pair_of(a, b);
    return pair != nullptr && pair->touches;
}

double turned_share(const BodyRecord& record, double angle_rad) {
    const bool is_ball = record.traits.primitive.kind == ConvexShape::Kind::Sphere;
    return is_ball ? 0 : std::min(angle_rad, 2.0) * static_cast<double>(record.traits.radius_m);
}

}  // namespace

Vec3 gain_mps2(const BodyRecord& record) {
    if (!pushable(record) || !record.small.awake || !flies(record)) return {0, 0, 0};
    return record.applied.force_N * record.motion->inverse_mass;
}

double crossing_of(const BodyRecord& record) {
    constexpr double kCrossingShare = 0.5;
    const auto radius_m = static_cast<double>(record.sweep.inner_radius_m);
    return radius_m > 0 ? kCrossingShare * radius_m : std::numeric_limits<double>::infinity();
}

bool moves_past_itself(const BodyRecord& record) {
    if (record.sweep.inner_radius_m <= 0 || record.sweep.ccd == ContinuousCollision::Off)
        return false;
    if (record.sweep.ccd == ContinuousCollision::On) return true;
    const Transform& from = start_of(record);
    const Transform& to = record.motion->at;
    Real farthest_m = glm::distance(from.position_m, to.position_m);
    if (record.traits.primitive.kind != ConvexShape::Kind::Sphere) {
        Real traces = 0;
        for (int axis = 0; axis < 3; ++axis)
            traces += glm::dot(from.rotation[axis], to.rotation[axis]);
        farthest_m += std::sqrt(std::max(3 - traces, Real{0})) * record.traits.radius_m;
    }
    return farthest_m > record.sweep.inner_radius_m;
}

Impact first_impact(const StepWorld& world, const BodyRecord& record, std::uint32_t unseen_group) {
    const BodyPath path = path_of(record);
    const MovingBody moving{*record.traits.geometry, path, crossing_of(record)};
    Impact first;
    const auto near = bodies_near(world,
                                  swept_bounds(moving.geometry, path),
                                  {.group = record.filter.group,
                                   .collides_with = record.filter.collides_with,
                                   .ignored = &record,
                                   .unseen_group = unseen_group});
    for (const BodyRecord* other : near) {
        const BodyPath other_path = path_of(*other);
        const auto impact =
            time_of_impact(moving,
                           {*other->traits.geometry, other_path, crossing_of(*other)},
                           are_in_contact(record, *other) ? Known::Held : Known::Nothing,
                           first.share);
        if (impact) first = *impact;
    }
    return first;
}

bool outruns_points(const BodyRecord& record, const Outlook& outlook) {
    if (record.sweep.inner_radius_m <= 0 || record.sweep.ccd == ContinuousCollision::Off)
        return false;
    const double left_s = (1 - outlook.now) * outlook.step_s;
    const double moves_m =
        static_cast<double>(glm::length(record.motion->velocity_mps)) * left_s +
        static_cast<double>(glm::length(gain_mps2(record))) * (left_s * left_s / 2) +
        turned_share(record, static_cast<double>(glm::length(record.motion->spin_radps)) * left_s);
    return moves_m > static_cast<double>(ahead_m(record));
}

double touching_m(const BodyRecord& a, const BodyRecord& b) {
    constexpr double kTouchingShare = 0.04;
    return kTouchingShare * std::min(crossing_of(a), crossing_of(b));
}

bool touch(const Pair& pair) {
    const auto is_touching = [limit_m = touching_m(*pair.a, *pair.b)](const ManifoldPoint& point) {
        return static_cast<double>(point.distance_m) <= limit_m;
    };
    return pair.touches && std::ranges::any_of(pair.manifolds, [&](const Manifold& manifold) {
               return std::ranges::any_of(manifold.points, is_touching);
           });
}

bool flies(const BodyRecord& record) {
    return std::ranges::none_of(record.small.pairs,
                                [](const PairLink& link) { return touch(*link.pair); });
}

bool stop_at_hit(const StepWorld& world, BodyRecord& record, Real duration_s) {
    const Impact impact = first_impact(world, record, 0);
    if (impact.share >= 1) return false;
    const auto share = static_cast<Real>(impact.share);
    stop_at_share(record, share);
    // Less the speed of the fall that it did not make.
    record.motion->velocity_mps -=
        record.traits.weight_N * record.motion->inverse_mass * (duration_s * (1 - share));
    // What stands at the impact already and still heads for it would gain that speed in every step.
    const Vec3 normal{impact.normal};
    const Real into = glm::dot(record.motion->velocity_mps, normal);
    if (share - record.sweep.since < kStuckShare && into < 0)
        record.motion->velocity_mps -= normal * into;
    return true;
}

void stop_at_share(BodyRecord& record, Real share) {
    if (share >= record.sweep.until || record.sweep.since >= record.sweep.until) return;
    const Real since = record.sweep.since;
    const Real part = (share - since) / (record.sweep.until - since);
    const Transform from = start_of(record);
    const Transform to = record.motion->at;
    record.motion->ballistic.going = false;
    Transform stopped = from;
    stopped.position_m += (to.position_m - from.position_m) * part;
    stopped.rotation = turned_part_way(from.rotation, to.rotation, part);
    record.motion->at = stopped;
    record.sweep.until = share;
    write_rigid_pose(record);
}

}  // namespace plumbline::physics
