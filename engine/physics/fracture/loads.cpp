// What pushed a body in the latest step, place by place.
#include "engine/physics/fracture.h"
#include "engine/physics/world/world_state.h"

#include <algorithm>

namespace plumbline::physics {
namespace {

/// What closes faster than this meets in an impact.
constexpr Real kImpact_mps = 0.05_r;
/// A manifold that is younger has carried nothing that lasts.
constexpr std::uint32_t kLasting_steps = 2;

/// Those that have points; a reference is good within the call only.
template <class Visit>
void each_manifold_of(const WorldState& world, const BodyRecord& record, const Visit& visit) {
    if (world.small) {
        for (const PairLink& link : record.small.pairs) {
            for (const Manifold& manifold : link.pair->manifolds) {
                if (!manifold.points.empty()) visit(manifold);
            }
        }
        return;
    }
    world.engine->each_manifold([&](const Manifold& manifold) {
        const bool is_own = manifold.a == &record || manifold.b == &record;
        if (is_own && !manifold.points.empty()) visit(manifold);
    });
}

Real closing_mps(const Manifold& manifold) {
    const auto velocity_mps = [](const BodyRecord& record, const Vec3& point) {
        const MotionBefore& before = record.before;
        return before.velocity_mps + glm::cross(before.spin_radps, point - before.at.position_m);
    };
    Real fastest_mps = 0;
    for (const ManifoldPoint& point : manifold.points) {
        if (point.normal_Ns <= 0) continue;
        const Vec3 relative = velocity_mps(*manifold.a, point.b.surface_m) -
                              velocity_mps(*manifold.b, point.b.surface_m);
        fastest_mps = std::max(fastest_mps, -glm::dot(relative, point.normal_world));
    }
    return fastest_mps;
}

/// `per_s`: what an impulse beyond what lasts counts by.
void add_loads(const Manifold& manifold,
               bool on_a,
               double step_s,
               double per_s,
               std::vector<BodyLoad>& loads) {
    double sum_Ns = 0;
    for (const ManifoldPoint& point : manifold.points)
        sum_Ns += static_cast<double>(point.normal_Ns);
    if (sum_Ns <= 0) return;
    const bool lasts = manifold.load.age_steps >= kLasting_steps;
    const double lasting_Ns =
        std::min(lasts ? static_cast<double>(manifold.load.lasting_N) * step_s : 0.0, sum_Ns);
    const double force_per_Ns = (lasting_Ns / step_s + (sum_Ns - lasting_Ns) * per_s) / sum_Ns;
    const double side = on_a ? 1 : -1;
    for (const ManifoldPoint& point : manifold.points) {
        if (point.normal_Ns <= 0) continue;
        const std::array<Vec3, 2> tangents = tangents_of(point.normal_world);
        Vec3d force_N =
            Vec3d(point.normal_world) * static_cast<double>(point.normal_Ns) * force_per_Ns;
        for (std::size_t t = 0; t < 2; ++t)
            force_N += Vec3d(tangents[t]) * static_cast<double>(point.load.friction_N[t]);
        loads.push_back(
            {.point_m = Vec3d((on_a ? point.a : point.b).surface_m), .force_N = side * force_N});
    }
}

void add_loads(const JointRecord& joint,
               const BodyRecord& record,
               double step_s,
               std::vector<BodyLoad>& loads) {
    if (joint.state.broken) return;
    const bool on_a = joint.a == &record;
    const SolverJoint& solver = joint.solver;
    const Transform& at = record.motion->at;
    const Vec3d anchor_m = on_a ? solver.anchor_in_a : solver.anchor_in_b;
    const double side = (on_a ? 1 : -1) / step_s;
    loads.push_back({.point_m = Vec3d(at.position_m) + glm::dmat3(at.rotation) * anchor_m,
                     .force_N = side * solver.total_impulse_Ns,
                     .torque_Nm = side * solver.total_angular_impulse_Nms});
}

}  // namespace

std::vector<BodyLoad> loads_on(const PhysicsWorld& world, BodyId body, double impact_s) {
    const WorldState& state = internals(world);
    const BodyRecord& record = state.body(body);
    // Of Bullet's sub-steps, contacts know the latest.
    const double step_s = state.small ? state.def.step_s : state.def.step_s / state.def.substeps;
    bool is_impact = false;
    each_manifold_of(state, record, [&](const Manifold& manifold) {
        is_impact = is_impact || closing_mps(manifold) > kImpact_mps;
    });
    const double per_s = is_impact ? 1 / impact_s : 1 / step_s;
    std::vector<BodyLoad> loads;
    each_manifold_of(state, record, [&](const Manifold& manifold) {
        add_loads(manifold, manifold.a == &record, step_s, per_s, loads);
    });
    for (const JointId id : record.joints)
        add_loads(*state.joints.get(id), record, state.def.step_s, loads);
    return loads;
}

}  // namespace plumbline::physics
