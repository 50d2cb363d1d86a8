#include "tests/engine/effects/drawn.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::effects {
namespace {

using physics::BodyKind;
using test::box;
using test::Running;

constexpr ServedDomains kListening{.frame = false, .sound = true};

scene::SurfaceTable creaking_surfaces() {
    scene::SurfaceTable surfaces = test::plain_surfaces();
    surfaces.surfaces.push_back(
        {.name = "wood",
         .density_kgpm3 = 600,
         .creak_sound = std::filesystem::path(PL_SOURCE_DIR) / "assets/sounds/creak_wood.ogg"});
    return surfaces;
}

/// A leaf of 1 m on a hinge at the origin, held by a little friction.
scene::SceneDescription gate(float creak, Real mass_kg = 14) {
    scene::EntityDescription leaf = box("leaf", {0.5_r, 0, 0}, {1, 1, 0.05_r});
    leaf.body->mass_kg = mass_kg;
    leaf.material = "wood";
    scene::SceneDescription scene =
        test::scene_of({leaf, box("post", {-0.2_r, 0, 0}, {0.1_r, 2, 0.1_r}, BodyKind::Static)});
    scene.materials["wood"] = {.name = "wood", .surface = "wood"};
    scene.joints.push_back({.name = "hinge",
                            .kind = physics::JointKind::Hinge,
                            .a = "leaf",
                            .b = "post",
                            .axis = {0, 1, 0},
                            .motor = physics::JointMotor{.target = 0, .max = 1.5_r},
                            .creak = creak,
                            .location = in_file("garden.toml", 50)});
    return scene;
}

struct Swung {
    explicit Swung(const scene::SceneDescription& scene)
        : run(scene, creaking_surfaces()), effects(*run, kListening) {}
    void push(Real spin_radps) {
        run->physics.set_velocity(run.body("leaf"),
                                  glm::cross(Vec3{0, spin_radps, 0}, Vec3{0.5_r, 0, 0}),
                                  {0, spin_radps, 0});
    }
    std::vector<audio::LoopCue> listen(int steps) {
        run.step(steps, effects);
        return effects.sound(*run, {}).loops;
    }
    Running run;
    EffectRuntime effects;
};

TEST(CreakSounds, AreHeardWhileTheGateMovesAndNotWhileItRests) {
    Swung gate_(gate(0.8F));
    EXPECT_EQ(line_of(gate_.effects, "creak_sounds").called_for_by,
              Callers{"joint hinge (garden.toml:50)"});
    EXPECT_TRUE(gate_.listen(60).empty());
    gate_.push(1.5_r);
    const auto creaking = gate_.listen(10);
    ASSERT_EQ(creaking.size(), 1U);
    EXPECT_GT(creaking[0].gain, 0.1F);
    EXPECT_NEAR(glm::length(creaking[0].position_world), 0.0F, 0.02F) << "at the hinge";
    EXPECT_NE(creaking[0].sound, assets::SoundId{});
    EXPECT_TRUE(gate_.listen(600).empty()) << "its friction stopped it";
}

// Power at the pin goes with load and speed, loudness with its root.
TEST(CreakSounds, AreLouderUnderLoadAndHigherWithSpeed) {
    const auto creak = [](Real mass_kg, Real spin_radps) {
        Swung gate_(gate(0.5F, mass_kg));
        gate_.run.step(5, gate_.effects);
        gate_.push(spin_radps);
        return gate_.listen(12).at(0);
    };
    EXPECT_GT(creak(20, 1).gain, 1.3F * creak(5, 1).gain);
    EXPECT_GT(creak(14, 2).gain, 1.2F * creak(14, 0.8_r).gain);
    EXPECT_GT(creak(14, 2).pitch, 1.1F * creak(14, 0.8_r).pitch);
}

TEST(CreakSounds, OnlyWhereAJointSaysSo) {
    Swung silent(gate(0.0F));
    silent.push(2);
    EXPECT_TRUE(silent.listen(10).empty());
    EXPECT_EQ(line_of(silent.effects, "creak_sounds").constructions, 0U);
    EXPECT_EQ(line_of(silent.effects, "creak_sounds").bytes_cpu, 0U);
}

TEST(CreakSounds, EndWithTheirJoint) {
    Swung gate_(gate(1.0F));
    gate_.push(2);
    EXPECT_FALSE(gate_.listen(10).empty());
    gate_.run->registry.destroy(gate_.run->find("leaf"));
    EXPECT_TRUE(gate_.listen(60).empty());
    EXPECT_FALSE(line_of(gate_.effects, "creak_sounds").exists);
}

}  // namespace
}  // namespace plumbline::effects
