// A world's bodies and joints as plain data, for engines that are not ours; and how well poses that another
// engine found fit together.
#pragma once

#include "engine/physics/body.h"
#include "engine/physics/joint.h"

#include <vector>

namespace plumbline::physics {

class PhysicsWorld;

/// All in the mass frame: at the centre of mass, along the principal axes of inertia.
struct BodyCopy {
    BodyId id{};
    BodyKind kind{BodyKind::Static};  ///< what is frozen is static
    /// Boxes, spheres, cylinders, capsules, cones, hulls; or one mesh. `body_from_child` leads to the mass frame.
    std::vector<CompoundChild> parts{};
    Pose world_from_mass{};
    double mass_kg{0};
    Vec3d inertia_kgm2{0, 0, 0};  ///< principal
    Real friction{0};             ///< combined as sqrt(a*b)
    Real restitution{0};          ///< combined as max(a, b)
    Real rolling_friction_m{0};
    Real spinning_friction_m{0};
    double linear_damping_per_s{0};
    double angular_damping_per_s{0};
    Vec3 linear_factor{1, 1, 1};
    Vec3 gravity_factor{1, 1, 1};  ///< the linear factor in it
    CombineRule friction_rule{CombineRule::Usual};
    CombineRule restitution_rule{CombineRule::Usual};
    bool can_sleep{true};
    bool is_belt{false};     ///< its surface moves along itself
    bool always_ccd{false};  ///< its definition asks for continuous collision in every step
    CollisionFilter filter{};
    std::vector<PartTraits> part_traits{};  ///< of `parts`; empty: all are as the body
};

struct WorldCopy {
    std::vector<BodyCopy> bodies;  ///< in the order of their ids
    std::vector<JointDef> joints;  ///< as they were asked for; anchors are those of their creation
};

WorldCopy copy_of(const PhysicsWorld& world);

/// How far bodies are inside each other where they stand now, found anew, and joints from what they hold.
struct PoseFaults {
    double penetration_m{0};
    double joint_error_m{0};
};
/// What joints say of themselves is of these poses from now on. Hinges count their turns from one call to the next, half a turn
/// between two at most.
PoseFaults pose_faults(PhysicsWorld& world);

}  // namespace plumbline::physics
