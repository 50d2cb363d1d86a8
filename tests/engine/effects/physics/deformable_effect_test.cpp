// Cloths and soft bodies: stand still while they are called off, sleep, are drawn, saved and loaded.
#include "engine/core/io/archive.h"
#include "engine/physics/sheet.h"
#include "engine/scene/simulation/simulation_archive.h"
#include "tests/engine/effects/fields/in_fields.h"

namespace plumbline::effects {
namespace {

using scene::SceneDescription;

SceneDescription curtain() {
    SceneDescription scene = test::scene_of({test::ground(), kilogram("ball", {0, 3, 0.1_r})});
    scene::ClothDescription cloth;
    cloth.name = "curtain";
    cloth.cells = {{8, 8}};
    cloth.stretch_Npm = 200;
    cloth.pose.position = {0, 2, 0};
    cloth.pose.orientation = glm::angleAxis(0.6_r, Vec3{1, 0, 0});
    cloth.pins = {{.along = {0, 0, 1, 0}, .to = {}}};
    scene.forces.cloths = {cloth};
    scene::SoftDescription soft;
    soft.name = "jelly";
    soft.size_m = {0.4, 0.4, 0.4};
    soft.cell_m = 0.2;
    soft.pose.position = {2, 0.5_r, 0};
    scene.forces.softs = {soft};
    return scene;
}

Vec3d low_end(const test::Running& run) {
    return run.simulation->cloths().front().body->body().positions_m().back();
}

TEST(DeformableEffect, HangsStillWhileItIsCalledOff) {
    test::Running run(curtain());
    EffectRuntime effects(*run, {});
    run.step(20, effects);
    EXPECT_GT(line_of(effects, "cloth").calls, 20U);
    EXPECT_GT(line_of(effects, "soft").calls, 20U);
    run->switches.turn("cloth", false);
    run.step(1, effects);
    const Vec3d stopped = low_end(run);
    run.step(30, effects);
    EXPECT_EQ(low_end(run), stopped);
    EXPECT_FALSE(line_of(effects, "cloth").exists);
    run->switches.turn("cloth", true);
    run.step(10, effects);
    EXPECT_GT(glm::distance(low_end(run), stopped), 0.01);
}

TEST(DeformableEffect, GoesOnFromASavedStateToTheBit) {
    test::Running first(curtain());
    EffectRuntime first_effects(*first, {});
    first.step(40, first_effects);
    Archive out;
    scene::serialize_state(*first, out);
    const std::string bytes = out.take();
    test::Running second(curtain());
    EffectRuntime second_effects(*second, {});
    second.step(3, second_effects);
    Archive in(bytes);
    scene::serialize_state(*second, in);
    ASSERT_FALSE(in.failed()) << in.fault();
    EXPECT_EQ(second->state_hash(), first->state_hash());
    first.step(30, first_effects);
    second.step(30, second_effects);
    EXPECT_EQ(second->state_hash(), first->state_hash());
}

TEST(DeformableEffect, SleepsAndCostsNothingThen) {
    SceneDescription scene = curtain();
    scene.entities.pop_back();
    scene.forces.cloths.front().damping_s = 0.05;
    scene.forces.cloths.front().pose.orientation = {1, 0, 0, 0};
    test::Running run(scene);
    EffectRuntime effects(*run, {});
    run.step(600, effects);
    ASSERT_TRUE(run->cloths().front().body->is_asleep());
    const std::uint64_t calls = line_of(effects, "cloth").calls;
    run.step(10, effects);
    EXPECT_EQ(line_of(effects, "cloth").calls, calls);
}

// Two curtains that hang against each other, drawn out by nothing yet.
TEST(DeformableEffect, SleepsFromTheStartUntilItIsStruck) {
    SceneDescription scene = curtain();
    scene.entities.pop_back();
    scene::ClothDescription& sheet = scene.forces.cloths.front();
    sheet.pose.orientation = {1, 0, 0, 0};
    sheet.asleep = true;
    scene.forces.cloths.push_back(sheet);
    scene.forces.cloths.back().name = "other";
    scene.forces.cloths.back().pose.position.z += 0.004_r;
    test::Running run(scene);
    EffectRuntime effects(*run, {});
    const Vec3d start = low_end(run);
    run.step(60, effects);
    EXPECT_EQ(line_of(effects, "cloth").calls, 0U);
    EXPECT_EQ(low_end(run), start);
    run->cloths().front().body->strike(60, {0, 0, 1e-3});
    run.step(2, effects);
    for (const auto& cloth : run->cloths()) EXPECT_FALSE(cloth.body->is_asleep()) << cloth.name;
    EXPECT_LT(low_end(run).y, start.y);
}

/// Each of the two effects by itself, and both together.
TEST(DeformableEffect, ClothTouchesASoftBodyWhileBothAreCalledFor) {
    SceneDescription scene = curtain();
    scene.entities.pop_back();
    scene::ClothDescription& sheet = scene.forces.cloths.front();
    sheet.pins.clear();
    sheet.damping_s = 0.03;
    sheet.pose.position = {2, 0.75_r, 0};
    sheet.pose.orientation = glm::angleAxis(1.5707963_r, Vec3{1, 0, 0});
    const auto highest_m = [](const test::Running& run) {
        double highest = 0;
        for (const Vec3d& at : run.simulation->cloths().front().body->body().positions_m())
            highest = std::max(highest, at.y);
        return highest;
    };
    test::Running run(scene);
    EffectRuntime effects(*run, {});
    run.step(180, effects);
    EXPECT_GT(highest_m(run), 0.38) << "over a jelly of 0.4 m";
    run->switches.turn("soft", false);
    run.step(120, effects);
    EXPECT_LT(highest_m(run), 0.32) << "what stands still is not touched: its own folds carry it";
}

TEST(DeformableEffect, SaysOnceWhatIsSofterThanAsked) {
    SceneDescription scene = curtain();
    scene.forces.cloths.front().stretch_Npm = 1e7;
    test::Running run(scene);
    EffectRuntime effects(*run, {});
    run.step(5, effects);
    int said = 0;
    for (const std::string& warning : run->warnings)
        said +=
            warning.find("cloth curtain: the sub-steps allowed bear") != std::string::npos ? 1 : 0;
    EXPECT_EQ(said, 1);
}

TEST(DeformableEffect, WindWakesIt) {
    SceneDescription scene = curtain();
    scene.entities.pop_back();
    scene.forces.cloths.front().damping_s = 0.05;
    scene.forces.cloths.front().pose.orientation = {1, 0, 0, 0};
    scene.forces.wind_zones = {
        {.min_m = {-9, -9, -9}, .max_m = {9, 9, 9}, .velocity_mps = {0, 0, 6}}};
    test::Running run(scene);
    EffectRuntime effects(*run, {});
    run->switches.turn("wind", false);
    run.step(600, effects);
    ASSERT_TRUE(run->cloths().front().body->is_asleep());
    run->switches.turn("wind", true);
    run.step(60, effects);
    EXPECT_GT(low_end(run).z, 0.2);
}

TEST(DeformableEffect, IsDrawnBetweenSteps) {
    test::Running run(curtain());
    EffectRuntime effects(*run, kImage);
    run.step(20, effects);
    const auto& cloth = run->cloths().front();
    const auto& visual = run->registry.get<scene::Visual>(cloth.entity);
    const auto vertex = [&](Real blend) {
        draw(run, effects, blend);
        return Vec3d(run->library().mesh(visual.mesh).vertices[80].position_body);
    };
    const Vec3d before = vertex(0);
    const Vec3d after = vertex(1);
    const Vec3d between = vertex(0.5_r);
    EXPECT_NEAR(glm::distance(before, cloth.before_m[80]), 0.002, 1e-3);
    EXPECT_GT(glm::distance(before, after), 1e-4);
    EXPECT_NEAR(glm::distance(between, (before + after) / 2.0), 0, 1e-3);
}

/// A soft block, 0.4 m high, over a pond; and a pond may be called off.
SceneDescription floating(double density_kgpm3) {
    SceneDescription scene = test::scene_of({});
    scene::SoftDescription soft;
    soft.name = "block";
    soft.size_m = {0.8, 0.4, 0.8};
    soft.cell_m = 0.2;
    soft.young_Pa = 1e6;
    soft.density_kgpm3 = density_kgpm3;
    soft.pose.position = {0, 0.1_r, 0};
    scene.forces.softs = {soft};
    scene.forces.waters.push_back({.name = "pond", .min_m = {-5, -9, -5}, .max_m = {5, 0, 5}});
    return scene;
}

double height_m(const test::Running& run) {
    const physics::PointBody& body = run.simulation->softs().front().body->body();
    return body.totals().moment_kgm.y / body.mass_kg();
}

TEST(DeformableEffect, SoftBodiesFloatAtTheirDraftAndSleepThere) {
    test::Running run(floating(300));
    EffectRuntime effects(*run, {});
    run.step(30 * 60, effects);
    EXPECT_NEAR(height_m(run), 0.2 - 0.3 * 0.4, 2e-3);
    EXPECT_TRUE(run.simulation->softs().front().body->is_asleep());
    run->switches.turn("buoyancy", false);
    run->softs().front().body->strike(0, {0, 0, 0});
    run.step(60, effects);
    EXPECT_LT(height_m(run), -1);
}

// Without resistance it bobs on, and what rings in it dies away.
TEST(DeformableEffect, SoftBodiesAfloatGainNoEnergy) {
    SceneDescription scene = floating(500);
    scene::SoftDescription& soft = scene.forces.softs[0];
    soft.size_m = {1, 0.5, 1};
    soft.cell_m = 0.25;
    soft.young_Pa = 1e7;
    soft.poisson = 0.3;
    soft.pose.position = {0, 0.02_r, 0};
    scene.forces.waters[0].drag = 0;
    test::Running run(scene);
    EffectRuntime effects(*run, {});
    const auto energy_J = [&run] {
        const physics::PointBody& body = run->softs().front().body->body();
        const physics::PointTotals totals = body.totals();
        return totals.kinetic_J + totals.elastic_J + totals.water_J + 9.81 * totals.moment_kgm.y;
    };
    const double start_J = energy_J();
    run.step(20 * 60, effects);
    EXPECT_NEAR(energy_J(), start_J, 0.05);  // of 2 J of bobbing, the ringing's
    EXPECT_LT(energy_J(), start_J + 1e-3);
}

TEST(DeformableEffect, ClothSinksSlowlyWhereAirWouldLetItFall) {
    SceneDescription scene = floating(300);
    scene::ClothDescription cloth;
    cloth.name = "sheet";
    cloth.cells = {{4, 4}};
    cloth.drag = 1.2;
    cloth.pose.position = {0, -1, 3};
    cloth.pose.orientation = glm::angleAxis(1.5707963_r, Vec3{1, 0, 0});
    scene.forces.cloths = {cloth};
    test::Running run(scene);
    EffectRuntime effects(*run, {});
    run.step(120, effects);
    // sqrt(2 m g / (rho C A)) m/s
    const double wanted_mps = std::sqrt(2 * cloth.density_kgpm2 * 9.81 / (1000 * cloth.drag));
    EXPECT_NEAR(low_end(run).y, -1 - 2 * wanted_mps, 0.02);
}

// Of fine cells, at a fidelity that allows few sub-steps: it once became so soft that it turned inside out and flew off, and never came
// to rest where they were a few more.
TEST(DeformableEffect, AHeavyBallOfFineCellsComesToRestAsARoundThing) {
    SceneDescription scene = test::scene_of({test::ground()});
    scene.forces.fidelity.soft = scene::Fidelity::Draft;
    scene::SoftDescription ball;
    ball.name = "ball";
    ball.form = scene::SoftForm::Ellipsoid;
    ball.size_m = {0.5, 0.5, 0.5};
    ball.cell_m = 0.1;
    ball.poisson = 0.33;
    ball.damping_s = 0.02;
    ball.pose.position = {0, 0.51_r, 0};
    scene.forces.softs = {ball};
    test::Running run(scene);
    EffectRuntime effects(*run, {});
    run.step(300, effects);
    const physics::PointBody& body = run->softs().front().body->body();
    const auto [low, high] = physics::bounds_of(body.positions_m());
    EXPECT_NEAR(high.y - low.y, 0.89, 0.02);
    EXPECT_NEAR(high.x - low.x, 1.04, 0.02);
    EXPECT_LT(body.totals().kinetic_J, 0.1);
}

}  // namespace
}  // namespace plumbline::effects
