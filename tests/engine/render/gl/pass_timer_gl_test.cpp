// Times of passes on both processors.
#include "engine/render/gl/pass_timer.h"
#include "tests/engine/render/gl_fixture.h"

#include <glad/gl.h>

namespace plumbline::render {
namespace {

class PassTimerGl : public GlTest {};

TEST_F(PassTimerGl, TellsPassesInTheirOrderAndForgetsThemWithTheNextFrame) {
    gl::PassTimers timers;
    for (int frame = 0; frame < 3; ++frame) {
        timers.begin_frame();
        EXPECT_TRUE(timers.timings().empty());
        { const gl::PassTimers::Scope first(timers, "opaque"); }
        { const gl::PassTimers::Scope second(timers, "sky"); }
        ASSERT_EQ(timers.timings().size(), 2U);
        EXPECT_EQ(timers.timings()[0].name, "opaque");
        EXPECT_EQ(timers.timings()[1].name, "sky");
        EXPECT_GE(timers.timings()[0].cpu_ms, 0.0);
    }
}

TEST_F(PassTimerGl, TheGpusTimeIsThatOfAnEarlierFrame) {
    gl::PassTimers timers;
    const auto frame = [&] {
        timers.begin_frame();
        { const gl::PassTimers::Scope pass(timers, "pass"); }
        glFinish();
        return timers.timings()[0].gpu_ms;
    };
    EXPECT_EQ(frame(), -1.0) << "not measured yet";
    double later = -1.0;
    for (int i = 0; i < 10; ++i) later = frame();
    EXPECT_GE(later, 0.0);
    EXPECT_LT(later, 1e4) << "software GL's first query can read as hours";
}

}  // namespace
}  // namespace plumbline::render
