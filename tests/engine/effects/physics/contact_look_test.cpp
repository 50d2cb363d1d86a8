// What contacts do to looks.
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

TEST(ContactAppearance, LooksAreThoseOfBeforeWhenTheyComeBack) {
    scene::SceneDescription scene = touchy();
    scene.materials["blue"].name = "blue";
    scene.entities[2].material = "blue";
    test::Running run(scene);
    EffectRuntime effects(*run, {.frame = true});
    run.step(60 * 3, effects);
    EXPECT_EQ(worn(run, "b"), "yellow");
    run->physics.set_pose(run.body("b"), {.position = {9, 40, 0}});
    run.step(3, effects);
    EXPECT_EQ(worn(run, "b"), "blue") << "its own";
    EXPECT_EQ(worn(run, "a"), "yellow");
}

}  // namespace
}  // namespace plumbline::effects
