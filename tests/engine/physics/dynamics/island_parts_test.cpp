// What moves farther within a step than its points can foresee goes on after its impacts, with nothing lost.
#include "engine/physics/dynamics/island_parts.h"

#include "engine/physics/totals.h"
#include "tests/engine/physics/test_world.h"

#include <algorithm>
#include <cmath>

namespace plumbline::physics {
namespace {

constexpr double kRates_hz[] = {30, 60, 240};
constexpr int kPhases = 24;

WorldDef of_rate(double hz, const Vec3& gravity_mps2 = {0, 0, 0}) {
    WorldDef def = in_small_steps(1);
    def.substeps_max = 16;
    def.step_s = 1 / hz;
    def.gravity_mps2 = gravity_mps2;
    return def;
}

/// Two that come from 10 m on both sides, later by a share of 1/60 s.
struct Meeting {
    Meeting(TestWorld& test, const ShapeDef& shape, int phase, BodyDef def)
        : away_m(10 + 5.0 * phase / kPhases) {
        def.kind = BodyKind::Dynamic;
        def.velocity_mps = {300, 0, 0};
        left = test.add(shape, {static_cast<Real>(-away_m), 0, 0}, def);
        def.velocity_mps = {-300, 0, 0};
        right = test.add(shape, {static_cast<Real>(away_m), 0, 0}, def);
    }

