#include "engine/effects/sound/room_probe.h"
#include "engine/effects/sound/sound_obstacles.h"
#include "engine/physics/character.h"
#include "tests/engine/effects/drawn.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::effects {
namespace {

using physics::BodyKind;
using test::box;
using test::Running;

constexpr ServedDomains kInside{.frame = false, .sound = true};
constexpr Real kThick_m = 0.2_r;

/// A closed room about the origin, its measures those of the air in it.
std::vector<scene::EntityDescription> room(const Vec3& size_m) {
    std::vector<scene::EntityDescription> walls;
    for (int axis = 0; axis < 3; ++axis) {
        for (const Real side : {Real{-1}, Real{1}}) {
            Vec3 position{0, 0, 0};
            Vec3 size = size_m + Vec3{2 * kThick_m, 2 * kThick_m, 2 * kThick_m};
            position[axis] = side * (size_m[axis] + kThick_m) / 2;
            size[axis] = kThick_m;
            walls.push_back(
                box("wall" + std::to_string(walls.size()), position, size, BodyKind::Static));
        }
    }
    return walls;
}

scene::SurfaceTable absorbing(float share) {
    scene::SurfaceTable surfaces = test::plain_surfaces();
    surfaces.surfaces[0].absorption = share;
    return surfaces;
}

scene::SceneDescription with_reverb(std::vector<scene::EntityDescription> entities) {
    scene::SceneDescription scene = test::scene_of(std::move(entities));
    scene.acoustics =
        scene::AcousticsDescription{.reverb = true, .location = in_file("house.toml", 3)};
    return scene;
}

// 0.161 V / (S a), wherever in the room one stands: 72 m3 and 108 m2 to 5 %, the time to 10 %.
TEST(RoomProbe, FindsVolumeSurfaceAndSabinesTime) {
    const Vec3 size{6, 3, 4};
    for (const float absorbs : {0.05F, 0.1F, 0.3F}) {
        Running run(with_reverb(room(size)), absorbing(absorbs));
        for (const Vec3& ear : {Vec3{0, 0, 0}, Vec3{1.5_r, -0.4_r, 1}, Vec3{-2.5_r, 1, -1.2_r}}) {
            RoomProbe probe;
            probe.cast(*run, ear, RoomProbe::kDirections);
            const RoomEstimate estimate = probe.estimate(ear);
            EXPECT_NEAR(estimate.volume_m3, 72.0F, 3.6F);
            EXPECT_NEAR(estimate.surface_m2, 108.0F, 5.4F);
            EXPECT_EQ(estimate.openness, 0.0F);
            const float expected_s = 0.161F * 72.0F / (108.0F * absorbs);
            EXPECT_NEAR(room_of(estimate).decay_s / expected_s, 1.0F, 0.1F);
        }
    }
}

// The eye is high in the person's body, which is no entity's.
TEST(RoomProbe, IsNotTheBodyOfWhoListens) {
    Running run(with_reverb(room({6, 3, 4})), absorbing(0.1F));
    const physics::Character person(run->physics, {.feet_position_m = {0.5_r, -1.5_r, 0.3_r}});
    const Vec3 eye{0.5_r, 0.12_r, 0.3_r};
    RoomProbe probe;
    probe.cast(*run, eye, RoomProbe::kDirections);
    const RoomEstimate estimate = probe.estimate(eye);
    EXPECT_NEAR(estimate.volume_m3, 72.0F, 3.6F);
    EXPECT_EQ(estimate.openness, 0.0F);
    // And what is heard through a wall has only that in its way.
    const auto obstacles = obstacles_between(*run, {6, -1.4_r, 0}, eye, {});
    ASSERT_EQ(obstacles.size(), 1U);
    EXPECT_NEAR(obstacles[0].thickness_m, 0.2 * std::hypot(5.5, 1.52, 0.3) / 5.5, 0.005);
}

TEST(RoomProbe, AnOpenSideLetsTheSoundOut) {
    std::vector<scene::EntityDescription> walls = room({6, 3, 4});
    Running closed(with_reverb(walls), absorbing(0.05F));
    walls.pop_back();  // a wall of 18 m2, of 108
    Running open(with_reverb(walls), absorbing(0.05F));
    RoomProbe in_closed;
    RoomProbe in_open;
    in_closed.cast(*closed, {0, 0, -1}, RoomProbe::kDirections);
    in_open.cast(*open, {0, 0, -1}, RoomProbe::kDirections);
    const RoomEstimate estimate = in_open.estimate({0, 0, -1});
    EXPECT_NEAR(estimate.openness, 0.1, 0.06);
    const audio::Room heard = room_of(estimate);
    EXPECT_LT(heard.decay_s, 0.5F * room_of(in_closed.estimate({0, 0, -1})).decay_s);
    EXPECT_GT(estimate.absorption_m2, 2 * in_closed.estimate({0, 0, -1}).absorption_m2);
}

TEST(RoomProbe, WhatIsSeenThroughADoorIsNotTheRoom) {
    std::vector<scene::EntityDescription> walls = room({6, 3, 4});
    walls.pop_back();
    walls.push_back(box("hill", {0, 0, 30}, {80, 80, 1}, BodyKind::Static));
    Running run(with_reverb(walls), absorbing(0.05F));
    RoomProbe probe;
    probe.cast(*run, {0, 0, -1}, RoomProbe::kDirections);
    const RoomEstimate estimate = probe.estimate({0, 0, -1});
    EXPECT_NEAR(estimate.openness, 0.1, 0.06);
    EXPECT_LT(estimate.volume_m3, 80.0F);
}

TEST(RoomProbe, ForgetsWhatWasMetElsewhere) {
    Running run(with_reverb(room({6, 3, 4})), absorbing(0.1F));
    RoomProbe probe;
    probe.cast(*run, {0, 0, 0}, RoomProbe::kDirections);
    EXPECT_EQ(probe.estimate({1, 0, 0}).openness, 0.0F);
    EXPECT_EQ(probe.estimate({30, 0, 0}).openness, 1.0F);
    EXPECT_EQ(room_of(probe.estimate({30, 0, 0})).gain, 0.0F);
}

TEST(RoomReverb, IsHeardInsideAndNotOutside) {
    std::vector<scene::EntityDescription> entities = room({6, 3, 4});
    entities.push_back(box("ground", {0, -2.2_r, 0}, {200, 1, 200}, BodyKind::Static));
    Running run(with_reverb(std::move(entities)), absorbing(0.1F));
    EffectRuntime effects(*run, kInside);
    EXPECT_EQ(line_of(effects, "room_reverb").called_for_by,
              Callers{"[sound] reverb (house.toml:3)"});
    const auto listen = [&](const Vec3& ear, int frames) {
        audio::Room heard;
        for (int i = 0; i < frames; ++i) {
            run.step(1, effects);
            heard = effects.sound(*run, listener_at(ear)).room;
        }
        return heard;
    };
    const audio::Room inside = listen({0, 0, 0}, 120);
    EXPECT_GT(inside.gain, 0.9F);
    EXPECT_NEAR(inside.decay_s, 1.073F, 0.2F);
    EXPECT_NEAR(inside.size_m, 4 * 72.0F / 108.0F, 0.3F);
    // Out through the wall: no step is heard, and in the end nothing.
    const audio::Room at_once = listen({0, 0, 20}, 1);
    EXPECT_GT(at_once.gain, 0.5F);
    EXPECT_EQ(listen({0, 0, 20}, 600).gain, 0.0F);
    const LedgerLine line = line_of(effects, "room_reverb");
    EXPECT_LT(line.calls, 140U) << "ten times a second, and not more";
}

}  // namespace
}  // namespace plumbline::effects
