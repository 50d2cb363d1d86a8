// A body's side in Bullet, in plain types. Poses are of the mass frame: at the centre of mass, along
// the principal axes. Velocities and forces have world axes.
#pragma once

#include "engine/core/pose.h"
#include "engine/physics/body.h"
#include "engine/physics/transform.h"

namespace plumbline::physics {

struct BodyRecord;
struct ShapeRecord;

/// Gives a record that knows its kind and factors the rigid body that the definition asks for, with
/// its masses, radii and CCD spheres.
void give_rigid_body(BodyRecord& record, const BodyDef& def, const ShapeRecord& shape);
/// Immovable for as long as it is frozen.
void set_rigid_mass(BodyRecord& record, bool frozen);

/// Bullet's copy of the pose: used by contacts, casts and drawing.
void write_rigid_pose(const BodyRecord& record);
/// bullet_*: ... with velocities, and the inertia along the world's axes.
void write_rigid_motion(const BodyRecord& record);
/// bullet_*: what its solver made of them.
void read_rigid_motion(BodyRecord& record);
/// bullet_*: velocities and forces that a step starts with.
void write_rigid_start(const BodyRecord& record);

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

}  // namespace plumbline::physics
