// How a body lies in air or water, and how near it is to a point: for force fields.
#pragma once

#include "engine/physics/body.h"
#include "engine/physics/transform.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace plumbline::physics {

class PhysicsWorld;
struct BodyGeometry;

/// Of the mass of displaced water or air: what moves along with a ball (Lamb, Hydrodynamics, 92); taken for all shapes.
inline constexpr double kAddedShare = 0.5;
/// Of critical damping: the waves that a bobbing float sends out, which a level surface does not show. Floats at sea have 0.05 to
/// 0.2 (Newman, Marine Hydrodynamics, 6.19).
inline constexpr double kRadiated = 0.1;

/// The part of a body below a level plane. Volumes of boxes and hulls by Catto, "Exact Buoyancy for Polyhedra" (Game Programming
/// Gems 6, 2.5); of a sphere by the cap's formula; of other round shapes by discs along their axis, within 1e-6 of the volume.
/// Parts that overlap count twice. Areas of round shapes are those of facets, within 3 %.
struct Submersion {
    double volume_m3{0};
    Vec3d center_m{0, 0, 0};  ///< of the volume, world; of no meaning without one
    double whole_m3{0};       ///< of the body
    double waterline_m2{0};   ///< of the cut at the level
    double silhouette_m2{0};  ///< of what is below, along the direction that was asked for
};

/// m2: how large it looks along the unit `direction`, in the frame of its principal axes (silhouette.h).
double silhouette_m2(const PhysicsWorld& world, BodyId id, const Vec3d& direction_mass);

/// Where a body's centre of mass and principal axes of inertia are.
struct MassFrame {
    Vec3d center_m{0, 0, 0};
    Quatd world_from_mass{1, 0, 0, 0};
};

/// What of it lies below a level when its mass frame is there. `direction`: unit, world.
Submersion submersion(const PhysicsWorld& world,
                      BodyId id,
                      const MassFrame& at,
                      double level_m,
                      const Vec3d& direction);

/// Where a ball is near a body.
struct BallContact {
    Vec3d normal{0, 1, 0};  ///< unit, from the body to the ball
    Vec3d on_body_m{0, 0, 0};
    double distance_m{0};  ///< of the surfaces; negative: penetration
};

/// Looks for the places of a body that are nearest to balls. A mesh is solid below the fronts of its triangles, as far down as a
/// ball reaches.
class BallSearch {
public:
    /// The body's mass frame is at `at`. No ball reaches out of the box from `low_m` to `high_m`, world.
    BallSearch(const PhysicsWorld& world,
               BodyId id,
               const MassFrame& at,
               const Vec3d& low_m,
               const Vec3d& high_m);
    /// Nothing of the body is in the box.
    bool finds_nothing() const { return parts_.empty() && !has_mesh(); }
    /// None farther off than `reach_m`.
    std::optional<BallContact> nearest(const Vec3d& ball_m, double radius_m, double reach_m) const;

private:
    bool has_mesh() const;
    /// `local`: the ball's centre in the mass frame; `body`: where that is, seen from the ball's centre.
    std::optional<BallContact> nearest_part(const Transform& body,
                                            const Vec3d& local,
                                            double radius_m,
                                            double reach_m) const;

    const BodyGeometry& geometry_;
    MassFrame at_;
    Mat3 rotation_;
    std::vector<std::uint32_t> parts_;  ///< in the box
};

/// The coefficient of a body's material.
double friction_of(const PhysicsWorld& world, BodyId id);

/// Of a belt or a turntable, while belts are on (WorldFeatures).
SurfaceMotion surface_motion(const PhysicsWorld& world, BodyId id);

/// The principal axes of inertia as the body stands, and as seen from its frame.
Quatd world_from_mass(const PhysicsWorld& world, BodyId id);
Quatd mass_from_body(const PhysicsWorld& world, BodyId id);

/// Convex parts that it is made of.
std::size_t part_count(const PhysicsWorld& world, BodyId id);

/// Of a ball round the centre of mass that holds all of it; of a ball, its own.
double radius_m(const PhysicsWorld& world, BodyId id);

/// Half of the shortest side of the boxes round its parts.
double thinnest_half_m(const PhysicsWorld& world, BodyId id);

/// Half the size of the box along its principal axes round it, from its centre of mass.
Vec3d half_extent_m(const PhysicsWorld& world, BodyId id);

}  // namespace plumbline::physics
