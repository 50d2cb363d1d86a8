// What of an entity is seen.
#include "engine/physics/query.h"
#include "tests/support/scene_in_code.h"

namespace plumbline::scene {
namespace {

TEST(EntityVisuals, LampsHaveADarkLook) {
    EntityDescription lamp = test::cube("lamp", {0, 0, 0});
    lamp.material = "glow";
    lamp.light = LightDescription{.on = LampOn::Dark};
    EntityDescription always = lamp;
    always.name = "always";
    always.light->on = LampOn::Always;
    SceneDescription scene = test::scene_of({lamp, always});
    scene.materials["glow"] = {.name = "glow", .emissive = Vec3f{3.0F}, .roughness = 0.2F};
    test::Running run(scene);
    EXPECT_TRUE(run->registry.has<LampAppearance>(run->find("always")))
        << "a hand may switch it off";
    ASSERT_TRUE(run->registry.has<LampAppearance>(run->find("lamp")));
    const auto& look = run->registry.get<LampAppearance>(run->find("lamp"));
    const auto& visual = run->registry.get<Visual>(run->find("lamp"));
    ASSERT_EQ(look.off.size(), 1U);
    EXPECT_EQ(run->library().material(visual.materials[0]).emissive, Vec3f{3.0F});
    EXPECT_EQ(run->library().material(look.off[0]).emissive, Vec3f{0.0F});
    EXPECT_EQ(run->library().material(look.off[0]).roughness, 0.2F) << "all else as it was";
}

TEST(EntityVisuals, OnlyWhatStandsIsStatic) {
    EntityDescription picture = test::cube("picture", {0, 9, 0});
    picture.body.reset();
    test::Running run(test::scene_of({picture, test::ground(), test::cube("cube", {0, 5, 0})}));
    const auto is_static = [&](const char* name) {
        return run->registry.get<Visual>(run->find(name)).is_static;
    };
    EXPECT_TRUE(is_static("picture"));
    EXPECT_TRUE(is_static("ground"));
    EXPECT_FALSE(is_static("cube"));
}

TEST(EntityVisuals, TriggersTakeTheScaledPrimitive) {
    EntityDescription volume = test::cube("volume", {0, 0, 0});
    volume.body.reset();
    volume.scale = {2, 1, 1};
    volume.trigger = TriggerDescription{.times = 3, .spawn = "p"};
    EntityDescription bare = volume;
    bare.name = "bare";
    bare.visual = {};
    test::Running run(test::scene_of({volume, bare}));
    ASSERT_TRUE(run->registry.has<TriggerVolume>(run->find("volume")));
    const auto& trigger = run->registry.get<TriggerVolume>(run->find("volume"));
    EXPECT_EQ(trigger.times_left, 3);
    EXPECT_FALSE(run->registry.has<TriggerVolume>(run->find("bare")));
    // It reaches 1 m along x and half a metre along z.
    const auto meets = [&](const Vec3& at) {
        run->physics.create_body({.kind = physics::BodyKind::Static, .shape = trigger.shape});
        return cast_ray(run->physics, at + Vec3{0, 5, 0}, at - Vec3{0, 5, 0}).has_value();
    };
    EXPECT_TRUE(meets({0.9_r, 0, 0}));
    EXPECT_FALSE(meets({0, 0, 0.9_r}));
}

}  // namespace
}  // namespace plumbline::scene