    double away_m;
    BodyId left;
    BodyId right;
};

TEST(IslandParts, BallsThatMeetAt600MpsBounceOrStopWhereTheyMeet) {
    constexpr double kSeconds = 0.1;
    for (const double hz : kRates_hz) {
        for (int phase = 0; phase < kPhases; ++phase) {
            for (const double restitution : {0.0, 1.0}) {
                TestWorld test(of_rate(hz));
                const Meeting balls(test,
                                    SphereShape{0.05_r},
                                    phase,
                                    {.friction = 0, .restitution = static_cast<Real>(restitution)});
                test.run(kSeconds);
                EXPECT_NEAR(test.velocity(balls.left).x, -300 * restitution, 0.1);
                EXPECT_NEAR(test.velocity(balls.right).x, 300 * restitution, 0.1);
                const double since_s = kSeconds - (balls.away_m - 0.05) / 300;
                EXPECT_NEAR(test.at(balls.right).x, 0.05 + 300 * restitution * since_s, 1e-3)
                    << hz << " Hz, phase " << phase;
            }
        }
    }
}

TEST(IslandParts, ABallThatGrazesAnotherHitsIt) {
    constexpr double kRadius_m = 0.11;
    for (const double hz : kRates_hz) {
        for (int phase = 0; phase < kPhases; ++phase) {
            for (const double overlap_m : {0.02, 0.05}) {
                TestWorld test(of_rate(hz));
                const BodyDef smooth{.kind = BodyKind::Dynamic, .friction = 0, .restitution = 1};
                const double beside_m = 2 * kRadius_m - overlap_m;
                const BodyId struck = test.add(SphereShape{static_cast<Real>(kRadius_m)},
                                               {0, static_cast<Real>(beside_m), 0},
                                               smooth);
                BodyDef fast = smooth;
                fast.velocity_mps = {40, 0, 0};
                const double away_m = 2 + 40.0 / hz * phase / kPhases;
                test.add(SphereShape{static_cast<Real>(kRadius_m)},
                         {static_cast<Real>(-away_m), 0, 0},
                         fast);
                test.run(0.1);
                // Along the line of centres, with all of the speed along it.
                const double sine = beside_m / (2 * kRadius_m);
                const double struck_mps = 40 * std::sqrt(1 - sine * sine);
                EXPECT_NEAR(glm::length(test.velocity(struck)), struck_mps, 0.04 * struck_mps)
                    << hz << " Hz, phase " << phase << ", " << overlap_m << " m";
            }
        }
    }
}

TEST(IslandParts, ABallThatBouncesHitsTheNextBallWithinTheStep) {
    for (const double hz : kRates_hz) {
        for (int phase = 0; phase < kPhases; ++phase) {
            TestWorld test(of_rate(hz));
            test.ground(0, 1);
            BodyDef smooth{.kind = BodyKind::Dynamic, .friction = 0, .restitution = 1};
            const BodyId next = test.add(SphereShape{0.05_r}, {0.25_r, 0.3_r, 0}, smooth);
            const auto away_m = static_cast<Real>(0.3 + 50 / hz * phase / kPhases);
            smooth.velocity_mps = {50, -50, 0};
            test.add(SphereShape{0.05_r}, {-away_m, 0.05_r + away_m, 0}, smooth);
            test.run(0.1);
            // From the ground it goes up as it came, head-on.
            EXPECT_NEAR(test.velocity(next).x, 50, 1) << hz << " Hz, phase " << phase;
            EXPECT_NEAR(test.velocity(next).y, 50, 1) << hz << " Hz, phase " << phase;
        }
    }
}

TEST(IslandParts, ABallReturnsFromAPlateThatComes) {
    for (const double hz : kRates_hz) {
        for (int phase = 0; phase < kPhases; ++phase) {
            TestWorld test(of_rate(hz));
            const BodyId plate =
                test.add(BoxShape{{2, 0.1_r, 2}},
                         {0, 0, 0},
                         {.kind = BodyKind::Kinematic, .velocity_mps = {0, 10, 0}});
            const double away_m = 2 + 70.0 / hz * phase / kPhases;
            const BodyId ball = test.add(SphereShape{0.05_r},
                                         {0, static_cast<Real>(away_m), 0},
                                         {.kind = BodyKind::Dynamic,
                                          .velocity_mps = {0, -60, 0},
                                          .friction = 0,
                                          .restitution = 1});
            test.run(0.1);
            EXPECT_NEAR(test.velocity(ball).y, 80, 0.1) << hz << " Hz, phase " << phase;
            EXPECT_NEAR(test.at(plate).y, 1, 1e-4);
        }
    }
}

TEST(IslandParts, BoxesThatTurnAndMeetAt600MpsDoNotPass) {
    for (const double hz : kRates_hz) {
        for (int phase = 0; phase < kPhases; ++phase) {
            TestWorld test(of_rate(hz));
            const Meeting boxes(test,
                                BoxShape{{0.1_r, 0.1_r, 0.1_r}},
                                phase,
                                {.angular_velocity_radps = {0, 0, 20}});
            const double start_J = energy(test.world).kinetic_J;
            test.run(0.1);
            EXPECT_LT(test.at(boxes.left).x, 0) << hz << " Hz, phase " << phase;
            EXPECT_GT(test.at(boxes.right).x, 0);
            EXPECT_LT(energy(test.world).kinetic_J, start_J);
            EXPECT_NEAR(glm::length(momentum_kgmps(test.world)), 0, 0.1);
        }
    }
}

TEST(IslandParts, ABoxLosesNothingOfItsFallAtAFloorThatItMeetsWithinTheStep) {
    constexpr double kFall_mps = 40;
    for (const double hz : kRates_hz) {
        for (int phase = 0; phase < kPhases; ++phase) {
            TestWorld test(of_rate(hz));
            test.add(BoxShape{{10, 1, 10}}, {0, -0.5_r, 0}, {});
            const double height_m = 1 + kFall_mps * phase / kPhases / 60;
            const BodyId box = test.add(BoxShape{{0.2_r, 0.2_r, 0.2_r}},
                                        {0, static_cast<Real>(height_m + 0.1), 0},
                                        {.kind = BodyKind::Dynamic,
                                         .velocity_mps = {0, -kFall_mps, 0},
                                         .friction = 0,
                                         .restitution = 0.5_r});
            test.run(0.1);
            const double since_s = 0.1 - height_m / kFall_mps;
            EXPECT_NEAR(test.velocity(box).y, kFall_mps / 2, 1e-3);
            EXPECT_NEAR(test.at(box).y, 0.1 + kFall_mps / 2 * since_s, 2e-3)
                << hz << " Hz, phase " << phase;
        }
    }
}

TEST(IslandParts, AWhirlingRodGainsNothingFromAPost) {
    for (const double hz : kRates_hz) {
        for (int i = 0; i < 7; ++i) {
            TestWorld test(of_rate(hz));
            const double angle = 0.3 + 0.1 * i;
            test.add(BoxShape{{0.1_r, 4, 0.1_r}},
                     {static_cast<Real>(1.5 * std::cos(angle)),
                      0,
                      static_cast<Real>(-1.5 * std::sin(angle))},
                     {.kind = BodyKind::Static});
            const BodyId rod =
                test.add(BoxShape{{4, 0.04_r, 0.04_r}},
                         {0, 0, 0},
                         {.kind = BodyKind::Dynamic, .angular_velocity_radps = {0, 50, 0}});
            const double start_J = energy(test.world).kinetic_J;
            for (int step = 0; step < 0.3 * hz; ++step) {
                test.world.step();
                ASSERT_LE(energy(test.world).kinetic_J, start_J * (1 + 1e-5)) << hz << " Hz, " << i;
            }
            EXPECT_LT(test.spin(rod).y, 25) << hz << " Hz, post " << i;
        }
    }
}

TEST(IslandParts, APlateAt50MpsDoesNotPenetrateARidge) {
    const MeshShape roof{
        .vertices_m =
            {{-4, 0, -8}, {4, 0, -8}, {-4, 0.4_r, 0}, {4, 0.4_r, 0}, {-4, 0, 8}, {4, 0, 8}},
        .triangles = {{0, 2, 1}, {1, 2, 3}, {2, 4, 3}, {3, 4, 5}}};
    for (const double hz : kRates_hz) {
        for (const double tilt : {-0.25, -0.1, 0.0, 0.15}) {
            TestWorld test(of_rate(hz, {0, -9.81_r, 0}));
            test.add(roof, {0, 0, 0}, {.kind = BodyKind::Static});
            BodyDef plate{.kind = BodyKind::Dynamic, .mass_kg = 200, .velocity_mps = {0, -50, 0}};
            plate.world_from_body.orientation = Quat(
                static_cast<Real>(std::cos(tilt / 2)), static_cast<Real>(std::sin(tilt / 2)), 0, 0);
            test.add(BoxShape{{1, 0.1_r, 2}}, {0, 5.5_r, 0}, plate);
            double deepest_m = 0;
            for (int step = 0; step < 0.5 * hz; ++step) {
                test.world.step();
                deepest_m = std::max(deepest_m, max_penetration_m(test.world));
            }
            EXPECT_LT(deepest_m, 2.5e-3) << hz << " Hz, " << tilt << " rad";
        }
    }
}

}  // namespace
}  // namespace plumbline::physics
