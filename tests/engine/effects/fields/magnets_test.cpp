// Magnets wake each other; fixed ones pull.
#include "tests/engine/effects/fields/in_fields.h"

namespace plumbline::effects {
namespace {

using scene::SceneDescription;

TEST(Magnets, OneThatMovesWakesOneThatSleeps) {
    SceneDescription scene = test::scene_of({test::ground()});
    for (const char* name : {"lies", "comes"}) {
        scene::EntityDescription magnet = test::box(name, {0, 0.05_r, 0}, {0.1_r, 0.1_r, 0.1_r});
        magnet.body->mass_kg = 0.5_r;
        magnet.body->magnet = scene::Magnet{{0, 0, 100}};
        scene.entities.push_back(magnet);
    }
    scene.entities.back().world_from_body.position = {0, 0.05_r, 8};
    test::Running run(scene);
    EffectRuntime effects(*run, {});
    run.step(180, effects);
    EXPECT_FALSE(run.state("lies").awake);
    EXPECT_EQ(line_of(effects, "magnets").calls > 0, true);
    run->physics.set_pose(run.body("comes"), {.position = {0, 0.05_r, 0.18_r}});
    run->physics.set_velocity(run.body("comes"), {0, 0, -0.1_r}, {0, 0, 0});
    run.step(30, effects);
    EXPECT_GT(run.state("lies").world_from_body.position.z, 0.01_r) << "pulled towards it";
}

TEST(Magnets, FixedOnesPullAndStay) {
    SceneDescription scene = test::scene_of({});
    scene.gravity_mps2 = {0, 0, 0};
    scene::EntityDescription fixed = kilogram("fixed", {0, 0, 0});
    fixed.body->kind = physics::BodyKind::Static;
    fixed.body->magnet = scene::Magnet{{0, 0, 100}};
    scene::EntityDescription free = kilogram("free", {0, 0, 1});
    free.body->magnet = scene::Magnet{{0, 0, 100}};
    scene.entities = {fixed, free};
    test::Running run(scene);
    EffectRuntime effects(*run, {});
    run.step(30, effects);
    EXPECT_NEAR(static_cast<double>(run.state("free").velocity_mps.z), -0.5 * 6e-3, 1e-4);
}

}  // namespace
}  // namespace plumbline::effects
