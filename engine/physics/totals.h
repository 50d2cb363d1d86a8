// Totals over a world as it is now. Each walks all bodies, joints or contact points.
#pragma once

#include "engine/physics/contact.h"
#include "engine/physics/joint.h"

#include <cstddef>
#include <vector>

namespace plumbline::physics {

class PhysicsWorld;

struct Energy {
    double kinetic_J{0};
    double potential_J{0};  ///< m*g*h above the plane through the origin, against gravity
    double elastic_J{0};    ///< what springs hold

    double total_J() const { return kinetic_J + potential_J + elastic_J; }
};

std::size_t body_count(const PhysicsWorld& world);
std::size_t awake_count(const PhysicsWorld& world);
std::size_t joint_count(const PhysicsWorld& world);  ///< broken ones included

Energy energy(const PhysicsWorld& world);
Vec3d momentum_kgmps(const PhysicsWorld& world);
Vec3d angular_momentum_kgm2ps(const PhysicsWorld& world);  ///< about the world's origin

/// Deepest contact point of the latest step; 0 if none.
double max_penetration_m(const PhysicsWorld& world);
double max_joint_error_m(const PhysicsWorld& world);  ///< of joints that are not broken

/// What a joint did to its bodies in the latest step of small_step, as a mean over it, world axes; torques about their centres
/// of mass. Zero once it is broken.
struct JointLoad {
    Vec3d force_on_a_N{0, 0, 0};  ///< on b the opposite
    Vec3d torque_on_a_Nm{0, 0, 0};
    Vec3d torque_on_b_Nm{0, 0, 0};
};
JointLoad joint_load(const PhysicsWorld& world, JointId id);

/// Every touching pair whether or not a body asked for events, for state files.
std::vector<ContactEvent> all_contacts(const PhysicsWorld& world);
/// The most sub-steps that any island got in the latest step; what is asked for where none was.
int most_substeps(const PhysicsWorld& world);

}  // namespace plumbline::physics
