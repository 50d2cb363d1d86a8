// What contacts do to looks, and volumes to the world.
#include "tests/engine/effects/drawn.h"

namespace plumbline::effects {
namespace {

/// Two cubes over the ground, red ones that are yellow while they touch something.
scene::SceneDescription touchy() {
    scene::SceneDescription scene =
        test::scene_of({test::ground(), test::cube("a", {0, 2, 0}), test::cube("b", {0, 5, 0})});
    for (const char* name : {"red", "yellow"}) scene.materials[name].name = name;
    for (std::size_t i : {1U, 2U}) {
        scene.entities[i].material = "red";
        scene.entities[i].contact_material = "yellow";
    }
    return scene;
}

std::string worn(test::Running& run, const std::string& name) {
    const auto& visual = run->registry.get<scene::Visual>(run->find(name));
    return run.library.material(visual.materials.at(0)).name;
}

// SOURCES A35: from the step in which the pair begins to touch to that in which it ends.
TEST(ContactAppearance, IsWornFromTheBeginOfAContactToItsEnd) {
    test::Running run(touchy());
    EffectRuntime effects(*run, {.frame = true});
    // It falls 1.5 m: sqrt(2 * 1.5 / 9.81) = 0.553 s.
    run.step(32, effects);
    EXPECT_EQ(worn(run, "a"), "red");
    run.step(3, effects);
    EXPECT_EQ(worn(run, "a"), "yellow");
    EXPECT_EQ(worn(run, "b"), "red");
    run.step(60 * 6, effects);
    EXPECT_FALSE(run.state("b").awake);
    EXPECT_EQ(worn(run, "b"), "yellow") << "also asleep";
    run->physics.apply_impulse(run.body("b"), Vec3{0, 5, 0} * Real{1000});
    run.step(4, effects);
    EXPECT_EQ(worn(run, "b"), "red");
    EXPECT_EQ(worn(run, "a"), "yellow") << "the ground is under it";
    EXPECT_EQ(line_of(effects, "contact_look").called_for_by.size(), 2U);
    EXPECT_GE(line_of(effects, "contact_look").calls, 3U);
}

TEST(ContactAppearance, CostsNothingWhereNobodyCallsForIt) {
    test::Running run(test::scene_of({test::ground(), test::cube("a", {0, 2, 0})}));
    EffectRuntime effects(*run, {.frame = true});
    run.step(60, effects);
    for (const char* name : {"contact_look", "triggers", "contact_events"}) {
        const LedgerLine line = line_of(effects, name);
        EXPECT_EQ(line.constructions, 0U) << name;
        EXPECT_EQ(line.calls, 0U) << name;
        EXPECT_EQ(line.cpu_ms, 0.0) << name;
        EXPECT_EQ(line.bytes_cpu, 0U) << name;
    }
}

/// The book's volume: half as large 1, 0.25 and 1 m at (0, 1.5, 0), over a floor at y = 1.
scene::SceneDescription with_trigger(int times) {
    scene::EntityDescription floor =
        test::box("floor", {0, 0, 0}, {100, 2, 100}, physics::BodyKind::Static);
    scene::EntityDescription red = test::box("red_box", {0, 10, 0}, {2, 2, 2});
    red.body->mass_kg = 1;
    scene::EntityDescription volume = test::box("trigger", {0, 1.5_r, 0}, {2, 0.5_r, 2});
    volume.body.reset();
    volume.trigger = scene::TriggerDescription{
        .spawn = "green_box", .at_m = {5, 10, 0}, .of = {"red_box"}, .times = times};
    scene::SceneDescription scene = test::scene_of({floor, red, volume});
    scene.gravity_mps2 = {0, -10, 0};
    scene.prefabs["green_box"] = test::box("green_box", {0, 0, 0}, {4, 4, 4});
    scene.prefabs["green_box"].body->mass_kg = 2;
    return scene;
}

// SOURCES A36: the box's lower side is at y = 9 and comes to the volume's top, 1.75, after
// sqrt(2 * 7.25 / 10) = 1.204 s, which is in step 73. It falls through, to y = 2.
TEST(Triggers, ABoxThatComesInMakesAnotherAppear) {
    test::Running run(with_trigger(1));
    EffectRuntime effects(*run, {});
    run.step(72, effects);
    EXPECT_FALSE(run->registry.alive(run->find("green_box#1")));
    run.step(1, effects);
    ASSERT_TRUE(run->registry.alive(run->find("green_box#1")));
    EXPECT_NEAR(run.state("green_box#1").world_from_body.position.x, 5, 1e-6);
    EXPECT_NEAR(run.state("green_box#1").world_from_body.position.y, 10, 1e-6);
    EXPECT_NEAR(run->physics.mass_properties(run.body("green_box#1")).mass_kg, 2, 1e-5);
    run.step(240, effects);
    EXPECT_NEAR(run.state("red_box").world_from_body.position.y, 2, 0.02) << "nothing stopped it";
    EXPECT_FALSE(run->registry.alive(run->find("green_box#2"))) << "once only";
    EXPECT_EQ(line_of(effects, "triggers").calls, 1U);
}

TEST(Triggers, CountsEachTimeABodyComesInAsOftenAsItMay) {
    test::Running run(with_trigger(2));
    EffectRuntime effects(*run, {});
    for (std::uint64_t visit = 1; visit <= 3; ++visit) {
        run->physics.set_pose(run.body("red_box"), {.position = {0, 1.9_r, 0}});
        run.step(2, effects);
        EXPECT_EQ(line_of(effects, "triggers").calls, std::min<std::uint64_t>(visit, 2));
        run->physics.set_pose(run.body("red_box"), {.position = {0, 30, 0}});
        run.step(2, effects);
    }
}

TEST(Triggers, OthersThanThoseItNamesDoNotCount) {
    scene::SceneDescription scene = with_trigger(1);
    scene.entities[1].name = "blue_box";
    test::Running run(scene);
    EffectRuntime effects(*run, {});
    run.step(180, effects);
    EXPECT_EQ(line_of(effects, "triggers").calls, 0U);
}

}  // namespace
}  // namespace plumbline::effects
