// Where the two sides of a joint are against each other. Knows nothing of Bullet.
//
// Each side has a frame whose x axis is the joint's axis; both coincide at creation. Angles and
// displacements are of a against b about b's x axis, right-handed, zero at creation.
#pragma once

#include "engine/physics/dynamics/joint/joint_system.h"

namespace plumbline::physics {

/// Where a body's centre of mass and principal axes are. Of the world itself: the default.
struct MassPose {
    Vec3d position_m{0, 0, 0};
    Quatd orientation{1, 0, 0, 0};  ///< world from mass frame
};

/// The joint that holds two bodies as they are now: geometry and numbers of the definition, no
/// impulses, `a`, `b` and `key` left as they are by default.
SolverJoint placed_joint(const JointDef& def, const MassPose& a, const MassPose& b);

/// What one side is to the other.
struct JointSides {
    Vec3d gap_m{0, 0, 0};         ///< from b's anchor to a's, world axes
    Vec3d axis_a{1, 0, 0};        ///< x axis of a's frame, world axes
    Vec3d axis_b{1, 0, 0};        ///< of b's frame
    Quatd turned{1, 0, 0, 0};     ///< a's frame seen from b's; no rotation at creation
    double along_m{0};            ///< gap along b's axis
    double across_m{0};           ///< gap across it
    double angle_between_rad{0};  ///< of the two axes, 0 to pi
};
JointSides joint_sides(const SolverJoint& joint, const MassPose& a, const MassPose& b);

/// How far a rotation turns about x once the shortest swing of the x axis is taken out; -pi to pi.
double twist_about_x(const Quatd& rotation);
/// The angle that differs from `angle_rad` by whole turns and is nearest to `near_rad`.
double unwrapped(double angle_rad, double near_rad);

struct JointFit {
    double error_m{0};   ///< as JointState
    double position{0};  ///< as JointState
};
/// A hinge's angle is counted on from joint.position, which is that of the step before: it goes on
/// past half a turn as long as no step turns it by more.
JointFit joint_error(const SolverJoint& joint, const MassPose& a, const MassPose& b);
/// What a spring or an elastic joint holds.
double stored_J(const SolverJoint& joint, const MassPose& a, const MassPose& b);

}  // namespace plumbline::physics
