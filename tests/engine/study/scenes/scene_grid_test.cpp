#include "engine/study/scenes/scene_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

namespace plumbline::study {
namespace {

TEST(SceneGrid, BeginsAt60HzAndHasNothingTwice) {
    for (const GridSize size : {GridSize::Quick, GridSize::Full}) {
        const std::vector<Setting> grid = scene_grid(size);
        std::set<std::string> texts;
        for (const Setting& setting : grid) {
            EXPECT_TRUE(texts.insert(setting_text(setting)).second) << setting_text(setting);
            EXPECT_EQ(240 % setting.step_hz, 0) << "samples every 1/30 s fall on steps";
        }
        // small_step on demand and with 1, 2, 4, 8 sub-steps, bullet_si with 10 iterations, at four
        // rates; all else: bullet_si with 50, and at two rates six more and two in float64.
        EXPECT_EQ(grid.size(), size == GridSize::Quick ? 24U : 4U * 7U + 2U * 8U);
        const std::size_t per_rate = size == GridSize::Quick ? 6 : 15;
        for (std::size_t i = 0; i < grid.size(); ++i)
            EXPECT_EQ(grid[i].step_hz == 60, i < per_rate) << i;
        const bool doubled = std::ranges::any_of(
            grid, [](const Setting& setting) { return setting.precision == Precision::Float64; });
        EXPECT_EQ(doubled, size == GridSize::Full);
    }
}

TEST(SceneGrid, EffectsAreTriedAloneAndTogether) {
    const Setting plain{.step_hz = 120};
    EXPECT_EQ(with_fidelities(plain, {"cloth"}).size(), 2U);
    const std::vector<Setting> all = with_fidelities(plain, {"cloth", "rope"});
    ASSERT_EQ(all.size(), 6U);
    EXPECT_EQ(setting_text(all[0]), "small_step 120 Hz x 2-16, float32, cloth draft, rope draft");
    EXPECT_EQ(setting_text(all[2]), "small_step 120 Hz x 2-16, float32, rope draft");
    EXPECT_EQ(setting_text(all[3]),
              "small_step 120 Hz x 2-16, float32, cloth precise, rope precise");
    EXPECT_EQ(reference_setting(240, {"rope"}).fidelity.front().fidelity, scene::Fidelity::Precise);
    EXPECT_LT(guessed_cost(all[0]), guessed_cost(plain));
}

TEST(SceneGrid, CostsAreGuessedByRateWorkAndPrecision) {
    const Setting one{.step_hz = 60, .substeps = 0};
    EXPECT_DOUBLE_EQ(guessed_cost(one), 1);
    Setting other = one;
    other.step_hz = 240;
    EXPECT_DOUBLE_EQ(guessed_cost(other), 4);
    EXPECT_TRUE(same_but_rate(one, other));
    other.substeps = 4;
    EXPECT_FALSE(same_but_rate(one, other));
    EXPECT_DOUBLE_EQ(guessed_cost(other), 4 * 1.2);
    EXPECT_DOUBLE_EQ(guessed_cost(reference_setting(240)), 4 * 1.2 * 1.3);
    Setting bullet{.solver = physics::Solver::BulletSi, .substeps = 1, .iterations = 50};
    EXPECT_DOUBLE_EQ(guessed_cost(bullet), 1.6);
    bullet.solver = physics::Solver::BulletDantzig;
    EXPECT_DOUBLE_EQ(guessed_cost(bullet), 3) << "direct: iterations cost nothing";
}

}  // namespace
}  // namespace plumbline::study
