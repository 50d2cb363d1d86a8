// The bar in a window, as its framebuffer holds it. Needs an X server: CTest runs it under xvfb-run.
#include "engine/app/overlay/loading_screen.h"

#include "engine/platform/window.h"
#include "engine/render/loading_bar.h"

#include <glad/gl.h>
#include <gtest/gtest.h>

#include <array>

namespace plumbline::app {
namespace {

using Code = std::array<unsigned char, 3>;
constexpr int kWidth = 300;
constexpr int kHeight = 180;
constexpr Code kDark{23, 28, 33};
constexpr Code kEmpty{41, 48, 54};
constexpr Code kFilled{232, 194, 107};

class LoadingBarGl : public testing::Test {
protected:
    void SetUp() override {
        Result<std::unique_ptr<platform::Window>> opened = platform::Window::open(
            {.title = "loading", .width = kWidth, .height = kHeight, .vsync = false});
        ASSERT_TRUE(opened.ok()) << opened.error().message;
        window_ = std::move(*opened);
    }
    void draw(float share, render::LoadingBackground background) {
        render::draw_loading_bar(
            window_->gl_loader(),
            {.width_px = kWidth, .height_px = kHeight, .share = share, .background = background});
    }
    /// `along` of the bar from its left end; it lies an eighth of the height above the lower edge.
    static Code at_bar(float along) { return at(100 + static_cast<int>(99.0F * along), 23); }
    static Code at(int x, int y) {
        Code code{};
        glReadPixels(x, y, 1, 1, GL_RGB, GL_UNSIGNED_BYTE, code.data());
        return code;
    }

    std::unique_ptr<platform::Window> window_;
};

TEST_F(LoadingBarGl, TheBarIsFilledSoFarBeforeThereIsARenderer) {
    for (const float share : {0.0F, 0.25F, 1.0F}) {
        draw(share, render::LoadingBackground::Dark);
        EXPECT_EQ(at(5, 5), kDark);
        EXPECT_EQ(at(150, 150), kDark);
        EXPECT_EQ(at_bar(0.1F), share > 0.0F ? kFilled : kEmpty);
        EXPECT_EQ(at_bar(0.9F), share > 0.9F ? kFilled : kEmpty);
    }
}

TEST_F(LoadingBarGl, WhileNobodyKnowsHowFarAPieceGoesToAndFro) {
    struct Place {
        double now_s;
        float filled;
        float empty;
    };
    for (const Place& place :
         {Place{4.0, 0.1F, 0.5F}, Place{4.5, 0.5F, 0.1F}, Place{5.0, 0.9F, 0.5F}}) {
        render::LoadingBar bar = waiting_bar_of(*window_, place.now_s);
        EXPECT_NEAR(bar.share - bar.from, 0.25F, 1e-6F);
        render::draw_loading_bar(window_->gl_loader(), bar);
        EXPECT_EQ(at_bar(place.filled), kFilled) << place.now_s;
        EXPECT_EQ(at_bar(place.empty), kEmpty) << place.now_s;
    }
}

TEST_F(LoadingBarGl, OverAFrameItLeavesTheFrame) {
    draw(0.0F, render::LoadingBackground::Dark);
    glClearColor(0.0F, 1.0F, 0.0F, 1.0F);
    glClear(GL_COLOR_BUFFER_BIT);
    draw(0.5F, render::LoadingBackground::AsItIs);
    EXPECT_EQ(at(150, 150), (Code{0, 255, 0}));
    EXPECT_EQ(at_bar(0.3F), kFilled);
    EXPECT_EQ(at_bar(0.7F), kEmpty);
    EXPECT_EQ(glIsEnabled(GL_SCISSOR_TEST), GL_FALSE);
}

TEST_F(LoadingBarGl, AWindowWithoutPixelsIsLeftAlone) {
    render::draw_loading_bar(window_->gl_loader(), {});
    draw(0.0F, render::LoadingBackground::Dark);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

}  // namespace
}  // namespace plumbline::app
