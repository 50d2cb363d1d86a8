#include "engine/effects/sound/acoustics.h"
#include "engine/effects/sound/sound_obstacles.h"
#include "tests/engine/effects/drawn.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace plumbline::effects {
namespace {

using physics::BodyKind;
using test::box;
using test::Running;
using test::scene_of;

constexpr ServedDomains kWithPaths{.frame = false, .sound = true};

/// Between x = -0.1 and 0.1.
scene::EntityDescription wall(const std::string& name, const Vec3& size_m, Real x_m = 0) {
    return box(name, {x_m, 0, 0}, size_m, BodyKind::Static);
}

scene::EntityDescription sounding(const std::string& name, const Vec3& position_m) {
    scene::EntityDescription entity;
    entity.name = name;
    entity.world_from_body.position = position_m;
    entity.sound = scene::SoundDescription{
        .file = std::filesystem::path(PL_SOURCE_DIR) / "assets/sounds/loop_leaves.ogg",
        .radius_m = 500.0F};
    return entity;
}

scene::SceneDescription with_paths(std::vector<scene::EntityDescription> entities) {
    scene::SceneDescription scene = scene_of(std::move(entities));
    scene.acoustics =
        scene::AcousticsDescription{.paths = true, .location = in_file("garden.toml", 7)};
    return scene;
}

TEST(SoundObstacles, AreAsThickAsTheWayThroughThem) {
    Running run(scene_of({wall("near", {0.2_r, 9, 9}), wall("far", {0.5_r, 9, 9}, 3)}));
    const auto straight = obstacles_between(*run, {-2, 0, 0}, {6, 0, 0}, {});
    ASSERT_EQ(straight.size(), 2U);
    EXPECT_NEAR(straight[0].thickness_m, 0.2, 2e-3);
    EXPECT_NEAR(straight[0].at_m, 2.0, 2e-3);
    EXPECT_NEAR(straight[1].thickness_m, 0.5, 2e-3);
    // At 60 degrees to the wall's normal the way through it is twice as long.
    const Real across = 4 * std::tan(radians_from_degrees(60.0_r));
    const auto slanting = obstacles_between(*run, {-2, 0, -across / 2}, {2, 0, across / 2}, {});
    ASSERT_EQ(slanting.size(), 1U);
    EXPECT_NEAR(slanting[0].thickness_m, 0.4, 5e-3);
    EXPECT_TRUE(obstacles_between(*run, {-2, 6, 0}, {6, 6, 0}, {}).empty());
}

TEST(SoundObstacles, OfManyPiecesCountTogetherAndMakersDoNot) {
    scene::EntityDescription house = box("house", {0, 0, 0}, {1, 1, 1}, BodyKind::Static);
    physics::CompoundShape walls;
    for (const Real x : {Real{-2}, Real{2}})
        walls.children.push_back({.shape = physics::BoxShape{.size_m = {0.3_r, 5, 5}},
                                  .body_from_child = {.position = {x, 0, 0}}});
    house.body->shape = physics::ShapeDef{walls};
    Running run(scene_of({house}));
    const auto through = obstacles_between(*run, {-5, 0, 0}, {5, 0, 0}, {});
    ASSERT_EQ(through.size(), 1U);
    EXPECT_NEAR(through[0].thickness_m, 0.6, 5e-3);
    const auto from_inside = obstacles_between(*run, {0, 0, 0}, {5, 0, 0}, {});
    ASSERT_EQ(from_inside.size(), 1U);
    EXPECT_NEAR(from_inside[0].thickness_m, 0.3, 3e-3);
    const std::uint64_t mark = scene::mark_of(run->find("house"));
    EXPECT_TRUE(obstacles_between(*run, {-5, 0, 0}, {5, 0, 0}, {mark, 0}).empty());
    // What strikes the outside of a wall is heard through the wall.
    const auto knock = obstacles_between(*run, {-2.15_r, 0, 0}, {0, 0, 0}, {});
    ASSERT_EQ(knock.size(), 1U);
    EXPECT_NEAR(knock[0].thickness_m, 0.3, 0.04);
}

float detour_m(float half_way_m, float clear_m) {
    return 2 * std::hypot(half_way_m, clear_m) - 2 * half_way_m;
}

// 0.1 m of 10 kg/m3, and its edges far away: 1 kg/m2.
TEST(SoundPath, ThroughALightWallIsByTheMassLaw) {
    scene::SurfaceTable surfaces = test::plain_surfaces();
    surfaces.surfaces[0].density_kgpm3 = 10;
    Running run(scene_of({wall("wall", {0.1_r, 400, 400})}), surfaces);
    const SoundPath path = path_between(*run, {-3, 0, 0}, {3, 0, 0}, {});
    const auto round = [](float frequency_hz) {
        return 3 * share_round_edge(detour_m(3, 200), frequency_hz);
    };
    EXPECT_NEAR(path.low, share_through_wall(1, 250) + round(250), 0.01);
    EXPECT_NEAR(path.high, share_through_wall(1, 5'000) + round(5'000), 0.002);
}

TEST(SoundPath, ThroughAHeavyOneOnlyByGapsAndEdges) {
    scene::SurfaceTable surfaces = test::plain_surfaces();
    surfaces.surfaces[0].density_kgpm3 = 2'000;
    Running wide(scene_of({wall("wall", {0.3_r, 400, 400})}), surfaces);
    const SoundPath through = path_between(*wide, {-3, 0, 0}, {3, 0, 0}, {});
    EXPECT_NEAR(through.low, 0.1F + 3 * share_round_edge(detour_m(3, 200), 250), 0.002);
    EXPECT_NEAR(through.high, 0.01F + 3 * share_round_edge(detour_m(3, 200), 5'000), 0.002);
    // A wall of a man's height: over it and round both its ends.
    Running garden(scene_of({wall("wall", {0.3_r, 2, 4})}), surfaces);
    const SoundPath round = path_between(*garden, {-3, 0, 0}, {3, 0, 0}, {});
    const auto expected = [](float gaps, float frequency_hz) {
        return gaps + share_round_edge(detour_m(3, 1), frequency_hz) +
               2 * share_round_edge(detour_m(3, 2), frequency_hz);
    };
    EXPECT_NEAR(round.low, expected(0.1F, 250), 0.01);
    EXPECT_NEAR(round.high, expected(0.01F, 5'000), 0.01);
    EXPECT_LT(round.high, 0.4F * round.low);
    EXPECT_FLOAT_EQ(path_between(*garden, {-3, 3, 0}, {3, 3, 0}, {}).high, 1.0F);
}

TEST(SoundPath, APostIsNoWall) {
    Running run(scene_of({wall("post", {0.06_r, 4, 0.06_r})}));
    const SoundPath path = path_between(*run, {-3, 0, 0}, {3, 0, 0}, {});
    EXPECT_GT(path.low, 0.99F);
    EXPECT_GT(path.high, 0.9F);
}

TEST(SoundPath, NumbersThatAreNoneChangeNothing) {
    Running run(scene_of({wall("wall", {0.2_r, 9, 9})}));
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    EXPECT_EQ(path_between(*run, {nan, 0, 0}, {3, 0, 0}, {}).low, 1.0F);
    EXPECT_EQ(path_between(*run, {1, 0, 0}, {1, 0, 0}, {}).low, 1.0F);
}

TEST(SoundPaths, DullWhatIsBehindAWall) {
    Running run(with_paths({wall("wall", {0.3_r, 40, 40}), sounding("stream", {-3, 0, 0})}));
    EffectRuntime effects(*run, kWithPaths);
    EXPECT_EQ(line_of(effects, "sound_paths").called_for_by,
              Callers{"[sound] paths (garden.toml:7)"});
    const audio::LoopCue behind = effects.sound(*run, listener_at({3, 0, 0})).loops.at(0);
    EXPECT_LT(behind.gain, 0.2F);
    EXPECT_LT(behind.low_pass, 0.5F);
    // Round the corner it opens within a second.
    for (int i = 0; i < 60; ++i) {
        run.step(1, effects);
        effects.sound(*run, listener_at({-3, 0, 5}));
    }
    const audio::LoopCue open = effects.sound(*run, listener_at({-3, 0, 5})).loops.at(0);
    EXPECT_GT(open.gain, 0.99F);
    EXPECT_GT(open.low_pass, 0.99F);
}

TEST(SoundPaths, SoundTravelsAtItsSpeed) {
    scene::EntityDescription bell = sounding("bell", {-34.3_r, 0, 0});
    bell.sound->loop = false;
    Running run(with_paths({bell}));
    EffectRuntime effects(*run, kWithPaths);
    const SoundFrame heard = effects.sound(*run, listener_at({0, 0, 0}));
    ASSERT_EQ(heard.cues.size(), 1U);
    EXPECT_NEAR(heard.cues[0].delay_s, 0.1, 1e-5);
    EXPECT_EQ(heard.cues[0].gain, 1.0F);
}

TEST(SoundPaths, AreNotThereWhereNobodyCallsForThem) {
    scene::SceneDescription scene =
        scene_of({wall("wall", {0.3_r, 40, 40}), sounding("stream", {-3, 0, 0})});
    Running run(scene);
    EffectRuntime effects(*run, kWithPaths);
    const SoundFrame heard = effects.sound(*run, listener_at({3, 0, 0}));
    EXPECT_EQ(heard.loops.at(0).gain, 1.0F);
    for (const char* name : {"sound_paths", "room_reverb", "creak_sounds", "wind_sound"}) {
        const LedgerLine line = line_of(effects, name);
        EXPECT_EQ(line.constructions + line.calls + line.bytes_cpu, 0U) << name;
        EXPECT_EQ(line.cpu_ms, 0.0) << name;
    }
    run->switches.turn("sound_paths", true);
    scene.acoustics = scene::AcousticsDescription{};
    Running asked(scene);
    EffectRuntime some(*asked, kWithPaths);
    EXPECT_FALSE(line_of(some, "sound_paths").exists);
    asked->switches.turn("sound_paths", true);
    some.refresh(*asked);
    EXPECT_TRUE(line_of(some, "sound_paths").exists);
}

TEST(SoundPaths, OfFiveHundredSourcesFewAreTracedAFrame) {
    std::vector<scene::EntityDescription> entities{wall("wall", {0.3_r, 40, 40})};
    for (int i = 0; i < 500; ++i)
        entities.push_back(sounding("source" + std::to_string(i), {-1 - Real(i) / 20, 0, 0}));
    Running run(with_paths(std::move(entities)));
    EffectRuntime effects(*run, kWithPaths);
    for (int i = 0; i < 100; ++i) {
        run.step(1, effects);
        EXPECT_EQ(effects.sound(*run, listener_at({3, 0, 0})).loops.size(), 500U);
    }
    EXPECT_LE(line_of(effects, "sound_paths").calls, 300U);
}

}  // namespace
}  // namespace plumbline::effects
