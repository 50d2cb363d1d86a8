// Lamps that ask for shadows call for them; where none does, nothing is there.
#include "tests/engine/effects/drawn.h"
#include "tests/support/near.h"

namespace plumbline::effects {
namespace {

using test::Running;

scene::EntityDescription lamp(bool casts_shadow) {
    scene::EntityDescription entity;
    entity.name = "lamp";
    entity.world_from_body.position = {0, 3, 0};
    entity.world_from_body.orientation = glm::angleAxis(glm::half_pi<Real>(), Vec3{0, 0, 1});
    entity.light = scene::LightDescription{.offset_m = {1, 0, 0}, .shadow = casts_shadow};
    entity.location = in_file("test.toml", 7);
    return entity;
}

TEST(LightShadows, NoneWhereNoLampAsks) {
    Running run(test::scene_of({lamp(false)}));
    EffectRuntime effects(*run, kImage);
    const render::RenderFrame frame = draw(run, effects);
    EXPECT_FALSE(frame.light_shadows);
    ASSERT_EQ(frame.lights.size(), 1U);
    EXPECT_FALSE(frame.lights[0].casts_shadow);
    const LedgerLine line = line_of(effects, "light_shadows");
    EXPECT_EQ(line.constructions, 0U);
    EXPECT_EQ(line.calls, 0U);
    EXPECT_EQ(line.bytes_cpu, 0U);
}

TEST(LightShadows, ALampThatAsksCallsForThemUntilTheyAreSwitchedOff) {
    Running run(test::scene_of({lamp(false), lamp(true)}));
    EffectRuntime effects(*run, kImage);
    const render::RenderFrame frame = draw(run, effects);
    EXPECT_TRUE(frame.light_shadows);
    ASSERT_EQ(frame.lights.size(), 2U);
    EXPECT_FALSE(frame.lights[0].casts_shadow);
    EXPECT_TRUE(frame.lights[1].casts_shadow);
    // Off the origin by what the scene says, turned with the entity.
    EXPECT_TRUE(test::near(frame.lights[1].position_world, Vec3f{0.0F, 4.0F, 0.0F}, 1e-5));
    const LedgerLine line = line_of(effects, "light_shadows");
    EXPECT_EQ(line.called_for_by, Callers{"entity lamp (test.toml:7)"});
    EXPECT_EQ(line.calls, 1U);

    run->switches.turn("light_shadows", false);
    EXPECT_FALSE(draw(run, effects).light_shadows);
    EXPECT_FALSE(line_of(effects, "light_shadows").exists);
}

}  // namespace
}  // namespace plumbline::effects
