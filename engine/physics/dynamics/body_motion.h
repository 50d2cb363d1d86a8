// How one body moves in a step when no solver moves it.
#pragma once

#include "engine/core/math.h"
#include "engine/physics/dynamics/solver_body.h"
#include "engine/physics/physics_world.h"
#include "engine/physics/transform.h"

#include <cstdint>

namespace plumbline::physics {

struct BodyRecord;

/// The state of a body carried in double precision from step to step: rounding each to float32
/// would cost 1e-5 m within a second at 240 Hz.
struct BallisticState {
    Vec3d position_m{0, 0, 0};
    Vec3d velocity_mps{0, 0, 0};
    Quatd orientation{1, 0, 0, 0};
    Vec3d spin_radps{0, 0, 0};
    bool going{false};  ///< the numbers of BodyMotion are the ones above, rounded
};

/// What a step moves of a body, and what gives way when it is pushed. Everybody else reads it here;
/// Bullet gets a copy of the pose at the end of a step.
struct BodyMotion {
    Transform at{};  ///< mass frame
    Vec3 velocity_mps{0, 0, 0};
    Vec3 spin_radps{0, 0, 0};
    Real inverse_mass{0};           ///< 1/kg; 0: gives way to nothing
    Vec3 inverse_moments{0, 0, 0};  ///< 1/(kg m2), principal
    BallisticState ballistic{};     ///< the same pose and velocities, with more digits

    /// `arm`: from the centre of mass, world axes.
    Vec3 velocity_at(const Vec3& arm) const { return velocity_mps + glm::cross(spin_radps, arm); }
};

/// None of what is no belt.
SurfaceMotion surface_motion(const BodyRecord& record);

/// Along the world's axes.
SymmetricMat3 inverse_inertia_of(const BodyMotion& motion);
/// Change of spin per second, or by an angular impulse.
Vec3 angular_gain(const BodyMotion& motion, const Vec3& torque_Nm);

/// v shortened to `limit`, whatever its size; numbers that are not finite stay.
Vec3 limited(const Vec3& v, Real limit);
/// Shortens velocities beyond the limits of the world (body_record.h). Whether one was.
bool limit_speed(BodyRecord& record);

/// Whether the body turns so that its gyroscopic torque shows.
bool feels_gyro(const BodyRecord& record, const WorldFeatures& features);

/// Moves a body that nothing touches along the closed form of v' = g + f/m - k v, from where
/// record.before says. Its spin must already hold its share of damping, and torques. Leaves the
/// turning of bodies that feel the gyroscopic torque to turn_freely().
void integrate_ballistic(BodyRecord& record,
                         const Vec3d& gravity_mps2,
                         const WorldFeatures& features,
                         double duration_s);

/// Torque-free turning; the momentum is kept.
void turn_freely(BodyRecord& record, double duration_s);

/// Moves a kinematic body by its velocities, or to its target.
void integrate_kinematic(BodyRecord& record, bool to_target, Real duration_s);

}  // namespace plumbline::physics
