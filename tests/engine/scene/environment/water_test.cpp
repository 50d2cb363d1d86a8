// What things displace of a water, as its waves know it.
#include "engine/scene/environment/water.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

namespace plumbline::scene {
namespace {

std::vector<SceneWater> basin_of(double side_m) {
    WaterDescription said;
    said.min_m = {static_cast<Real>(-side_m / 2), -2, static_cast<Real>(-side_m / 2)};
    said.max_m = {static_cast<Real>(side_m / 2), 0, static_cast<Real>(side_m / 2)};
    std::vector<SceneWater> waters(1);
    waters[0].min_m = Vec3d(said.min_m);
    waters[0].max_m = Vec3d(said.max_m);
    waters[0].waves = std::make_unique<WaveField>(said, 24, 9.81);
    return waters;
}

TEST(Displaced, RaisesTheLevelByItsVolumeAndTakesItBack) {
    std::vector<SceneWater> waters = basin_of(10);
    Displaced known;
    displace(waters, known, {.water = 0, .volume_m3 = 2, .radius_m = 1});
    EXPECT_NEAR(waters[0].waves->range().mean_m, 0.02, 1e-12);
    EXPECT_EQ(known.gained_m3, 2);
    displace(waters, known, {.water = 0, .volume_m3 = 0.5, .radius_m = 1, .place_m = {2, 0, 1}});
    EXPECT_NEAR(waters[0].waves->range().mean_m, 0.005, 1e-12);
    EXPECT_EQ(known.gained_m3, -1.5);
    displace(waters, known, {});
    EXPECT_NEAR(waters[0].waves->range().mean_m, 0, 1e-12);
    EXPECT_NEAR(waters[0].waves->energy_J(), 0, 1e-9) << "nothing has moved meanwhile";
}

TEST(Displaced, StandsUpRoundItsPlaceAndIsFeltThere) {
    std::vector<SceneWater> waters = basin_of(10);
    Displaced known;
    displace(waters, known, {.water = 0, .volume_m3 = 1, .radius_m = 2});
    const double felt_m = waters[0].waves->height_m(0, 0, 2 * kFeltOfRadius);
    EXPECT_GT(felt_m, 0.05);
    // Another half of what it gained: the mean over the step to come.
    EXPECT_GT(felt_rise_m(waters[0], known, {0, 0, 0}), felt_m);
    displace(waters, known, known);
    EXPECT_NEAR(felt_rise_m(waters[0], known, {0, 0, 0}), felt_m, 1e-12);
    waters[0].waves.reset();
    EXPECT_EQ(felt_rise_m(waters[0], known, {0, 0, 0}), 0);
    displace(waters, known, {});
}

}  // namespace
}  // namespace plumbline::scene
