// Prices of fidelities: between points that differ in one effect alone.
#include "engine/study/findings/fidelity_price.h"

#include <gtest/gtest.h>

namespace plumbline::study {
namespace {

Point point_at(int step_hz, std::vector<scene::EffectFidelity> fidelity, double ms, double error) {
    Point point;
    point.setting.step_hz = step_hz;
    point.setting.fidelity = std::move(fidelity);
    point.status = RunStatus::Done;
    point.errors = {error};
    point.cost.repeats = 1;
    point.cost.ms_per_s_min = point.cost.ms_per_s_median = 60 * ms;
    return point;
}

TEST(FidelityPrice, IsTheDifferenceToTheSameWithoutIt) {
    using scene::Fidelity;
    const std::vector<Point> points{
        point_at(60, {}, 1, 0.02),
        point_at(120, {}, 2, 0.01),
        point_at(60, {{"cloth", Fidelity::Draft}}, 0.4, 0.05),
        point_at(120, {{"cloth", Fidelity::Draft}}, 1.5, 0.03),
        point_at(60, {{"cloth", Fidelity::Precise}}, 3, 0.005),
        point_at(60, {{"cloth", Fidelity::Draft}, {"rope", Fidelity::Draft}}, 0.1, 0.5),
        point_at(240, {{"rope", Fidelity::Draft}}, 0.1, 0.5)};
    const std::vector<FidelityPrice> cloth = prices_of(points, "cloth");
    ASSERT_EQ(cloth.size(), 2U);
    EXPECT_EQ(cloth[0].fidelity, Fidelity::Draft);
    EXPECT_NEAR(cloth[0].more_ms, -0.5, 1e-9) << "where the setting errs least";
    EXPECT_NEAR(cloth[0].error, 0.03, 1e-12);
    EXPECT_NEAR(cloth[1].more_ms, 2, 1e-9);
    EXPECT_NEAR(cloth[1].error_before, 0.02, 1e-12);
    EXPECT_TRUE(prices_of(points, "rope").empty()) << "nothing to compare with";
    EXPECT_EQ(price_text(cloth),
              "draft: -0.500 ms a frame, error 1 % to 3 %\n"
              "precise: +2.000 ms a frame, error 2 % to 0.5 %");
}

TEST(FidelityPrice, ErrorsThatNobodySeesAreNotCompared) {
    EXPECT_EQ(price_text(std::vector<FidelityPrice>{{.fidelity = scene::Fidelity::Draft,
                                                     .more_ms = -0.5,
                                                     .error = 2e-8,
                                                     .error_before = 1e-8}}),
              "draft: -0.500 ms a frame, error below 0.001 % with either");
}

}  // namespace
}  // namespace plumbline::study
