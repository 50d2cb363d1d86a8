#include "engine/physics/collision/pair_reach.h"

#include "engine/physics/world/body_record.h"

#include <algorithm>
#include <cmath>

namespace plumbline::physics {
namespace {

/// Points of others than spheres count when nearer than this share of the bodies' margin.
constexpr Real kNear = 0.1_r;

bool is_moving(const BodyRecord& record) {
    return record.kind != BodyKind::Static && !record.frozen;
}

/// How much of an impact's change of speed `record` takes. What is backed gives way to nothing.
Real share_of(const BodyRecord& record, const BodyRecord& other) {
    const Real own = record.motion->inverse_mass;
    const Real others = other.small.predicted.backed ? Real{0} : other.motion->inverse_mass;
    return own > 0 ? own / (own + others) : Real{0};
}

bool is_backing(const BodyRecord& record) {
    return record.small.predicted.backed || record.motion->inverse_mass <= 0;
}

Vec3 velocity_at(const BodyRecord& record, const Vec3& place_world) {
    const BodyMotion& motion = *record.motion;
    return motion.velocity_at(place_world - motion.at.position_m);
}

/// How fast the bodies come together at a point, after whatever impacts either may get.
Real closing_mps(const Manifold& manifold, const ManifoldPoint& point) {
    const Vec3 apart =
        velocity_at(*manifold.b, point.b.surface_m) - velocity_at(*manifold.a, point.a.surface_m);
    const Vec3& normal = point.normal_world;
    return glm::dot(apart, normal) +
           std::max(Real{0}, -glm::dot(manifold.a->small.predicted.change_mps, normal)) +
           std::max(Real{0}, glm::dot(manifold.b->small.predicted.change_mps, normal));
}

void keep_larger(PredictedChange& predicted, const Vec3& change, bool backed) {
    if (glm::dot(change, change) > glm::dot(predicted.change_mps, predicted.change_mps))
        predicted = {change, backed, false};
}

}  // namespace

Real spin_mps(const BodyRecord& record) {
    return is_moving(record) ? glm::length(record.motion->spin_radps) * record.traits.radius_m : 0;
}

Real ahead_m(const BodyRecord& record) {
    return is_moving(record) ? std::max(record.sweep.inner_radius_m, record.traits.radius_m / 4)
                             : Real{0};
}

Real near_m(const Pair& pair) {
    return pair.round ? pair.base_m : kNear * pair.base_m;
}

Real predicted_mps(const Pair& pair) {
    return glm::length(pair.a->small.predicted.change_mps) +
           glm::length(pair.b->small.predicted.change_mps);
}

Real reach_of(const Pair& pair, const CollideStep& step) {
    const BodyRecord& a = *pair.a;
    const BodyRecord& b = *pair.b;
    const Vec3 apart = a.motion->velocity_mps - b.motion->velocity_mps;
    const Real speed = glm::length(apart) + spin_mps(a) + spin_mps(b) + predicted_mps(pair);
    const Real displacement = speed * step.step_s + step.drop_m;
    if (pair.round) return pair.base_m + (2 * displacement <= pair.base_m ? Real{0} : displacement);
    return near_m(pair) + std::min(displacement, ahead_m(a) + ahead_m(b));
}

bool are_within_reach(const Pair& pair, const CollideStep& step) {
    const Real apart_m =
        glm::distance(pair.a->motion->at.position_m, pair.b->motion->at.position_m);
    return apart_m <= pair.a->traits.radius_m + pair.b->traits.radius_m + reach_of(pair, step);
}

bool knows_less(const Pair& pair, const CollideStep& step) {
    // Others that only an impact brings together collide in the next step, at most their CCD spheres apart.
    return pair.round && 2 * (predicted_mps(pair) - pair.predicted_mps) * step.step_s > pair.base_m;
}

bool is_reachable(const Manifold& manifold,
                  const ManifoldPoint& point,
                  Real near_m,
                  const CollideStep& step) {
    const Real closing = std::max(Real{0}, closing_mps(manifold, point));
    const Vec3 gap = point.a.surface_m - point.b.surface_m;
    const Real drift2 = glm::dot(gap, gap) - point.distance_m * point.distance_m;
    const bool is_far = point.distance_m > near_m + closing * step.step_s + step.drop_m;
    return !is_far && !(drift2 > near_m * near_m);
}

PairImpact impact_of(const Pair& pair, const CollideStep& step) {
    PairImpact impact;
    if (!pair.touches || pair.reach_m <= pair.base_m) return impact;
    for (const Manifold& manifold : pair.manifolds) {
        const BodyRecord& a = *manifold.a;
        const BodyRecord& b = *manifold.b;
        for (const ManifoldPoint& point : manifold.points) {
            const Real closing = closing_mps(manifold, point);
            const Real change = closing * (1 + manifold.material.restitution);
            if (closing * step.step_s <= std::max(point.distance_m, Real{0}) ||
                2 * change * step.step_s <= pair.base_m) {
                continue;
            }
            const Vec3 push = point.normal_world * change;
            keep_larger(
                &a == pair.a ? impact.on_a : impact.on_b, push * share_of(a, b), is_backing(b));
            keep_larger(
                &a == pair.a ? impact.on_b : impact.on_a, -push * share_of(b, a), is_backing(a));
        }
    }
    return impact;
}

}  // namespace plumbline::physics
