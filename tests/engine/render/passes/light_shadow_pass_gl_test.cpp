// Shadows of lamps against exact rays, pixel by pixel; what stands between keeps light out; who does not
// ask pays nothing.
#include "engine/render/light/light_shadows.h"
#include "tests/engine/render/image_fixture.h"

#include <cmath>

namespace plumbline::render {
namespace {

constexpr std::uint32_t kLampSide_px = 240;
constexpr float kLampHalf_m = 6.0F;
constexpr float kLampEye_m = 60.0F;
constexpr float kLampPixel_m = 2.0F * kLampHalf_m / kLampSide_px;
constexpr Vec3f kLampBoxMin{-1.0F, 0.0F, -1.0F};
constexpr Vec3f kLampBoxMax{1.0F, 2.0F, 1.0F};

bool hits_box(const Vec3f& from, const Vec3f& to) {
    float first = 1e-5F;
    float last = 1.0F;
    for (int i = 0; i < 3; ++i) {
        const float way = to[i] - from[i];
        if (std::abs(way) < 1e-9F) {
            if (from[i] < kLampBoxMin[i] || from[i] > kLampBoxMax[i]) return false;
            continue;
        }
        const float a = (kLampBoxMin[i] - from[i]) / way;
        const float b = (kLampBoxMax[i] - from[i]) / way;
        first = std::max(first, std::min(a, b));
        last = std::min(last, std::max(a, b));
    }
    return first <= last;
}

struct Off {
    int acne{0};
    int leaks{0};
    int shaded{0};
    int lit{0};
};

class LightShadowPassGl : public ImageGl {
protected:
    RenderFrame floor_from_above() {
        RenderFrame frame = empty_frame(kLampSide_px, kLampSide_px);
        frame.camera = camera_at({0.0F, kLampEye_m, 0.0F}, Vec3f{0.0F});
        frame.camera.fov_y_rad = 2.0F * std::atan(kLampHalf_m / kLampEye_m);
        add_box(frame, {60.0F, 1.0F, 60.0F}, {0.0F, -0.5F, 0.0F}, chalk());
        frame.light_shadows = LightShadows{};
        return frame;
    }

    RenderFrame box_by(const LocalLight& light) {
        RenderFrame frame = floor_from_above();
        add_box(frame, kLampBoxMax - kLampBoxMin, 0.5F * (kLampBoxMin + kLampBoxMax), chalk());
        frame.lights.push_back(light);
        return frame;
    }

    static Vec3f place(std::uint32_t x, std::uint32_t y) {
        const auto at = [](std::uint32_t pixel) {
            return (static_cast<float>(pixel) + 0.5F) * kLampPixel_m - kLampHalf_m;
        };
        return {at(x), 0.0F, at(y)};
    }

    /// What the floor sends out where nothing is in the way.
    static float light_at(const LocalLight& light, const Vec3f& point) {
        const Vec3f way = light.position_world - point;
        const float distance2 = glm::dot(way, way);
        const float share = distance2 / (light.radius_m * light.radius_m);
        const float window = std::max(1.0F - share * share, 0.0F);
        const float cosine = glm::dot(-way, light.direction_world) / std::sqrt(distance2);
        const float cone =
            light.is_spot
                ? std::clamp(
                      (cosine - light.outer_cos) / (light.inner_cos - light.outer_cos), 0.0F, 1.0F)
                : 1.0F;
        return light.intensity.x * window * window / distance2 * way.y / std::sqrt(distance2) *
               cone * cone * glm::one_over_pi<float>();
    }

