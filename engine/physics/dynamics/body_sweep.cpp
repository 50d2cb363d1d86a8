#include "engine/physics/dynamics/body_sweep.h"

#include "engine/physics/bullet/body.h"
#include "engine/physics/bullet/cast.h"
#include "engine/physics/bullet/rotations.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumbline::physics {
namespace {

/// Of a step's displacement: below it a body was at the impact when the step began.
constexpr Real kStuckShare = 0.02_r;
/// Of the inner radius: bodies that come to overlap by so much cross each other.
constexpr double kCrossingShare = 0.5;

/// What the body did since record.before.
BodyPath path_of(const BodyRecord& record) {
    const auto until = static_cast<double>(record.sweep.until);
    if (stands_still(record) || !(until > 0)) return {.from = record.motion->at};
    const SteadyMotion motion = motion_between(record.before.at, record.motion->at, 1);
    return {.from = record.before.at,
            .displacement_m = Vec3d(motion.velocity_mps) / until,
            .turn_rad = Vec3d(motion.spin_radps) / until,
            .until = until};
}

double crossing_of(const BodyRecord& record) {
    const auto radius_m = static_cast<double>(record.sweep.inner_radius_m);
    return radius_m > 0 ? kCrossingShare * radius_m : std::numeric_limits<double>::infinity();
}

/// Whether the step found contact points between the two before it moved them.
bool are_in_contact(const BodyRecord& a, const BodyRecord& b) {
    const auto& pairs = a.small.pairs;
    const auto place =
        std::lower_bound(pairs.begin(), pairs.end(), b.id, [](const PairLink& link, BodyId id) {
            return link.other < id;
        });
    return place != pairs.end() && place->other == b.id && place->pair->touches;
}

}  // namespace

bool moves_past_itself(const BodyRecord& record) {
    if (record.sweep.inner_radius_m <= 0 || record.sweep.ccd == ContinuousCollision::Off)
        return false;
    if (record.sweep.ccd == ContinuousCollision::On) return true;
    const Transform& from = record.before.at;
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
                           are_in_contact(record, *other),
                           first.share);
        if (impact) first = *impact;
    }
    return first;
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
    if (share < kStuckShare && into < 0) record.motion->velocity_mps -= normal * into;
    return true;
}

void stop_at_share(BodyRecord& record, Real share) {
    if (share >= record.sweep.until) return;
    const Real part = share / record.sweep.until;
    const Transform to = record.motion->at;
    record.motion->ballistic.going = false;
    Transform stopped = record.before.at;
    stopped.position_m += (to.position_m - stopped.position_m) * part;
    stopped.rotation = turned_part_way(record.before.at.rotation, to.rotation, part);
    record.motion->at = stopped;
    record.sweep.until = share;
    write_rigid_pose(record);
}

}  // namespace plumbline::physics
