// One floor under many lamps, pixel by pixel against the closed form. SOURCES B30.
#include "tests/engine/render/image_fixture.h"

namespace plumbline::render {
namespace {

constexpr float kFloorHalf_m = 16.0F;
constexpr float kLampHeight_m = 0.5F;
/// What the floor sends out straight below a lamp, of that lamp's light.
constexpr float kBelow = 0.7F;

struct Rows {
    int across{1};
    int deep{1};
    float reach_m{1.0F};  ///< of each lamp
};

class LampsGl : public ImageGl {
protected:
    static constexpr std::uint32_t kSide_px = 320;

    RenderFrame floor_under(const Rows& rows, const Vec3f& eye, const Vec3f& target) {
        RenderFrame frame = empty_frame(kSide_px, kSide_px);
        frame.camera = camera_at(eye, target);
        frame.camera.fov_y_rad = 2.0F * std::atan(kFloorHalf_m / glm::distance(eye, target));
        add_box(frame, {200.0F, 1.0F, 200.0F}, {0.0F, -0.5F, 0.0F}, chalk());
        for (int z = 0; z < rows.deep; ++z) {
            for (int x = 0; x < rows.across; ++x) {
                const Vec2f share{(static_cast<float>(x) + 0.5F) / static_cast<float>(rows.across),
                                  (static_cast<float>(z) + 0.5F) / static_cast<float>(rows.deep)};
                const Vec2f at = (share * 2.0F - 1.0F) * kFloorHalf_m;
                LocalLight lamp{.position_world = {at.x, kLampHeight_m, at.y},
                                .radius_m = rows.reach_m};
                lamp.intensity = Vec3f{kBelow / from_lamp(lamp, {at.x, 0.0F, at.y})};
                frame.lights.push_back(lamp);
            }
        }
        return frame;
    }

    /// What the floor at `point` sends out of one candela of the lamp: cosine over the square of the
    /// distance and pi, bent down to zero at the lamp's radius.
    static float from_lamp(const LocalLight& lamp, const Vec3f& point) {
        const Vec3f way = lamp.position_world - point;
        const float distance2 = glm::dot(way, way);
        const float share = distance2 / (lamp.radius_m * lamp.radius_m);
        const float window = std::max(1.0F - share * share, 0.0F);
        return window * window / distance2 * way.y / std::sqrt(distance2) *
               glm::one_over_pi<float>();
    }

    static float light_at(const RenderFrame& frame, const Vec3f& point) {
        float sum = 0.0F;
        for (const LocalLight& lamp : frame.lights)
            sum += lamp.intensity.x * from_lamp(lamp, point);
        return sum;
    }

    /// Where the middle of a pixel shows the floor; nothing above the horizon.
    static std::optional<Vec3f> floor_at(const Camera& camera, std::uint32_t x, std::uint32_t y) {
        const float tan = std::tan(camera.fov_y_rad * 0.5F);
        const auto clip = [](std::uint32_t at) {
            return (static_cast<float>(at) + 0.5F) / static_cast<float>(kSide_px) * 2.0F - 1.0F;
        };
        const Vec3f ray = camera.orientation * Vec3f{clip(x) * tan, -clip(y) * tan, -1.0F};
        if (ray.y > -1e-3F) return {};
        return camera.position_world - ray * (camera.position_world.y / ray.y);
    }

    /// Every third pixel is what all lamps together make of it, to one code of 255.
    void expect_predicted(const RenderFrame& frame) {
        const auto image = draw(frame);
        int compared = 0;
        for (std::uint32_t y = 1; y < kSide_px; y += 3) {
            for (std::uint32_t x = 1; x < kSide_px; x += 3) {
                const std::optional<Vec3f> point = floor_at(frame.camera, x, y);
                if (!point || std::max(std::abs(point->x), std::abs(point->z)) > 90.0F) continue;
                const int code = code_of(light_at(frame, *point));
                ASSERT_NEAR(pixel_at(image, x, y).r, code, 1)
                    << frame.lights.size() << " lamps, at " << point->x << ' ' << point->z;
                ++compared;
            }
        }
        EXPECT_GT(compared, 3000);
    }

    /// The floor below each lamp, in linear light: as bright as it was made to be.
    void expect_lit_below_each(const RenderFrame& frame) {
        const auto image = draw(frame);
        for (const LocalLight& lamp : frame.lights) {
            const auto pixel = [](float at_m) {
                return static_cast<std::uint32_t>((at_m + kFloorHalf_m) / (2.0F * kFloorHalf_m) *
                                                  kSide_px);
            };
            const std::uint32_t x = pixel(lamp.position_world.x);
            const std::uint32_t y = pixel(lamp.position_world.z);
            const float seen = linear_from_code(pixel_at(image, x, y).r);
            const std::optional<Vec3f> point = floor_at(frame.camera, x, y);
            ASSERT_TRUE(point);
            EXPECT_NEAR(seen, light_at(frame, *point), 0.005F) << x << ' ' << y;
            // A pixel's middle is at most 7 cm from the lamp's foot.
            EXPECT_NEAR(seen, kBelow, 0.05F) << x << ' ' << y;
        }
    }

    static float linear_from_code(int code) {
        const float c = static_cast<float>(code) / 255.0F;
        return c <= 0.04045F ? c / 12.92F : std::pow((c + 0.055F) / 1.055F, 2.4F);
    }

    const Vec3f kAbove{0.0F, 100.0F, 0.0F};
    const Vec3f kStanding{-3.0F, 1.7F, 15.0F};
};

TEST_F(LampsGl, EachOf24And256LampsLightsTheFloorBelowIt) {
    for (const Rows& rows : {Rows{6, 4, 2.5F}, Rows{16, 16, 0.96F}}) {
        const RenderFrame frame = floor_under(rows, kAbove, Vec3f{0.0F});
        expect_lit_below_each(frame);
        expect_predicted(frame);
    }
}

TEST_F(LampsGl, LampsThatOverlapAddUp) {
    for (const Rows& rows : {Rows{6, 4, 9.0F}, Rows{16, 16, 6.0F}}) {
        expect_predicted(floor_under(rows, kAbove, Vec3f{0.0F}));
        expect_predicted(floor_under(rows, kStanding, {2.0F, 0.0F, 0.0F}));
    }
}

TEST_F(LampsGl, All256MayReachEveryPlace) {
    const Rows rows{16, 16, 80.0F};
    expect_predicted(floor_under(rows, kAbove, Vec3f{0.0F}));
    expect_predicted(floor_under(rows, kStanding, {2.0F, 0.0F, 0.0F}));
}

}  // namespace
}  // namespace plumbline::render
