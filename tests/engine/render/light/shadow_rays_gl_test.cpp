// Shadows of the sun against exact rays, pixel by pixel, from a grazing sun to one overhead: no specks
// of shade on what is lit (acne), no light at the foot of what casts (detachment).
#include "engine/render/light/shadow_fit.h"
#include "tests/engine/render/image_fixture.h"

#include <cmath>

namespace plumbline::render {
namespace {

constexpr std::uint32_t kSide_px = 320;
constexpr float kHalf_m = 6.0F;
constexpr float kEye_m = 60.0F;
constexpr Vec3f kBoxMin{-1.0F, 0.0F, -1.0F};
constexpr Vec3f kBoxMax{1.0F, 2.0F, 1.0F};

bool meets_box(const Vec3f& from, const Vec3f& way) {
    float first = 1e-5F;
    float last = 1e9F;
    for (int i = 0; i < 3; ++i) {
        if (std::abs(way[i]) < 1e-9F) {
            if (from[i] < kBoxMin[i] || from[i] > kBoxMax[i]) return false;
            continue;
        }
        const float a = (kBoxMin[i] - from[i]) / way[i];
        const float b = (kBoxMax[i] - from[i]) / way[i];
        first = std::max(first, std::min(a, b));
        last = std::min(last, std::max(a, b));
    }
    return first <= last;
}

struct Wrong {
    int acne{0};
    int detached{0};
    int compared{0};
};

class ShadowRaysGl : public ImageGl {
protected:
    void SetUp() override {
        ImageGl::SetUp();
        frame_ = empty_frame(kSide_px, kSide_px);
        frame_.camera = camera_at({0.0F, kEye_m, 0.0F}, Vec3f{0.0F});
        frame_.camera.fov_y_rad = 2.0F * std::atan(kHalf_m / kEye_m);
        add_box(frame_, {60.0F, 1.0F, 60.0F}, {0.0F, -0.5F, 0.0F}, matt(Vec3f{0.8F}));
        add_box(frame_, kBoxMax - kBoxMin, 0.5F * (kBoxMin + kBoxMax), matt({0.8F, 0.1F, 0.1F}));
        frame_.sun_shadow = SunShadow{.size_px = 2048, .distance_m = 80.0F};
    }

    /// The shade's edge may be off by so many texels of the map, laid on the ground along the light
    /// and across it.
    Wrong compare(float height_deg, float turn_deg, float edge_texels) {
        const float height = radians_from_degrees(height_deg);
        const float turn = radians_from_degrees(turn_deg);
        const Vec3f to_sun{
            std::cos(height) * std::cos(turn), std::sin(height), std::cos(height) * std::sin(turn)};
        // As light as can be: what is lit is 0.8 however low the sun.
        frame_.sun = DirectionalLight{.direction_world = -to_sun,
                                      .radiance = Vec3f{glm::pi<float>() / to_sun.y}};
        const ViewShape view{.position_world = frame_.camera.position_world,
                             .forward_world = {0.0F, -1.0F, 0.0F},
                             .fov_y_rad = frame_.camera.fov_y_rad};
        const float texel_m =
            fit_sun_shadow(view, -to_sun, frame_.sun_shadow->distance_m, 2048).texel_m;
        const float across_m = edge_texels * texel_m + 0.5F * kPixel_m;
        const float along_m = edge_texels * texel_m / to_sun.y + 0.5F * kPixel_m;
        const Vec3f along = along_m * Vec3f{std::cos(turn), 0.0F, std::sin(turn)};
        const Vec3f across = across_m * Vec3f{-std::sin(turn), 0.0F, std::cos(turn)};
        const auto image = draw(frame_);
        Wrong wrong;
        for (std::uint32_t y = 0; y < kSide_px; ++y) {
            for (std::uint32_t x = 0; x < kSide_px; ++x) {
                const Vec3f at{place(x), 0.0F, place(y)};
                // Where the eye sees the box or its rim there is no ground.
                const Vec3f eye{0.0F, kEye_m, 0.0F};
                const float margin = 1.5F * kPixel_m / kHalf_m;
                if (meets_box(at * (1.0F - margin), eye - at)) continue;
                const bool shaded = meets_box(at, to_sun);
                const bool is_edge = meets_box(at + along, to_sun) != shaded ||
                                     meets_box(at - along, to_sun) != shaded ||
                                     meets_box(at + across, to_sun) != shaded ||
                                     meets_box(at - across, to_sun) != shaded;
                if (is_edge) continue;
                const bool seen_dark = pixel_at(image, x, y).g < code_of(0.4F);
                wrong.acne += static_cast<int>(!shaded && seen_dark);
                wrong.detached += static_cast<int>(shaded && !seen_dark);
                ++wrong.compared;
            }
        }
        return wrong;
    }

    static constexpr float kPixel_m = 2.0F * kHalf_m / kSide_px;
    static float place(std::uint32_t pixel) {
        return (static_cast<float>(pixel) + 0.5F) * kPixel_m - kHalf_m;
    }

    RenderFrame frame_;
};

// One map as scenes have it. Not one pixel of the ground is wrong further from the shade's edge than one
// and a half texels.
TEST_F(ShadowRaysGl, NoPixelIsWrongFromFiveDegreesToNinety) {
    for (const float height_deg : {5.0F, 10.0F, 20.0F, 40.0F, 60.0F, 80.0F, 90.0F}) {
        for (const float turn_deg : {0.0F, 33.0F, 120.0F}) {
            const Wrong wrong = compare(height_deg, turn_deg, 1.5F);
            EXPECT_EQ(wrong.acne, 0) << height_deg << " degrees, turned " << turn_deg;
            EXPECT_EQ(wrong.detached, 0) << height_deg << " degrees, turned " << turn_deg;
            EXPECT_GT(wrong.compared, 50'000);
        }
    }
}

// The same with cascades, whose far ones have a bias of their own.
TEST_F(ShadowRaysGl, CascadesAreNoWorse) {
    frame_.sun_shadow->cascades = 3;
    for (const float height_deg : {10.0F, 45.0F, 80.0F}) {
        const Wrong wrong = compare(height_deg, 33.0F, 1.5F);
        EXPECT_EQ(wrong.acne, 0) << height_deg;
        EXPECT_EQ(wrong.detached, 0) << height_deg;
    }
}

}  // namespace
}  // namespace plumbline::render
