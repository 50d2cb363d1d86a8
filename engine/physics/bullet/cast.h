// Spheres sent through Bullet's world, in plain types.
#pragma once

#include "engine/core/math.h"

#include <cstdint>
#include <optional>

namespace plumbline::physics {

class StepWorld;
struct BodyRecord;

/// Bodies that a cast or overlap sees. Groups must agree both ways.
struct BodyFilter {
    std::uint32_t group{~0U};
    std::uint32_t collides_with{~0U};
    const BodyRecord* ignored{nullptr};  ///< and what joints keep it from touching
    const BodyRecord* also_ignored{nullptr};
    std::uint32_t unseen_group{0};  ///< SweptBody::group whose members are not hit; 0: none

    bool sees(const BodyRecord& record) const;
};

/// A sphere that moves along a straight line.
struct SpherePath {
    Vec3 from_world{0, 0, 0};
    Vec3 motion_m{0, 0, 0};
    Real radius_m{0};
};

/// The first body that a sphere hits.
struct SphereHit {
    Real fraction{1};
    Vec3 normal_world{0, 1, 0};  ///< from the body hit to the sphere
};

/// As cast_among() of convex_query.h.
std::optional<SphereHit> cast_sphere(const StepWorld& world,
                                     const SpherePath& path,
                                     const BodyFilter& filter);

}  // namespace plumbline::physics
