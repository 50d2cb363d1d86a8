// Shots, lifts and explosions.
#include "engine/physics/query.h"
#include "tests/game/book_stage.h"

namespace plumbline::game {
namespace {

// SOURCES A33.
TEST(RulesForces, ShootsAKilogramAt25MetresASecondWhereThePointerIs) {
    Playground play(stage());
    const Vec3 point{3, 2, 0};
    const Vec3 eye = camera(play).position;
    play.step(at(play, point, press({Action::Shoot})));
    ASSERT_EQ(play.thing_count(), 1U);
    const Vec3 way = glm::normalize(point - eye);
    const Vec3 fall = Vec3{0, -10, 0} / Real{60};
    EXPECT_NEAR(glm::distance(play.state("shot#1").velocity_mps, way * Real{25} + fall), 0, 1e-3);
    EXPECT_NEAR(play.simulation->physics.state(play.body("shot#1")).mass.mass_kg, 1, 1e-5);
    EXPECT_NEAR(
        glm::length(glm::cross(play.state("shot#1").world_from_body.position - eye, way)), 0, 0.01)
        << "it starts on the ray";
    play.step(hold({Action::Shoot}));
    EXPECT_EQ(play.thing_count(), 1U) << "one a press";
}

// SOURCES A37: 20 N lift a kilogram that weighs 10 N with 10 m/s2.
TEST(RulesForces, LiftsWhatIsUnderThePointerWith20Newtons) {
    Playground play(stage_with({floor_at(0), loose("other", {8, 1, 0}), loose("box", {0, 1, 0})}));
    play.step(at(play, {0, 1, 0}, press({Action::Lift})));
    for (int i = 1; i < 60; ++i) play.step(at(play, {20, 20, 0}, hold({Action::Lift})));
    EXPECT_NEAR(play.state("box").velocity_mps.y, 10, 0.02);
    EXPECT_NEAR(play.state("box").world_from_body.position.y, 1 + 5, 0.05);
    play.run(1);
    EXPECT_NEAR(play.state("box").velocity_mps.y, 0, 0.02) << "and falls once it is let go";
    // Beside everything a free pointer lifts the scene's first body.
    play.step(at(play, {0, 40, 0}, press({Action::Lift})));
    for (int i = 1; i < 30; ++i) play.step(at(play, {0, 40, 0}, hold({Action::Lift})));
    EXPECT_NEAR(play.state("other").velocity_mps.y, 5, 0.02);
}

// SOURCES A37: 50 N s at 1 m, the less the farther, within 3 m, once.
TEST(RulesForces, AnExplosionPushesByFiftyThroughTheDistanceWithinThreeMetres) {
    scene::SceneDescription scene =
        stage_with({floor_at(0), loose("near", {2, 1, 0}), loose("far", {6, 1, 0})});
    scene.entities[1].body->friction = 0;
    Playground play(scene);
    const Vec3 hit{0, 0, 0};
    const Vec3 way = play.state("near").world_from_body.position - hit;
    const Real speed_mps = 50 / glm::length(way);
    play.step(at(play, hit, press({Action::Explode})));
    const Vec3 wanted = glm::normalize(way) * speed_mps + Vec3{0, -10, 0} / Real{60};
    EXPECT_NEAR(glm::distance(play.state("near").velocity_mps, wanted), 0, 0.05);
    EXPECT_NEAR(glm::length(play.state("far").velocity_mps), 0, 1e-3) << "5 m away: not reached";
    const Vec3 after = play.state("near").velocity_mps;
    play.step(at(play, hit, hold({Action::Explode})));
    EXPECT_NEAR(play.state("near").velocity_mps.x, after.x, 1e-3) << "one step a press";
}

TEST(RulesForces, WithoutAFreePointerTheSameKeysGoWhereTheCameraLooks) {
    Playground play(stage_with({floor_at(-5), loose("box", {0, 0, 0})}));
    play.simulation->physics.set_pose(play.body("box"), {.position = {0, 0, 0}});
    play.step(press({Action::Lift}));
    EXPECT_EQ(play.messages().back(), "nothing to lift") << "15 m are out of reach";
    EXPECT_FALSE(play.game->hud(*play.simulation).crosshair) << "none while orbiting";
}

TEST(RulesForces, WhatIsFrozenOrHeavyStaysWhereItIs) {
    Playground play(stage_with({floor_at(0), loose("box", {0, 1, 0})}));
    play.simulation->physics.set_frozen(play.body("box"), true);
    play.step(at(play, {0, 1, 0}, press({Action::Lift})));
    EXPECT_EQ(play.messages().back(), "nothing to lift");
    play.step(at(play, {1, 0, 0}, press({Action::Explode})));
    EXPECT_EQ(play.state("box").velocity_mps, Vec3(0, 0, 0));
}

TEST(RulesForces, AnExplosionNeedsSomethingToExplodeAt) {
    Playground play(stage_with({floor_at(0), loose("box", {0, 1, 0})}));
    play.step(at(play, {0, 40, 0}, press({Action::Explode})));
    EXPECT_EQ(play.messages().back(), "nothing to explode there");
    EXPECT_NEAR(glm::length(play.state("box").velocity_mps), 0, 1e-3);
}

}  // namespace
}  // namespace plumbline::game
