// How wide the edges of the sun's shadows are: as its disc makes them, sharp where things touch.
#include "tests/engine/render/image_fixture.h"

#include <cmath>
#include <vector>

namespace plumbline::render {
namespace {

constexpr std::uint32_t kSunSide_px = 400;
constexpr float kSunHalf_m = 2.0F;
constexpr float kSunEye_m = 10.0F;
constexpr float kSunPixel_m = 2.0F * kSunHalf_m / kSunSide_px;
constexpr float kSunReach_m = 0.35F;    // either side of an edge
constexpr float kSunTexel_m = 0.0075F;  // about, of a map of 2048 over 12 m from the eye

class SoftSunGl : public ImageGl {
protected:
    /// What casts: a box in z > 0.
    struct Caster {
        float left_m{0.0F};
        float bottom_m{0.0F};
        float top_m{0.0F};
        float seen_from_m{0.0F};  ///< its edge is looked at on this stretch along x
        float seen_to_m{0.0F};
    };

    /// A plate so far above the floor, and a stretch of its shade that it does not hide.
    static Caster plate(float height_m) {
        return {.left_m = height_m - 1.0F,
                .bottom_m = height_m - 0.01F,
                .top_m = height_m + 0.01F,
                .seen_from_m = -0.7F,
                .seen_to_m = -0.2F};
    }

    /// The width of the shade's edge, m: that of the disc whose edge has the same spread. The sun stands
    /// 45 degrees high towards +x.
    float edge_m(const Caster& caster, float disc_rad, Drawn hardening = Drawn::Always) {
        RenderFrame frame = empty_frame(kSunSide_px, kSunSide_px);
        frame.camera = camera_at({0.0F, kSunEye_m, 0.0F}, Vec3f{0.0F});
        frame.camera.fov_y_rad = 2.0F * std::atan(kSunHalf_m / kSunEye_m);
        add_box(frame, {30.0F, 1.0F, 30.0F}, {0.0F, -0.5F, 0.0F}, matt(Vec3f{0.7F}));
        add_box(frame,
                {3.0F, caster.top_m - caster.bottom_m, 6.0F},
                {caster.left_m + 1.5F, 0.5F * (caster.top_m + caster.bottom_m), 3.0F},
                matt(Vec3f{0.7F}));
        const Vec3f to_sun = glm::normalize(Vec3f{1.0F, 1.0F, 0.0F});
        frame.sun = DirectionalLight{.direction_world = -to_sun,
                                     .radiance = Vec3f{glm::pi<float>() / to_sun.y}};
        frame.sun_shadow =
            SunShadow{.size_px = 2048, .distance_m = 12.0F, .angular_size_rad = disc_rad};
        frame.quality.contact_hardening = hardening;
        const auto image = draw(frame);
        // Shaded where z > 0; the mean over a stretch along x that the plate does not hide.
        std::vector<double> lit;
        const auto first = static_cast<std::uint32_t>((kSunHalf_m - kSunReach_m) / kSunPixel_m);
        for (std::uint32_t y = first; y < kSunSide_px - first; ++y) {
            double sum = 0.0;
            const auto from =
                static_cast<std::uint32_t>((kSunHalf_m + caster.seen_from_m) / kSunPixel_m);
            const auto to =
                static_cast<std::uint32_t>((kSunHalf_m + caster.seen_to_m) / kSunPixel_m);
            for (std::uint32_t x = from; x < to; ++x) {
                const float c = static_cast<float>(pixel_at(image, x, y).g) / 255.0F;
                sum += std::pow((static_cast<double>(c) + 0.055) / 1.055, 2.4);
            }
            lit.push_back(sum / (to - from));
        }
        EXPECT_NEAR(lit.front(), 0.7, 0.03);
        EXPECT_NEAR(lit.back(), 0.0, 0.01);
        // The spread of the disc's chords is a quarter of its diameter.
        double mean = 0.0;
        double square = 0.0;
        for (std::size_t i = 1; i < lit.size(); ++i) {
            const double falls = (lit[i - 1] - lit[i]) / (lit.front() - lit.back());
            const double at = static_cast<double>(i) * static_cast<double>(kSunPixel_m);
            mean += falls * at;
            square += falls * at * at;
        }
        EXPECT_NEAR(mean, kSunReach_m, 2.0F * kSunTexel_m);
        return 4.0F * static_cast<float>(std::sqrt(std::max(square - mean * mean, 0.0)));
    }
};

TEST_F(SoftSunGl, AnEdgeIsAsWideAsTheDiscAtItsDistance) {
    for (const float height_m : {1.0F, 2.0F, 3.0F}) {
        const float disc_rad = radians_from_degrees(4.0F);
        const float expected_m = height_m * std::sqrt(2.0F) * 2.0F * std::tan(0.5F * disc_rad);
        EXPECT_NEAR(
            edge_m(plate(height_m), disc_rad), expected_m, 2.0F * kSunTexel_m + 0.05F * expected_m)
            << height_m;
    }
}

TEST_F(SoftSunGl, TheSunsOwnDiscIsHalfADegree) {
    const float disc_rad = radians_from_degrees(0.53F);
    const float expected_m = 3.0F * std::sqrt(2.0F) * std::tan(disc_rad);
    EXPECT_NEAR(edge_m(plate(3.0F), disc_rad), expected_m, 2.0F * kSunTexel_m);
}

TEST_F(SoftSunGl, WhereThingsTouchItIsSharp) {
    const Caster wall{.left_m = 0.0F, .top_m = 1.0F, .seen_from_m = -0.1F, .seen_to_m = -0.02F};
    EXPECT_LT(edge_m(wall, radians_from_degrees(0.53F)), 3.0F * kSunTexel_m);
}

TEST_F(SoftSunGl, UnaskedTheWidthIsThatOfTheMapsFilter) {
    EXPECT_LT(edge_m(plate(3.0F), 0.0F), 3.0F * kSunTexel_m);
    const float wide_rad = radians_from_degrees(4.0F);
    EXPECT_LT(edge_m(plate(3.0F), wide_rad, Drawn::Never), 3.0F * kSunTexel_m);
    // Here the CPU draws.
    EXPECT_LT(edge_m(plate(3.0F), wide_rad, Drawn::OnGpu), 3.0F * kSunTexel_m);
}

}  // namespace
}  // namespace plumbline::render
