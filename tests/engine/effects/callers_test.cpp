#include "engine/effects/callers.h"

#include "tests/engine/effects/drawn.h"

#include <string>

namespace plumbline::effects {
namespace {

using scene::EntityDescription;
using scene::SceneDescription;
using test::cube;
using test::Running;
using test::scene_of;

TEST(Callers, NamesTheFirstCallersAndCountsTheRest) {
    scene::SurfaceTable loud = test::plain_surfaces();
    loud.surfaces.push_back({.name = "wood", .impact_sounds = {"no/such.ogg"}});
    SceneDescription scene = scene_of({});
    scene.materials["wood"] = {.name = "wood", .surface = "wood"};
    EntityDescription crate = cube("crate", {});
    crate.material = "wood";
    scene.arrays.push_back({.name = "pile",
                            .prefab = crate,
                            .origin_m = {0, 5, 0},
                            .count = {10, 1, 1},
                            .spacing_m = {2, 2, 2}});
    Running run(scene, loud);
    EffectRuntime effects(*run, {.frame = true, .sound = true});
    const Callers callers = line_of(effects, "impact_sounds").called_for_by;
    ASSERT_EQ(callers.size(), 9U);
    EXPECT_EQ(callers.front(), "entity pile.0.0.0 (test.toml:10)");
    EXPECT_EQ(callers.back(), "and 2 more");
}

TEST(Callers, SettingsStandWhereAFileHasThem) {
    EXPECT_EQ(setting("[fog]", in_file("scenes/garden.toml", 12)), "[fog] (garden.toml:12)");
    EXPECT_EQ(setting("[fog]", {}), "[fog]");
}

TEST(Callers, EightAreNamedAndNoneIsNone) {
    SceneDescription scene = scene_of({});
    for (int i = 0; i < 8; ++i)
        scene.entities.push_back(cube("c" + std::to_string(i), {3 * static_cast<Real>(i), 0, 0}));
    scene.materials["glass"] = {.name = "glass", .ior = 1.5F};
    for (EntityDescription& entity : scene.entities) entity.material = "glass";
    scene.entities[3].material.clear();
    Running run(scene);
    const auto refracts = [](const assets::MaterialData& material) { return material.ior > 1.0F; };
    const Callers wearers = wearers_of(*run, refracts);
    ASSERT_EQ(wearers.size(), 7U);
    EXPECT_EQ(wearers[3], "entity c4 (test.toml:10)") << "c3 wears something else";
    EntityCallers all(*run);
    for (const scene::MovingBody& body : run->moving_bodies()) all.add(body.entity);
    EXPECT_EQ(all.take().size(), 8U) << "nobody is left to count";
    EXPECT_TRUE(EntityCallers(*run).take().empty());
}

}  // namespace
}  // namespace plumbline::effects
