#include "engine/study/report/scores.h"

#include "tests/engine/study/report/sample_findings.h"

#include <gtest/gtest.h>

namespace plumbline::study {

namespace {

TEST(Scores, CountWhoReachesWhatAndAtWhatPrice) {
    Findings findings;
    for (const char* id : {"A01", "A02", "A03"}) {
        findings.subjects.push_back(test::sample_subject(id));
    }
    // In the last one float64 costs three times as much, and a run of bullet_si crashes.
    for (Point& point : findings.subjects[2].points) {
        if (point.setting.precision == Precision::Float64) point.cost.ms_per_s_min *= 3;
    }
    findings.subjects[2].points.back().status = RunStatus::Crashed;
    const auto scores = scores_of(findings);
    ASSERT_EQ(scores.size(), 3U);

    EXPECT_EQ(scores[0].name, "small_step");
    EXPECT_EQ(scores[0].subjects, 3);
    EXPECT_EQ(scores[0].reached_01, 3);
    EXPECT_EQ(scores[0].cheapest_at_1, 3);  // of equals the first
    EXPECT_DOUBLE_EQ(scores[0].median_price, 1);
    EXPECT_EQ(scores[0].runs, 36);

    EXPECT_EQ(scores[1].name, "small_step, float64");
    EXPECT_EQ(scores[1].cheapest_at_1, 0);
    EXPECT_DOUBLE_EQ(scores[1].median_price, 1);  // of 1, 1, 3

    EXPECT_EQ(scores[2].name, "bullet_si");
    EXPECT_EQ(scores[2].reached_5, 0);  // it stalls above 6 %
    EXPECT_DOUBLE_EQ(scores[2].median_price, 0);
    EXPECT_EQ(scores[2].no_answer, 1);
}

TEST(Scores, NothingHasNoTable) {
    EXPECT_EQ(score_table({}), "");
    Findings findings;
    findings.subjects.resize(1);
    EXPECT_EQ(score_table(findings), "");
}

}  // namespace

}  // namespace plumbline::study
