// Force fields as effects: there only while called for, and named.
#include "tests/engine/effects/fields/in_fields.h"

namespace plumbline::effects {
namespace {

using scene::SceneDescription;

TEST(FieldEffects, AreAllZeroWhereNothingCallsForThem) {
    test::Running run(test::scene_of({test::ground(), kilogram("ball", {0, 1, 0})}));
    EffectRuntime effects(*run, {});
    run.step(60, effects);
    for (const char* name : {"drag", "buoyancy", "magnets", "conveyor", "explosion"}) {
        const LedgerLine line = line_of(effects, name);
        EXPECT_FALSE(line.exists) << name;
        EXPECT_EQ(line.constructions, 0U) << name;
        EXPECT_EQ(line.calls, 0U) << name;
        EXPECT_EQ(line.cpu_ms, 0.0) << name;
        EXPECT_EQ(line.bytes_cpu, 0U) << name;
    }
    EXPECT_TRUE(run->force_fields.all().empty());
}

TEST(FieldEffects, NameTheirCallers) {
    SceneDescription scene = pond_with({kilogram("ball", {0, 0, 0})});
    scene.entities.front().body->drag = scene::Drag{};
    scene.entities.front().body->magnet = scene::Magnet{{1, 0, 0}};
    scene.forces.explosions.push_back({.at_s = 5});
    test::Running run(scene);
    EffectRuntime effects(*run, {});
    run.step(10, effects);
    for (const char* name : {"drag", "buoyancy", "magnets", "explosion"}) {
        const LedgerLine line = line_of(effects, name);
        EXPECT_TRUE(line.exists) << name;
        EXPECT_EQ(line.called_for_by.size(), 1U) << name;
    }
    EXPECT_GE(line_of(effects, "drag").calls, 10U);
    EXPECT_EQ(line_of(effects, "explosion").calls, 0U) << "not yet";
}

}  // namespace
}  // namespace plumbline::effects
