// Sun, time, sky, fog, flashlight, and lamps of entities.
#include "tests/engine/scene/sections/scene_file_fixture.h"

namespace plumbline::scene {
namespace {

TEST_F(SceneFileTest, TimeMovesTheSunAndAModelMakesTheSky) {
    for (const char* face : {"px", "nx", "py", "ny", "pz", "nz"})
        write(fmt::format("assets/skies/heaps/{}.png", face), "x");
    const Outcome outcome = load(R"([sun]
direction = [0, -1, 0]
[time]
hour = 18
latitude_deg = -45
day_of_year = 81
north_deg = 90
[sky]
model = "atmosphere"
haze = 2
cloud_map = "skies/heaps"
clouds = 0.5
[[view]]
position_m = [0, 0, 1]
target_m = [0, 0, 0]
hour = 21.5
)");
    ASSERT_TRUE(outcome.scene.ok()) << outcome.scene.error().message;
    EXPECT_TRUE(outcome.faults.empty());
    const SceneDescription& scene = *outcome.scene;
    ASSERT_TRUE(scene.time);
    EXPECT_EQ(scene.time->hour, 18);
    EXPECT_NEAR(scene.time->latitude_rad, -glm::pi<double>() / 4, 1e-6);
    EXPECT_EQ(scene.time->day_of_year, 81);
    // North is -X, so west, where the sun sets that day, is +Z: light travels the other way.
    expect_near(scene.sun->direction, {0, 0, -1});
    ASSERT_TRUE(scene.sky && scene.sky->model);
    EXPECT_EQ(scene.sky->model->haze, 2.0F);
    EXPECT_EQ(scene.sky->model->clouds, 0.5F);
    EXPECT_EQ(scene.sky->folder.filename(), "heaps");
    ASSERT_TRUE(scene.views[0].hour);
    EXPECT_EQ(*scene.views[0].hour, 21.5);
}

TEST_F(SceneFileTest, LightAndAir) {
    for (const char* face : {"px", "nx", "py", "ny", "pz", "nz"})
        write(fmt::format("assets/skies/day/{}.png", face), "x");
    const Outcome outcome = load(R"([sun]
direction = [0, -2, 0]
color = [0.5, 0.25, 1]
intensity = 4
rotation_degps = 180
cube_m = 0.5
cube_distance_m = 12
shadow = { cascades = 1, size_px = 1024, distance_m = 40 }
[sky]
skybox = "skies/day"
[ambient]
color = [0.2, 0.3, 0.4]
[fog]
color_srgb = [1, 0.5, 0]
density_per_m = 0.05
[flashlight]
color = [1, 1, 0.5]
intensity = 70
radius_m = 20
inner_deg = 10
outer_deg = 25
on = true
cube_m = 0.04
[post]
bloom = 0.1
exposure = 2
[effects.fog]
)");
    ASSERT_TRUE(outcome.scene.ok()) << outcome.scene.error().message;
    EXPECT_TRUE(outcome.faults.empty());
    const SceneDescription& scene = *outcome.scene;
    ASSERT_TRUE(scene.sun && scene.sun->shadow && scene.sky && scene.fog && scene.flashlight);
    expect_near(scene.sun->direction, {0, -1, 0});
    expect_near_f(scene.sun->color, {0.5F, 0.25F, 1.0F});
    EXPECT_FLOAT_EQ(scene.sun->intensity, 4.0F);
    EXPECT_NEAR(scene.sun->rotation_radps, kPi, kSlack);
    EXPECT_EQ(scene.sun->shadow->cascades, 1);
    EXPECT_EQ(scene.sun->shadow->size_px, 1024);
    EXPECT_NEAR(scene.sun->shadow->distance_m, Real{40}, kSlack);
    EXPECT_EQ(scene.sky->folder, assets() / "skies/day");
    EXPECT_EQ(to_string(scene.sky->location), "scene.toml:9");
    expect_near_f(scene.ambient.color, {0.2F, 0.3F, 0.4F});
    // sRGB 0.5 is 0.21404 linear.
    EXPECT_NEAR(scene.fog->color.y, 0.21404F, 1e-5F);
    EXPECT_FLOAT_EQ(scene.fog->color.x, 1.0F);
    EXPECT_FLOAT_EQ(scene.fog->density_per_m, 0.05F);
    EXPECT_FLOAT_EQ(scene.flashlight->intensity, 70.0F);
    EXPECT_FLOAT_EQ(scene.flashlight->radius_m, 20.0F);
    EXPECT_FLOAT_EQ(scene.flashlight->inner_deg, 10.0F);
    EXPECT_FLOAT_EQ(scene.flashlight->outer_deg, 25.0F);
    EXPECT_TRUE(scene.flashlight->on);
    EXPECT_FLOAT_EQ(scene.sun->cube_m, 0.5F);
    EXPECT_FLOAT_EQ(scene.sun->cube_distance_m, 12.0F);
    EXPECT_FLOAT_EQ(scene.flashlight->cube_m, 0.04F);
    ASSERT_TRUE(scene.post);
    EXPECT_FLOAT_EQ(scene.post->bloom, 0.1F);
    EXPECT_FLOAT_EQ(scene.post->exposure, 2.0F);
    ASSERT_TRUE(scene.effect_settings.contains("fog"));
    EXPECT_EQ(scene.effect_settings.at("fog").line, 27);
}

TEST_F(SceneFileTest, SunShadowByYesAndNo) {
    EXPECT_TRUE(load("sun = { shadow = true }").scene->sun->shadow);
    EXPECT_FALSE(load("sun = { shadow = false }").scene->sun->shadow);
    EXPECT_FALSE(load("sun = {}").scene->sun->shadow);
}

TEST_F(SceneFileTest, EdgesOfLightCubes) {
    for (const std::string table : {"sun", "flashlight"}) {
        EXPECT_TRUE(load("[" + table + "]\ncube_m = 100").scene.ok());
        for (const std::string edge : {"-1", "101"}) {
            expect_first("[" + table + "]\ncube_m = " + edge,
                         "scene.toml:2:10: error: " + table + ".cube_m: " + edge +
                             "; expected a length from 0 to 100 m");
        }
    }
    expect_first("[sun]\ncube = 1",
                 "scene.toml:2:1: error: sun.cube: unknown key; did you mean \"cube_m\"?");
}

TEST_F(SceneFileTest, PointLightsHaveNoDirection) {
    const std::string lamp = "[[entity]]\nlight = { ";
    expect_only(lamp + "direction = [0, -1, 0] }\n",
                "2:23: warning: entity[0].light.direction: a point light shines everywhere; "
                "ignored");
    EXPECT_TRUE(load(lamp + "kind = \"spot\", direction = [0, -1, 0] }\n").faults.empty());
}

TEST_F(SceneFileTest, ANarrowConeNarrowsWhatIsInsideIt) {
    const auto cone = [&](const std::string& keys) {
        return *good("[[entity]]\nlight = { kind = \"spot\", " + keys + " }\n").entities[0].light;
    };
    const LightDescription usual;
    EXPECT_FLOAT_EQ(cone("outer_deg = 10").inner_deg, 6.0F);
    EXPECT_FLOAT_EQ(cone("outer_deg = 89").inner_deg, usual.inner_deg) << "never wider than usual";
    EXPECT_FLOAT_EQ(cone("inner_deg = 9, outer_deg = 10").inner_deg, 9.0F);
    expect_only("[[entity]]\nlight = { kind = \"spot\", inner_deg = 31, outer_deg = 30 }\n",
                "2:38: error: entity[0].light.inner_deg: 31 is wider than outer_deg, 30");
}

TEST_F(SceneFileTest, LampsShineAlwaysNeverOrInTheDark) {
    const auto on = [&](const std::string& value) {
        return good("[[entity]]\nlight = { " + value + " }\n").entities[0].light->on;
    };
    EXPECT_EQ(on(""), LampOn::Always);
    EXPECT_EQ(on("on = true"), LampOn::Always);
    EXPECT_EQ(on("on = false"), LampOn::Never);
    EXPECT_EQ(on("on = \"dark\""), LampOn::Dark);
    expect_only("[[entity]]\nlight = { on = \"drk\" }\n",
                "2:16: error: entity[0].light.on: \"drk\"; expected one of dark; did you mean "
                "\"dark\"?");
}

TEST_F(SceneFileTest, ASkyNeedsAllItsFaces) {
    expect_only("[sky]\n",
                "1:1: error: sky.skybox: missing; expected a folder of six faces, or model = "
                "\"atmosphere\"");
    for (const char* face : {"px", "nx", "py", "ny", "pz"})
        write(fmt::format("assets/skies/open/{}.png", face), "x");
    expect_only(
        "[sky]\nskybox = \"skies/open\"\n",
        "2:10: warning: sky.skybox: \"skies/open\" holds no nz.exr, .png or .jpg; the clear "
        "colour is used");
    EXPECT_FALSE(load("[sky]\nskybox = \"skies/open\"\n").scene->sky);
    expect_first("[sky]\nskybox = \"../../out\"\n", "scene.toml:2:10: error: sky.skybox: ");
}

}  // namespace
}  // namespace plumbline::scene
