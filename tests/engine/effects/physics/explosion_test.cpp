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

// Sunk into the ground by a little, as what rests is: the ground takes nothing of what goes off inside of it.
TEST(Explosion, InTheMiddleOfABodyPushesItNowhereAndStrikesItAllAround) {
    scene::EntityDescription core = test::box("core", {0, 0.4999_r, 0}, {1, 1, 1});
    core.body->mass_kg = 50;
    SceneDescription scene = test::scene_of(
        {core, test::box("ground", {0, -1, 0}, {20, 2, 20}, physics::BodyKind::Static)});
    scene.forces.explosions.push_back(
        {.at_s = 0.1, .position_m = {0, 0.5_r, 0}, .impulse_Ns = 4000});
    test::Running run(scene);
    EffectRuntime effects(*run, {});
    std::size_t struck = 0;
    run->before_step = [&struck](scene::Simulation& simulation) {
        struck = std::max(struck, simulation.blows.size());
    };
    run.step(30, effects);
    EXPECT_GT(struck, 100U);
    EXPECT_NEAR(run.state("core").world_from_body.position.y, 0.5, 1e-3);
    EXPECT_NEAR(glm::length(run.state("core").velocity_mps), 0, 1e-3);
}

// A block takes what goes into the solid angle of its side, a cloth likewise from either side; a wall hides the other cloth.
TEST(Explosion, StrikesClothAndSoftBodies) {
    SceneDescription scene = test::scene_of(
        {test::box("wall", {0, 0, -0.5_r}, {1.02_r, 1.02_r, 0.02_r}, physics::BodyKind::Static)});
    scene.gravity_mps2 = {0, 0, 0};
    scene::SoftDescription soft;
    soft.name = "block";
    soft.size_m = {2, 2, 2};
    soft.cell_m = 0.25;
    soft.pose.position = {2.005_r, 0, 0};
    scene.forces.softs = {soft};
    for (const double z : {1.0, -1.0}) {
        scene::ClothDescription cloth;
        cloth.name = z > 0 ? "seen" : "hidden";
        cloth.cells = {{8, 8}};
        cloth.size_m = {2, 2};
        cloth.drag = 0;
        cloth.pose.position = {0, 0, static_cast<Real>(z)};
        scene.forces.cloths.push_back(cloth);
    }
    scene.forces.explosions.push_back({.at_s = 0, .impulse_Ns = 60, .reach_m = 5});
    test::Running run(scene);
    EffectRuntime effects(*run, {});
    run.step(1, effects);
    // Along the normal of a cube's side about the charge: the integral of (1 + x^2 + y^2)^-2 over [-1, 1]^2, of 4 pi.
    const double along_Ns = 60 * 0.138532;
    const auto momentum = [](const scene::SceneDeformable& each) {
        return each.body->body().totals().momentum_kgmps;
    };
    EXPECT_NEAR(momentum(run->softs()[0]).x, along_Ns, 0.02 * along_Ns);
    EXPECT_NEAR(momentum(run->softs()[0]).y, 0, 0.01);
    EXPECT_NEAR(momentum(run->cloths()[0]).z, along_Ns, 0.02 * along_Ns);
    EXPECT_EQ(momentum(run->cloths()[1]).z, 0);
}

}  // namespace
}  // namespace plumbline::effects
