#include "engine/app/accuracy/accuracy_control.h"

#include "engine/core/io/files.h"
#include "engine/scene/scene_file.h"
#include "tests/engine/app/session_fixture.h"

#include <gtest/gtest.h>

namespace plumbline::app {
namespace {

const std::string kCase = "[scene]\ntitle = \"H99 a cube in the air\"\n" +
                          cube_text("cube", "0, 50, 0") +
                          R"([hard_case]
id = "H99"
shows = "A cube that falls."
known_to_fail = "nobody"
seconds = 1
[[hard_case.pass]]
measure = "height_m"
of = ["cube"]
above = 1
)";

// What the panel shows is of the setting in force, from the case's start.
TEST_F(SessionTest, AnotherSettingStartsAHardCaseAnew) {
    folder_.write("scene.toml", kCase);
    const auto session = open();
    ASSERT_TRUE(session && session->judge);
    FrameClock clock(session->simulation->step_s());
    AccuracyControl accuracy(*session, false);
    while (!session->judge->over()) {
        effects::advance(*session->simulation, *session->effects, *session->game, {});
        session->judge->after_step(*session->simulation);
    }
    EXPECT_EQ(session->judge->verdict(), study::Verdict::Pass);
    const study::Setting other{.solver = physics::Solver::BulletSi, .step_hz = 120, .substeps = 1};
    const std::string said = accuracy.apply({.setting = other}, clock);
    EXPECT_NE(said.find("hard case restarted"), std::string::npos) << said;
    EXPECT_EQ(session->judge->verdict(), study::Verdict::Undecided);
    EXPECT_FALSE(session->judge->over());
    EXPECT_EQ(session->simulation->steps(), 0U);
    EXPECT_EQ(session->simulation->physics.def().solver, physics::Solver::BulletSi);
    EXPECT_EQ(clock.step_s(), 1.0 / 120);
}

}  // namespace
}  // namespace plumbline::app
