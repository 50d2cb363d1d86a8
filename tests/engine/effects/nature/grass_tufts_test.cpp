#include "engine/effects/nature/grass_tufts.h"

#include <gtest/gtest.h>

#include <limits>
#include <utility>

namespace plumbline::effects {
namespace {

constexpr std::size_t kAllTufts = std::numeric_limits<std::size_t>::max();

TEST(GrassField, TheSamePlaceGrowsTheSameWhicheverWayOneComes) {
    const LawnAt flat = [](float, float) { return 0.25F; };
    const scene::GrassDescription grass{.density_perm2 = 4};
    GrassField here(grass);
    here.follow({0.0F, 1.7F, 0.0F}, 8.0F, kAllTufts, flat);
    GrassField walked(grass);
    for (float x = 40.0F; x >= 0.0F; x -= 0.5F)
        walked.follow({x, 1.7F, 0.0F}, 8.0F, kAllTufts, flat);
    ASSERT_FALSE(here.cells().empty());
    std::size_t tufts = 0;
    for (const auto& [cell, grown] : here.cells()) {
        const auto& other = walked.cells().at(cell);
        ASSERT_EQ(grown.size(), other.size());
        for (std::size_t i = 0; i < grown.size(); ++i) {
            EXPECT_EQ(grown[i].root_world, other[i].root_world);
            EXPECT_EQ(grown[i].root_world.y, 0.25F);
        }
        tufts += grown.size();
    }
    const double area_m2 = 4.0 * static_cast<double>(here.cells().size());
    EXPECT_NEAR(static_cast<double>(tufts), 4.0 * area_m2, 0.05 * 4.0 * area_m2);
    // What is left behind is forgotten: twice the area would be too much.
    EXPECT_LT(walked.cells().size(), 2 * here.cells().size());
}

TEST(GrassField, GrowsSoManyCellsAFrameNearestFirst) {
    const LawnAt flat = [](float, float) { return 0.0F; };
    GrassField field(scene::GrassDescription{});
    field.follow({1.0F, 1.7F, 1.0F}, 8.0F, 1, flat);
    ASSERT_EQ(field.cells().size(), 1U);
    EXPECT_EQ(field.cells().begin()->first, (std::pair{0, 0}));
    field.follow({1.0F, 1.7F, 1.0F}, 8.0F, 4, flat);
    EXPECT_EQ(field.cells().size(), 5U);
}

}  // namespace
}  // namespace plumbline::effects
