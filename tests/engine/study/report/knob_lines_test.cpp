#include "engine/study/report/knob_lines.h"

#include "engine/study/report/setting_names.h"
#include "tests/engine/study/report/sample_findings.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace plumbline::study {

namespace {

std::vector<std::string> names_of(const std::vector<KnobLine>& lines) {
    std::vector<std::string> names;
    for (const KnobLine& line : lines) names.push_back(line.name);
    return names;
}

Point point_at(const Setting& setting) {
    return {.setting = setting};
}

TEST(SettingNames, SayWhatTellsSettingsApart) {
    EXPECT_EQ(family_name({.substeps = 4}), "small_step x 4");
    EXPECT_EQ(family_name({.substeps = 4, .iterations = 2}), "small_step x 4, 2 it");
    const Setting bullet{.solver = physics::Solver::BulletSi,
                         .substeps = 1,
                         .iterations = 10,
                         .precision = Precision::Float64};
    EXPECT_EQ(family_name(bullet), "bullet_si, 10 it, float64");
    EXPECT_EQ(short_setting(bullet), "60 Hz, 10 it");
    EXPECT_EQ(contender_name(bullet), "bullet_si, float64");
    EXPECT_TRUE(family_name({.substeps = 0, .substeps_max = 16}).ends_with("-16"));
}

TEST(KnobLines, EveryPointIsOnOne) {
    const Subject subject = test::sample_subject("A01");
    const auto lines = knob_lines(subject.points);
    EXPECT_EQ(lines.size(), 6U);
    for (const Point& point : subject.points) {
        EXPECT_EQ(std::ranges::count_if(lines,
                                        [&](const KnobLine& line) {
                                            return std::ranges::find(line.points, &point) !=
                                                   line.points.end();
                                        }),
                  1)
            << setting_text(point.setting);
    }
}

TEST(KnobLines, SubStepsAndIterationsLeadOutOfARatesLine) {
    std::vector<Point> points;
    for (const int hz : {120, 30, 60}) points.push_back(point_at({.step_hz = hz, .substeps = 4}));
    for (const int substeps : {16, 1}) points.push_back(point_at({.substeps = substeps}));
    points.push_back(point_at({.substeps = 4, .iterations = 8}));
    points.push_back(point_at({.substeps = 0}));
    const auto lines = knob_lines(points);
    ASSERT_EQ(lines.size(), 4U);
    EXPECT_EQ(lines[0].name, "small_step x 4");
    EXPECT_TRUE(lines[0].is_of_rate);
    EXPECT_EQ(lines[0].points.front()->setting.step_hz, 30);
    EXPECT_EQ(lines[1].name, "small_step 60 Hz x 1 to 16");
    EXPECT_EQ(lines[1].points.size(), 3U);  // with the one of the rates at 60 Hz
    EXPECT_EQ(lines[2].name, "small_step 60 Hz, 1 to 8 it");
    EXPECT_EQ(lines[2].points.size(), 2U);
    EXPECT_EQ(lines[3].points.size(), 1U);  // on demand: alone
    EXPECT_FALSE(lines[3].is_of_rate);
}

TEST(KnobLines, NoneOfNothing) {
    EXPECT_TRUE(knob_lines({}).empty());
    const std::vector<Point> one{point_at({.substeps = 2})};
    EXPECT_EQ(names_of(knob_lines(one)), std::vector<std::string>{"small_step 60 Hz x 2"});
}

}  // namespace

}  // namespace plumbline::study
