#include "engine/study/image/image_reference.h"

#include "engine/assets/primitives.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::study {
namespace {

assets::ImageData plain(std::uint32_t side_px, std::uint8_t code) {
    return {.width = side_px,
            .height = side_px,
            .format = assets::PixelFormat::Rgb8,
            .bytes = std::vector<std::uint8_t>(std::size_t{side_px} * side_px * 3, code)};
}

TEST(ImageReference, RaysGoWhereTheCameraLooks) {
    render::Camera camera{.fov_y_rad = glm::half_pi<float>()};
    EXPECT_LT(glm::distance(ray_through(camera, 2.0F, Vec2f{0.5F}), {0.0F, 0.0F, -1.0F}), 1e-6F);
    // 90 degrees upright: the upper edge is at 45; twice as wide as high.
    const Vec3f corner = ray_through(camera, 2.0F, Vec2f{0.0F});
    EXPECT_LT(glm::distance(corner, glm::normalize(Vec3f{-2.0F, 1.0F, -1.0F})), 1e-6F);
    camera.orientation = glm::angleAxis(glm::half_pi<float>(), Vec3f{0.0F, 1.0F, 0.0F});
    EXPECT_LT(glm::distance(ray_through(camera, 2.0F, Vec2f{0.5F}), {-1.0F, 0.0F, 0.0F}), 1e-6F);
}

TEST(ImageReference, APixelHasTheShareOfItsSamplesThatTheSunReaches) {
    // 2 x 2 pixels of 4 x 4 samples; shaded left of 3/8 of the width: the samples of the left pixels have
    // their centres at 1/16, 3/16, 5/16 (shaded) and 7/16.
    const LightImage reference = reference_image(
        plain(8, 255), plain(8, 0), 4, [](const Vec2f& at) { return at.x < 0.375F; });
    ASSERT_EQ(reference.width_px, 2U);
    ASSERT_EQ(reference.height_px, 2U);
    for (const std::uint32_t y : {0U, 1U}) {
        EXPECT_NEAR(reference.at(0, y).y, 0.25F, 1e-6F);
        EXPECT_NEAR(reference.at(1, y).y, 1.0F, 1e-6F);
    }
}

TEST(ImageReference, AsksNoRayWhereTheSunMakesNoDifference) {
    int asked = 0;
    const auto count = [&](const Vec2f&) {
        ++asked;
        return true;
    };
    const LightImage reference = reference_image(plain(4, 128), plain(4, 128), 2, count);
    EXPECT_EQ(asked, 0);
    EXPECT_NEAR(reference.at(1, 1).x, light_of_code(128), 1e-6F);
}

TEST(ImageReference, TheFramesRaysKnowItsShadow) {
    assets::AssetLibrary library;
    render::RenderFrame frame{.width_px = 200, .height_px = 200};
    const assets::MaterialId matt = library.add_material({});
    const auto add = [&](const Vec3f& size, const Vec3f& place) {
        const assets::MeshId mesh =
            library.add_mesh("box " + std::to_string(size.x), assets::box_mesh(size));
        render::add_item(frame,
                         {.mesh = mesh, .world_from_body = glm::translate(Mat4f{1.0F}, place)},
                         {&matt, 1});
    };
    add({40.0F, 1.0F, 40.0F}, {0.0F, -0.5F, 0.0F});
    add({2.0F, 2.0F, 2.0F}, {0.0F, 1.0F, 0.0F});
    // From 100 m above; 10 m of the floor are seen across.
    frame.camera = {.position_world = {0.0F, 100.0F, 0.0F},
                    .orientation = glm::angleAxis(-glm::half_pi<float>(), Vec3f{1.0F, 0.0F, 0.0F}),
                    .fov_y_rad = 2.0F * std::atan(0.05F)};
    frame.sun =
        render::DirectionalLight{.direction_world = glm::normalize(Vec3f{1.0F, -1.0F, 0.0F})};
    const auto shaded = [&](float x_m) {
        return shaded_by_rays(frame, library)({0.5F + x_m / 10.0F, 0.5F});
    };
    EXPECT_FALSE(shaded(2.0F)) << "it asks for no shadow";
    frame.sun_shadow = render::SunShadow{};
    EXPECT_TRUE(shaded(2.0F));
    EXPECT_FALSE(shaded(3.1F));
    EXPECT_FALSE(shaded(-2.0F));
    EXPECT_FALSE(shaded(0.0F)) << "the top of the box";
}

}  // namespace
}  // namespace plumbline::study
