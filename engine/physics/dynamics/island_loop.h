// The sub-steps of one island. Knows nothing of Bullet.
//
// Every sub-step: bounce; forces and the impulses of the sub-step before; sweep with bias; move;
// put joints right; relax. docs/PHYSICS.md says why in this order.
#pragma once

#include "engine/physics/dynamics/contact/contact_set.h"
#include "engine/physics/dynamics/energy_guard.h"
#include "engine/physics/dynamics/field_forces.h"
#include "engine/physics/dynamics/impact/impact_pass.h"
#include "engine/physics/dynamics/joint/joint_system.h"

#include <vector>

namespace plumbline::physics {

struct LoopSettings {
    double step_s{1.0 / 60.0};
    double start_s{0};  ///< since the start of the step that this is a part of
    int substeps{4};
    double spring_s{0};    ///< a sub-step that contacts are made for; 0: those of the step
    int iterations{1};     ///< sweeps of each kind per sub-step
    Real gravity_mps2{0};  ///< its magnitude: what is slower than a fall of two sub-steps rests
    Real push_mps{3};      ///< the fastest that penetration pushes bodies apart
    bool gyroscopic_torque{true};
    JointMethod joint_method{JointMethod::Direct};
    Team* team{nullptr};  ///< none: the caller alone works
};

/// What the step showed of how hard the island is.
struct LoopReport {
    std::uint64_t row_solves{0};
    std::uint32_t impacts{0};
    double max_joint_error_m{0};
    double braked_J{0};               ///< more energy than can have been, taken out
    std::uint32_t clamped_bodies{0};  ///< pushed apart too fast, and slowed
    bool unresolved_joints{false};    ///< swung too fast for a sub-step: light bodies were slowed
};

/// A body that moves along some of the world's axes only.
struct HeldBody {
    std::uint32_t body{0};        ///< index in IslandLoop::bodies
    Vec3 linear_factor{1, 1, 1};  ///< 0 along the others
};

class IslandLoop {
public:
    std::vector<SolverBody> bodies;  ///< the first is the world
    std::vector<HeldBody> held;
    ContactSet contacts;
    std::vector<Real>
        touching_m;  ///< of each constraint: nearer is touching, where an impact is solved
    std::vector<SolverJoint> joints;
    FieldForces fields;

    /// Empties the island; keeps the memory.
    void clear();
    /// Moves bodies for one step. Velocities, `delta_position_m`, `delta_rotation`, impulses and joints are left as
    /// the step ends.
    LoopReport run(const LoopSettings& settings);
    /// Changes velocities alone, by the impacts of all that touches or meets within `settings.step_s`, faster than a fall
    /// of two `rest_s`.
    LoopReport run_impacts(const LoopSettings& settings, Real rest_s);

private:
    void substep(int number);
    void solve_velocities();
    void relax();

    LoopSettings settings_{};
    Real h_{0};
    EnergyGuard guard_;
    ImpactPass impacts_;
    JointSystem joint_system_;
    LoopReport report_{};
};

}  // namespace plumbline::physics
