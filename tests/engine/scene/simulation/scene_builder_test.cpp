// What a scene is warned of when it is built: numbers that no step of it can follow.
#include "tests/support/scene_in_code.h"

#include <gtest/gtest.h>

namespace plumbline::scene {
namespace {

using test::cube;
using test::Running;
using test::scene_of;

std::vector<std::string> warnings_of(const SceneDescription& scene,
                                     const SimulationOverrides& overrides = {}) {
    return Running(scene, test::plain_surfaces(), overrides)->warnings;
}

/// Two bodies of 1 kg on a spring of `stiffness_Npm`.
SceneDescription on_a_spring(Real stiffness_Npm) {
    SceneDescription scene = scene_of({cube("a", {0, 5, 0}), cube("b", {0, 7, 0})});
    for (EntityDescription& entity : scene.entities) entity.body->mass_kg = 1;
    scene.joints = {{.name = "coil",
                     .kind = JointKind::Spring,
                     .a = "a",
                     .b = "b",
                     .anchor_a_m = {0, 5, 0},
                     .anchor_b_m = {0, 7, 0},
                     .stiffness_Npm = stiffness_Npm,
                     .location = in_file("test.toml", 40)}};
    return scene;
}

// The bodies swing at the root of 2 k; 0.5 rad in 1/960 s is 115.2 kN/m.
TEST(SceneBuilder, WarnsOfSpringsThatSwingFasterThanTheShortestSubstep) {
    EXPECT_TRUE(warnings_of(on_a_spring(115e3_r)).empty());
    EXPECT_EQ(
        warnings_of(on_a_spring(116e3_r)),
        std::vector<std::string>{
            "test.toml:40: joint coil: 116000 N/m swings its bodies faster than 960 sub-steps "
            "a second can follow: it holds them, but swings slower or not at all; up to "
            "1.15e+05 N/m they can"});
    EXPECT_TRUE(warnings_of(on_a_spring(116e3_r), {.step_hz = 120}).empty());
    // Twice as stiff where only one end moves.
    SceneDescription hung = on_a_spring(230e3_r);
    hung.joints[0].b = "world";
    EXPECT_TRUE(warnings_of(hung).empty());
    hung.joints[0].stiffness_Npm = 232e3_r;
    EXPECT_EQ(warnings_of(hung).size(), 1U);
}

// A ball of 0.5 m fits into a cube of 1 m: 0.1 kg m2 for 1 kg.
TEST(SceneBuilder, WarnsOfInertiasThatNoSolidBodyHas) {
    SceneDescription scene = scene_of({cube("thing", {0, 5, 0})});
    scene.entities[0].body->mass_kg = 1;
    EXPECT_TRUE(warnings_of(scene).empty());
    scene.entities[0].body->inertia_kgm2 = Vec3{1, 5.1e-3_r, 1};
    EXPECT_TRUE(warnings_of(scene).empty());
    scene.entities[0].body->inertia_kgm2 = Vec3{1, 1e-6_r, 1};
    EXPECT_EQ(
        warnings_of(scene),
        std::vector<std::string>{
            "test.toml:10: entity thing: a moment of inertia of 1e-06 kg m2, where a ball that "
            "fits into it has 0.1: 0.005 is used, as with less it would turn through what it lies "
            "on"});
}

}  // namespace
}  // namespace plumbline::scene
