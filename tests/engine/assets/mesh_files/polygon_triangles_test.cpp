// Polygons that are not convex: their triangles cover them once, whichever way they face.
#include "engine/assets/mesh_files/polygon_triangles_impl.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace plumbline::assets {
namespace {

/// Twice the sum of the areas, each along `normal`; `least` is that of the smallest.
float area_of(const std::vector<Vec3f>& polygon, const Vec3f& normal, float& least) {
    float sum = 0;
    for (const auto& [a, b, c] : triangles_of(polygon)) {
        const float area =
            glm::dot(glm::cross(polygon[b] - polygon[a], polygon[c] - polygon[a]), normal);
        least = std::min(least, area);
        sum += area;
    }
    return sum;
}

/// A comb of so many teeth, 1 m wide and 1 m apart, on a back of 1 m: seen from +z, to the left round.
std::vector<Vec3f> comb(int teeth) {
    std::vector<Vec3f> corners{{0, 0, 0}, {static_cast<float>(2 * teeth - 1), 0, 0}};
    for (int i = teeth - 1; i >= 0; --i) {
        const auto x = static_cast<float>(2 * i);
        if (i < teeth - 1) corners.push_back({x + 1, 1, 0});
        corners.push_back({x + 1, 5, 0});
        corners.push_back({x, 5, 0});
        if (i > 0) corners.push_back({x, 1, 0});
    }
    return corners;
}

TEST(PolygonTriangles, CoverACombOnceWhicheverWayItFaces) {
    for (const int teeth : {2, 3, 63}) {
        const std::vector<Vec3f> flat = comb(teeth);
        ASSERT_LE(flat.size(), kMostCorners);
        // A back of 2 n - 1 by 1 m and n teeth of 1 by 4 m.
        const auto twice_area = static_cast<float>(2 * (2 * teeth - 1 + 4 * teeth));
        for (int axis = 0; axis < 3; ++axis) {
            for (const float side : {1.0F, -1.0F}) {
                std::vector<Vec3f> polygon;
                for (const Vec3f& corner : flat) {
                    Vec3f place{7.0F};
                    place[(axis + 1) % 3] = corner.x;
                    place[(axis + 2) % 3] = corner.y;
                    polygon.push_back(place);
                }
                if (side < 0) std::reverse(polygon.begin(), polygon.end());
                Vec3f normal{0.0F};
                normal[axis] = side;
                float least = 0;
                EXPECT_EQ(triangles_of(polygon).size(), polygon.size() - 2);
                EXPECT_NEAR(area_of(polygon, normal, least), twice_area, 1e-3F * twice_area);
                EXPECT_GE(least, 0) << "none is turned over";
            }
        }
    }
}

TEST(PolygonTriangles, OfWhatIsCrossedOrFlatAreAsMany) {
    for (const std::vector<Vec3f>& polygon :
         {std::vector<Vec3f>{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}},
          std::vector<Vec3f>(40, Vec3f{1.0F}),
          std::vector<Vec3f>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {1.5F, 0, 0}}}) {
        const auto triangles = triangles_of(polygon);
        EXPECT_EQ(triangles.size(), polygon.size() - 2);
        for (const auto& triangle : triangles) {
            for (const std::uint32_t i : triangle) EXPECT_LT(i, polygon.size());
        }
    }
    EXPECT_TRUE(triangles_of(std::vector<Vec3f>(2)).empty());
}

}  // namespace
}  // namespace plumbline::assets
