// Contact points of any two convex shapes, also of such as do not touch yet.
#pragma once

#include "engine/physics/collision/narrow_phase/contact_region.h"
#include "engine/physics/collision/narrow_phase/epa.h"

#include <optional>

namespace plumbline::physics {

/// The direction in which two shapes are farthest apart or overlap least, and their points there.
struct Separation {
    Vec3d normal{0, 1, 0};  ///< unit, from b to a
    double distance_m{0};   ///< of the surfaces; negative: penetration
    Vec3d on_a{0, 0, 0};    ///< on the cores
    Vec3d on_b{0, 0, 0};
};

/// None: the shapes are farther apart than `reach_m`. The distance is exact to a millionth of the shapes' size;
/// where a flat face is as good a direction within that, the normal is the face's.
std::optional<Separation> separation_of(const PlacedConvex& a,
                                        const PlacedConvex& b,
                                        double reach_m);

/// How far apart the shapes are along a unit normal from b to a: exact, whatever the normal.
double distance_along(const PlacedConvex& a, const PlacedConvex& b, const Vec3d& normal);

/// Points with one normal, on the surfaces.
struct SurfaceContact {
    std::array<RegionPoint, ContactRegion::kMost> points;
    std::size_t count{0};
};

/// The whole contact along the separation's normal, its nearest point included. Points farther apart than `reach_m`
/// are left out.
SurfaceContact contact_along(const PlacedConvex& a,
                             const PlacedConvex& b,
                             const Separation& separation,
                             double reach_m);

/// Both in one: quicker, because the contact of a face often proves that the face is the best direction.
struct ConvexPair {
    Separation separation;
    SurfaceContact contact;
};
std::optional<ConvexPair> contact_of(const PlacedConvex& a, const PlacedConvex& b, double reach_m);

}  // namespace plumbline::physics
