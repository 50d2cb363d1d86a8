// The keys that the book's stages brought: a camera that goes by steps, bodies held along axes, looks of
// contact, volumes, the textbook's parts of light.
#include "tests/engine/scene/sections/scene_file_fixture.h"

#include <cmath>

namespace plumbline::scene {
namespace {

class BookSceneFile : public SceneFileTest {
protected:
    SceneDescription good(std::string_view text) {
        const Outcome outcome = load(text);
        EXPECT_TRUE(outcome.faults.empty()) << (outcome.faults.empty() ? "" : outcome.faults[0]);
        EXPECT_TRUE(outcome.scene.ok());
        return outcome.scene ? *outcome.scene : SceneDescription{};
    }
    void expect_only(const std::string& text, const std::string& fault) {
        const Outcome outcome = load(text);
        ASSERT_EQ(outcome.faults.size(), 1U) << text;
        EXPECT_EQ(outcome.faults[0], "scene.toml:" + fault) << text;
    }
};

constexpr const char* kBody =
    "[[entity]]\nname = \"a\"\nprimitive = { sphere = 1 }\n[entity.body]\n";

// SOURCES A8, A26: distance 15, pitch 20 and yaw 0 stand on the side of -Z, above.
TEST_F(BookSceneFile, OrbitPlacesTheCamera) {
    const SceneDescription scene = good(
        "[camera]\ntarget_m = [1, 2, 3]\n"
        "orbit = { distance_m = 15, pitch_deg = 20, yaw_deg = 0, step_deg = 5, step_m = 5 }\n");
    const Real pitch = radians_from_degrees(20.0_r);
    EXPECT_TRUE(scene.has_camera);
    EXPECT_NEAR(scene.camera.position_m.x, 1, 1e-5);
    EXPECT_NEAR(scene.camera.position_m.y, 2 + 15 * std::sin(pitch), 1e-5);
    EXPECT_NEAR(scene.camera.position_m.z, 3 - 15 * std::cos(pitch), 1e-5);
    ASSERT_TRUE(scene.camera.orbit.has_value());
    EXPECT_NEAR(scene.camera.orbit->step_rad, radians_from_degrees(5.0_r), kSlack);
    EXPECT_NEAR(scene.camera.orbit->step_m, 5, kSlack);
}

TEST_F(BookSceneFile, WhatOrbitLeavesOpenIsAsThePositionSays) {
    const SceneDescription steps =
        good("[camera]\nposition_m = [10, 5, 0]\ntarget_m = [0, 0, 0]\norbit = { step_deg = 1 }\n");
    expect_near(steps.camera.position_m, {10, 5, 0});
    const SceneDescription nearer = good(
        "[camera]\nposition_m = [10, 5, 0]\ntarget_m = [0, 0, 0]\norbit = { distance_m = 1 }\n");
    const Vec3 wanted = glm::normalize(Vec3{10, 5, 0});
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(nearer.camera.position_m[i], wanted[i], 1e-5);
    // About an up of its own: yaw is about it, pitch towards it.
    const SceneDescription tilted = good(
        "[camera]\ntarget_m = [0, 0, 0]\nup = [0, 0, 2]\n"
        "orbit = { distance_m = 2, pitch_deg = 30, yaw_deg = 0 }\n");
    EXPECT_NEAR(tilted.camera.position_m.z, 1, 1e-5);
    expect_near(tilted.camera.up, {0, 0, 1});
}

TEST_F(BookSceneFile, ACameraThatCannotStandSoIsRefused) {
    expect_only(
        "[camera]\nup = [0, 0, 0]\n",
        "2:6: error: camera.up: [0, 0, 0] has no direction; expected a vector of some length");
    expect_only("[camera]\nposition_m = [0, 5, 0]\ntarget_m = [0, 0, 0]\nup = [0, 1, 0]\n",
                "4:6: error: camera.up: lies along the line of sight; expected another direction");
    expect_only("[camera]\norbit = { distance_m = 0 }\n",
                "2:24: error: camera.orbit.distance_m: 0; expected a length from 0.1 to 500 m");
    expect_only("[camera]\norbit = { step = 5 }\n",
                "2:11: error: camera.orbit.step: unknown key; did you mean \"step_deg\"?");
}

// SOURCES A39.
TEST_F(BookSceneFile, LinearFactorHoldsAlongAxes) {
    const SceneDescription scene = good(std::string(kBody) + "linear_factor = [1, 1, 0]\n");
    expect_near(scene.entities[0].body->linear_factor, {1, 1, 0});
    expect_only(
        std::string(kBody) + "linear_factor = [1, 0.5, 1]\n",
        "5:17: error: entity[0].body.linear_factor: expected 1 (free) or 0 (held) for each of "
        "x, y and z, as in [1, 1, 0]");
    expect_only(
        std::string(kBody) + "kind = \"static\"\nlinear_factor = [0, 1, 1]\n",
        "6:17: warning: entity[0].body.linear_factor: only dynamic bodies are held along axes; "
        "ignored");
}

// SOURCES A35.
TEST_F(BookSceneFile, ContactMaterialIsAMaterialOfABody) {
    const std::string materials = "[[material]]\nname = \"red\"\n[[material]]\nname = \"blue\"\n";
    const SceneDescription scene =
        good(materials +
             "[[entity]]\nprimitive = { sphere = 1 }\nmaterial = \"red\"\n"
             "contact_material = \"blue\"\nbody = {}\n");
    EXPECT_EQ(scene.entities[0].contact_material, "blue");
    expect_only(
        materials +
            "[[entity]]\nprimitive = { sphere = 1 }\ncontact_material = \"bleu\"\nbody = {}\n",
        "7:20: error: entity[0].contact_material: no material is called \"bleu\"; did you mean "
        "\"blue\"?");
    expect_only(
        materials + "[[entity]]\nprimitive = { sphere = 1 }\ncontact_material = \"blue\"\n",
        "7:20: error: entity[0].contact_material: nothing touches an entity without a body");
}

// SOURCES A36.
TEST_F(BookSceneFile, ATriggerIsAVolumeWithoutABody) {
    const std::string prefab =
        "[[prefab]]\nname = \"green_box\"\nprimitive = { box = [4, 4, 4] }\nbody = {}\n";
    const std::string volume = "[[entity]]\nname = \"t\"\nprimitive = { box = [2, 0.5, 2] }\n";
    const SceneDescription scene =
        good(prefab + volume +
             "trigger = { spawn = \"green_box\", at_m = [5, 10, 0], of = [\"t\"], times = 3 }\n");
    const TriggerDescription& trigger = *scene.entities[0].trigger;
    EXPECT_EQ(trigger.spawn, "green_box");
    expect_near(trigger.at_m, {5, 10, 0});
    EXPECT_EQ(trigger.of, std::vector<std::string>{"t"});
    EXPECT_EQ(trigger.times, 3);
    expect_only(
        prefab + volume + "trigger = { spawn = \"green_bx\", at_m = [0, 0, 0] }\n",
        "8:21: error: entity[0].trigger.spawn: no prefab is called \"green_bx\"; did you mean "
        "\"green_box\"?");
    expect_only(
        prefab + volume +
            "trigger = { spawn = \"green_box\", at_m = [0, 0, 0], of = [\"tt\", \"t#1\"] }\n",
        "6:8: warning: entity[0].trigger.of: no entity is called \"tt\"; did you mean \"t\"?");
    expect_only(prefab + volume + "trigger = { at_m = [0, 0, 0] }\n",
                "8:11: error: entity[0].trigger.spawn: missing; expected the name of a prefab");
    expect_only(prefab + volume + "trigger = { spawn = \"green_box\" }\n",
                "8:11: error: entity[0].trigger.at_m: missing; expected where it appears");
    expect_only(
        prefab + volume + "trigger = { spawn = \"green_box\", at_m = [0, 0, 0] }\nbody = {}\n",
        "8:11: error: entity[0].trigger: is passed through: the entity has no body");
    expect_only(
        prefab +
            "[[entity]]\nname = \"t\"\ntrigger = { spawn = \"green_box\", at_m = [0, 0, 0] }\n",
        "7:11: error: entity[0].trigger: is the volume of a primitive other than a plane; "
        "there is none");
}

// SOURCES A15, A17, A20.
TEST_F(BookSceneFile, TheTextbooksLightIsTakenApart) {
    const SceneDescription scene = good(
        "[[material]]\nname = \"m\"\nshading = \"blinn_phong\"\nshininess = 15\nspecular = 1\n"
        "diffuse = 0.25\nwhite_highlight = true\nflat = true\n");
    const assets::MaterialData& material = scene.materials.at("m");
    EXPECT_EQ(material.shininess, 15.0F);
    EXPECT_EQ(material.diffuse, 0.25F);
    EXPECT_TRUE(material.white_highlight);
    EXPECT_TRUE(material.flat);
    expect_only(
        "[[material]]\nname = \"m\"\ndiffuse = 0.5\n",
        "3:11: warning: material[0].diffuse: needs shading = \"blinn_phong\" and a shininess "
        "above 0; ignored");
}

// SOURCES A3, A12: numbers as the screen showed them.
TEST_F(BookSceneFile, TheBooksColoursAreOfTheScreen) {
    Diagnostics faults;
    const std::filesystem::path assets = std::filesystem::path(PL_SOURCE_DIR) / "assets";
    const auto scene = read_description(assets / "scenes/book/box.toml", assets, faults);
    ASSERT_TRUE(scene.ok());
    const auto shown = [](float linear) {
        const double value = static_cast<double>(linear);
        return std::lround(255 * (1.055 * std::pow(value, 1 / 2.4) - 0.055));
    };
    EXPECT_EQ(shown(scene->clear_color.x), 153);
    EXPECT_EQ(shown(scene->clear_color.y), 166);
    EXPECT_EQ(shown(scene->clear_color.z), 217);
    EXPECT_EQ(shown(scene->materials.at("red").base_color.y), 51);
    expect_near(scene->camera.position_m, {10, 5, 0});
    expect_near(scene->camera.target_m, {0, 0, 0});
    expect_near(scene->camera.up, {0, 1, 0});
    EXPECT_NEAR(scene->camera.fov_y_rad, kPi / 2, kSlack);
    EXPECT_NEAR(scene->camera.near_m, 1, kSlack);
    EXPECT_NEAR(scene->camera.far_m, 1000, 1e-3);
}

}  // namespace
}  // namespace plumbline::scene
