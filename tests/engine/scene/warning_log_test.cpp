// Warnings of a running scene.
#include "engine/scene/warning_log.h"

#include "tests/support/scene_in_code.h"

#include <gtest/gtest.h>

namespace plumbline::scene {
namespace {

using test::scene_of;

std::string logged(WarningLog& log, const Simulation& simulation) {
    testing::internal::CaptureStderr();
    log.log_new(simulation);
    return testing::internal::GetCapturedStderr();
}

TEST(WarningLog, TellsEachOnce) {
    test::Running run(scene_of({}));
    WarningLog log;
    EXPECT_EQ(logged(log, *run), "");
    run->warnings = {"one", "two"};
    const std::string first = logged(log, *run);
    EXPECT_LT(first.find("warning: one"), first.find("warning: two"));
    EXPECT_EQ(logged(log, *run), "");
    run->warnings.push_back("three");
    const std::string second = logged(log, *run);
    EXPECT_NE(second.find("three"), std::string::npos);
    EXPECT_EQ(second.find("one"), std::string::npos);
}

}  // namespace
}  // namespace plumbline::scene
