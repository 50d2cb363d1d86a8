// Bodies that push each other, as one step finds them, and what solves them.
#pragma once

#include "engine/physics/physics_world.h"
#include "engine/physics/world/joint_record.h"

#include <btBulletDynamicsCommon.h>

#include <limits>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace plumbline::physics {

/// Dynamic bodies connected by touching pairs and joints. Static and kinematic bodies bound an
/// island and belong to none. Everything is in an order that only ids decide.
struct Island {
    std::vector<BodyRecord*> bodies;               ///< dynamic, awake
    std::vector<btPersistentManifold*> manifolds;  ///< with at least one point
    std::vector<JointRecord*> joints;              ///< not broken
    bool supported{false};                         ///< something that bounds it touches or holds it
    bool carried{false};                           ///< ... and moves: a kinematic body

    void clear() {
        bodies.clear();
        manifolds.clear();
        joints.clear();
        supported = false;
        carried = false;
    }
};

/// What solving an island needs to know of the step.
struct IslandStep {
    double step_s{1.0 / 60.0};
    Vec3d gravity_mps2{0, 0, 0};
    int substeps_least{1};
    int substeps_most{1};
    int iterations{1};  ///< sweeps of bias and of relaxation per sub-step
    JointMethod joints{JointMethod::Direct};
    WorldFeatures features{};
    StepCost* cost{nullptr};
    FeatureUse* use{nullptr};
};

/// The normal impulse at a contact point over the whole step, N s. `m_appliedImpulse` and its two
/// lateral brothers hold mean forces of the latest sub-step in N instead: what the next step starts
/// from, however long its sub-steps are. Bullet leaves this field to solvers and keeps it.
inline btScalar frame_impulse_Ns(const btManifoldPoint& point) {
    return point.m_contactMotion1;
}
inline void set_frame_impulse(btManifoldPoint& point, btScalar impulse_Ns) {
    point.m_contactMotion1 = impulse_Ns;
}

/// A manifold's m_companionIdA while the solver remembers nothing of it.
inline constexpr int kUnknownToSolver = std::numeric_limits<int>::max();

/// Solves islands that touch or are joined: moves the bodies (Bullet's transforms and
/// BodyRecord::flight), leaves velocities, impulses on the manifold points and joint states.
class IslandSolver {
public:
    IslandSolver();
    ~IslandSolver();
    void begin_step();  ///< before the islands of a step
    IslandReport solve(Island& island, const IslandStep& step);
    /// What contacts carried in the latest step. `manifolds`: of all pairs.
    void serialize(Archive& archive, std::span<btPersistentManifold* const> manifolds);

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace plumbline::physics
