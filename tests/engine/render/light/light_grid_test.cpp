#include "engine/render/light/light_grid.h"

#include "engine/assets/primitives.h"

#include <gtest/gtest.h>

namespace plumbline::render {
namespace {

constexpr float kWallAlbedo = 0.6F;  // of the walls: what a surface of one colour sends on

/// The same light from above and from below: a sky of radiance 1, and a sun that makes the ground as
/// bright is left out.
OutsideLight even_sky() {
    return {.sky = {Vec3f{1.0F / 0.282095F}, Vec3f{0.0F}, Vec3f{0.0F}, Vec3f{0.0F}}};
}

/// Rooms of boxes, 4 x 3 x 4 m within.
class LightGrids : public testing::Test {
protected:
    void add_wall(const Vec3f& size_m, const Vec3f& place) {
        const std::string name = "wall " + std::to_string(walls_++);
        const assets::MaterialId material =
            library_.add_material({.base_color = Vec3f{kWallAlbedo}});
        add_item(frame_,
                 {.mesh = library_.add_mesh(name, assets::box_mesh(size_m)),
                  .world_from_body = glm::translate(Mat4f{1.0F}, place),
                  .is_static = true},
                 {&material, 1});
    }
    /// All but the wall at x = 2.
    void add_open_room() {
        add_wall({4.4F, 0.2F, 4.4F}, {0.0F, -0.1F, 0.0F});
        add_wall({4.4F, 0.2F, 4.4F}, {0.0F, 3.1F, 0.0F});
        add_wall({0.2F, 3.4F, 4.4F}, {-2.1F, 1.5F, 0.0F});
        add_wall({4.4F, 3.4F, 0.2F}, {0.0F, 1.5F, -2.1F});
        add_wall({4.4F, 3.4F, 0.2F}, {0.0F, 1.5F, 2.1F});
    }
    void close_room() { add_wall({0.2F, 3.4F, 4.4F}, {2.1F, 1.5F, 0.0F}); }

    LightGrid grid_under(const OutsideLight& outside) {
        const IndirectLight box{
            .min_world = {-2.0F, 0.0F, -2.0F}, .max_world = {2.0F, 3.0F, 2.0F}, .spacing_m = 0.5F};
        const RayScene rays(frame_, library_);
        LightGrid grid(box, rays);
        grid.light(outside, rays);
        return grid;
    }
    static float mean_at(const LightGrid& grid, std::uint32_t x, std::uint32_t y, std::uint32_t z) {
        return grid.means()[x + grid.counts()[0] * (y + grid.counts()[1] * z)].y;
    }

    assets::AssetLibrary library_;
    RenderFrame frame_;
    int walls_{0};
};

TEST_F(LightGrids, NothingReachesAClosedRoom) {
    add_open_room();
    close_room();
    const LightGrid grid = grid_under(even_sky());
    for (const Vec4f& mean : grid.means()) EXPECT_LT(mean.y, 1e-3F);
}

TEST_F(LightGrids, TheSkyIsSeenInFullWhereNothingStands) {
    OutsideLight outside = even_sky();
    outside.sky[1] = Vec3f{0.3F};  // more from above
    const LightGrid grid = grid_under(outside);
    // Above the horizon 1 + 0.488603 * 0.3 * y, whose mean is that at y = 1/2; below it the ground.
    const float ground = 0.22F;
    const float expected = 0.5F * (1.0F + 0.488603F * 0.3F * 0.5F + ground);
    for (const Vec4f& mean : grid.means()) EXPECT_NEAR(mean.y, expected, 0.01F);
    for (const Vec4f& slope : grid.slopes()) EXPECT_GT(slope.y, 0.5F);
}

TEST_F(LightGrids, ARoomIsBrightestAtItsOpenSideAndLightComesFromThere) {
    add_open_room();
    const LightGrid grid = grid_under(even_sky());
    for (std::uint32_t x = 0; x + 1 < grid.counts()[0]; ++x)
        EXPECT_LT(mean_at(grid, x, 3, 4), mean_at(grid, x + 1, 3, 4));
    const std::uint32_t middle = 4 + grid.counts()[0] * (3 + grid.counts()[1] * 4);
    EXPECT_GT(grid.slopes()[middle].x, 0.5F);
}

TEST_F(LightGrids, ASpotOfSunLightsTheCeilingFromBelow) {
    add_open_room();
    const LightGrid dark = grid_under({});
    EXPECT_EQ(mean_at(dark, 6, 3, 4), 0.0F);
    // In by the open side, down to the floor.
    const LightGrid grid = grid_under(
        {.sun_radiance = Vec3f{1.0F}, .to_sun_world = glm::normalize(Vec3f{1.0F, 1.0F, 0.0F})});
    const std::uint32_t below_ceiling = 5 + grid.counts()[0] * (5 + grid.counts()[1] * 4);
    EXPECT_GT(grid.means()[below_ceiling].y, 0.02F);
    EXPECT_LT(grid.slopes()[below_ceiling].y, 0.0F);
}

TEST_F(LightGrids, WhatLiesWithinAWallTakesItsNeighboursLight) {
    add_wall({0.6F, 3.0F, 4.0F}, {0.25F, 1.5F, 0.0F});
    const LightGrid grid = grid_under(even_sky());
    const float within = mean_at(grid, 4, 3, 4);
    EXPECT_GT(within, 0.1F);
    EXPECT_NEAR(within, (mean_at(grid, 3, 3, 4) + mean_at(grid, 5, 3, 4)) * 0.5F, 0.05F);
}

}  // namespace
}  // namespace plumbline::render
