// A rigid body as it is asked for, and as it is found after a step.
#pragma once

#include "engine/core/id.h"
#include "engine/core/pose.h"
#include "engine/physics/shape.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace plumbline::physics {

struct BodyTag;
using BodyId = Id<BodyTag>;

enum class BodyKind : std::uint8_t {
    Static,     ///< never moves
    Dynamic,    ///< moved by forces and contacts
    Kinematic,  ///< moved by the caller; pushes others, is pushed by none
};

/// When a body is swept along its path instead of jumping a step at a time.
enum class ContinuousCollision : std::uint8_t {
    Auto,  ///< only in steps in which it moves more than its own inner radius
    On,    ///< in every step
    Off,
};

/// Which bodies touch each other; both must agree.
struct CollisionFilter {
    std::uint32_t group{1};            ///< one bit
    std::uint32_t collides_with{~0U};  ///< groups
};

inline bool may_touch(const CollisionFilter& a, const CollisionFilter& b) {
    return (a.group & b.collides_with) != 0 && (b.group & a.collides_with) != 0;
}

/// How the coefficients of two bodies that touch become one: by the later of their two rules (as in glTF's
/// KHR_physics_rigid_bodies).
enum class CombineRule : std::uint8_t {
    Usual,  ///< friction as sqrt(a*b), restitution as max(a, b)
    Multiply,
    Maximum,
    Minimum,
    Average,
};

/// What a body is made of, as its contacts feel it, or what two materials make together.
struct Material {
    Real friction{0};
    Real restitution{0};
    Real rolling_m{0};   ///< torque against rolling per newton pressed
    Real spinning_m{0};  ///< ... against spinning about the normal
    CombineRule friction_rule{CombineRule::Usual};
    CombineRule restitution_rule{CombineRule::Usual};
};

/// What a part of a compound shape is made of and what it touches.
struct PartTraits {
    Material material{};
    CollisionFilter filter{};
};

/// A rigid body as it is asked for. Copied; need not outlive the call. The pose is of the body's
/// origin, not of its centre of mass.
struct BodyDef {
    BodyKind kind{BodyKind::Static};
    ShapeId shape{};
    Pose world_from_body{};
    Real mass_kg{1};                         ///< dynamic only; > 0
    std::optional<Vec3> inertia_kgm2{};      ///< principal; none: of the shape
    Quat body_from_inertia{1, 0, 0, 0};      ///< unit; the axes that inertia_kgm2 is about
    std::optional<Vec3> center_of_mass_m{};  ///< body frame; none: of the shape
    Vec3 velocity_mps{0, 0, 0};              ///< of the body's origin
    Vec3 angular_velocity_radps{0, 0, 0};    ///< world axes
    /// Static and kinematic bodies: how fast their surface moves along itself, body frame: a belt; and turns about the
    /// body's origin: a turntable that stands still. small_step only.
    Vec3 surface_velocity_mps{0, 0, 0};
    Vec3 surface_spin_radps{0, 0, 0};
    Real friction{0.5_r};  ///< combined as sqrt(a*b), or as the rule says
    Real rolling_friction{0};
    Real spinning_friction{0};
    Real restitution{0};  ///< 0…1, combined as max(a, b), or as the rule says
    CombineRule friction_rule{CombineRule::Usual};
    CombineRule restitution_rule{CombineRule::Usual};
    Real linear_damping_per_s{0};  ///< speed decays as exp(-damping * t)
    Real angular_damping_per_s{0};
    Vec3 linear_factor{1, 1, 1};  ///< dynamic; world axes: 1 is free, 0 keeps its place along it
    Real gravity_factor{1};       ///< dynamic; times the world's gravity
    bool can_sleep{true};
    ContinuousCollision ccd{ContinuousCollision::Auto};
    bool contact_events{false};  ///< list this body's contacts in StepReport::contacts
    CollisionFilter filter{};
    /// Of the parts of a compound shape, in its order; empty: all are as the body says. Where it is not, the body's filter
    /// lets through what any part's does. small_step only: others go by the body.
    std::vector<PartTraits> parts{};
    std::uint64_t user{0};  ///< the caller's own mark, handed back in hits and events
};

/// How a surface moves along itself, beyond its body's motion: at the centre of mass, and about it; world axes.
struct SurfaceMotion {
    Vec3 velocity_mps{0, 0, 0};
    Vec3 spin_radps{0, 0, 0};
};

/// What the body weighs.
struct MassProperties {
    Real mass_kg{0};                 ///< 0: immovable
    Vec3 inertia_kgm2{0, 0, 0};      ///< principal, about the centre of mass
    Vec3 center_of_mass_m{0, 0, 0};  ///< body frame
};

/// A body as it is now.
struct BodyState {
    Pose world_from_body{};
    Vec3 velocity_mps{0, 0, 0};            ///< of the body's origin
    Vec3 angular_velocity_radps{0, 0, 0};  ///< world axes
    bool awake{true};
    bool frozen{false};
    BodyKind kind{BodyKind::Static};
    CollisionFilter filter{};
    std::uint64_t user{0};
    MassProperties mass{};

    bool pushable() const { return kind == BodyKind::Dynamic && !frozen; }  ///< by forces
    Vec3 center_of_mass_world() const {
        return transform_point(world_from_body, mass.center_of_mass_m);
    }
};

}  // namespace plumbline::physics
