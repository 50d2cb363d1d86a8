// What the scene is drawn into.
#include "engine/render/passes/scene_target.h"
#include "tests/engine/render/gl_fixture.h"

#include <glad/gl.h>

namespace plumbline::render {
namespace {

class SceneTargetGl : public GlTest {
protected:
    static void fill(const SceneTarget& target, float red) {
        target.bind();
        glDisable(GL_SCISSOR_TEST);
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        glClearColor(red, 0.0F, 0.0F, 1.0F);
        glClear(GL_COLOR_BUFFER_BIT);
    }
    static float red_at(const SceneTarget& target, std::uint32_t x, std::uint32_t y) {
        std::vector<float> texels(std::size_t{target.color().width()} * target.color().height() *
                                  4);
        glBindTexture(GL_TEXTURE_2D, target.color().name());
        glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_FLOAT, texels.data());
        return texels[(std::size_t{y} * target.color().width() + x) * 4];
    }
};

constexpr PixelSize kEightByFour{8, 4};

TEST_F(SceneTargetGl, HoldsTheBytesThatItSays) {
    for (const std::uint32_t samples : {1U, 4U}) {
        SceneTarget target;
        ASSERT_TRUE(target.resize(kEightByFour, gl::TargetFormat::HdrColor, samples).ok());
        if (target.samples() != samples) continue;  // the driver has fewer
        EXPECT_EQ(target.bytes(),
                  SceneTarget::bytes_for(kEightByFour, gl::TargetFormat::HdrColor, samples));
        EXPECT_EQ(target.bytes(), 32U * (8U + 4U) * (samples == 1 ? 1U : 5U));
    }
}

TEST_F(SceneTargetGl, IsMadeAnewOnlyForAnotherSizeOrNumberOfSamples) {
    SceneTarget target;
    ASSERT_TRUE(target.resize(kEightByFour, gl::TargetFormat::HdrColor, 1).ok());
    const unsigned int name = target.color().name();
    fill(target, 0.25F);
    ASSERT_TRUE(target.resize(kEightByFour, gl::TargetFormat::HdrColor, 1).ok());
    EXPECT_EQ(target.color().name(), name);
    EXPECT_EQ(red_at(target, 3, 3), 0.25F);
    ASSERT_TRUE(target.resize({8, 5}, gl::TargetFormat::HdrColor, 1).ok());
    EXPECT_EQ(target.color().height(), 5U);
    ASSERT_TRUE(target.resize({8, 5}, gl::TargetFormat::HdrColor, 2).ok());
    EXPECT_GT(target.samples(), 1U);
}

TEST_F(SceneTargetGl, SeveralSamplesAreSeenOnceResolved) {
    SceneTarget target;
    ASSERT_TRUE(target.resize(kEightByFour, gl::TargetFormat::HdrColor, 2).ok());
    fill(target, 0.5F);
    target.resolve();
    EXPECT_EQ(red_at(target, 7, 3), 0.5F);
}

TEST_F(SceneTargetGl, ACopyTakesFromTheFirstToTheLastPixel) {
    SceneTarget from;
    SceneTarget to;
    ASSERT_TRUE(from.resize(kEightByFour, gl::TargetFormat::HdrColor, 1).ok());
    ASSERT_TRUE(to.resize(kEightByFour, gl::TargetFormat::HdrColor, 1).ok());
    fill(from, 1.0F);
    fill(to, 0.0F);
    to.copy(from, {2.0F, 1.0F}, {5.0F, 2.0F});
    for (std::uint32_t y = 0; y < 4; ++y) {
        for (std::uint32_t x = 0; x < 8; ++x) {
            const bool inside = x >= 2 && x <= 5 && y >= 1 && y <= 2;
            EXPECT_EQ(red_at(to, x, y), inside ? 1.0F : 0.0F) << x << ' ' << y;
        }
    }
}

}  // namespace
}  // namespace plumbline::render
