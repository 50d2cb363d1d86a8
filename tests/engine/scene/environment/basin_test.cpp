// What a mesh holds: bowls by their closed forms, and what runs out.
#include "engine/scene/environment/basin.h"

#include "engine/assets/primitives.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace plumbline::scene {
namespace {

using Corners = std::vector<Vec3d>;

void add_box(Corners& corners_m, const Vec3d& middle_m, const Vec3d& size_m) {
    const assets::MeshData mesh = assets::box_mesh(Vec3f(size_m));
    for (const std::uint32_t index : mesh.indices)
        corners_m.push_back(middle_m + Vec3d(mesh.vertices[index].position_body));
}

/// Inside 2 x 1 x 0.6 above y = 0, with walls of 0.2; one of them ends lower.
Corners trough(double low_wall_m) {
    Corners corners_m;
    add_box(corners_m, {0, -0.1, 0}, {2.4, 0.2, 1.4});
    for (const double side : {-1.0, 1.0}) add_box(corners_m, {side * 1.1, 0.3, 0}, {0.2, 0.6, 1.4});
    add_box(corners_m, {0, 0.3, -0.6}, {2, 0.6, 0.2});
    add_box(corners_m, {0, low_wall_m / 2, 0.6}, {2, low_wall_m, 0.2});
    return corners_m;
}

TEST(Basin, HoldsWhatItsWallsDo) {
    const Basin basin(trough(0.6), 0.5);
    ASSERT_FALSE(basin.is_empty());
    EXPECT_NEAR(basin.volume_m3(), 2 * 1 * 0.5, 0.03);
    EXPECT_TRUE(basin.holds(0.9, -0.4));
    EXPECT_FALSE(basin.holds(1.1, 0)) << "in the wall";
    EXPECT_FALSE(basin.holds(1.3, 0)) << "outside";
    EXPECT_FALSE(basin.holds(99, std::nan("")));
    EXPECT_NEAR(basin.min_m().y, 0, 1e-7);
    EXPECT_EQ(basin.max_m().y, 0.5);
    EXPECT_NEAR(basin.max_m().x, 1, 0.03);
    EXPECT_NEAR(basin.min_m().z, -0.5, 0.03);
}

TEST(Basin, RunsOutOverTheLowestWall) {
    EXPECT_FALSE(Basin(trough(0.3), 0.25).is_empty());
    EXPECT_TRUE(Basin(trough(0.3), 0.35).is_empty());
    EXPECT_TRUE(Basin(trough(0.6), -1).is_empty());
    EXPECT_TRUE(Basin({}, 0).is_empty());
}

TEST(Basin, ALidAboveTheWaterLeavesItThere) {
    Corners corners_m = trough(0.6);
    add_box(corners_m, {0, 0.55, 0}, {1, 0.06, 0.5});
    const Basin covered(corners_m, 0.5);
    EXPECT_TRUE(covered.holds(0, 0));
    EXPECT_NEAR(covered.volume_m3(), 1, 0.03);
    add_box(corners_m, {0, 0.25, 0}, {0.5, 0.5001, 0.5});
    EXPECT_FALSE(Basin(corners_m, 0.4).holds(0, 0)) << "a stone stands in it";
}

TEST(Basin, ItsSurfaceReachesTheWall) {
    const Basin basin(trough(0.6), 0.5);
    double area_m2 = 0;
    double widest_m = 0;
    for (const Basin::Cell& cell : basin.surface()) {
        area_m2 += (cell.x1 - cell.x0) * (cell.z1 - cell.z0);
        widest_m = std::max(widest_m, cell.x1);
    }
    EXPECT_GT(widest_m, 1);
    EXPECT_LT(widest_m, 1.1);
    EXPECT_NEAR(area_m2, 2, 0.25);
}

}  // namespace
}  // namespace plumbline::scene
