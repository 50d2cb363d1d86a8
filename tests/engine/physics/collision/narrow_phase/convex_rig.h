// Convex shapes in random poses for tests, and their separation found without the engine's narrow phase.
#pragma once

#include "engine/core/random.h"
#include "engine/physics/collision/narrow_phase/convex_convex.h"
#include "tests/engine/physics/collision/shape/hull_rig.h"

#include <memory>
#include <string>
#include <vector>

namespace plumbline::physics::convex_rig {

using Kind = ConvexShape::Kind;

/// A shape with what it points to.
struct Solid {
    std::string name;
    ConvexShape shape;
    std::shared_ptr<HullGeometry> hull;
};

inline Solid sphere(double radius) {
    return {"sphere", {.kind = Kind::Sphere, .radius_m = static_cast<Real>(radius)}, nullptr};
}
inline Solid capsule(double radius, double half) {
    return {"capsule",
            {.kind = Kind::Capsule,
             .radius_m = static_cast<Real>(radius),
             .half_height_m = static_cast<Real>(half)},
            nullptr};
}
inline Solid box(const Vec3d& half) {
    return {"box", {.kind = Kind::Box, .half_m = Vec3(half)}, nullptr};
}
inline Solid cylinder(double radius, double half) {
    Solid solid = capsule(radius, half);
    solid.name = "cylinder";
    solid.shape.kind = Kind::Cylinder;
    return solid;
}
inline Solid cone(double radius, double half) {
    Solid solid = capsule(radius, half);
    solid.name = "cone";
    solid.shape.kind = Kind::Cone;
    return solid;
}
inline Solid hull(std::string name, const std::vector<Vec3d>& corners) {
    auto geometry = std::make_shared<HullGeometry>(hull_rig::hull_round(corners));
    return {std::move(name), {.kind = Kind::Hull, .hull = geometry.get()}, geometry};
}

inline std::vector<Vec3d> random_corners(int count, std::uint64_t seed) {
    Random random(seed);
    std::vector<Vec3d> corners;
    while (static_cast<int>(corners.size()) < count) {
        const Vec3d at{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
        if (glm::length(at) > 0.3 && glm::length(at) < 1)
            corners.push_back(glm::normalize(at) * Vec3d{0.6, 0.4, 0.5});
    }
    return corners;
}

/// One of each kind, about a metre long.
inline const std::vector<Solid>& catalogue() {
    static const std::vector<Solid> kSolids{
        sphere(0.5),
        capsule(0.25, 0.4),
        box({0.5, 0.3, 0.4}),
        cylinder(0.4, 0.5),
        cone(0.4, 0.5),
        hull("hull of 8", random_corners(8, 5)),
        hull("octagonal prism", hull_rig::prism_corners(8, 0.5, 0.4)),
        hull("hull of 30", random_corners(30, 7)),
    };
    return kSolids;
}

/// On the unit sphere, evenly.
inline Vec3d random_direction(Random& random) {
    while (true) {
        const Vec3d at{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
        const double length = glm::length(at);
        if (length > 0.1 && length < 1) return at / length;
    }
}

inline glm::dmat3 random_turn(Random& random) {
    const double half_rad = random.uniform(0, 3.14159F);
    return glm::mat3_cast(Quatd{std::cos(half_rad), random_direction(random) * std::sin(half_rad)});
}

inline PlacedConvex placed(const Solid& solid, const glm::dmat3& axes, const Vec3d& center_m) {
    PlacedConvex convex{.shape = &solid.shape, .axes = axes, .center_m = center_m};
    if (solid.shape.kind == Kind::Sphere || solid.shape.kind == Kind::Capsule)
        convex.radius_m = static_cast<double>(solid.shape.radius_m);
    return convex;
}

/// How far the shape reaches along `direction` from the frame's origin.
double reach_along(const PlacedConvex& convex, const Vec3d& direction);
/// The gap between the shapes along a unit normal from b to a; negative: overlap.
double gap_along(const PlacedConvex& a, const PlacedConvex& b, const Vec3d& normal);
/// Off the surface, outward; near the surface only.
double height_over(const PlacedConvex& convex, const Vec3d& point);

struct Direction {
    Vec3d normal{0, 1, 0};
    double gap_m{0};
};
/// The largest gap over all directions: samples, the best of which climb.
Direction widest_gap(const PlacedConvex& a, const PlacedConvex& b, int samples, int climbs);
/// Climbs from `start` on.
Direction climbed(const PlacedConvex& a, const PlacedConvex& b, const Vec3d& start, double step);

}  // namespace plumbline::physics::convex_rig
