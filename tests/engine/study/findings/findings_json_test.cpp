#include "engine/study/findings/findings_json.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace plumbline::study {
namespace {

Findings a_study() {
    const Setting small{.step_hz = 240, .substeps = 4, .precision = Precision::Float64};
    const Setting stock{.solver = physics::Solver::BulletSi, .substeps = 1, .iterations = 10};
    Subject subject{.id = "A20 e=0.5",
                    .title = "Bounce, \"dropped\"",
                    .set_up = "A ball, falling.",
                    .reference = "apex_n = e^(2n) H",
                    .tier = Tier::TwoIntegrators,
                    .peer_scene = "bounce",
                    .metrics = {{"apex, first", "1 m"}, {"energy", "start"}},
                    .euler_floor = {{1.0 / 60, 0.1 / 3}},
                    .points = {{.setting = small,
                                .errors = {1e-300, 0.1},
                                .cost = {.ms_per_s_min = 0.1,
                                         .ms_per_s_median = 0.2,
                                         .ms_per_s_max = 0.3,
                                         .repeats = 5,
                                         .step_ms_median = 0.004,
                                         .step_ms_p99 = 0.005,
                                         .work_per_s = 1234}},
                               {.setting = stock, .status = RunStatus::Crashed, .why = "signal 11"},
                               {.setting = stock, .errors = {std::nan(""), 2}}},
                    .verdicts = {{.knob = "step rate",
                                  .solver = physics::Solver::BulletSi,
                                  .held = "x 1, 10 it",
                                  .trend = Trend::Converges,
                                  .order = 1.01,
                                  .theory = 1,
                                  .halvings = 4},
                                 {.knob = "sub-steps", .trend = Trend::TooFew}},
                    .notes = {"a note"}};
    return {.command = "plumbline study A20",
            .machine = "a machine",
            .build = "0.1",
            .made_on = "2026-11-21",
            .complete = false,
            .clock_spread = 0.03,
            .subjects = {subject},
            .images = {{.scene = "garden.toml",
                        .width_px = 640,
                        .height_px = 360,
                        .samples_per_pixel = 16,
                        .mean_luminance = 0.1,
                        .rows = {{.name = "level high",
                                  .error = {.mean = 0.1 / 3, .rms = 0.1},
                                  .cpu_ms = 12.5,
                                  .more_ms = {.mean = -1e-3, .standard_error = 0.1, .pairs = 4},
                                  .unbeaten = true,
                                  .verdict = "\"so\""}}}}};
}

TEST(FindingsJson, ReadsBackWhatItWrote) {
    const std::string text = findings_to_json(a_study());
    const Result<Findings> read = findings_from_json(text);
    ASSERT_TRUE(read.ok()) << read.error().message;
    EXPECT_EQ(findings_to_json(*read), text);
    const Subject& subject = read->subjects.at(0);
    EXPECT_EQ(subject.points.at(0).setting, a_study().subjects[0].points[0].setting);
    EXPECT_EQ(subject.points.at(0).errors.at(0), 1e-300);
    EXPECT_EQ(subject.points.at(1).status, RunStatus::Crashed);
    EXPECT_TRUE(std::isnan(subject.points.at(2).errors.at(0)));
    EXPECT_EQ(read->images.at(0).rows.at(0).error.mean, 0.1 / 3);
    EXPECT_TRUE(read->images.at(0).rows.at(0).unbeaten);
    EXPECT_EQ(subject.verdicts.at(0).order, 1.01);
    EXPECT_EQ(subject.verdicts.at(1).order, std::nullopt);
    EXPECT_EQ(subject.euler_floor.at(0).error, 0.1 / 3);
    EXPECT_FALSE(read->complete);
}

TEST(FindingsJson, PartsReadBackAlone) {
    const Subject subject = a_study().subjects[0];
    EXPECT_EQ(subject_to_json(*subject_from_json(subject_to_json(subject))),
              subject_to_json(subject));
    for (const Point& point : subject.points) {
        EXPECT_EQ(*setting_from_json(setting_to_json(point.setting)), point.setting);
        EXPECT_EQ(point_to_json(*point_from_json(point_to_json(point))), point_to_json(point));
    }
}

TEST(FindingsJson, NamesWhatItDoesNotKnow) {
    const std::string good = setting_to_json({});
    const auto with = [&](const char* from, const char* to) {
        std::string text = good;
        return text.replace(text.find(from), std::string(from).size(), to);
    };
    const std::pair<std::string, const char*> bad[] = {
        {"", "not what a study writes"},
        {"[]", "array"},
        {with("small_step", "smallstep"), "smallstep"},
        {with("float32", "float16"), "float16"},
        {with("step_hz", "hz"), "step_hz"},
        {with("60", "\"60\""), "number"}};
    for (const auto& [text, part] : bad) {
        const Result<Setting> read = setting_from_json(text);
        ASSERT_FALSE(read.ok()) << text;
        EXPECT_NE(read.error().message.find(part), std::string::npos) << read.error().message;
    }
}

TEST(FindingsCsv, HasALineForEveryPointAndMetric) {
    const std::string csv = findings_to_csv(a_study());
    EXPECT_EQ(std::ranges::count(csv, '\n'), 1 + 3 * 2);
    EXPECT_NE(csv.find("\nA20 e=0.5,\"apex, first\",1 m,T2 two integrators,small_step,240,4,16,1,"
                       "float64,done,,1e-300,0.1,0.2,0.3,5,0.004,0.005,1234\n"),
              std::string::npos)
        << csv;
    EXPECT_NE(csv.find(",crashed,signal 11,,"), std::string::npos) << csv;
}

}  // namespace
}  // namespace plumbline::study
