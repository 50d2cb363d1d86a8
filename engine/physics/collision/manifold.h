// Where two bodies touch and what goes through it: the pair's own, from step to step. Plain data.
#pragma once

#include "engine/core/math.h"
#include "engine/physics/contact.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace plumbline::physics {

struct BodyRecord;

/// A body's side of a contact point: the point or, where the side is round (sphere, capsule, side of
/// a cylinder), the centre of the sphere that touches there.
struct ContactSide {
    Real radius_m{0};         ///< 0: not round
    Vec3 offset_m{0, 0, 0};   ///< from the centre of mass, world axes
    Vec3 surface_m{0, 0, 0};  ///< the point on the surface, world
    Vec3 local_m{0, 0, 0};    ///< the same, mass frame
    /// World axes, unit, where the side is round about an axis through the centre of mass and not a sphere: rims, cones. Else zero.
    Vec3 axis{0, 0, 0};
    bool is_moving_face{false};  ///< a flat face of what forces move, and the other side is round
};

/// What a point carried, as mean forces over the latest sub-step: what the next step starts from.
/// Newtons and not N s, because the next sub-step may be of another length: an island chooses its number
/// of sub-steps in every step, and the rate may change.
struct PointLoad {
    Real normal_N{0};
    std::array<Real, 2> friction_N{};  ///< along tangents_of(normal_world)
    Real twist_Nm{0};                  ///< about the normal
};

struct ManifoldPoint {
    std::uint32_t feature{
        0};  ///< of the manifold, the same for as long as the point is found again
    int age_steps{0};
    Vec3 normal_world{0, 1, 0};  ///< from b to a
    Real distance_m{0};          ///< negative: penetration
    ContactSide a;
    ContactSide b;
    PointLoad load;
    Real normal_Ns{0};  ///< over the whole of the latest step
};

Material combined(const Material& a, const Material& b);

/// What all points of a manifold carried together in the latest step that solved it; mean forces of
/// its last sub-step, as PointLoad.
struct ManifoldLoad {
    std::uint64_t step{0};  ///< number of that step; 0: none
    std::uint32_t age_steps{0};
    Real normal_N{0};
    Real before_N{0};   ///< in the sub-step before
    Real lasting_N{0};  ///< what it goes on carrying between impacts
    Vec3 friction_N{0, 0, 0};
    Vec3 rolling_Nm{0, 0, 0};  ///< on the body that gives way
};

/// Contact points of two bodies' parts, any number; on a mesh with several normals.
struct Manifold {
    BodyRecord* a{nullptr};
    BodyRecord* b{nullptr};
    std::uint32_t part_a{0};  ///< of the pair's `a`; a mesh is one part
    std::uint32_t part_b{0};
    std::uint32_t features_made{0};
    Material material;
    bool found{false};  ///< in the latest search; else it goes
    std::vector<ManifoldPoint> points;
    ManifoldLoad load;
};

/// The one of `points` that is nearest to `point` on either body, nearer than `near_m`, and presses the same way;
/// null: none.
ManifoldPoint* nearest_point(std::span<ManifoldPoint> points,
                             const ManifoldPoint& point,
                             Real near_m);
/// The last point takes the place of this one.
void remove_point(Manifold& manifold, std::size_t index);
/// Nothing is known of what the manifold carried.
void forget_loads(Manifold& manifold);

/// Two unit vectors that make a right-handed frame with a unit normal.
std::array<Vec3, 2> tangents_of(const Vec3& normal);

}  // namespace plumbline::physics
