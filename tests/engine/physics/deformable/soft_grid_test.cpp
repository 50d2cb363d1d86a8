// Grids of cells: their sizes, volumes and outer faces.
#include "engine/physics/soft_grid.h"

#include <gtest/gtest.h>

#include <numbers>

namespace plumbline::physics {
namespace {

TEST(SoftGrid, ABoxHasItsSize) {
    const SoftGrid grid = box_grid({2, 1, 0.5}, {4, 2, 1});
    EXPECT_EQ(grid.cells.size(), 8U);
    EXPECT_EQ(grid.points_m.size(), 5U * 3U * 2U);
    EXPECT_EQ(grid.faces.size(), 2U * (8U + 4U + 2U));
    const SoftBody soft({.grid = grid, .density_kgpm3 = 100});
    EXPECT_NEAR(soft.rest_volume_m3(), 1, 1e-12);
    EXPECT_NEAR(soft.mass_kg(), 100, 1e-9);
    EXPECT_NEAR(soft.totals().elastic_J, 0, 1e-9);
    EXPECT_NEAR(soft.longest_side_m(), 0.5, 1e-12);
}

// Its volume is the ellipsoid's; no cell is inside out.
TEST(SoftGrid, AnEllipsoidHasItsVolume) {
    const SoftBody soft({.grid = ellipsoid_grid({0.4, 0.25, 0.3}, {6, 4, 4})});
    const double exact_m3 = 4.0 / 3 * std::numbers::pi * 0.4 * 0.25 * 0.3;
    EXPECT_NEAR(soft.rest_volume_m3() / exact_m3, 1, 1e-9);
    for (std::size_t i = 0; i < soft.positions_m().size(); ++i) EXPECT_GT(soft.mass_kg(i), 0);
}

TEST(SoftGrid, CellsInsideAreTaken) {
    const SoftGrid grid =
        voxel_grid({0, 0, 0}, {3, 1, 1}, 1, [](const Vec3d& at) { return at.x < 1 || at.x > 2; });
    EXPECT_EQ(grid.cells.size(), 2U);
    EXPECT_EQ(grid.faces.size(), 12U);
    EXPECT_EQ(grid.points_m.size(), 16U);
}

// Also between points where the face is cut more finely; no corner twice.
TEST(SoftGrid, PlacesCoverTheSurface) {
    const SoftBody soft({.grid = box_grid({1, 1, 1}, {2, 2, 2})});
    EXPECT_EQ(soft.places(1).size(), 26U);
    for (const SurfacePlace& place : soft.places(2)) {
        Vec3d at{0, 0, 0};
        for (std::size_t i = 0; i < 4; ++i)
            at += place.weights[i] * soft.positions_m()[place.points[i]];
        EXPECT_NEAR(std::max({std::abs(at.x), std::abs(at.y), std::abs(at.z)}), 0.5, 1e-12);
    }
}

}  // namespace
}  // namespace plumbline::physics
