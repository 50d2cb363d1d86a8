#include "engine/scene/extract.h"

#include "engine/core/limits.h"
#include "engine/scene/simulation/sun_hour.h"
#include "tests/support/near.h"
#include "tests/support/scene_in_code.h"

#include <gtest/gtest.h>

namespace plumbline::scene {
namespace {

using test::box;
using test::cube;
using test::ground;
using test::near;
using test::Running;
using test::scene_of;

render::RenderFrame frame_of(Running& run, Real blend) {
    return extract(*run, run.game.view(*run, blend, 0.0F, 0.0F), 640, 480);
}

Vec3f place_of(const render::DrawItem& item) {
    return Vec3f(item.world_from_body[3]);
}

TEST(Extract, DrawsBetweenTheLastTwoPoses) {
    EntityDescription slider = cube("slider", {0, 50, 0});
    slider.body->velocity_mps = {6, 0, 0};
    SceneDescription scene = scene_of({slider});
    scene.gravity_mps2 = {0, 0, 0};
    Running run(scene);
    run.step(10);  // 0.1 m a step
    EXPECT_TRUE(near(place_of(frame_of(run, 0).items.at(0)), Vec3f{0.9F, 50.0F, 0.0F}, 1e-4));
    EXPECT_TRUE(near(place_of(frame_of(run, 0.5_r).items.at(0)), Vec3f{0.95F, 50.0F, 0.0F}, 1e-4));
    EXPECT_TRUE(near(place_of(frame_of(run, 1).items.at(0)), Vec3f{1.0F, 50.0F, 0.0F}, 1e-4));
}

TEST(Extract, TellsWhatCannotMove) {
    EntityDescription image = cube("image", {5, 1, 0});
    image.body.reset();
    Running run(scene_of({ground(), cube("cube", {0, 5, 0}), image}));
    const render::RenderFrame frame = frame_of(run, 1);
    ASSERT_EQ(frame.items.size(), 3U);
    EXPECT_TRUE(frame.items[0].is_static);
    EXPECT_FALSE(frame.items[1].is_static);
    EXPECT_TRUE(frame.items[2].is_static);
}

TEST(Extract, WhatItGivesOutlivesTheWorld) {
    render::RenderFrame frame;
    std::vector<assets::MaterialId> materials;
    {
        Running run(scene_of({cube("a", {0, 5, 0}), ground()}));
        frame = frame_of(run, 1);
        for (auto [entity, visual] : run->registry.view<Visual>()) {
            materials.insert(materials.end(), visual.materials.begin(), visual.materials.end());
        }
    }
    EXPECT_EQ(frame.material_ids, materials);
    ASSERT_EQ(frame.items.size(), 2U);
    for (const render::DrawItem& item : frame.items) {
        ASSERT_EQ(render::materials_of(frame, item).size(), 1U);
    }
    EXPECT_EQ(frame.items[1].first_material, 1U);
}

TEST(Extract, EqualThingsShareOneMesh) {
    Running run(
        scene_of({cube("a", {0, 5, 0}), cube("b", {5, 5, 0}), box("c", {9, 5, 0}, {2, 1, 1})}));
    const render::RenderFrame frame = frame_of(run, 1);
    ASSERT_EQ(frame.items.size(), 3U);
    EXPECT_EQ(frame.items[0].mesh, frame.items[1].mesh);
    EXPECT_NE(frame.items[0].mesh, frame.items[2].mesh);
}

TEST(Extract, DuskDimsSunAndSkyButNoLamp) {
    SceneDescription scene = scene_of({});
    scene.sun = SunDescription{.direction = {0, -1, 0}, .color = {1, 1, 1}, .intensity = 4};
    scene.ambient.color = {0.2F, 0.2F, 0.2F};
    EntityDescription lamp;
    lamp.name = "lamp";
    lamp.light = LightDescription{.color = {1, 1, 1}, .intensity = 10};
    scene.entities = {lamp};
    Running run(scene);
    run->switches.light_scale = 0.5F;
    const render::RenderFrame frame = frame_of(run, 1);
    ASSERT_TRUE(frame.sun);
    EXPECT_TRUE(near(frame.sun->radiance, Vec3f{2.0F}, 1e-6));
    EXPECT_TRUE(near(frame.ambient, Vec3f{0.1F}, 1e-6));
    ASSERT_EQ(frame.lights.size(), 1U);
    EXPECT_TRUE(near(frame.lights[0].intensity, Vec3f{10.0F}, 1e-6));
    EXPECT_FALSE(frame.sun_shadow || frame.fog || frame.sky || frame.flashlight || frame.post);
}

TEST(Extract, LampsThatWaitForTheDarkGlowWhenTheSunIsLowAndByTheirSwitch) {
    SceneDescription scene = scene_of({});
    scene.sun = SunDescription{.direction = {0, -1, 0}};
    scene.materials["bulb"] = {.name = "bulb", .emissive = {9, 6, 3}};
    EntityDescription lamp = cube("lamp", {0, 2, 0});
    lamp.body.reset();
    lamp.material = "bulb";
    lamp.light = LightDescription{.on = LampOn::Dark, .color = {1, 1, 1}, .intensity = 10};
    scene.entities = {lamp};
    Running run(scene);
    const auto seen_under = [&](float sun_height_deg) {
        const float height = radians_from_degrees(sun_height_deg);
        run->switches.sun_direction = {-std::cos(height), -std::sin(height), 0.0F};
        return frame_of(run, 1);
    };
    const auto glow = [&](const render::RenderFrame& frame) {
        return run->library().material(frame.material_ids.at(0)).emissive.x;
    };
    const render::RenderFrame noon = seen_under(60.0F);
    EXPECT_TRUE(noon.lights.empty());
    EXPECT_EQ(glow(noon), 0.0F);
    // Half way through the last five degrees half of it shines.
    const render::RenderFrame low = seen_under(2.5F);
    ASSERT_EQ(low.lights.size(), 1U);
    EXPECT_NEAR(low.lights[0].intensity.x, 5.0F, 0.05F);
    const render::RenderFrame night = seen_under(-30.0F);
    ASSERT_EQ(night.lights.size(), 1U);
    EXPECT_NEAR(night.lights[0].intensity.x, 10.0F, 1e-4F);
    EXPECT_EQ(glow(night), 9.0F);
    run->switches.turn("lamps", true);
    EXPECT_EQ(seen_under(60.0F).lights.size(), 1U);
    run->switches.turn("lamps", false);
    EXPECT_TRUE(seen_under(-30.0F).lights.empty());
}

TEST(Extract, TheDayGoesOnAboutTheEarthsAxis) {
    SceneDescription scene = scene_of({});
    scene.sun = SunDescription{};
    scene.time = TimeDescription{.hour = 9};
    Running run(scene);
    set_hour(*run, 9);
    ASSERT_TRUE(hour_of(*run));
    EXPECT_NEAR(*hour_of(*run), 9.0, 1e-3);
    run->switches.sun_rotation_radps = radians_from_degrees(15.0F);
    run.step(60);
    EXPECT_NEAR(*hour_of(*run), 10.0, 5e-3);
    EXPECT_NEAR(glm::length(run->switches.sun_direction), 1.0F, 1e-5F);
}

TEST(Extract, KeepsTheNearestLights) {
    SceneDescription scene = scene_of({});
    const int count = static_cast<int>(limits::kLights) + 10;
    for (int i = 0; i < count; ++i) {
        EntityDescription lamp;
        lamp.name = "lamp" + std::to_string(i);
        lamp.world_from_body.position = {static_cast<Real>(count - i), 0, 0};
        lamp.light = LightDescription{};
        scene.entities.push_back(lamp);
    }
    Running run(scene);
    ViewPoint view;  // at the origin
    const render::RenderFrame frame = extract(*run, view, 64, 64);
    ASSERT_EQ(frame.lights.size(), limits::kLights);
    for (const render::LocalLight& light : frame.lights) {
        EXPECT_LE(light.position_world.x, static_cast<float>(limits::kLights));
    }
    ASSERT_FALSE(run->warnings.empty());
    EXPECT_EQ(run->warnings.front(), "266 lights: only the 256 nearest to the camera shine");
}

TEST(NoGame, LooksAtTheTarget) {
    const NoGame game({.position_m = {4, 3, 6}, .target_m = {0, 0.5_r, 0}});
    Running run(scene_of({}));
    const ViewPoint view = game.view(*run, Real{1}, 0.0F, 0.0F);
    const Vec3 forward = view.world_from_camera.orientation * Vec3{0, 0, -1};
    EXPECT_TRUE(near(forward, glm::normalize(Vec3{-4, -2.5_r, -6}), 1e-5));
    const Vec3 right = view.world_from_camera.orientation * Vec3{1, 0, 0};
    EXPECT_NEAR(static_cast<double>(right.y), 0.0, 1e-5) << "the horizon is level";
}

TEST(NoGame, LooksStraightDown) {
    const NoGame game({.position_m = {0, 10, 0}, .target_m = {0, 0, 0}});
    Running run(scene_of({}));
    const ViewPoint view = game.view(*run, Real{1}, 0.0F, 0.0F);
    EXPECT_TRUE(near(view.world_from_camera.orientation * Vec3{0, 0, -1}, Vec3{0, -1, 0}, 1e-5));
}

}  // namespace
}  // namespace plumbline::scene
