#include "engine/physics/totals.h"

#include "engine/physics/bullet/body.h"
#include "engine/physics/world/joint_record.h"
#include "engine/physics/world/world_state.h"

#include <algorithm>

namespace plumbline::physics {

std::size_t body_count(const PhysicsWorld& world) {
    return internals(world).bodies.size();
}

std::size_t awake_count(const PhysicsWorld& world) {
    const WorldState& state = internals(world);
    if (state.small) return state.small->bodies.count();
    std::size_t count = 0;
    state.bodies.each([&count](BodyId, const std::unique_ptr<BodyRecord>& record) {
        if (pushable(*record) && is_active(*record)) ++count;
    });
    return count;
}

std::size_t joint_count(const PhysicsWorld& world) {
    return internals(world).joints.size();
}

Energy energy(const PhysicsWorld& world) {
    const Vec3d gravity{world.def().gravity_mps2};
    Energy sum;
    internals(world).bodies.each([&](BodyId, const std::unique_ptr<BodyRecord>& record) {
        if (!pushable(*record)) return;
        const Transform at = record->motion->at;
        const Vec3d v{record->motion->velocity_mps};
        const Vec3d spin{unrotated(record->motion->spin_radps, at.rotation)};
        sum.kinetic_J += 0.5 * record->traits.mass_kg * glm::dot(v, v) +
                         0.5 * glm::dot(record->traits.inertia_kgm2, spin * spin);
        const Vec3d pull_mps2 = gravity * Vec3d{record->traits.gravity_factor};
        sum.potential_J -= record->traits.mass_kg * glm::dot(pull_mps2, Vec3d{at.position_m});
    });
    sum.elastic_J = elastic_energy_J(internals(world).joints);
    return sum;
}

Vec3d momentum_kgmps(const PhysicsWorld& world) {
    Vec3d sum{0, 0, 0};
    internals(world).bodies.each([&](BodyId, const std::unique_ptr<BodyRecord>& record) {
        if (pushable(*record)) sum += record->traits.mass_kg * Vec3d{record->motion->velocity_mps};
    });
    return sum;
}

Vec3d angular_momentum_kgm2ps(const PhysicsWorld& world) {
    Vec3d sum{0, 0, 0};
    internals(world).bodies.each([&](BodyId, const std::unique_ptr<BodyRecord>& record) {
        if (!pushable(*record)) return;
        const Transform at = record->motion->at;
        const Vec3d v{record->motion->velocity_mps};
        const Vec3d body_spin{unrotated(record->motion->spin_radps, at.rotation)};
        const Vec3 own = at.rotation * Vec3{record->traits.inertia_kgm2 * body_spin};
        sum += record->traits.mass_kg * glm::cross(Vec3d{at.position_m}, v) + Vec3d{own};
    });
    return sum;
}

double max_penetration_m(const PhysicsWorld& world) {
    double deepest = 0;
    internals(world).engine->each_manifold([&deepest](const Manifold& manifold) {
        for (const ManifoldPoint& point : manifold.points)
            deepest = std::max(deepest, -static_cast<double>(point.distance_m));
    });
    return deepest;
}

double max_joint_error_m(const PhysicsWorld& world) {
    double most_m = 0;
    internals(world).joints.each([&most_m](JointId, const std::unique_ptr<JointRecord>& record) {
        if (!record->state.broken) most_m = std::max(most_m, record->state.error_m);
    });
    return most_m;
}

JointLoad joint_load(const PhysicsWorld& world, JointId id) {
    const WorldState& state = internals(world);
    const JointRecord& joint = *state.joints.get(id);
    if (joint.state.broken) return {};
    const double step_s = static_cast<double>(state.def.step_s);
    const Vec3d force_N = joint.solver.total_impulse_Ns / step_s;
    const Vec3d torque_Nm = joint.solver.total_angular_impulse_Nms / step_s;
    const auto moment_of = [](const BodyRecord* body, const Vec3d& anchor, const Vec3d& force) {
        if (body == nullptr) return Vec3d{0, 0, 0};
        return glm::cross(Vec3d(body->motion->at.rotation * Vec3(anchor)), force);
    };
    return {.force_on_a_N = force_N,
            .torque_on_a_Nm = torque_Nm + moment_of(joint.a, joint.solver.anchor_in_a, force_N),
            .torque_on_b_Nm = moment_of(joint.b, joint.solver.anchor_in_b, -force_N) - torque_Nm};
}

int most_substeps(const PhysicsWorld& world) {
    int most = world.def().substeps;
    for (const IslandReport& island : world.report().islands)
        most = std::max(most, island.substeps);
    return most;
}

}  // namespace plumbline::physics
