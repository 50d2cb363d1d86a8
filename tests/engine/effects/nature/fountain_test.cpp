// The drops of fountains against what ballistics says.
#include "engine/effects/nature/drops.h"
#include "tests/engine/effects/drawn.h"
#include "tests/support/near.h"

#include <algorithm>
#include <cmath>

namespace plumbline::effects {
namespace {

using scene::Fidelity;
using scene::FountainDescription;
using scene::SceneDescription;
using test::Running;

constexpr float kGravity_mps2 = 9.81F;
constexpr float kStep_s = 1.0F / 60.0F;
const Vec3f kDown{0.0F, -kGravity_mps2, 0.0F};

FountainDescription jet(const Vec3& direction, Real speed_mps) {
    return {.position_m = {0, 1, 0},
            .direction = direction,
            .speed_mps = speed_mps,
            .spread_rad = 0,
            .drag = false,
            .location = in_file("garden.toml", 7)};
}

Drops running(const FountainDescription& fountain, float seconds, const Obstacles& obstacles = {}) {
    Drops drops({&fountain, 1}, Fidelity::Balanced, kDown);
    for (float s = 0.0F; s < seconds; s += kStep_s) drops.step(kStep_s, obstacles);
    return drops;
}

/// Where drops cross the height that they left at, on their way down.
float reach_m(Drops drops) {
    float farthest = 0.0F;
    for (const Drop& drop : drops.drops()) {
        if (drop.position_world.y >= 1.0F) farthest = std::max(farthest, drop.position_world.x);
    }
    return farthest;
}

TEST(Fountain, AJetRisesAsHighAsItsSpeedCarriesIt) {
    const float speed = 4.0F;
    float highest = 0.0F;
    const Drops drops = running(jet({0, 1, 0}, Real{4}), 2.0F);
    for (const Drop& drop : drops.drops()) highest = std::max(highest, drop.position_world.y);
    // The nozzle is at 1 m. Some drop is within half a step of the top.
    const float top = 1.0F + speed * speed / (2.0F * kGravity_mps2);
    EXPECT_LE(highest, top + 1e-5F);
    EXPECT_GE(highest, top - kGravity_mps2 * kStep_s * kStep_s / 8.0F);
}

TEST(Fountain, AJetReachesAsFarAsBallisticsSays) {
    const auto half = static_cast<Real>(std::sqrt(0.5));
    // v^2 sin(2 a) / g with a of 45 degrees; some drop is within a step's way of it.
    const float expected = 9.0F / kGravity_mps2;
    const float found = reach_m(running(jet({half, half, 0}, Real{3}), 2.0F));
    EXPECT_LE(found, expected + 1e-4F);
    EXPECT_GE(found, expected - 3.0F * std::sqrt(0.5F) * kStep_s);
}

TEST(Fountain, AirSlowsADropToItsTerminalSpeed) {
    FountainDescription fountain = jet({0, -1, 0}, Real{0});
    fountain.drop_mm = Real{2};
    fountain.drag = true;
    const Drops drops = running(fountain, 3.9F);
    float fastest = 0.0F;
    for (const Drop& drop : drops.drops())
        fastest = std::max(fastest, glm::length(drop.velocity_mps));
    // m g = rho A c v^2 / 2 for a ball of 1 mm in air of 1.2 kg/m3 with c = 0.47.
    const float terminal =
        std::sqrt(8.0F * 1000.0F * 0.001F * kGravity_mps2 / (3.0F * 1.2F * 0.47F));
    EXPECT_NEAR(fastest, terminal, 0.01F * terminal);
}

TEST(Fountain, DragAloneSlowsAsItsFormulaSays) {
    FountainDescription fountain = jet({1, 0, 0}, Real{20});
    fountain.drop_mm = Real{1};
    fountain.drag = true;
    fountain.flow_lps = 1e-6_r;  // one drop
    const auto after = [&](int steps) {
        // dv/dt = -k v^2 sideways: 20 / (1 + 20 k t), with gravity off.
        Drops drops({&fountain, 1}, Fidelity::Balanced, Vec3f{0.0F});
        const float step_s = 0.6F / static_cast<float>(steps);
        for (int i = 0; i < steps; ++i) drops.step(step_s, {});
        EXPECT_EQ(drops.drops().size(), 1U);
        return drops.drops().empty() ? Drop{} : drops.drops().front();
    };
    const Drop drop = after(60);
    const float k = 0.375F * 1.2e-3F * 0.47F / 0.5e-3F;
    const float expected = 20.0F / (1.0F + 20.0F * k * drop.age_s);
    EXPECT_NEAR(drop.velocity_mps.x, expected, 1e-3F * expected);
}

TEST(Fountain, TheWindCarriesDropsAlong) {
    FountainDescription fountain = jet({0, 1, 0}, Real{0});
    fountain.drop_mm = Real{1};
    fountain.drag = true;
    fountain.flow_lps = 1e-6_r;  // one drop
    Drops drops({&fountain, 1}, Fidelity::Balanced, Vec3f{0.0F});
    for (int i = 0; i < 60; ++i) drops.step(0.01F, {}, {5.0F, 0.0F, 0.0F});
    ASSERT_EQ(drops.drops().size(), 1U);
    const Drop& drop = drops.drops().front();
    // Seen from the air it begins at -5 m/s, and v = v0 / (1 + v0 k t).
    const float k = 0.375F * 1.2e-3F * 0.47F / 0.5e-3F;
    const float expected = 5.0F - 5.0F / (1.0F + 5.0F * k * drop.age_s);
    EXPECT_NEAR(drop.velocity_mps.x, expected, 1e-3F * 5.0F);
    EXPECT_EQ(drop.velocity_mps.z, 0.0F);
}

TEST(Fountain, WhatFlowsInFlowsOutOrIsHeld) {
    FountainDescription fountain = jet({0, 1, 0}, Real{3});
    fountain.flow_lps = 0.3_r;
    fountain.pools = {{.center_m = {0, 0.5_r, 0}, .radius_m = 1}};
    const WaterFlow flow = running(fountain, 3.0F).flow();
    EXPECT_NEAR(flow.in_l, 0.9, 0.3 * 2.0 / 60.0) << "0.3 l/s for 3 s";
    EXPECT_NEAR(flow.in_l, flow.held_l + flow.out_l, 1e-5);
    // A drop flies v/g up, as long down, and the half metre: 0.6116 + 0.1372 s.
    EXPECT_NEAR(flow.held_l, 0.3 * (0.6116 + 0.1372), 0.3 * 2.0 / 60.0);
    EXPECT_GT(flow.out_l, 0.5);
}

TEST(Fountain, DropsEndInPoolsAndRaiseRingsThere) {
    FountainDescription fountain = jet({0, 1, 0}, Real{2});
    fountain.pools = {{.center_m = {0, 0.5_r, 0}, .radius_m = 0.4_r}};
    const Drops drops = running(fountain, 2.0F);
    ASSERT_FALSE(drops.rings().empty());
    for (const WaterRing& ring : drops.rings()) {
        EXPECT_TRUE(test::near(ring.center_world, Vec3f{0.0F, 0.5F, 0.0F}, 1e-3));
        EXPECT_NEAR(ring.reach_m, 0.4F, 1e-3F) << "to the pool's edge";
    }
    for (const Drop& drop : drops.drops()) EXPECT_GE(drop.position_world.y, 0.5F);
}

TEST(Fountain, DropsEndOnWhatStandsInTheirWay) {
    // A plate at a height of 1.2 m over a jet that would rise to 1.82 m.
    const Obstacles plate = [](const Vec3f& from, const Vec3f& to) -> std::optional<float> {
        if (from.y > 1.2F || to.y < 1.2F) return {};
        return (1.2F - from.y) / (to.y - from.y);
    };
    const Drops drops = running(jet({0, 1, 0}, Real{4}), 2.0F, plate);
    EXPECT_FALSE(drops.drops().empty());
    for (const Drop& drop : drops.drops()) {
        if (drop.held_l > 0.0F) {
            EXPECT_LT(drop.position_world.y, 1.2F + 4.0F * kStep_s);
        }
    }
}

TEST(Fountain, MoreDropsThanAreDrawnStandForMoreWaterEach) {
    FountainDescription fountain = jet({0, 1, 0}, Real{3});
    fountain.flow_lps = 500;
    fountain.drop_mm = 1;  // a thousand million drops a second
    Drops drops({&fountain, 1}, Fidelity::Precise, kDown);
    for (int i = 0; i < 60; ++i) drops.step(kStep_s, {});
    EXPECT_LE(drops.drops().size(), static_cast<std::size_t>(Drops::kMostPerSecond));
    EXPECT_NEAR(drops.flow().in_l, 500.0, 500.0 * 2.0 / 60.0);
}

TEST(Fountain, FidelityChangesHowManyDropsButNotHowMuchWater) {
    const FountainDescription fountain = jet({0, 1, 0}, Real{3});
    Drops few({&fountain, 1}, Fidelity::Draft, kDown);
    Drops many({&fountain, 1}, Fidelity::Precise, kDown);
    for (int i = 0; i < 60; ++i) {
        few.step(kStep_s, {});
        many.step(kStep_s, {});
    }
    EXPECT_NEAR(static_cast<double>(few.drops().size()),
                0.2 * static_cast<double>(many.drops().size()),
                2.0);
    EXPECT_NEAR(few.flow().in_l, many.flow().in_l, 1e-3);
}

SceneDescription with_fountain() {
    SceneDescription scene = test::scene_of({});
    scene.fountains = {jet({0, 1, 0}, Real{3})};
    return scene;
}

TEST(Fountain, NobodyWhoDoesNotCallForItPays) {
    Running run(test::scene_of({}));
    EffectRuntime effects(*run, kImage);
    run.step(3, effects);
    const render::RenderFrame frame = draw(run, effects);
    EXPECT_TRUE(frame.drops.empty() && frame.water_rings.empty());
    const LedgerLine line = line_of(effects, "fountain");
    EXPECT_EQ(line.constructions, 0U);
    EXPECT_EQ(line.calls, 0U);
    EXPECT_EQ(line.bytes_cpu, 0U);
}

TEST(Fountain, RunsWhenItIsFirstSeenAndSaysWhoCalledForIt) {
    Running run(with_fountain());
    EffectRuntime effects(*run, kImage);
    EXPECT_GT(draw(run, effects).drops.size(), 100U);
    EXPECT_EQ(line_of(effects, "fountain").called_for_by, Callers{"[[fountain]] (garden.toml:7)"});
    run->switches.turn("fountain", false);
    EXPECT_TRUE(draw(run, effects).drops.empty());
}

TEST(Fountain, IsTheSameAfterTheSameStepsHoweverManyImagesAreDrawn) {
    Running often(with_fountain());
    Running seldom(with_fountain());
    EffectRuntime often_effects(*often, kImage);
    EffectRuntime seldom_effects(*seldom, kImage);
    for (int i = 0; i < 30; ++i) {
        often.step(1, often_effects);
        draw(often, often_effects, 0.3_r);
        draw(often, often_effects, 0.7_r);
    }
    seldom.step(30, seldom_effects);
    const auto a = draw(often, often_effects).drops;
    const auto b = draw(seldom, seldom_effects).drops;
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i)
        ASSERT_EQ(a[i].position_world, b[i].position_world) << i;
    // Paused, nothing moves from image to image.
    const auto later = draw(often, often_effects).drops;
    EXPECT_EQ(later.front().position_world, a.front().position_world);
}

TEST(Fountain, ANozzleInsideASolidLetsItsDropsOut) {
    SceneDescription scene = with_fountain();
    scene.entities = {
        test::box("block", {0, 1, 0}, {0.2_r, 0.2_r, 0.2_r}, physics::BodyKind::Static)};
    Running run(scene);
    EffectRuntime effects(*run, kImage);
    run.step(90, effects);
    float highest = 0.0F;
    for (const render::DropStreak& drop : draw(run, effects).drops)
        highest = std::max(highest, drop.position_world.y);
    EXPECT_GT(highest, 1.4F) << "3 m/s carry 0.46 m from the nozzle at 1 m";
}

TEST(Fountain, FarAwayFewerDropsAreDrawnAndNoneBeyondSight) {
    SceneDescription scene = with_fountain();
    scene.camera.target_m = {0, 1, 0};
    const auto drawn_from = [&](Real distance_m) {
        scene.camera.position_m = {0, 1, distance_m};
        Running run(scene);
        run.game = scene::NoGame{scene.camera};
        EffectRuntime effects(*run, kImage);
        return static_cast<double>(draw(run, effects).drops.size());
    };
    const double near = drawn_from(5);
    EXPECT_NEAR(drawn_from(14), near / 2, near * 0.06);
    EXPECT_NEAR(drawn_from(28), near / 4, near * 0.06);
    EXPECT_EQ(drawn_from(200), 0.0);
}

}  // namespace
}  // namespace plumbline::effects
