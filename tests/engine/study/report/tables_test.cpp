#include "engine/study/report/tables.h"

#include "tests/engine/study/report/sample_findings.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::study {

namespace {

std::size_t count_of(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
        ++count;
    }
    return count;
}

TEST(Tables, EveryRunHasItsRow) {
    const Subject subject = test::sample_subject("A01");
    const std::string table = points_table(subject);
    for (const Point& point : subject.points) {
        EXPECT_EQ(count_of(table, ">" + setting_text(point.setting) + "<"), 1U)
            << setting_text(point.setting);
    }
    EXPECT_EQ(count_of(table, "<tr"), subject.points.size() + 1);
    EXPECT_FALSE(test::holds(table, "bad"));
}

TEST(Tables, RunsWithoutAnswerAreRedAndSayWhy) {
    Subject subject = test::sample_subject("A01");
    subject.points[0].status = RunStatus::Crashed;
    subject.points[0].why = "signal 11 <segv>";
    subject.points[0].errors.clear();
    subject.points[1].status = RunStatus::TimedOut;
    subject.points[2].errors = {std::nan("")};
    const std::string table = points_table(subject);
    EXPECT_EQ(count_of(table, "<tr class=\"bad\">"), 2U);
    EXPECT_TRUE(test::holds(table, "crashed: signal 11 &lt;segv&gt;"));
    EXPECT_TRUE(test::holds(table, "<td class=\"n bad\">not a number</td>"));
    EXPECT_EQ(failure_line(subject),
              "<p class=\"bad\">2 of 36 runs failed: 1 crashed, 1 timed out.</p>\n");
    EXPECT_EQ(failure_line(test::sample_subject("A01")), "");
}

TEST(Tables, TheVerdictLineNamesTheCheapestAndWhoFails) {
    // 2 % at 60 Hz and first order: 1 % at 120 Hz, for 0.02 ms/s at 60 Hz twice that.
    EXPECT_EQ(verdict_line(test::sample_subject("A01")),
              "1 % costs 0.04 ms/s with small_step at 120 Hz x 1; small_step, float64 0.04; "
              "not with bullet_si.");
    EXPECT_EQ(verdict_line(Subject{}), "No runs.");
    Subject hopeless = test::sample_subject("A01");
    std::erase_if(hopeless.points, [](const Point& point) {
        return point.setting.solver != physics::Solver::BulletSi;
    });
    EXPECT_EQ(verdict_line(hopeless), "Nobody reaches 1 %.");
}

TEST(Tables, CostsAndBudgetsPerSolver) {
    const std::string tables = cost_tables(test::sample_subject("A01"));
    EXPECT_EQ(count_of(tables, "not reached"), 3U);  // bullet_si: 7 % at best 6 %
    EXPECT_TRUE(test::holds(tables, "<b>0.01</b> ms/s <span class=\"soft\">30 Hz x 1</span>"));
    EXPECT_TRUE(test::holds(tables, "0.0312 % <span class=\"soft\">960 Hz x 4</span>"));
    EXPECT_EQ(cost_tables(Subject{}), "");
}

TEST(Tables, KnobsAreSaidInWords) {
    Subject subject = test::sample_subject("A01");
    std::string table = verdict_table(subject);
    EXPECT_TRUE(
        test::holds(table, "Pays: each doubling divides the error by about 2. As theory says."));
    EXPECT_TRUE(test::holds(table, "<td class=\"bad\">stalls</td>"));
    subject.verdicts[0].order = 0.7;
    subject.verdicts[1].trend = Trend::Diverges;
    table = verdict_table(subject);
    EXPECT_TRUE(test::holds(table, "divides the error by about 1.62. Theory says 2."));
    EXPECT_TRUE(test::holds(table, "Harms"));
    EXPECT_EQ(verdict_table(Subject{}), "");
}

TEST(Tables, EveryPeerHasItsRowByRisingCost) {
    const std::vector<PeerPoint> peers{{"dear <1>", 2, 9, 0.01}, {"cheap", 1, 3, 0.5}};
    const std::string table = peer_table(peers);
    EXPECT_TRUE(test::holds(table, "All 2 figures"));
    EXPECT_TRUE(test::holds(table, "<td>dear &lt;1&gt;</td><td class=\"n\">120</td>"));
    EXPECT_LT(table.find("cheap"), table.find("dear"));
    EXPECT_EQ(peer_table({}), "");
}

TEST(Tables, ContentsHaveALineEach) {
    Findings findings = test::sample_findings();
    findings.subjects.push_back(test::sample_subject("A02 <b>"));
    const std::string table = contents_table(findings);
    EXPECT_TRUE(test::holds(table, "<a href=\"#s1\">A01</a>"));
    EXPECT_TRUE(test::holds(table, "<a href=\"#s2\">A02 &lt;b&gt;</a>"));
}

}  // namespace

}  // namespace plumbline::study
