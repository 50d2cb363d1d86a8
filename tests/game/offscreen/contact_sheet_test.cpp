// Many images on one, and where a tour stops.
#include "game/offscreen/contact_sheet.h"

#include "tests/support/near.h"

#include <gtest/gtest.h>

#include <array>

namespace plumbline::game {
namespace {

using Color = std::array<int, 3>;

Color color_at(const assets::ImageData& image, std::uint32_t x, std::uint32_t y) {
    const std::size_t at = (std::size_t{y} * image.width + x) * 3;
    return {image.bytes[at], image.bytes[at + 1], image.bytes[at + 2]};
}

/// 6 x 3 pixels; the left half of one code, the right half of another.
assets::ImageData halves(std::uint8_t left, std::uint8_t right) {
    assets::ImageData image{
        .width = 6, .height = 3, .format = assets::PixelFormat::Rgb8, .bytes = {}};
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 6; ++x) image.bytes.insert(image.bytes.end(), 3, x < 3 ? left : right);
    return image;
}

constexpr Color kGround{24, 24, 24};

TEST(ContactSheet, PutsThreeInARowAtAThirdOfTheirSides) {
    std::vector<assets::ImageData> images;
    for (int i = 0; i < 4; ++i) images.push_back(halves(static_cast<std::uint8_t>(10 * i), 200));
    const assets::ImageData sheet = contact_sheet(images);
    EXPECT_EQ(sheet.width, 3U * (2 + 6) + 6);
    EXPECT_EQ(sheet.height, 2U * (1 + 6) + 6);
    ASSERT_EQ(sheet.bytes.size(), std::size_t{sheet.width} * sheet.height * 3);
    for (int i = 0; i < 4; ++i) {
        const std::uint32_t x = 6 + static_cast<std::uint32_t>(i % 3) * 8;
        const std::uint32_t y = 6 + static_cast<std::uint32_t>(i / 3) * 7;
        EXPECT_EQ(color_at(sheet, x, y), (Color{10 * i, 10 * i, 10 * i}));
        EXPECT_EQ(color_at(sheet, x + 1, y), (Color{200, 200, 200}));
        EXPECT_EQ(color_at(sheet, x + 2, y), kGround);
        EXPECT_EQ(color_at(sheet, x, y - 1), kGround);
    }
    EXPECT_EQ(color_at(sheet, 14, 13), kGround) << "nothing is the fifth";
}

TEST(ContactSheet, APixelIsTheMeanOfNine) {
    assets::ImageData image = halves(0, 0);
    image.bytes[0] = 255;  // the red of one
    EXPECT_EQ(color_at(contact_sheet({image}), 6, 6), (Color{28, 0, 0}));
}

TEST(ContactSheet, IsAsWideAsWhatItHolds) {
    EXPECT_EQ(contact_sheet({halves(1, 2)}).width, 2U + 12);
    EXPECT_EQ(contact_sheet({halves(1, 2)}).height, 1U + 12);
    const assets::ImageData none = contact_sheet({});
    EXPECT_EQ(none.bytes.size(), std::size_t{none.width} * none.height * 3);
}

TEST(TourStops, AreTheScenesOwnViewsElseARoundTrip) {
    scene::SceneDescription scene;
    scene.camera.position_m = {0, 1, 4};
    scene.camera.target_m = {0, 0, 0};
    scene.has_camera = true;
    const auto round = tour_stops(scene);
    ASSERT_EQ(round.size(), 6U);
    EXPECT_EQ(round[0].name, "start");
    EXPECT_EQ(round[5].name, "round_5");
    EXPECT_EQ(round[0].wait_s, 0);
    for (const scene::ViewDescription& stop : round) {
        EXPECT_EQ(stop.target_m, Vec3(0, 0, 0));
        EXPECT_NEAR(glm::length(stop.position_m), std::sqrt(17.0), 1e-5);
    }
    EXPECT_TRUE(test::near(round[3].position_m, Vec3(0, 1, -4), 1e-5)) << "half way round";
    scene.views = {{.name = "mine"}};
    ASSERT_EQ(tour_stops(scene).size(), 1U);
    EXPECT_EQ(tour_stops(scene)[0].name, "mine");
}

TEST(TourStops, WithoutACameraGoAboutWhatThePlayerSees) {
    scene::SceneDescription scene;
    scene.player.emplace();
    scene.player->feet_position_m = {3, 0, 0};
    for (const scene::ViewDescription& stop : tour_stops(scene))
        EXPECT_TRUE(test::near(stop.target_m, Vec3(3, 1.65, -6), 1e-5));
}

}  // namespace
}  // namespace plumbline::game
