// The sun's shadows in several cascades, near and far, where geometry puts them. SOURCES B32.
#include "tests/engine/render/image_fixture.h"

#include <optional>

namespace plumbline::render {
namespace {

constexpr std::uint32_t kWidth_px = 960;
constexpr std::uint32_t kHeight_px = 640;

/// A plain seen from 8 m up, over which the sun shines from the left at 45 degrees: what is h high
/// shades the ground from its foot to h to the right of it.
class CascadesGl : public ImageGl {
protected:
    void SetUp() override {
        ImageGl::SetUp();
        frame_ = empty_frame(kWidth_px, kHeight_px);
        frame_.camera = camera_at(kEye, {0.0F, 0.0F, -10.0F});
        add_box(frame_, {900.0F, 1.0F, 900.0F}, {0.0F, -0.5F, 0.0F}, matt(Vec3f{0.8F}));
        frame_.sun = DirectionalLight{.direction_world = glm::normalize(Vec3f{1.0F, -1.0F, 0.0F}),
                                      .radiance = Vec3f{3.0F}};
        frame_.sun_shadow = SunShadow{.size_px = 2048, .distance_m = 240.0F, .cascades = 4};
    }

    /// How bright the ground is there; nothing out of sight.
    std::optional<int> ground(const assets::ImageData& image, float x, float z) const {
        const Camera& camera = frame_.camera;
        const Vec3f seen =
            glm::inverse(camera.orientation) * (Vec3f{x, 0.0F, z} - camera.position_world);
        const float tan_y = std::tan(camera.fov_y_rad * 0.5F);
        const float tan_x = tan_y * static_cast<float>(kWidth_px) / static_cast<float>(kHeight_px);
        const Vec2f share{0.5F + 0.5F * seen.x / (-seen.z * tan_x),
                          0.5F - 0.5F * seen.y / (-seen.z * tan_y)};
        if (seen.z > -0.1F || std::min(share.x, share.y) < 0.0F ||
            std::max(share.x, share.y) >= 1.0F)
            return {};
        return pixel_at(image,
                        static_cast<std::uint32_t>(share.x * kWidth_px),
                        static_cast<std::uint32_t>(share.y * kHeight_px))
            .g;
    }

    static constexpr Vec3f kEye{0.0F, 8.0F, 30.0F};
    RenderFrame frame_;
};

TEST_F(CascadesGl, ShadowsHangAtTheFeetOfBoxesNearAndFar) {
    struct Box {
        float z;
        float height_m;
        float depth_m;
    };
    // 14, 54 and 150 m from the eye: of four, in the first, the third and the last cascade.
    const std::array<Box, 3> boxes{
        {{18.0F, 2.0F, 1.0F}, {-23.0F, 4.0F, 4.0F}, {-120.0F, 10.0F, 40.0F}}};
    for (const Box& box : boxes) {
        add_box(frame_,
                {1.0F, box.height_m, box.depth_m},
                {-0.5F, 0.5F * box.height_m, box.z},
                matt({0.8F, 0.1F, 0.1F}));
    }
    for (const std::uint32_t cascades : {1U, 2U, 3U, 4U}) {
        frame_.sun_shadow->cascades = cascades;
        const auto image = draw(frame_);
        const int lit = ground(image, -6.0F, 15.0F).value_or(0);
        EXPECT_GT(lit, 180);
        for (const Box& box : boxes) {
            // From the foot, which is at x = 0, to the shadow's end; two of the farthest texels off.
            const float off_m = cascades == 1 || box.z < -100.0F ? 0.5F : 0.25F;
            for (float x = off_m; x < box.height_m - off_m; x += 0.2F) {
                const auto shaded = ground(image, x, box.z);
                ASSERT_TRUE(shaded);
                EXPECT_LT(*shaded, 20) << cascades << " cascades, " << x << " m from " << box.z;
            }
            for (const float x : {box.height_m + off_m + 0.1F, -1.5F - off_m})
                EXPECT_NEAR(ground(image, x, box.z).value_or(0), lit, 4) << x << ' ' << box.z;
        }
    }
}

TEST_F(CascadesGl, AWallsShadowRunsOnOverTheBorders) {
    // Out of the image to beyond the last cascade's start.
    add_box(frame_, {1.0F, 4.0F, 400.0F}, {-0.5F, 2.0F, -170.0F}, matt({0.8F, 0.1F, 0.1F}));
    for (const std::uint32_t cascades : {2U, 3U, 4U}) {
        frame_.sun_shadow->cascades = cascades;
        const auto image = draw(frame_);
        const int lit = ground(image, 8.0F, 0.0F).value_or(0);
        int samples = 0;
        for (float z = 10.0F; z > -170.0F; z -= 0.25F) {
            for (const float x : {1.0F, 2.0F, 3.0F}) {
                const auto shaded = ground(image, x, z);
                ASSERT_TRUE(shaded) << x << ' ' << z;
                ASSERT_LT(*shaded, 20) << cascades << " cascades: a gap at " << x << ' ' << z;
                ++samples;
            }
            ASSERT_NEAR(ground(image, 6.0F, z).value_or(0), lit, 6) << cascades << ' ' << z;
        }
        EXPECT_GT(samples, 2000);
    }
}

TEST_F(CascadesGl, ARoofHighAboveEveryCascadeCasts) {
    // Its shadow lies as far to the right of it as it is high: 14 m from the eye.
    constexpr float kUp_m = 60.0F;
    add_box(frame_, {4.0F, 1.0F, 6.0F}, {-kUp_m, kUp_m, 18.0F}, matt(Vec3f{0.8F}));
    for (const std::uint32_t cascades : {1U, 4U}) {
        frame_.sun_shadow->cascades = cascades;
        const auto image = draw(frame_);
        EXPECT_LT(ground(image, 0.0F, 18.0F).value_or(255), 20) << cascades;
        EXPECT_GT(ground(image, 4.0F, 18.0F).value_or(0), 180) << cascades;
    }
}

TEST_F(CascadesGl, FarShadowsReachAsFarAsOneSees) {
    add_box(frame_, {1.0F, 30.0F, 120.0F}, {-0.5F, 15.0F, -260.0F}, matt({0.8F, 0.1F, 0.1F}));
    frame_.sun_shadow = SunShadow{.size_px = 1024, .distance_m = 60.0F, .cascades = 1};
    auto image = draw(frame_);
    const int lit = ground(image, -20.0F, -260.0F).value_or(0);
    EXPECT_GT(lit, 180);
    EXPECT_NEAR(ground(image, 12.0F, -260.0F).value_or(0), lit, 4) << "beyond the scene's distance";
    EXPECT_EQ(bytes_of("sun_shadow"), std::uint64_t{1024} * 1024 * 4);
    frame_.quality.far_shadows = true;
    image = draw(frame_);
    for (const float x : {4.0F, 12.0F, 24.0F})
        EXPECT_LT(ground(image, x, -260.0F).value_or(255), 20) << x;
    EXPECT_NEAR(ground(image, 40.0F, -260.0F).value_or(0), lit, 4);
    EXPECT_EQ(bytes_of("sun_shadow"), std::uint64_t{1024} * 1024 * 4 * 2) << "one cascade more";
}

}  // namespace
}  // namespace plumbline::render
