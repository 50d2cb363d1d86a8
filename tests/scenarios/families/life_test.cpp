// Sleep, waking, uneven steps and repeatability: H86 to H89.
#include "engine/physics/totals.h"
#include "tests/scenarios/families/case_run.h"

#include <functional>

namespace plumbline::study {
namespace {

// --- H86: what is slow still moves

TEST(Life, H86ASlowSlideIsNotFrozen) {
    ScenarioWorld world(balanced());
    world.floor(0);
    const BodyId box = world.box(
        {0, 0.5, 0}, {1, 1, 1}, {.friction = 0, .velocity_mps = {0.1, 0, 0}, .can_sleep = true});
    world.run(20);
    expect_at_most("H86 slide of .1 m/s in 20 s", std::abs(world.at(box).x / 2 - 1), 0.01);
}

TEST(Life, H86ASlowRollIsNotFrozen) {
    ScenarioWorld world(balanced());
    world.floor();
    const BodyId ball =
        world.sphere({0, 0.5, 0},
                     0.5,
                     {.velocity_mps = {0.05, 0, 0}, .spin_radps = {0, 0, -0.1}, .can_sleep = true});
    world.run(20);
    expect_at_most("H86 roll of .05 m/s in 20 s", std::abs(world.at(ball).x - 1), 0.02);
}

TEST(Life, H86ASlowSpinIsNotFrozen) {
    ScenarioWorld world(balanced());
    world.floor(0);
    const BodyId top = world.sphere(
        {0, 0.5, 0}, 0.5, {.friction = 0, .spin_radps = {0, 0.5, 0}, .can_sleep = true});
    world.run(20);
    expect_at_most("H86 spin of .5 rad/s after 20 s", std::abs(world.spin(top).y / 0.5 - 1), 0.01);
}

TEST(Life, H86APendulumNearItsTopFalls) {
    for (const double angle : {1e-2, 1e-3}) {
        ScenarioWorld world(balanced());
        const Vec3d up{std::sin(angle), std::cos(angle), 0};
        const BodyId rod =
            world.box(up * 0.5,
                      {0.1, 1, 0.1},
                      {.turn = glm::angleAxis(-angle, Vec3d{0, 0, 1}), .can_sleep = true});
        world.join({.kind = JointKind::Hinge, .a = rod, .axis_world = {0, 0, 1}});
        double lowest = 1;
        for (int i = 0; i < 600; ++i) {
            world.physics.step();
            lowest = std::min(lowest, world.at(rod).y);
        }
        EXPECT_LT(lowest, 0) << "it stands on its head, " << angle << " rad off";
    }
}

// --- H87: what sleeps wakes when it must

/// Three boxes asleep on each other on a static block.
struct Sleepers {
    ScenarioWorld world{balanced()};
    BodyId block;
    Sleepers() {
        world.floor();
        block = world.fixed_box({0, 0.5, 0}, {2, 1, 2});
        for (int i = 0; i < 3; ++i) world.box({0, 1.5 + i, 0}, {1, 1, 1}, {.can_sleep = true});
        for (int i = 0; i < 600 && awake_count(world.physics) > 0; ++i) world.physics.step();
        EXPECT_EQ(awake_count(world.physics), 0U) << "asleep within 10 s";
    }
    bool awake(std::size_t i) const { return world.physics.state(world.movers[i]).awake; }
};

TEST(Life, H87SleepersWakeWithinAFrame) {
    const std::vector<std::pair<std::string, std::function<void(Sleepers&)>>> causes{
        {"support removed", [](Sleepers& at) { at.world.physics.destroy_body(at.block); }},
        {"lowest removed",
         [](Sleepers& at) {
             at.world.physics.destroy_body(at.world.movers[0]);
             at.world.movers.erase(at.world.movers.begin());
         }},
        {"force on the top",
         [](Sleepers& at) {
             at.world.physics.apply_force(at.world.movers[2], {200, 0, 0});
         }},
        {"impulse",
         [](Sleepers& at) {
             at.world.physics.apply_impulse(at.world.movers[1], {1, 0, 0});
         }},
        {"gravity turned off",
         [](Sleepers& at) {
             WorldDef def = at.world.physics.def();
             def.gravity_mps2 = {0, 0, 0};
             at.world.physics.reconfigure(def);
         }},
        {"support moved",
         [](Sleepers& at) {
             at.world.physics.set_pose(at.block, {vec(10, 0.5, 0), kNoRotation});
         }},
        {"joint", [](Sleepers& at) {
             at.world.join({.kind = JointKind::Fixed,
                            .a = at.world.movers[0],
                            .b = at.world.movers[2],
                            .anchor_a_world = vec(0, 2.5, 0),
                            .anchor_b_world = vec(0, 2.5, 0)});
         }}};
    for (const auto& [name, cause] : causes) {
        Sleepers at;
        cause(at);
        at.world.physics.step();
        for (std::size_t i = 0; i < at.world.movers.size(); ++i)
            EXPECT_TRUE(at.awake(i)) << name << ", box " << i;
    }
}

TEST(Life, H87WhatLostItsSupportFallsAtOnce) {
    Sleepers at;
    at.world.physics.destroy_body(at.block);
    at.world.run(0.25);
    for (std::size_t i = 0; i < 3; ++i) {
        const double expected = 1.5 + static_cast<double>(i) - 0.5 * kG_mps2 * 0.0625;
        EXPECT_NEAR(at.world.at(at.world.movers[i]).y, expected, 0.01) << "box " << i;
    }
}

TEST(Life, H87AWokenPileDoesNotJump) {
    Sleepers at;
    for (const BodyId id : at.world.movers) at.world.physics.wake(id);
    double top = 0;
    for (int i = 0; i < 60; ++i) {
        at.world.physics.step();
        top = std::max(top, top_speed_mps(at.world));
    }
    expect_at_most("H87 woken pile, speed m/s", top, 1e-3);
}

// --- H88: uneven steps

/// Steps of 1/20 to 1/240 s, the same ones every time.
void run_unevenly(ScenarioWorld& world, double seconds) {
    std::uint32_t seed = 12345;
    WorldDef def = world.physics.def();
    double left_s = seconds;
    while (left_s > 1e-9) {
        seed = seed * 1664525U + 1013904223U;
        const double share = static_cast<double>(seed >> 8U) / (1U << 24U);
        def.step_s = std::min(left_s, 1.0 / 240 + share * (1.0 / 20 - 1.0 / 240));
        world.physics.reconfigure(def);
        world.physics.step();
        left_s -= def.step_s;
    }
}

TEST(Life, H88UnevenStepsEndWhereEvenOnesDo) {
    {
        ScenarioWorld world(balanced());
        world.floor(0.3);
        const BodyId box =
            world.box({0, 0.25, 0}, {1, 0.5, 1}, {.friction = 0.3, .velocity_mps = {5, 0, 0}});
        run_unevenly(world, 2.5);
        expect_at_most("H88 sliding stop", std::abs(world.at(box).x / 4.2473667 - 1), 0.1);
    }
    {
        ScenarioWorld world(balanced());
        world.floor(0, 1);
        world.sphere({0, 5.5, 0}, 0.5, {.friction = 0, .restitution = 1});
        const double start_J = world.energy_J();
        run_unevenly(world, 20);
        expect_at_most("H88 bounce e=1, energy", std::abs(world.energy_J() / start_J - 1), 0.1);
    }
    {
        ScenarioWorld world(balanced());
        world.floor();
        for (int i = 0; i < 5; ++i) world.box({0, 0.5 + i, 0}, {1, 1, 1});
        run_unevenly(world, 10);
        expect_at_most(
            "H88 tower of 5, drift m", drift_m(world.at(world.movers[4]), {0, 0, 0}), 0.01);
        expect_at_most("H88 tower of 5, sag m", std::abs(world.at(world.movers[4]).y - 4.5), 0.02);
        expect_at_most("H88 tower of 5, speed m/s", top_speed_mps(world), 0.05);
    }
}

TEST(Life, H88TinyStepsDoNoHarm) {
    WorldDef def = world_def(balanced());
    def.step_s = 1e-4;
    ScenarioWorld world(def);
    world.floor();
    for (int i = 0; i < 3; ++i) world.box({0, 0.5 + i, 0}, {1, 1, 1});
    world.run(0.5);
    EXPECT_TRUE(all_finite(world));
    expect_at_most(
        "H88 steps of .1 ms, drift m", drift_m(world.at(world.movers[2]), {0, 0, 0}), 1e-3);
    expect_at_most("H88 steps of .1 ms, speed m/s", top_speed_mps(world), 5e-3);
}

// --- H89: the same again

/// Boxes and balls above each other, or, with `states`, as another heap stands now.
void build_heap(ScenarioWorld& world,
                bool backwards,
                const std::vector<BodyState>& states = {},
                double aside_m = 0) {
    world.floor();
    std::vector<Vec3d> places;
    for (int i = 0; i < 40; ++i)
        places.push_back({0.3 * (i % 5) - 0.6 + aside_m * (i % 7), 1 + 0.7 * i, 0.37 * (i % 3)});
    if (backwards) std::reverse(places.begin(), places.end());
    for (std::size_t i = 0; i < places.size(); ++i) {
        BodyDef def{.kind = BodyKind::Dynamic, .mass_kg = 1, .can_sleep = false};
        const bool ball = std::abs(places[i].x) < 0.1;
        const auto shape = ball
                               ? physics::ShapeDef(physics::SphereShape{.radius_m = 0.4_r})
                               : physics::ShapeDef(physics::BoxShape{.size_m = vec(0.8, 0.6, 0.7)});
        def.world_from_body.position = Vec3(places[i]);
        if (!states.empty()) {
            def.world_from_body = states[i].world_from_body;
            def.velocity_mps = states[i].velocity_mps;
            def.angular_velocity_radps = states[i].angular_velocity_radps;
        }
        world.add(shape, def);
    }
}

TEST(Life, H89RunsAreTheSameBitForBit) {
    std::vector<std::uint64_t> hashes;
    for (int i = 0; i < 5; ++i) {
        ScenarioWorld world(balanced());
        build_heap(world, false);
        world.run(5);
        hashes.push_back(physics::state_hash(world.physics, world.movers));
    }
    EXPECT_EQ(std::count(hashes.begin(), hashes.end(), hashes[0]), 5);
}

TEST(Life, H89ARebuiltWorldGoesOnAsAFreshOneWould) {
    ScenarioWorld world(balanced());
    build_heap(world, false);
    world.run(2);
    std::vector<BodyState> states;
    for (const BodyId id : world.movers) states.push_back(world.physics.state(id));
    // Through another solver: with its own it goes on with what its contacts carried.
    WorldDef other = world_def(balanced());
    other.solver = physics::Solver::BulletSi;
    ScenarioWorld fresh(other);
    build_heap(fresh, false, states);
    fresh.physics.reconfigure(world_def(balanced()));
    world.physics.reconfigure(other);
    world.physics.reconfigure(world_def(balanced()));
    world.run(3);
    fresh.run(3);
    expect_at_most("H89 a rebuilt world differs from a fresh one",
                   physics::state_hash(world.physics, world.movers) ==
                           physics::state_hash(fresh.physics, fresh.movers)
                       ? 0
                       : 1,
                   0);
}

/// The mean height of a body, of a statistic of heaps: where one body lies is chaos.
double heap_height_m(bool backwards) {
    constexpr int kHeaps = 12;
    double sum = 0;
    for (int k = 0; k < kHeaps; ++k) {
        ScenarioWorld world(balanced());
        build_heap(world, backwards, {}, 1e-3 * k);
        world.run(8);
        for (const BodyId id : world.movers)
            sum += world.at(id).y / static_cast<double>(world.movers.size());
    }
    return sum / kHeaps;
}

TEST(Life, H89OrderOfMakingChangesNothingThatCounts) {
    expect_at_most("H89 heaps made backwards, mean height",
                   std::abs(heap_height_m(true) / heap_height_m(false) - 1),
                   0.1);
}

}  // namespace
}  // namespace plumbline::study
