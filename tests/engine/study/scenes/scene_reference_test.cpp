#include "engine/study/scenes/scene_reference.h"

#include <gtest/gtest.h>

namespace plumbline::study {
namespace {

/// Two runs of one body; its place and the centre are off by `off_m` at the second moment.
SceneAnswer answer_off_by(double off_m, int copies) {
    SceneAnswer answer{.bodies = 1, .mass_kg = 1, .gravity_mps2 = 10, .body_size_m = 1};
    for (int i = 0; i < copies; ++i) {
        Trace trace{.energy_turnover_J = 1};
        for (const double x : {0.0, off_m}) {
            Moment moment{.time_s = x == 0 ? 0.0 : 1.0, .bodies = {{.position_m = {x, 0, 0}}}};
            moment.layout.center_m.x = x;
            trace.moments.push_back(moment);
        }
        answer.traces.push_back(trace);
    }
    return answer;
}

TEST(SceneReference, RunsAreComparedOneByOneAndCopiesByTheirStatistics) {
    SceneReference reference{.answer = answer_off_by(0, 3),
                             .scales = {.length_m = 10, .energy_J = 1, .body_size_m = 1}};
    const SceneAnswer off = answer_off_by(0.5, 3);
    EXPECT_NEAR(errors_against(reference, off)[0], 0.05, 1e-12);
    EXPECT_EQ(metrics_of(reference).size(), errors_against(reference, off).size());
    EXPECT_EQ(metrics_of(reference)[0].name, trajectory_metrics(reference.scales)[0].name);
    reference.chaotic = true;
    EXPECT_EQ(metrics_of(reference)[0].name, ensemble_metrics(reference.scales)[0].name);
    EXPECT_EQ(metrics_of(reference).size(), errors_against(reference, off).size());
    EXPECT_NEAR(errors_against(reference, off)[0], 0.05, 1e-12);
}

TEST(SceneReference, NoneIsMadeWithoutThePrograms) {
    ScenePlan plan(10, {}, {});
    const SceneProbe probe{.scene = "x.toml", .moments = {30}, .second_cpu_s = 1e-3};
    const auto reference =
        make_reference(plan, probe, 0.5, [](const SceneReference&) -> Result<Done> {
            ADD_FAILURE() << "nothing ran";
            return Done{};
        });
    ASSERT_FALSE(reference.ok());
    EXPECT_NE(reference.error().message.find("need the program"), std::string::npos);
}

}  // namespace
}  // namespace plumbline::study