    /// The edge may be off by so many texels of the map, as they lie on the floor, and half a pixel.
    Off compare(const LocalLight& light, float edge_texels) {
        const RenderFrame frame = box_by(light);
        const auto image = draw(frame);
        const float texel = shadow_numbers(light, 0, frame.light_shadows->size_px).w;
        Off off;
        for (std::uint32_t y = 0; y < kLampSide_px; ++y) {
            for (std::uint32_t x = 0; x < kLampSide_px; ++x) {
                const Vec3f at = place(x, y);
                const Vec3f eye{0.0F, kLampEye_m, 0.0F};
                if (hits_box(at * (1.0F - 1.5F * kLampPixel_m / kLampHalf_m), eye)) continue;
                const float expected = std::min(light_at(light, at), 1.0F);
                if (expected < 0.02F) continue;
                const Vec3f way = light.position_world - at;
                const float margin_m =
                    edge_texels * texel * glm::dot(way, way) / way.y + 0.5F * kLampPixel_m;
                const bool shaded = hits_box(at, light.position_world);
                bool is_edge = false;
                for (int i = 0; i < 8; ++i) {
                    const float turn = static_cast<float>(i) * 0.25F * glm::pi<float>();
                    const Vec3f beside =
                        at + margin_m * Vec3f{std::cos(turn), 0.0F, std::sin(turn)};
                    is_edge = is_edge || hits_box(beside, light.position_world) != shaded;
                }
                if (is_edge) continue;
                const int code = pixel_at(image, x, y).g;
                off.shaded += static_cast<int>(shaded);
                off.lit += static_cast<int>(!shaded);
                off.leaks += static_cast<int>(shaded && code > 0);
                off.acne += static_cast<int>(!shaded && std::abs(code - code_of(expected)) > 2);
            }
        }
        return off;
    }
};

TEST_F(LightShadowPassGl, APointLightsUmbraIsWhereRaysSay) {
    for (const Vec3f& place : {Vec3f{2.5F, 4.0F, 1.5F},
                               Vec3f{-3.0F, 1.2F, 0.3F},
                               Vec3f{0.0F, 5.0F, 0.0F},
                               Vec3f{1.9F, 2.9F, -2.3F}}) {
        const Off off = compare({.position_world = place,
                                 .intensity = Vec3f{30.0F},
                                 .radius_m = 14.0F,
                                 .casts_shadow = true},
                                1.6F);
        EXPECT_EQ(off.acne, 0) << place.x << ' ' << place.y;
        EXPECT_EQ(off.leaks, 0) << place.x << ' ' << place.y;
        EXPECT_GT(off.lit, 20'000);
        EXPECT_GT(off.shaded, place.x == 0.0F ? 100 : 2'000);
    }
}

TEST_F(LightShadowPassGl, ASpotsUmbraIsWhereRaysSay) {
    const Vec3f place{3.0F, 4.0F, 0.0F};
    const Off off = compare({.position_world = place,
                             .intensity = Vec3f{30.0F},
                             .radius_m = 14.0F,
                             .is_spot = true,
                             .direction_world = glm::normalize(Vec3f{-1.0F, 0.5F, 0.0F} - place),
                             .inner_cos = std::cos(0.4F),
                             .outer_cos = std::cos(0.7F),
                             .casts_shadow = true},
                            1.6F);
    EXPECT_EQ(off.acne, 0);
    EXPECT_EQ(off.leaks, 0);
    EXPECT_GT(off.shaded, 2'000);
}

TEST_F(LightShadowPassGl, LightInARoomStaysInTheRoom) {
    RenderFrame frame = floor_from_above();
    const auto wall = chalk();
    add_box(frame, {4.0F, 3.0F, 0.1F}, {0.0F, 1.5F, 2.0F}, wall);
    add_box(frame, {4.0F, 3.0F, 0.1F}, {0.0F, 1.5F, -2.0F}, wall);
    add_box(frame, {0.1F, 3.0F, 4.0F}, {2.0F, 1.5F, 0.0F}, wall);
    add_box(frame, {0.1F, 3.0F, 4.0F}, {-2.0F, 1.5F, 0.0F}, wall);
    add_box(frame, {4.1F, 0.1F, 4.1F}, {0.0F, 3.0F, 0.0F}, wall);
    frame.lights.push_back({.position_world = {0.7F, 1.6F, -0.4F},
                            .intensity = Vec3f{200.0F},
                            .radius_m = 12.0F,
                            .casts_shadow = true});
    const auto brightest = [&] {
        const auto image = draw(frame);
        int most = 0;
        for (std::uint32_t y = 0; y < kLampSide_px; ++y)
            for (std::uint32_t x = 0; x < kLampSide_px; ++x)
                most = std::max(most, pixel_at(image, x, y).g);
        return most;
    };
    EXPECT_EQ(brightest(), 0);
    frame.lights[0].casts_shadow = false;
    EXPECT_GT(brightest(), 100) << "without shadows it shines through";
}

TEST_F(LightShadowPassGl, ABulbDoesNotShadeItsOwnLight) {
    const LocalLight light{.position_world = {0.0F, 3.0F, 0.0F},
                           .intensity = Vec3f{20.0F},
                           .radius_m = 9.0F,
                           .casts_shadow = true};
    RenderFrame frame = floor_from_above();
    frame.lights.push_back(light);
    const auto bulb = library_.add_material({.name = "bulb", .emissive = Vec3f{1.0F}});
    add_box(frame, Vec3f{0.2F}, light.position_world, bulb);
    const auto image = draw(frame);
    const Vec3f at = place(170, 120);
    EXPECT_NEAR(pixel_at(image, 170, 120).g, code_of(light_at(light, at)), 2);
}

// Each map is drawn once and kept; what moves draws again only the maps that it is in.
TEST_F(LightShadowPassGl, KeepsWhatDidNotChange) {
    RenderFrame frame = box_by({.position_world = {0.0F, 4.0F, 0.0F},
                                .intensity = Vec3f{30.0F},
                                .radius_m = 9.0F,
                                .casts_shadow = true});
    for (DrawItem& item : frame.items) item.is_static = true;
    add_box(frame, Vec3f{0.3F}, {3.5F, 4.0F, 0.0F}, chalk());
    draw(frame);
    EXPECT_EQ(renderer_->stats().shadow_passes_rendered, 6U);
    EXPECT_EQ(renderer_->stats().shadowed_lights, 1U);
    draw(frame);
    EXPECT_EQ(renderer_->stats().shadow_passes_rendered, 0U);
    EXPECT_EQ(renderer_->stats().shadow_passes_cached, 6U);
    frame.items.back().world_from_body[3].y += 0.2F;
    draw(frame);
    EXPECT_EQ(renderer_->stats().shadow_passes_rendered, 1U);
    const auto kept = draw(frame);
    renderer_->forget_scene();
    EXPECT_EQ(draw(frame).bytes, kept.bytes) << "a map on top of a kept one is a whole one";
}

TEST_F(LightShadowPassGl, CostNothingUnasked) {
    RenderFrame frame = box_by({.position_world = {2.0F, 4.0F, 0.0F}, .casts_shadow = true});
    frame.light_shadows.reset();
    draw(frame);
    EXPECT_EQ(bytes_of("light_shadows"), 0U);
    EXPECT_EQ(renderer_->stats().shadow_passes_rendered, 0U);
    EXPECT_EQ(renderer_->stats().shadowed_lights, 0U);
    frame.light_shadows = LightShadows{};
    draw(frame);
    EXPECT_EQ(bytes_of("light_shadows"), std::uint64_t{6} * 512 * 512 * 4);
    frame.quality.shadowed_lights = 0;
    draw(frame);
    EXPECT_EQ(bytes_of("light_shadows"), 0U);
}

}  // namespace
}  // namespace plumbline::render
