// How a body would break: pieces cut beforehand, what holds them together, and how hard loads pull at that.
//
// Between loads the body is rigid. Its pieces are Voronoi cells; a bond is the polygon that two of them share, filled with
// springs of stiffness E/distance per area in all directions: a rigid-body-spring network (Bolander and Saito, "Fracture analyses
// using spring networks with random geometry", Engineering Fracture Mechanics 61, 1998, section 2), which carries uniform strain
// exactly. Stress does not depend on E.
#pragma once

#include "engine/physics/body.h"
#include "engine/physics/joint.h"

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace plumbline::physics {

class PhysicsWorld;

/// A flat face: its corners counter-clockwise from outside.
struct PolyhedronFace {
    std::vector<std::uint32_t> corners;
    int beyond{-1};  ///< the number of the piece behind it; -1: none
};

/// A convex solid.
struct Polyhedron {
    std::vector<Vec3d> corners_m;
    std::vector<PolyhedronFace> faces;

    bool empty() const { return faces.empty(); }
};

/// Body frame.
struct FracturePiece {
    Polyhedron solid;
    Vec3d seed_m{0, 0, 0};  ///< what is nearer to it than to any other seed belongs to the piece
    Vec3d center_m{0, 0, 0};
    double volume_m3{0};
    glm::dmat3 inertia_m5{0.0};  ///< about the centre, for a density of 1
};

/// The polygon between two pieces, body frame.
struct FractureBond {
    std::array<std::uint32_t, 2> pieces{};
    Vec3d normal{1, 0, 0};  ///< unit, from the first to the second
    Vec3d center_m{0, 0, 0};
    double area_m2{0};
    double distance_m{0};       ///< of the seeds
    glm::dmat3 second_m4{0.0};  ///< integral of (r r I - r r^T) about the centre
    double torsion_m3{0};       ///< torque for a shear stress of 1 Pa at the rim
    std::vector<Vec3d> corners_m;
};

struct FracturePattern {
    std::vector<FracturePiece> pieces;
    std::vector<FractureBond> bonds;
    double volume_m3{0};
    double longest_m{0};  ///< extent along the longest of the body's axes

    /// The one among `pieces` that a point belongs to; these must not be empty.
    std::uint32_t piece_at(const Vec3d& point_m, std::span<const std::uint32_t> pieces) const;
};

/// Cells of about the same size round points that `seed` scatters. Fewer than asked for where they would be too small. Empty: the
/// body is no single convex solid.
FracturePattern fracture_pattern(const PhysicsWorld& world,
                                 BodyId body,
                                 std::uint32_t pieces,
                                 std::uint64_t seed);

/// What pushes a body at a place.
struct BodyLoad {
    Vec3d point_m{0, 0, 0};
    Vec3d force_N{0, 0, 0};
    Vec3d torque_Nm{0, 0, 0};
};

/// Forces of the latest step, world axes; an impact counts as a force over `impact_s`.
std::vector<BodyLoad> loads_on(const PhysicsWorld& world, BodyId body, double impact_s);

/// The joint carries nothing from now on, as if it had broken; both its ends wake.
void cut_joint(PhysicsWorld& world, JointId id);

/// Each joint that holds `from` holds, from now on and at the same place, the body that `to` names for its anchor there: one that
/// moves. It keeps its zero and what it carried.
void hand_over_joints(PhysicsWorld& world,
                      BodyId from,
                      const std::function<BodyId(const Vec3& anchor_world)>& to);

/// Some pieces of a pattern that hold together, at work.
class FractureNetwork {
public:
    /// `pieces` ascending; `cracked`: the bonds of the pattern that carry nothing. The pattern must outlive it.
    FractureNetwork(const FracturePattern& pattern,
                    std::vector<std::uint32_t> pieces,
                    std::span<const std::uint32_t> cracked,
                    double density_kgpm3);
    ~FractureNetwork();
    FractureNetwork(FractureNetwork&&) noexcept;
    FractureNetwork& operator=(FractureNetwork&&) noexcept;

    /// The largest principal stress in each bond, Pa, tension positive; 0 where it is cracked or of other pieces. Loads and spin in
    /// the body frame; what they do not balance accelerates the pieces as rigid bodies, one that hang together.
    std::vector<double> stress_Pa(std::span<const BodyLoad> loads, const Vec3d& spin_radps);
    /// Cracks what is above the strength, the worst `share` of it (at least one) and at most `rounds` times with the stress as it is
    /// then. Whether anything cracked.
    bool crack(std::span<const BodyLoad> loads,
               const Vec3d& spin_radps,
               double strength_Pa,
               double share,
               int rounds);

    std::vector<std::uint32_t> cracked() const;  ///< ascending
    /// Pieces that hang together, ascending, by their first.
    std::vector<std::vector<std::uint32_t>> parts() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace plumbline::physics
