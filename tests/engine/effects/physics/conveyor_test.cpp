// Belts stop when they are called off.
#include "tests/engine/effects/fields/in_fields.h"

namespace plumbline::effects {
namespace {

using scene::SceneDescription;

TEST(Conveyor, StopsWhenItIsCalledOff) {
    SceneDescription scene =
        test::scene_of({test::ground(), test::box("box", {0, 0.5_r, 0}, {1, 1, 1})});
    scene.entities.front().body->surface_velocity_mps = {2, 0, 0};
    test::Running run(scene);
    EffectRuntime effects(*run, {});
    run.step(90, effects);
    EXPECT_NEAR(static_cast<double>(run.state("box").velocity_mps.x), 2, 1e-3);
    EXPECT_GE(line_of(effects, "conveyor").calls, 90U);
    run->switches.turn("conveyor", false);
    run.step(90, effects);
    EXPECT_NEAR(static_cast<double>(run.state("box").velocity_mps.x), 0, 1e-3);
    EXPECT_FALSE(line_of(effects, "conveyor").exists);
}

}  // namespace
}  // namespace plumbline::effects
