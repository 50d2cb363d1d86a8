// A body's side in Bullet, in plain types. Poses are of the mass frame: at the centre of mass, along
// the principal axes. Velocities and forces have world axes.
#pragma once

#include "engine/core/pose.h"
#include "engine/physics/body.h"
#include "engine/physics/collision/manifold.h"
#include "engine/physics/dynamics/solver_body.h"
#include "engine/physics/dynamics/transform.h"

namespace plumbline::physics {

struct BodyRecord;
struct ShapeRecord;

/// Gives a record that knows its kind and factors the rigid body that the definition asks for, with
/// its masses, radii and CCD spheres.
void give_rigid_body(BodyRecord& record, const BodyDef& def, const ShapeRecord& shape);
/// Immovable for as long as it is frozen.
void set_rigid_mass(BodyRecord& record, bool frozen);

Transform rigid_transform(const BodyRecord& record);
Vec3 rigid_position(const BodyRecord& record);
void set_rigid_transform(BodyRecord& record, const Transform& to);

Vec3 linear_velocity(const BodyRecord& record);
Vec3 angular_velocity(const BodyRecord& record);
bool stands_still(const BodyRecord& record);
void set_linear_velocity(BodyRecord& record, const Vec3& velocity_mps);
void set_angular_velocity(BodyRecord& record, const Vec3& spin_radps);

Real inverse_mass_of(const BodyRecord& record);  ///< 1/kg; 0: gives way to nothing
SymmetricMat3 inverse_inertia_of(const BodyRecord& record);
Vec3 inverse_moments_of(const BodyRecord& record);  ///< principal
/// Change of spin per second that a torque makes.
Vec3 angular_gain(const BodyRecord& record, const Vec3& torque_Nm);

Vec3 total_force_N(const BodyRecord& record);
Vec3 total_torque_Nm(const BodyRecord& record);
void add_force(BodyRecord& record, const Vec3& force_N);
void add_torque(BodyRecord& record, const Vec3& torque_Nm);
void clear_forces(BodyRecord& record);
/// `arm` from the centre of mass.
void add_impulse(BodyRecord& record, const Vec3& impulse_Ns, const Vec3& arm);

/// What Bullet's own solvers and its drawing take a body for.
enum class Activity : std::uint8_t { Awake, Asleep };
bool is_active(const BodyRecord& record);
/// Of one that may sleep, or never does.
void set_activity(BodyRecord& record, Activity activity);
void wake_rigid_body(BodyRecord& record);

/// The box along the world's axes round the shape where it is now.
struct Box {
    Vec3 low{0, 0, 0};
    Vec3 high{0, 0, 0};
};
Box box_of(const BodyRecord& record);

void set_rigid_friction(BodyRecord& record, Real friction);
void set_rigid_restitution(BodyRecord& record, Real restitution);
/// What the materials of the two bodies make.
PairMaterial material_of(const BodyRecord& a, const BodyRecord& b);

}  // namespace plumbline::physics
