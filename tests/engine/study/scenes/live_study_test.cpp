#include "engine/study/scenes/live_study.h"

#include <gtest/gtest.h>

#include <chrono>

namespace plumbline::study {
namespace {

// The programs are not beside the tests.
TEST(LiveStudy, SaysWhyItCameToNothing) {
    LiveStudy live({.scene = "/nowhere.toml"});
    for (int i = 0; i < 1000 && !live.state().ended; ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    const LiveStudy::State state = live.state();
    ASSERT_TRUE(state.ended);
    EXPECT_NE(state.failure.find("need the program"), std::string::npos) << state.failure;
    EXPECT_TRUE(state.study.subject.points.empty());
    EXPECT_EQ(live.revision(), 1U);
    live.stop();
}

}  // namespace
}  // namespace plumbline::study
