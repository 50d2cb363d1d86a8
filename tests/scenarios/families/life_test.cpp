// Sleep, waking, uneven steps and repeatability: H86 to H89.
#include "tests/scenarios/families/rig.h"

#include <functional>

namespace plumbline::physics {
namespace {

// --- H86: what is slow still moves

TEST(Life, H86ASlowSlideIsNotFrozen) {
    Rig rig(balanced());
    rig.floor(0);
    const BodyId box = rig.box(
        {0, 0.5, 0}, {1, 1, 1}, {.friction = 0, .velocity_mps = {0.1, 0, 0}, .can_sleep = true});
    rig.run(20);
    expect_at_most("H86 slide of .1 m/s in 20 s", std::abs(rig.at(box).x / 2 - 1), 0.01);
}

TEST(Life, H86ASlowRollIsNotFrozen) {
    Rig rig(balanced());
    rig.floor();
    const BodyId ball =
        rig.ball({0, 0.5, 0},
                 0.5,
                 {.velocity_mps = {0.05, 0, 0}, .spin_radps = {0, 0, -0.1}, .can_sleep = true});
    rig.run(20);
    expect_at_most("H86 roll of .05 m/s in 20 s", std::abs(rig.at(ball).x - 1), 0.02);
}

TEST(Life, H86ASlowSpinIsNotFrozen) {
    Rig rig(balanced());
    rig.floor(0);
    const BodyId top =
        rig.ball({0, 0.5, 0}, 0.5, {.friction = 0, .spin_radps = {0, 0.5, 0}, .can_sleep = true});
    rig.run(20);
    expect_at_most("H86 spin of .5 rad/s after 20 s", std::abs(rig.spin(top).y / 0.5 - 1), 0.01);
}

TEST(Life, H86APendulumNearItsTopFalls) {
    for (const double angle : {1e-2, 1e-3}) {
        Rig rig(balanced());
        const Vec3d up{std::sin(angle), std::cos(angle), 0};
        const BodyId rod =
            rig.box(up * 0.5,
                    {0.1, 1, 0.1},
                    {.turn = glm::angleAxis(-angle, Vec3d{0, 0, 1}), .can_sleep = true});
        rig.join({.kind = JointKind::Hinge, .a = rod, .axis_world = {0, 0, 1}});
        double lowest = 1;
        for (int i = 0; i < 600; ++i) {
            rig.world.step();
            lowest = std::min(lowest, rig.at(rod).y);
        }
        EXPECT_LT(lowest, 0) << "it stands on its head, " << angle << " rad off";
    }
}

// --- H87: what sleeps wakes when it must

/// Three boxes asleep on each other on a static block.
struct Sleepers {
    Rig rig{balanced()};
    BodyId block;
    Sleepers() {
        rig.floor();
        block = rig.fixed_box({0, 0.5, 0}, {2, 1, 2});
        for (int i = 0; i < 3; ++i) rig.box({0, 1.5 + i, 0}, {1, 1, 1}, {.can_sleep = true});
        for (int i = 0; i < 600 && rig.world.awake_count() > 0; ++i) rig.world.step();
        EXPECT_EQ(rig.world.awake_count(), 0U) << "asleep within 10 s";
    }
    bool awake(std::size_t i) const { return rig.world.state(rig.movers[i]).awake; }
};

TEST(Life, H87SleepersWakeWithinAFrame) {
    const std::vector<std::pair<std::string, std::function<void(Sleepers&)>>> causes{
        {"support removed", [](Sleepers& at) { at.rig.world.destroy_body(at.block); }},
        {"lowest removed",
         [](Sleepers& at) {
             at.rig.world.destroy_body(at.rig.movers[0]);
             at.rig.movers.erase(at.rig.movers.begin());
         }},
        {"force on the top",
         [](Sleepers& at) {
             at.rig.world.apply_force(at.rig.movers[2], {200, 0, 0});
         }},
        {"impulse",
         [](Sleepers& at) {
             at.rig.world.apply_impulse(at.rig.movers[1], {1, 0, 0});
         }},
        {"gravity turned off",
         [](Sleepers& at) { at.rig.world.reconfigure(afloat(at.rig.world.def())); }},
        {"friction", [](Sleepers& at) { at.rig.world.set_friction(at.rig.movers[0], 0.1_r); }},
        {"support moved",
         [](Sleepers& at) {
             at.rig.world.set_pose(at.block, {vec(10, 0.5, 0), kNoRotation});
         }},
        {"joint", [](Sleepers& at) {
             at.rig.join({.kind = JointKind::Fixed,
                          .a = at.rig.movers[0],
                          .b = at.rig.movers[2],
                          .anchor_a_world = vec(0, 2.5, 0),
                          .anchor_b_world = vec(0, 2.5, 0)});
         }}};
    for (const auto& [name, cause] : causes) {
        Sleepers at;
        cause(at);
        at.rig.world.step();
        for (std::size_t i = 0; i < at.rig.movers.size(); ++i)
            EXPECT_TRUE(at.awake(i)) << name << ", box " << i;
    }
}

TEST(Life, H87WhatLostItsSupportFallsAtOnce) {
    Sleepers at;
    at.rig.world.destroy_body(at.block);
    at.rig.run(0.25);
    for (std::size_t i = 0; i < 3; ++i) {
        const double expected = 1.5 + static_cast<double>(i) - 0.5 * kG * 0.0625;
        EXPECT_NEAR(at.rig.at(at.rig.movers[i]).y, expected, 0.01) << "box " << i;
    }
}

TEST(Life, H87AWokenPileDoesNotJump) {
    Sleepers at;
    for (const BodyId id : at.rig.movers) at.rig.world.wake(id);
    double top = 0;
    for (int i = 0; i < 60; ++i) {
        at.rig.world.step();
        top = std::max(top, at.rig.top_speed_mps());
    }
    expect_at_most("H87 woken pile, speed m/s", top, 1e-3);
}

// --- H88: uneven steps

/// Steps of 1/20 to 1/240 s, the same ones every time.
void run_unevenly(Rig& rig, double seconds) {
    std::uint32_t seed = 12345;
    WorldDef def = rig.world.def();
    double left_s = seconds;
    while (left_s > 1e-9) {
        seed = seed * 1664525U + 1013904223U;
        const double share = static_cast<double>(seed >> 8U) / (1U << 24U);
        def.step_s = std::min(left_s, 1.0 / 240 + share * (1.0 / 20 - 1.0 / 240));
        rig.world.reconfigure(def);
        rig.world.step();
        left_s -= def.step_s;
    }
}

TEST(Life, H88UnevenStepsEndWhereEvenOnesDo) {
    {
        Rig rig(balanced());
        rig.floor(0.3);
        const BodyId box =
            rig.box({0, 0.25, 0}, {1, 0.5, 1}, {.friction = 0.3, .velocity_mps = {5, 0, 0}});
        run_unevenly(rig, 2.5);
        expect_at_most("H88 sliding stop", std::abs(rig.at(box).x / 4.2473667 - 1), 0.1);
    }
    {
        Rig rig(balanced());
        rig.floor(0, 1);
        rig.ball({0, 5.5, 0}, 0.5, {.friction = 0, .restitution = 1});
        const double start_J = rig.energy_J();
        run_unevenly(rig, 20);
        expect_at_most("H88 bounce e=1, energy", std::abs(rig.energy_J() / start_J - 1), 0.1);
    }
    {
        Rig rig(balanced());
        rig.floor();
        for (int i = 0; i < 5; ++i) rig.box({0, 0.5 + i, 0}, {1, 1, 1});
        run_unevenly(rig, 10);
        expect_at_most("H88 tower of 5, drift m", drift_m(rig.at(rig.movers[4]), {0, 0, 0}), 0.01);
        expect_at_most("H88 tower of 5, sag m", std::abs(rig.at(rig.movers[4]).y - 4.5), 0.02);
        expect_at_most("H88 tower of 5, speed m/s", rig.top_speed_mps(), 0.05);
    }
}

TEST(Life, H88TinyStepsDoNoHarm) {
    WorldDef def = balanced();
    def.step_s = 1e-4;
    Rig rig(def);
    rig.floor();
    for (int i = 0; i < 3; ++i) rig.box({0, 0.5 + i, 0}, {1, 1, 1});
    rig.run(0.5);
    EXPECT_TRUE(rig.all_finite());
    expect_at_most("H88 steps of .1 ms, drift m", drift_m(rig.at(rig.movers[2]), {0, 0, 0}), 1e-3);
    expect_at_most("H88 steps of .1 ms, speed m/s", rig.top_speed_mps(), 5e-3);
}

// --- H89: the same again

/// Boxes and balls above each other, or, with `states`, as another heap stands now.
void build_heap(Rig& rig, bool backwards, const std::vector<BodyState>& states = {}) {
    rig.floor();
    std::vector<Vec3d> places;
    for (int i = 0; i < 40; ++i)
        places.push_back({0.3 * (i % 5) - 0.6, 1 + 0.7 * i, 0.37 * (i % 3)});
    if (backwards) std::reverse(places.begin(), places.end());
    for (std::size_t i = 0; i < places.size(); ++i) {
        BodyDef def = Rig::def_of(BodyKind::Dynamic, {});
        const bool ball = std::abs(places[i].x) < 0.1;
        def.shape = rig.shape(ball ? ShapeDef(SphereShape{.radius_m = 0.4_r})
                                   : ShapeDef(BoxShape{.size_m = vec(0.8, 0.6, 0.7)}));
        def.world_from_body.position = Vec3(places[i]);
        if (!states.empty()) {
            def.world_from_body = states[i].world_from_body;
            def.velocity_mps = states[i].velocity_mps;
            def.angular_velocity_radps = states[i].angular_velocity_radps;
        }
        rig.movers.push_back(rig.world.create_body(def));
    }
}

TEST(Life, H89RunsAreTheSameBitForBit) {
    std::vector<std::uint64_t> hashes;
    for (int i = 0; i < 5; ++i) {
        Rig rig(balanced());
        build_heap(rig, false);
        rig.run(5);
        hashes.push_back(rig.hash(rig.movers));
    }
    EXPECT_EQ(std::count(hashes.begin(), hashes.end(), hashes[0]), 5);
}

TEST(Life, H89ARebuiltWorldGoesOnAsAFreshOneWould) {
    Rig rig(balanced());
    build_heap(rig, false);
    rig.run(2);
    std::vector<BodyState> states;
    for (const BodyId id : rig.movers) states.push_back(rig.world.state(id));
    // Through another solver: with its own it goes on with what its contacts carried.
    WorldDef other = balanced();
    other.solver = Solver::BulletSi;
    Rig fresh(other);
    build_heap(fresh, false, states);
    fresh.world.reconfigure(balanced());
    rig.world.reconfigure(other);
    rig.world.reconfigure(balanced());
    rig.run(3);
    fresh.run(3);
    expect_at_most("H89 a rebuilt world differs from a fresh one",
                   rig.hash(rig.movers) == fresh.hash(fresh.movers) ? 0 : 1,
                   0);
}

TEST(Life, H89OrderOfMakingChangesNothingThatCounts) {
    const auto height = [](bool backwards) {
        Rig rig(balanced());
        build_heap(rig, backwards);
        rig.run(8);
        double sum = 0;
        for (const BodyId id : rig.movers) sum += rig.at(id).y;
        return sum / static_cast<double>(rig.movers.size());
    };
    // Mean height of the heap: a statistic, not a trajectory.
    expect_at_most(
        "H89 heap made backwards, mean height", std::abs(height(true) / height(false) - 1), 0.15);
}

}  // namespace
}  // namespace plumbline::physics
