// A joint between two bodies, or a body and the world, as it is asked for and as a step left it.
#pragma once

#include "engine/physics/body.h"

#include <array>
#include <cstdint>
#include <optional>

namespace plumbline::physics {

struct JointTag;
using JointId = Id<JointTag>;

enum class JointKind : std::uint8_t {
    BallAndSocket,  ///< the anchors coincide
    Hinge,          ///< ... and the bodies turn about one axis only
    Slider,         ///< the bodies move along one axis only and do not turn
    Fixed,          ///< as if glued
    Cone,           ///< a ball joint whose axis stays within a cone; twist may be bounded too
    Distance,       ///< the anchors keep a distance, or one between limits
    Spring,         ///< the anchors are pulled towards a distance
    Elastic,  ///< the anchors are pulled together and the bodies turned back: a piece of a rod
};

/// Drives a hinge or a slider with at most a torque or force. Without stiffness and damping it takes what the target speed
/// takes; with one of them it pushes as a spring and a damper do, stiffness * (position - where the joint is) + damping *
/// (target - its speed), by implicit Euler.
struct JointMotor {
    Real target{0};     ///< rad/s or m/s, of a against b
    Real max{0};        ///< N m or N; >= 0
    Real stiffness{0};  ///< N m/rad or N/m; >= 0
    Real damping{0};    ///< N m s/rad or N s/m; >= 0
    Real position{0};   ///< rad or m, as JointState::position
    bool by_mass{
        false};  ///< both are times the mass that the joint's axis moves, or its moment of inertia
    Real turn_rad{0};  ///< Slider: how far a is held turned against b about the axis; 0 at creation
};

/// How small_step solves the joints of an island.
enum class JointMethod : std::uint8_t {
    Direct,     ///< one sparse factorisation a sub-step, exact
    Iterative,  ///< one block after the other, soft as h allows: cheaper for nets of thousands
};

/// A joint as it is asked for, with the bodies where they are now. Copied.
///
/// Angles and displacements are of a against b along `axis_world`, right-handed, zero at creation.
struct JointDef {
    JointKind kind{JointKind::BallAndSocket};
    BodyId a{};
    BodyId b{};  ///< null: the world
    Vec3 anchor_a_world{0, 0, 0};
    Vec3 anchor_b_world{0, 0, 0};  ///< same as a's but for Distance, Spring and Elastic
    Vec3 axis_world{0, 1, 0};      ///< Hinge, Slider, Cone; any length but 0
    /// rad (Hinge, which counts its turns: any range), m (Slider, Distance: of the distance), rad
    /// (Cone: the larger magnitude is the angle at most between a's axis and b's). None: free;
    /// Distance: rest_length_m.
    std::optional<std::array<Real, 2>> limits{};
    std::optional<std::array<Real, 2>> twist_limits{};  ///< rad, Cone only
    std::optional<JointMotor> motor{};                  ///< Hinge, Slider
    Real stiffness_Npm{0};  ///< Spring; Elastic: along any direction, or 0: the anchors coincide
    Real damping_Nspm{0};   ///< Spring
    std::optional<Real> rest_length_m{};  ///< Spring, Distance; none: the distance at creation
    Real bend_Nmprad{0};                  ///< Elastic: of bending and twist alike; 0: free
    Real damping_s{0};                    ///< Elastic: of the material, as a time
    /// Elastic, small_step: how fast a loses its spin while something jointed touches something. What presses light bodies hard
    /// makes them roll away under it, as no rope does that would have to twist for it.
    Real pressed_decay_per_s{0};
    int substeps{0};        ///< Elastic, small_step: the least that its bodies get
    bool straight{false};   ///< Elastic: at rest the principal axes are parallel; else as now
    bool collide{false};    ///< whether a and b still touch each other
    Real break_N{0};        ///< breaks when it carried more over a step; 0: never
    std::uint64_t user{0};  ///< the caller's own mark
};

/// What the latest step left of a joint.
struct JointState {
    /// How far the joint is from what it forbids: the gap between the anchors (m) or, where it is
    /// more, the misalignment in rad times 1 m; limits count once they are passed.
    double error_m{0};
    Real force_N{0};  ///< mean over the step of what it carried, without torques
    Real torque_Nm{0};
    /// rad (Hinge), m (Slider: displacement; Distance, Spring: length), rad (Cone: the angle
    /// between the axes); 0 else.
    Real position{0};
    bool broken{false};  ///< carries nothing any more
};

/// A joint of a world; valid until it is destroyed.
struct JointView {
    const JointDef& def;  ///< as asked for, with the motor as it is now
    const JointState& state;
};

}  // namespace plumbline::physics
