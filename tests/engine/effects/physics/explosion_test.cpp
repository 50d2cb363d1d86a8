// Charges go off once, and spare what is hidden.
#include "tests/engine/effects/fields/in_fields.h"

namespace plumbline::effects {
namespace {

using scene::SceneDescription;

TEST(Explosion, GoesOffOnceAtEveryRate) {
    for (const int hz : {30, 60, 240}) {
        SceneDescription scene = test::scene_of({kilogram("ball", {0, 0, 2})});
        scene.gravity_mps2 = {0, 0, 0};
        scene.accuracy.step_hz = hz;
        scene.accuracy.step_hz_given = true;
        scene.forces.explosions.push_back({.at_s = 0.5, .impulse_Ns = 100});
        test::Running run(scene);
        EffectRuntime effects(*run, {});
        run.step(hz / 2, effects);
        EXPECT_EQ(run.state("ball").velocity_mps.z, 0) << hz;
        run.step(hz, effects);
        EXPECT_NEAR(static_cast<double>(run.state("ball").velocity_mps.z), 100 * 0.01 / 4, 1e-4)
            << hz;
    }
}

TEST(Explosion, SparesWhatIsOutOfReachOrHidden) {
    SceneDescription scene = test::scene_of(
        {kilogram("near", {0, 0, 2}), kilogram("far", {0, 0, -5}), kilogram("behind", {4, 0, 0})});
    scene.gravity_mps2 = {0, 0, 0};
    scene.entities.push_back(
        test::box("wall", {2, 0, 0}, {0.2_r, 3, 3}, physics::BodyKind::Static));
    scene.forces.explosions.push_back({.at_s = 0, .impulse_Ns = 100, .reach_m = 4.5_r});
    scene.forces.explosions.push_back(
        {.position_m = {0, 0, 2.5_r}, .impulse_Ns = 1000});  // nobody sets it off
    test::Running run(scene);
    EffectRuntime effects(*run, {});
    run.step(2, effects);
    EXPECT_GT(run.state("near").velocity_mps.z, 0);
    EXPECT_EQ(run.state("far").velocity_mps.z, 0);
    EXPECT_EQ(run.state("behind").velocity_mps.x, 0);
    EXPECT_EQ(line_of(effects, "explosion").calls, 2U)
        << "near and, hidden, none: targets in reach";
}

}  // namespace
}  // namespace plumbline::effects
