// Hard cases of assets/scenes/hard, held to the rules of their own files where `plumbline stability` does
// not look: at other rates, and in float64.
#include "engine/study/gallery/gallery.h"
#include "tests/scenarios/families/case_run.h"

#include <filesystem>

namespace plumbline::study {
namespace {

struct GalleryCase {
    std::string id;
    int step_hz{60};
};

std::vector<GalleryCase> gallery_cases() {
    const std::pair<const char*, std::vector<int>> all[] = {{"H01", {30, 60, 240}},
                                                            {"H02", {60}},
                                                            {"H03", {60}},
                                                            {"H04", {30, 60, 240}},
                                                            {"H05", {30, 60}},
                                                            {"H08", {60}},
                                                            {"H11", {60}},
                                                            {"H17", {30, 60, 240}},
                                                            {"H19", {60}},
                                                            {"H20", {60}},
                                                            {"H22", {60}},
                                                            {"H24", {30, 60, 240}},
                                                            {"H30", {60}},
                                                            {"H31", {60}},
                                                            {"H44", {60}},
                                                            {"H74", {30, 60, 240}}};
    std::vector<GalleryCase> cases;
    for (const auto& [id, rates] : all) {
        for (const int hz : rates) {
            if (kDouble || hz != 60) cases.push_back({id, hz});
        }
    }
    return cases;
}

class GalleryCases : public testing::TestWithParam<GalleryCase> {};

/// Rows are how far outside its limit a rule is, as a share of the limit.
TEST_P(GalleryCases, HoldTheirOwnRules) {
    const auto& [id, step_hz] = GetParam();
    const Result<CaseResult> result =
        run_case({.scene = std::filesystem::path(PL_SOURCE_DIR) / "assets/scenes/hard" /
                           fmt::format("{}.toml", id),
                  .step_hz = step_hz});
    ASSERT_TRUE(result.ok()) << result.error().message;
    ASSERT_TRUE(result->ran && !result->gave_up) << result->why;
    for (const RuleResult& rule : result->rules)
        expect_at_most(
            fmt::format("{} {} Hz: {}", id, step_hz, rule.text), std::max(0.0, -rule.margin), 0);
}

INSTANTIATE_TEST_SUITE_P(Shipped,
                         GalleryCases,
                         testing::ValuesIn(gallery_cases()),
                         [](const auto& tested) {
                             return fmt::format("{}At{}Hz", tested.param.id, tested.param.step_hz);
                         });

}  // namespace
}  // namespace plumbline::study
