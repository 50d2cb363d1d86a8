// The touching points of one pair of bodies that share a normal, as the solver's rows.
//
// Up to four points, one to a lane: what the sweeps do four times, one vector instruction does. The points' normal impulses are solved together; their
// friction is one force and one twist at the centre of the load.
#pragma once

#include "engine/physics/dynamics/contact/lanes.h"
#include "engine/physics/dynamics/joint/softness.h"
#include "engine/physics/dynamics/solver_body.h"

#include <cmath>
#include <cstdint>

namespace plumbline::physics {

/// 1/(kg m2): of both bodies about an axis.
inline Real inverse_moment_along(const SolverBody& a, const SolverBody& b, const Vec3& axis) {
    return glm::dot(axis, a.inverse_inertia * axis) + glm::dot(axis, b.inverse_inertia * axis);
}

/// Four points on a face are one more than it takes to hold a body, and two on one spot one: what keeps the matrix of rigid
/// points from being singular, as a share of its diagonal.
inline constexpr Real kRedundancy = 0.01_r;

/// A separation no lane without a point can ever close.
inline constexpr Real kNoPoint_m = 1e6_r;

/// More than twenty fields because the sweeps go through constraints from the first byte to the last: parts apart
/// would be cache lines apart.
struct ContactConstraint {
    std::uint32_t a{kWorldBody};
    std::uint32_t b{kWorldBody};
    std::int32_t count{0};  ///< lanes in use
    bool against_immovable{false};
    bool face_turns{
        false};  ///< rounded against a flat face of a movable body, which takes the normal along
    bool rolls{false};    ///< has axis_a or axis_b
    bool jointed{false};  ///< a joint holds a or b: its solution moves them again
    bool bounced{false};  ///< off in this sub-step: on its way out, at the speed it should have
    std::uint32_t belt{
        0};  ///< one more than b's number in ContactSet::belts; 0: b's surface moves as b does
    std::uint32_t row_solves{0};  ///< rows times sweeps of this step
    Vec3 normal{0, 1, 0};         ///< from b to a
    /// A rounded side (sphere, capsule, side of a cylinder) is the sphere that touches: `offset` is its
    /// centre and its surface is `radius` nearer to the other body. Other sides have radius 0.
    Real radius_a{0};
    Real radius_b{0};

    // Filled by prepare().
    LaneVec3 angular_a{};  ///< arm x normal
    LaneVec3 angular_b{};
    Lanes separation_m{};
    Lanes compliance{};       ///< of soft rows, 1/kg
    LaneMatrix soft_mass{};   ///< all points penetrating, with bias
    LaneMatrix rigid_mass{};  ///< all points pressing, without

    // Geometry at the step's start, world axes.
    LaneVec3 offset_a{};  ///< centre of mass to the point or the centre of the sphere
    LaneVec3 offset_b{};
    Lanes start_separation_m{kNoPoint_m, kNoPoint_m, kNoPoint_m, kNoPoint_m};

    Lanes normal_Ns{};  ///< of the present sub-step
    Lanes before_Ns{};  ///< of the sub-step before, as far as it goes on
    Lanes total_Ns{};   ///< summed over the step

    // Friction: at the centre of the load, limited together by an ellipsoid.
    Vec3 tangent[2]{};
    Vec3 center_a{0, 0, 0};  ///< arms of the centre
    Vec3 center_b{0, 0, 0};
    /// Change of the slip per impulse, 1/kg: along both tangents, and along one by an impulse along the other.
    Real slip_response[2]{0, 0};
    Real slip_coupling{0};
    Real twist_mass{0};
    Real twist_arm_m{0};  ///< mean distance of the load from its centre
    Real tangent_Ns[2]{0, 0};
    Real twist_Nms{0};
    Vec3 rolling_Nms{0, 0, 0};
    /// Normal load of the sub-step before, of all the pair's constraints; in the first of them.
    Real load_before_Ns{0};
    Real friction{0};
    Real restitution{0};
    Real rolling_m{0};   ///< torque against rolling per newton pressed
    Real spinning_m{0};  ///< ... against spinning about the normal

    LaneMatrix response{};  ///< A: change of closing speed per impulse, 1/kg

    // At the step's start, read where bodies turn.
    Vec3 start_normal{0, 1, 0};
    Vec3 center_offset_a{0, 0, 0};  ///< as offset_a and offset_b, of the centre of friction
    Vec3 center_offset_b{0, 0, 0};
    /// Of a side that is round about an axis through its centre of mass (rims, cones) that axis, world, at the step's start; else
    /// zero. Its points stay where they are as it rolls.
    Vec3 axis_a{0, 0, 0};
    Vec3 axis_b{0, 0, 0};

    /// Whether friction or rolling resistance still holds an impulse.
    bool holds_friction() const {
        return tangent_Ns[0] != 0 || tangent_Ns[1] != 0 || twist_Nms != 0 ||
               rolling_Nms != Vec3{0, 0, 0};
    }
    bool spheres() const { return radius_a > 0 && radius_b > 0 && count == 1; }
    bool rounded() const { return radius_a > 0 || radius_b > 0; }
    /// Nothing but whole spheres against what is flat or a sphere: turning does not move the surface.
    bool whole_spheres() const {
        const auto whole = [](Real radius, const LaneVec3& offset) {
            const Vec3 center = lane(offset, 0);
            return radius == 0 || glm::dot(center, center) < radius * radius * 1e-4_r;
        };
        return rounded() && count == 1 && whole(radius_a, offset_a) && whole(radius_b, offset_b);
    }
    /// How far the place of contact moved over the side that is not round, by how a moved against b
    /// since the start. The masses are those of the start: a sphere shot past by more than twice its
    /// size is not weighed there.
    Vec3 shift_of(const Vec3& moved) const {
        const Real most = 2 * (radius_a + radius_b);
        const Real length2 = glm::dot(moved, moved);
        return length2 > most * most ? moved * (most / std::sqrt(length2)) : moved;
    }
};

/// Arms, masses and the centre of friction from the constraint's geometry and impulses, at the step's start. `a` and `b` are
/// its bodies, `soft` how penetration gives way; `sharing` (1: it alone) constraints have that stiffness
/// between them.
void prepare(ContactConstraint& constraint,
             const SolverBody& a,
             const SolverBody& b,
             const Softness& soft,
             Real sharing);
/// Turns the normal, and the tangents by the shortest way with it.
void turn_normal(ContactConstraint& constraint, const Vec3& normal);
/// Whether follow() may find other arms than prepare() did.
bool arms_turn(const ContactConstraint& constraint, const SolverBody& a, const SolverBody& b);
/// Separations, arms and normal where the bodies have gone to since the step's start.
void follow(ContactConstraint& constraint, const SolverBody& a, const SolverBody& b);
/// From the bodies' centres of mass to where point `i` touches now.
struct PointArms {
    Vec3 a{0, 0, 0};
    Vec3 b{0, 0, 0};
};
PointArms arms_of(const ContactConstraint& constraint,
                  const SolverBody& a,
                  const SolverBody& b,
                  int i);
/// Masses for the present arms and inertias.
void weigh_anew(ContactConstraint& constraint, const SolverBody& a, const SolverBody& b);

}  // namespace plumbline::physics
