// Ropes stand still while they are called off, and cost nothing then.
#include "tests/engine/effects/fields/in_fields.h"

namespace plumbline::effects {
namespace {

using scene::SceneDescription;

SceneDescription swinging() {
    SceneDescription scene = test::scene_of({});
    scene::RopeDescription rope;
    rope.name = "line";
    rope.a = "world";
    rope.anchor_a_m = {0, 5, 0};
    rope.anchor_b_m = {2, 5, 0};
    rope.length_m = 2;
    scene.forces.ropes = {rope};
    return scene;
}

TEST(Rope, StandsStillWhileItIsCalledOff) {
    test::Running run(swinging());
    EffectRuntime effects(*run, {});
    const auto end = [&run] { return run->points_of(run->ropes().front()).back(); };
    run.step(10, effects);
    EXPECT_EQ(line_of(effects, "rope").calls, 200U);
    run->switches.turn("rope", false);
    run.step(1, effects);
    const Vec3d stopped = end();
    run.step(60, effects);
    EXPECT_EQ(end(), stopped);
    EXPECT_FALSE(line_of(effects, "rope").exists);
    run->switches.turn("rope", true);
    run.step(20, effects);
    EXPECT_LT(end().y, stopped.y - 0.1);
}

TEST(Rope, WhatAPlayerFrozeStaysSo) {
    test::Running run(swinging());
    EffectRuntime effects(*run, {});
    const physics::BodyId piece = run->ropes().front().pieces[3];
    run->physics.set_frozen(piece, true);
    for (const bool on : {false, true}) {
        run->switches.turn("rope", on);
        run.step(2, effects);
    }
    EXPECT_TRUE(run->physics.state(piece).frozen);
    EXPECT_FALSE(run->physics.state(run->ropes().front().pieces[4]).frozen);
}

}  // namespace
}  // namespace plumbline::effects
