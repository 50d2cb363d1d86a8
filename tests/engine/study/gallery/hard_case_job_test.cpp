// One hard case in a worker process.
#include "tests/engine/study/gallery/sample_table.h"

#include <cmath>
#include <limits>
#include <string>

namespace plumbline::study {
namespace {

TEST(Gallery, ARunSaysTheSameTwice) {
    const CaseRun run{.scene = kAssets / "scenes/hard/H25.toml"};
    const Result<CaseResult> first = run_case(run);
    const Result<CaseResult> second = run_case(run);
    ASSERT_TRUE(first.ok() && second.ok());
    EXPECT_TRUE(first->passed);
    EXPECT_NEAR(first->simulated_s, 2, 1e-9);
    EXPECT_EQ(first->work_per_s, second->work_per_s);
    ASSERT_EQ(first->rules.size(), second->rules.size());
    for (std::size_t i = 0; i < first->rules.size(); ++i)
        EXPECT_EQ(first->rules[i].value, second->rules[i].value) << first->rules[i].text;
}

TEST(Gallery, ARunThatTakesTooLongIsGivenUp) {
    const Result<CaseResult> result =
        run_case({.scene = kAssets / "scenes/hard/H11.toml", .cpu_limit_s = 1e-6});
    ASSERT_TRUE(result.ok());
    EXPECT_TRUE(result->ran);
    EXPECT_FALSE(result->passed);
    EXPECT_TRUE(result->gave_up) << "nothing had failed by then";
    EXPECT_NE(result->why.find("given up"), std::string::npos) << result->why;
    EXPECT_NEAR(result->simulated_s, 1.0 / 60, 1e-9);
}

TEST(Stability, ResultsSurviveTheirJson) {
    CaseResult before = result(false, -0.5);
    before.why = "a \"reason\"";
    before.interventions = {
        .braked_J = 0.5, .braked_islands = 2, .clamped_bodies = 3, .left_out_pairs = 6};
    before.rules.push_back({.text = "height_m above 0",
                            .allowed = {Allowed::Kind::Near, 2, 0.5},
                            .value = std::nan(""),
                            .margin = -std::numeric_limits<double>::infinity()});
    const Result<CaseResult> after = parse_case_result(case_result_json(before));
    ASSERT_TRUE(after.ok());
    EXPECT_EQ(after->why, before.why);
    EXPECT_EQ(after->cpu_ms_per_s, before.cpu_ms_per_s);
    EXPECT_EQ(after->work_per_s, before.work_per_s);
    EXPECT_EQ(after->interventions.braked_J, 0.5);
    EXPECT_EQ(after->interventions.braked_islands, 2U);
    EXPECT_EQ(after->interventions.clamped_bodies, 3U);
    EXPECT_EQ(after->interventions.left_out_pairs, 6U);
    ASSERT_EQ(after->rules.size(), 2U);
    EXPECT_EQ(after->rules[0].margin, -0.5);
    EXPECT_EQ(after->rules[0].allowed.kind, Allowed::Kind::Below);
    EXPECT_EQ(after->rules[1].allowed.kind, Allowed::Kind::Near);
    EXPECT_EQ(after->rules[1].allowed.limit, 2);
    EXPECT_EQ(after->rules[1].allowed.within, 0.5);
    EXPECT_TRUE(std::isnan(after->rules[1].value));
    EXPECT_EQ(after->rules[1].margin, before.rules[1].margin);
    EXPECT_EQ(after->worst()->text, "height_m above 0");
    EXPECT_FALSE(parse_case_result("{\"ran\": true}").ok());
    EXPECT_FALSE(parse_case_result("nonsense").ok());
}

TEST(Stability, JobsRefuseWithAReason) {
    for (const std::string body :
         {"",
          "{}",
          R"({"scene": "x.toml", "solver": "best", "step_hz": 60, "cpu_limit_s": 1})",
          R"({"scene": "none.toml", "solver": "small_step", "step_hz": 60, "cpu_limit_s": 1})"}) {
        const Result<std::string> answer = run_hard_case_job(body);
        ASSERT_FALSE(answer.ok()) << body;
        EXPECT_FALSE(answer.error().message.empty()) << body;
    }
}

TEST(HardCaseJob, TheWorstRuleIsTheOneWithTheLeastMargin) {
    EXPECT_EQ(CaseResult{}.worst(), nullptr);
    CaseResult judged = result(true, 0.5);
    judged.rules.push_back({.text = "tighter", .margin = 0.1});
    judged.rules.push_back({.text = "wider", .margin = 0.9});
    EXPECT_EQ(judged.worst()->text, "tighter");
}

TEST(HardCaseJob, AJobSaysWhatItsRunSays) {
    ::setenv("PLUMBLINE_DATA", PL_SOURCE_DIR, 1);
    const CaseRun run{.scene = kAssets / "scenes/hard/H25.toml"};
    const Result<CaseResult> here = run_case(run);
    const Result<CaseResult> told =
        parse_case_result(run_hard_case_job(case_job_body(run)).value());
    ASSERT_TRUE(here.ok() && told.ok());
    EXPECT_TRUE(told->ran && told->passed) << told->why;
    EXPECT_EQ(told->work_per_s, here->work_per_s);
    EXPECT_EQ(told->simulated_s, here->simulated_s);
    ASSERT_EQ(told->rules.size(), here->rules.size());
    EXPECT_EQ(told->rules[0].value, here->rules[0].value);
}

}  // namespace
}  // namespace plumbline::study
