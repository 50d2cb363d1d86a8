#include "engine/study/scenes/scene_plan.h"

#include <gtest/gtest.h>

#include <vector>

namespace plumbline::study {
namespace {

TEST(ScenePlan, CountsTheTimeOfAllItsWorkers) {
    const ScenePlan plan(100, {.count = 4}, {});
    EXPECT_NEAR(plan.left_s(), 100, 0.5);
    EXPECT_NEAR(plan.cpu_left_s(), 400, 2);
    EXPECT_NEAR(plan.cpu_left_s(0.25), 100, 2);
    EXPECT_EQ(ScenePlan(10, {.count = 0}, {}).workers(), 1) << "one at least";
    const ScenePlan over(-1, {.count = 2}, {});
    EXPECT_EQ(over.cpu_left_s(), 0);
    EXPECT_LT(over.left_s(), 0);
}

TEST(ScenePlan, NothingToRunIsDoneAtOnceAndExtendingGivesTime) {
    int reports = 0;
    ScenePlan plan(10, {}, [&](const StudyProgress&) { ++reports; });
    const auto never = [](const ScenePlan::Finished&) { ADD_FAILURE(); };
    EXPECT_TRUE(plan.run({}, never).ok());
    EXPECT_EQ(reports, 0);
    EXPECT_FALSE(plan.interrupted());
    plan.extend(50);
    EXPECT_NEAR(plan.left_s(), 50, 0.5);
}

TEST(ScenePlan, IsExtendedForAsMuchAsIsNeededUpToAMost) {
    ScenePlan plan(10, {.count = 2}, {});
    plan.extend_for(15, 3);
    EXPECT_NEAR(plan.left_s(), 10, 0.5) << "there are 20 s of CPU time";
    plan.extend_for(40, 3);
    EXPECT_NEAR(plan.cpu_left_s(), 40, 1);
    plan.extend_for(1000, 3);
    EXPECT_NEAR(plan.left_s(), 60, 0.5);
}

// The programs are not beside the tests: refused, after it was said that nothing is done.
TEST(ScenePlan, SaysWhichProgramIsMissing) {
    std::vector<StudyProgress> said;
    ScenePlan plan(10, {}, [&](const StudyProgress& progress) { said.push_back(progress); });
    plan.expect(2);
    const std::vector<SceneRun> runs(1);
    const Result<Done> done =
        plan.run(runs, [](const ScenePlan::Finished&) { ADD_FAILURE() << "nothing ran"; });
    ASSERT_FALSE(done.ok());
    EXPECT_NE(done.error().message.find("need the program"), std::string::npos)
        << done.error().message;
    ASSERT_EQ(said.size(), 1U);
    EXPECT_NEAR(said[0].left_s, 2, 0.1) << "what is expected, not all that there is";
    EXPECT_NEAR(said[0].share, 0, 0.05);
}

}  // namespace
}  // namespace plumbline::study
