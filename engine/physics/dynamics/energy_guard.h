// No contact gives more motion than gravity, forces and what was there can have given.
#pragma once

#include "engine/physics/dynamics/contact/contact_constraint.h"
#include "engine/physics/dynamics/field_forces.h"
#include "engine/physics/dynamics/joint/joint_system.h"

#include <span>

namespace plumbline::physics {

/// Contacts are found once a step. A body that turns far within it (a whirling rod, a coin on its
/// edge) carries its points along to where it touches nothing, and what acts there may do work from
/// nothing. Islands that no machine drives are held to their budget: kinetic energy at the start,
/// plus the work of gravity, the callers' forces and springs, plus a share for honest errors of the
/// step; what is above is taken out of all their motion about the common centre, or about the ground
/// where they touch what never moves. The centre of those that touch nothing moves as what acts from
/// outside says: joints that act on bodies heavier than themselves (geometric_stiffness.h) push it.
///
/// Where nothing may take energy either (ideal joints without limits, springs, damping and contacts, held by what never moves) a
/// step that lost or gained more than 1e-4 of its motion is put back on its budget: a light chain that snaps under a heavy weight
/// moves faster within a sub-step than that can follow (projection onto an invariant: Hairer, Lubich and Wanner, Geometric
/// Numerical Integration, IV.4). Its velocities are scaled together, so the joints still allow them.
class EnergyGuard {
public:
    /// Before the step's first sub-step. `joint_speed`: how fast the joints' rows change, m/s or rad/s (JointSystem::most_speed).
    /// `h`: the sub-step, s.
    void begin(std::span<const SolverBody> bodies,
               std::span<const ContactConstraint> contacts,
               std::span<const SolverJoint> joints,
               double joint_speed,
               Real h);
    /// After the last: what was too much and was taken out, J; 0: nothing. `fields`: what they did meanwhile.
    double end(std::span<SolverBody> bodies,
               std::span<const SolverJoint> joints,
               const FieldWork& fields,
               double step_s) const;

private:
    bool watches_{false};
    bool grounded_{false};
    bool joined_{false};
    bool conserves_{false};      ///< neither gives nor takes
    double start_J_{0};          ///< kinetic
    double elastic_J_{0};        ///< in springs at the start
    Vec3d center_mps_{0, 0, 0};  ///< velocity of the common centre at the start
    double share_{0};            ///< of the start's energy that a step may err by
    double slack_J_{0};
};

}  // namespace plumbline::physics
