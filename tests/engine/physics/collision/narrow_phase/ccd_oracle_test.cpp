// Shapes of every size in random poses against libccd, which shares nothing with the engine: no direction that it finds parts two shapes
// more easily than ours.
#include "tests/engine/physics/collision/narrow_phase/convex_rig.h"

#include <ccd/ccd.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

namespace plumbline::physics {
namespace {

using namespace convex_rig;

/// Of the smaller shape's size.
constexpr double kOracleShare = 1e-5;

Vec3d vector_of(const ccd_vec3_t& v) {
    return {v.v[0], v.v[1], v.v[2]};
}

/// In the shape's own frame, written down from the shape's definition.
Vec3d surface_point(const ConvexShape& shape, const Vec3d& direction) {
    const auto radius = static_cast<double>(shape.radius_m);
    const double half = std::copysign(static_cast<double>(shape.half_height_m), direction.y);
    const double ring = std::hypot(direction.x, direction.z);
    const Vec3d rim =
        ring > 0 ? Vec3d{direction.x, 0, direction.z} * (radius / ring) : Vec3d{radius, 0, 0};
    switch (shape.kind) {
        case Kind::Sphere:
            return glm::normalize(direction) * radius;
        case Kind::Capsule:
            return Vec3d{0, half, 0} + glm::normalize(direction) * radius;
        case Kind::Box:
            return glm::sign(direction) * Vec3d{shape.half_m};
        case Kind::Cylinder:
            return rim + Vec3d{0, half, 0};
        case Kind::Cone: {
            const Vec3d tip{0, static_cast<double>(shape.half_height_m), 0};
            return glm::dot(tip, direction) > glm::dot(rim - tip, direction) ? tip : rim - tip;
        }
        case Kind::Hull:
            return *std::ranges::max_element(shape.hull->corners_m, {}, [&](const Vec3d& corner) {
                return glm::dot(corner, direction);
            });
        case Kind::None:
            break;
    }
    return {0, 0, 0};
}

void oracle_support(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* at) {
    const PlacedConvex& convex = *static_cast<const PlacedConvex*>(object);
    const Vec3d local = glm::transpose(convex.axes) * vector_of(*direction);
    const Vec3d point = convex.axes * surface_point(*convex.shape, local) + convex.center_m;
    ccdVec3Set(at, point.x, point.y, point.z);
}

/// From one twentieth of a metre to one, thin and long ones among them.
Solid random_solid(std::size_t kind, Random& random) {
    const auto size = [&random] {
        return 0.05 * std::pow(20.0, static_cast<double>(random.uniform(0, 1)));
    };
    const Vec3d sizes{size(), size(), size()};
    switch (kind) {
        case 0:
            return sphere(sizes.x);
        case 1:
            return capsule(sizes.x, sizes.y);
        case 2:
            return box(sizes);
        case 3:
            return cylinder(sizes.x, sizes.y);
        case 4:
            return cone(sizes.x, sizes.y);
        default: {
            std::vector<Vec3d> corners;
            const auto count = static_cast<std::size_t>(random.uniform(4, 24));
            while (corners.size() < count) corners.push_back(random_direction(random) * sizes);
            return hull("hull", corners);
        }
    }
}

/// How deep the shapes overlap along the direction in which libccd parts them; 0: it finds no overlap.
double oracle_depth_m(const PlacedConvex& a, const PlacedConvex& b) {
    ccd_t settings;
    CCD_INIT(&settings);
    settings.support1 = oracle_support;
    settings.support2 = oracle_support;
    settings.max_iterations = 500;
    settings.epa_tolerance = 1e-9;
    ccd_real_t depth = 0;
    ccd_vec3_t direction;
    ccd_vec3_t at;
    if (ccdGJKPenetration(&a, &b, &settings, &depth, &direction, &at) != 0) return 0;
    const Vec3d found = vector_of(direction);
    const double length = glm::length(found);
    // A touch has no direction.
    if (!(length > 0.5)) return 0;
    return -std::max(gap_along(a, b, found / length), gap_along(a, b, -found / length));
}

TEST(CcdOracle, FindsNoDirectionThatPartsShapesMoreEasily) {
    const char* wanted = std::getenv("PLUMBLINE_CONVEX_POSES");
    const int poses = wanted != nullptr ? std::atoi(wanted) : 100;
    constexpr std::size_t kKinds = 6;
    Random random(9);
    int overlaps = 0;
    for (std::size_t i = 0; i < kKinds; ++i) {
        for (std::size_t k = i; k < kKinds; ++k) {
            for (int pose = 0; pose < poses; ++pose) {
                const Solid of_a = random_solid(i, random);
                const Solid of_b = random_solid(k, random);
                SCOPED_TRACE(of_a.name + " and " + of_b.name + ", pose " + std::to_string(pose));
                PlacedConvex a = placed(of_a, random_turn(random), {0, 0, 0});
                const PlacedConvex b = placed(of_b, random_turn(random), {0, 0, 0});
                const double small_m = std::min(size_of(a), size_of(b));
                const Vec3d along = random_direction(random);
                const double gap_m = static_cast<double>(random.uniform(-0.5F, 0)) * small_m;
                a.center_m = along * (gap_m - gap_along(a, b, along));
                const auto ours = separation_of(a, b, 10);
                ASSERT_TRUE(ours);
                const double depth_m = oracle_depth_m(a, b);
                if (depth_m == 0) continue;  // it takes some that overlap by little for apart
                ++overlaps;
                ASSERT_LE(-ours->distance_m, depth_m + kOracleShare * small_m);
            }
        }
    }
    EXPECT_GT(overlaps, 3 * poses);
}

}  // namespace
}  // namespace plumbline::physics
