#include "engine/scene/simulation.h"

#include "engine/core/limits.h"
#include "engine/physics/query.h"
#include "engine/physics/totals.h"
#include "engine/scene/simulation/entity_lookup.h"
#include "tests/support/near.h"
#include "tests/support/scene_in_code.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <limits>

namespace plumbline::scene {
namespace {

using physics::BodyKind;
using test::ball;
using test::box;
using test::cube;
using test::ground;
using test::near;
using test::Running;
using test::scene_of;

bool mentions(const std::vector<std::string>& texts, std::string_view part) {
    return std::any_of(texts.begin(), texts.end(), [&](const std::string& text) {
        return text.find(part) != std::string::npos;
    });
}

TEST(Simulation, FallsAsGalileoSays) {
    Running run(scene_of({cube("cube", {0, 100, 0})}));
    run.step(60);
    // Half of 9.81 after one second, whatever the step.
    EXPECT_NEAR(static_cast<double>(run.state("cube").world_from_body.position.y), 95.095, 1e-5);
    EXPECT_EQ(run->steps(), 60U);
    EXPECT_DOUBLE_EQ(run->time_s(), 1.0);
}

TEST(Simulation, OverridesStandAboveTheScene) {
    Running run(
        scene_of({}),
        test::plain_surfaces(),
        {.solver = physics::Solver::BulletPgs, .step_hz = 240, .substeps = 3, .iterations = 7});
    EXPECT_DOUBLE_EQ(run->step_s(), 1.0 / 240.0);
    EXPECT_EQ(run->physics.def().substeps, 3);
    EXPECT_EQ(run->physics.def().iterations, 7);
    EXPECT_EQ(run->physics.def().solver, physics::Solver::BulletPgs);
}

TEST(Simulation, KeepsFileOrderAndNumbersArraysXFirst) {
    SceneDescription scene = scene_of({cube("first", {0, 50, 0}), cube("second", {5, 50, 0})});
    scene.arrays.push_back({.name = "pile",
                            .prefab = cube("crate", {}),
                            .origin_m = {0, 1, 0},
                            .count = {2, 1, 2},
                            .spacing_m = {3, 1, 4}});
    Running run(scene);
    std::vector<std::string> names;
    for (const MovingBody& body : run->moving_bodies()) {
        names.push_back(run->registry.get<Name>(body.entity).text);
    }
    const std::vector<std::string> expected{
        "first", "second", "pile.0.0.0", "pile.1.0.0", "pile.0.0.1", "pile.1.0.1"};
    EXPECT_EQ(names, expected);
    EXPECT_TRUE(near(run.state("pile.1.0.1").world_from_body.position, Vec3{3, 1, 4}, 1e-6));
}

TEST(Simulation, TurnsTheCopiesOfAnArrayStepByStep) {
    EntityDescription plank = box("plank", {}, {2, 1, 1});
    plank.world_from_body.orientation = quat_from_euler_deg({0, 0, 90});
    SceneDescription scene = scene_of({});
    const Vec3 turn_rad{0, radians_from_degrees(30.0_r), radians_from_degrees(5.0_r)};
    scene.arrays.push_back({.name = "stairs",
                            .prefab = plank,
                            .count = {1, 4, 2},
                            .spacing_m = {3, 3, 3},
                            .turn_rad = turn_rad});
    Running run(scene);
    // Its long side is up, whatever the turn about +Y; its z side shows the turn.
    const Quat turned = run.state("stairs.0.3.1").world_from_body.orientation;
    EXPECT_TRUE(near(turned * Vec3{1, 0, 0}, Vec3{0, 1, 0}, 1e-6));
    const Real angle = radians_from_degrees(95.0_r);  // 3 times 30 and 5
    EXPECT_TRUE(near(turned * Vec3{0, 0, 1}, Vec3{std::sin(angle), 0, std::cos(angle)}, 1e-6));
    EXPECT_TRUE(near(run.state("stairs.0.0.0").world_from_body.orientation * Vec3{0, 0, 1},
                     Vec3{0, 0, 1},
                     1e-6));
}

TEST(Simulation, WeighsByDensityVolumeAndScale) {
    EntityDescription given = box("given", {0, 10, 0}, {1, 2, 3});
    given.scale = {2, 1, 1};
    given.body->density_kgpm3 = 100;
    EntityDescription surface = box("surface", {0, 20, 0}, {0.1_r, 0.1_r, 0.1_r});
    EntityDescription weighed = cube("weighed", {0, 30, 0});
    weighed.body->mass_kg = 7;
    Running run(scene_of({given, surface, weighed}));
    const auto mass = [&](const char* name) {
        return static_cast<double>(run->physics.state(run.body(name)).mass.mass_kg);
    };
    EXPECT_NEAR(mass("given"), 1200.0, 1e-3);
    EXPECT_NEAR(mass("surface"), 1.0, 1e-5);  // 1000 kg/m3
    EXPECT_NEAR(mass("weighed"), 7.0, 1e-6);
}

TEST(Simulation, ScaleIsVisualAndShape) {
    EntityDescription tall = cube("tall", {0, 10, 0});
    tall.scale = {1, 4, 1};
    Running run(scene_of({tall}));
    Vec3 min;
    Vec3 max;
    physics::bounds(run->physics, run.body("tall"), min, max);
    EXPECT_NEAR(static_cast<double>(max.y - min.y), 4.0, 0.1);
    EXPECT_EQ(run->registry.get<Transform>(run->find("tall")).scale, (Vec3{1, 4, 1}));
}

TEST(Simulation, RemovesAndCountsWhatFallsBelowTheKillHeight) {
    SceneDescription scene = scene_of({cube("doomed", {0, 0, 0}), cube("high", {5, 1000, 0})});
    scene.kill_below_m = Real{-5};
    Running run(scene);
    run.step(59);  // 4.74 m
    EXPECT_TRUE(run->find("doomed"));
    run.step(10);  // 6.49 m
    EXPECT_FALSE(run->find("doomed"));
    EXPECT_TRUE(run->find("high"));
    EXPECT_EQ(run->tally().removed, 1U);
    EXPECT_EQ(body_count(run->physics), 1U);
    EXPECT_EQ(run->moving_bodies().size(), 1U);
}

TEST(Simulation, DestroyingAnEntityDestroysItsBody) {
    Running run(scene_of({cube("a", {0, 10, 0}), cube("b", {5, 10, 0})}));
    const physics::BodyId body = run.body("a");
    run->registry.mark_for_destruction(run->find("a"));
    run.step(1);
    EXPECT_FALSE(run->physics.contains(body));
    EXPECT_FALSE(entity_of(*run, body));
    EXPECT_EQ(run->moving_bodies().size(), 1U);
    EXPECT_FALSE(run->find("a"));
}

TEST(Simulation, FindsEntitiesByBodyAndName) {
    Running run(scene_of({ground(), cube("a", {0, 10, 0})}));
    EXPECT_EQ(entity_of(*run, run.body("a")), run->find("a"));
    EXPECT_EQ(entity_of(*run, run.body("ground")), run->find("ground"));
    EXPECT_FALSE(run->find("nobody"));
    EXPECT_EQ(describe(*run, run->find("a")), "entity a (test.toml:10)");
}

TEST(Simulation, NumbersWhatPlayMakes) {
    Running run(scene_of({ground()}));
    EntityDescription crate = cube("crate", {0, 5, 0});
    crate.location = {};
    const ecs::Entity first = run->spawn(crate);
    const ecs::Entity second = run->spawn(crate);
    EXPECT_EQ(run->registry.get<Name>(first).text, "crate#1");
    EXPECT_EQ(run->registry.get<Name>(second).text, "crate#2");
    EXPECT_EQ(describe(*run, second), "entity crate#2");
    EXPECT_EQ(run->moving_bodies().size(), 2U);
}

TEST(Simulation, RefusesToSpawnABodyWithoutAShape) {
    Running run(scene_of({}));
    EntityDescription shapeless = cube("ghost", {0, 5, 0});
    shapeless.visual = std::monostate{};
    EXPECT_FALSE(run->spawn(shapeless));
    EXPECT_TRUE(mentions(run->warnings, "needs a model or a primitive"));
    EXPECT_EQ(run->registry.alive_count(), 0U);
}

TEST(Simulation, HashTellsStatesApart) {
    const auto hash_after = [](Real speed_mps, int steps) {
        EntityDescription thrown = cube("cube", {0, 3, 0});
        thrown.body->velocity_mps = {speed_mps, 0, 0};
        Running run(scene_of({ground(), thrown}));
        run.step(steps);
        return run->state_hash();
    };
    // Before it lies still.
    EXPECT_EQ(hash_after(1, 30), hash_after(1, 30));
    EXPECT_NE(hash_after(1, 30), hash_after(1, 29));
    EXPECT_NE(hash_after(1, 30), hash_after(1.0001_r, 30));
}

TEST(Simulation, StandsABoxInForAMissingModel) {
    EntityDescription statue = cube("statue", {0, 0.5_r, 0});
    statue.visual = ModelVisual{.file = "no/such/statue.glb", .root = "no/such"};
    statue.body->shape = physics::ShapeDef{physics::SphereShape{.radius_m = 2}};
    Running run(scene_of({statue}));
    ASSERT_TRUE(run.simulation);
    EXPECT_TRUE(mentions(run->warnings, "test.toml:10: entity statue: a box stands for its model"));
    Vec3 min;
    Vec3 max;
    physics::bounds(run->physics, run.body("statue"), min, max);
    EXPECT_NEAR(static_cast<double>(max.y - min.y), 4.0, 0.1) << "the body keeps its shape";
    const Visual& visual = run->registry.get<Visual>(run->find("statue"));
    EXPECT_NEAR(run.library.mesh(visual.mesh).bounds.size().y, 4.0F, 1e-4F);
}

TEST(Simulation, SceneMaterialsWinByName) {
    const test::TemporaryFolder folder;
    const auto file =
        folder.write("tri.obj",
                     "mtllib tri.mtl\n"
                     "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                     "usemtl bark\nf 1 2 3\nf 1 4 2\nusemtl leaf\nf 1 3 4\nf 2 4 3\n");
    folder.write("tri.mtl", "newmtl bark\nKd 1 0 0\nnewmtl leaf\nKd 0 1 0\n");
    SceneDescription scene = scene_of({});
    scene.materials["bark"] = {.name = "bark", .roughness = 0.123F};
    EntityDescription tree = cube("tree", {0, 0, 0});
    tree.visual = ModelVisual{.file = file, .root = folder.path()};
    tree.body.reset();
    scene.entities = {tree};
    Running run(scene);
    const Visual& visual = run->registry.get<Visual>(run->find("tree"));
    ASSERT_EQ(visual.materials.size(), 2U);
    for (const assets::MaterialId id : visual.materials) {
        const assets::MaterialData& material = run.library.material(id);
        EXPECT_EQ(material.roughness == 0.123F, material.name == "bark") << material.name;
    }
    EXPECT_TRUE(visual.is_static);
}

TEST(Simulation, WarnsOfBodiesThatStartInsideEachOther) {
    Running apart(scene_of({ground(), cube("a", {0, 0.5_r, 0}), cube("b", {0, 1.5_r, 0})}));
    EXPECT_TRUE(apart->warnings.empty()) << apart->warnings.front();
    Running inside(scene_of({ground(), cube("a", {0, 0.5_r, 0}), cube("b", {0.5_r, 0.5_r, 0})}));
    EXPECT_TRUE(mentions(inside->warnings, "1 pair of bodies starts interpenetrating"));
    EXPECT_TRUE(mentions(inside->warnings, "entity a (test.toml:10)"));
}

// FAULTS 19: it fell through the ground.
TEST(Simulation, ACubeOfNextToNoInertiaStandsOnTheGround) {
    EntityDescription thing = cube("thing", {0, 1.5_r, 0});
    thing.world_from_body.orientation = glm::angleAxis(0.1_r, glm::normalize(Vec3{1, 0, 0.5_r}));
    thing.body->mass_kg = 1;
    thing.body->inertia_kgm2 = Vec3{1e-6_r, 1e-6_r, 1e-6_r};
    Running run(scene_of({ground(), thing}));
    run.step(300);
    const ecs::Entity entity = run->find("thing");
    EXPECT_NEAR(run->registry.get<Transform>(entity).world_from_body.position.y, 0.5, 0.01);
}

// FAULTS 19: Bullet's penetration depth gives up on it.
TEST(Simulation, WarnsOfABoxOfTenKilometresRoundTheGround) {
    Running run(scene_of({ground(), box("box", {0, 0, 0}, {1e4_r, 1e4_r, 1e4_r})}));
    EXPECT_TRUE(mentions(run->warnings, "1 pair of bodies starts interpenetrating"));
    EXPECT_TRUE(mentions(run->warnings, "by 5000"));
}

TEST(Simulation, AThousandBallsOnOneSpotPartByThePairsOfTheNearest) {
    SceneDescription scene = scene_of({ground()});
    scene.arrays.push_back({.name = "balls",
                            .prefab = ball("ball", {}, 0.25_r),
                            .origin_m = {0, 1, 0},
                            .count = {1000, 1, 1},
                            .spacing_m = {0, 0, 0}});
    Running run(scene);
    EXPECT_TRUE(mentions(run->warnings, "at least 1997 pairs of bodies start interpenetrating"))
        << "999 with the first and 998 with the second";
    const physics::StepCost& cost = run->physics.report().cost;
    run.step(1);
    // 1000 * 999 / 2 pairs, without the 100 nearest of each: 100 * 1000 - 100 * 101 / 2.
    EXPECT_EQ(cost.interventions.left_out_pairs, 404'550U);
    EXPECT_EQ(cost.contacts, 94'950U);
    EXPECT_TRUE(mentions(run->warnings,
                         "404550 pairs of bodies in a crowd push nothing at 0.017 s: each body "
                         "meets the 100 that are nearest"));
    const std::size_t told = run->warnings.size();
    for (int i = 0; i < 5; ++i) {
        run.step(1);
        EXPECT_LE(cost.contacts, 100'000U + 1'000U) << "the ground's too";
    }
    EXPECT_EQ(run->warnings.size(), told) << "once is enough";
    EXPECT_TRUE(run->physics.report().isolated.empty());
}

TEST(Simulation, RefusesMoreBodiesThanItHolds) {
    SceneDescription scene = scene_of({});
    scene.arrays.push_back({.name = "heap",
                            .prefab = cube("crate", {}),
                            .count = {static_cast<int>(limits::kBodies) + 1, 1, 1}});
    assets::AssetLibrary library;
    const auto built = build_simulation(scene, {}, library, test::plain_surfaces());
    ASSERT_FALSE(built.ok());
    EXPECT_EQ(built.error().exit_code, ExitCode::Refused);
    EXPECT_EQ(built.error().message, "test.toml: 50001 bodies; at most 50000 are allowed");
}

TEST(Simulation, HasThirtyOneGroupsBesideTheDefault) {
    const auto scene_with_groups = [](int count) {
        SceneDescription scene = scene_of({});
        for (int i = 0; i < count; ++i) {
            EntityDescription entity = cube("cube" + std::to_string(i), {Real(3 * i), 5, 0});
            entity.body->group = "group" + std::to_string(i);
            scene.entities.push_back(entity);
        }
        return scene;
    };
    assets::AssetLibrary library;
    EXPECT_TRUE(build_simulation(scene_with_groups(31), {}, library, test::plain_surfaces()).ok());
    const auto refused =
        build_simulation(scene_with_groups(32), {}, library, test::plain_surfaces());
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().exit_code, ExitCode::Refused);
    EXPECT_NE(refused.error().message.find("test.toml:10: entity cube31: group \"group31\""),
              std::string::npos)
        << refused.error().message;
}

TEST(Simulation, GroupsDecideWhoMeetsWhom) {
    EntityDescription ghost = cube("ghost", {0, 2, 0});
    ghost.body->group = "ghosts";
    ghost.body->collides_with = {"ghosts"};
    Running run(scene_of({ground(), ghost, cube("solid", {5, 2, 0})}));
    run.step(120);
    EXPECT_LT(run.state("ghost").world_from_body.position.y, Real{-5});
    EXPECT_NEAR(static_cast<double>(run.state("solid").world_from_body.position.y), 0.5, 0.01);
}

TEST(Simulation, TakesOutWhatIsNotFiniteAndGoesOn) {
    Running run(scene_of({cube("sick", {0, 50, 0}), cube("well", {5, 50, 0})}));
    run.step(10);
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    run->physics.set_velocity(run.body("sick"), {nan, 0, 0}, {0, 0, 0});
    run.step(50);
    EXPECT_EQ(run->physics.report().isolated.size(), 1U);
    EXPECT_TRUE(mentions(run->warnings, "entity sick (test.toml:10): taken out"));
    EXPECT_NEAR(
        static_cast<double>(run.state("well").world_from_body.position.y), 50.0 - 0.5 * 9.81, 1e-4);
    EXPECT_TRUE(is_finite(run->registry.get<Transform>(run->find("sick")).world_from_body));
}

TEST(Simulation, CarriesWhatStandsOnALift) {
    EntityDescription lift = box("lift", {0, 0, 0}, {4, 0.2_r, 4}, BodyKind::Kinematic);
    lift.motion = MotionDescription{.points_m = {{0, 3, 0}}, .period_s = 8};
    Running run(scene_of({lift, cube("rider", {0, 0.6_r, 0})}));
    run.step(240);  // half the tour: at the top
    EXPECT_NEAR(static_cast<double>(run.state("lift").world_from_body.position.y), 3.0, 1e-5);
    EXPECT_NEAR(static_cast<double>(run.state("rider").world_from_body.position.y), 3.6, 0.02);
    const Transform& drawn = run->registry.get<Transform>(run->find("lift"));
    EXPECT_NEAR(static_cast<double>(drawn.world_from_body.position.y), 3.0, 1e-5);
}

TEST(MassRatio, IsNamedOnceWhereTheTwoTouch) {
    EntityDescription anvil = cube("anvil", {0, 2, 0});
    anvil.body->mass_kg = 30000;
    EntityDescription feather = cube("feather", {0, 0.5_r, 0});
    feather.body->mass_kg = 1;
    const auto warnings = [&](Real above_m) {
        anvil.world_from_body.position.y = above_m;
        Running run(scene_of({ground(), feather, anvil}));
        run.step(10);
        return std::ranges::count_if(run->warnings, [](const std::string& text) {
            return text.find("mass ratio") != std::string::npos;
        });
    };
    EXPECT_EQ(warnings(1.5_r), 1);
    EXPECT_EQ(warnings(9), 0);
    anvil.body->mass_kg = 9000;
    EXPECT_EQ(warnings(1.5_r), 0);
}

TEST(ChangedAccuracy, TimeAndPathsGoOn) {
    EntityDescription lift = box("lift", {0, 0, 0}, {1, 0.2_r, 1});
    lift.body->kind = BodyKind::Kinematic;
    lift.motion = MotionDescription{.points_m = {{0, 0, 0}, {0, 4, 0}}, .period_s = 8};
    Running plain(scene_of({lift, cube("cube", {5, 50, 0})}));
    Running changed(scene_of({lift, cube("cube", {5, 50, 0})}));
    plain.step(120);
    changed.step(60);
    physics::WorldDef def = changed->physics.def();
    def.step_s = 1.0 / 240;
    changed->set_accuracy(def);
    EXPECT_DOUBLE_EQ(changed->step_s(), 1.0 / 240);
    EXPECT_DOUBLE_EQ(changed->time_s(), 1.0);
    changed.step(240);
    EXPECT_DOUBLE_EQ(changed->time_s(), 2.0);
    EXPECT_EQ(changed->step_at(2.0), changed->steps());
    for (const char* name : {"lift", "cube"}) {
        EXPECT_LT(glm::distance(changed.state(name).world_from_body.position,
                                plain.state(name).world_from_body.position),
                  1e-4_r)
            << name;
    }
}

}  // namespace
}  // namespace plumbline::scene
