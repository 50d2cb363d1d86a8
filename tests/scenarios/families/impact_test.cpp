// Bodies that hit each other or the floor: A22, A23, A24, H25.
#include "tests/scenarios/families/rig.h"

namespace plumbline::physics {
namespace {

struct Blow {
    double mass_ratio;  ///< of the body that comes to the one at rest
    double aside;       ///< distance of the path from the centre, in radii
};

/// Errors of the two velocities after, as a share of the first speed, and of the momentum.
void expect_blow(const std::string& row, const Blow& blow, const WorldDef& def) {
    constexpr double kRadius_m = 0.1;
    constexpr double kSpeed_mps = 2;
    constexpr double kE = 0.7;
    Rig rig(afloat(def));
    const Stuff stuff{.friction = 0, .restitution = kE};
    Stuff coming = stuff;
    coming.mass_kg = blow.mass_ratio;
    coming.velocity_mps = {kSpeed_mps, 0, 0};
    const double aside_m = blow.aside * kRadius_m;
    const BodyId a = rig.ball({-0.5, aside_m, 0}, kRadius_m, coming);
    const BodyId b = rig.ball({0, 0, 0}, kRadius_m, stuff);
    const Vec3d momentum = rig.world.momentum_kgmps();
    rig.run(0.5);

    const double up = aside_m / (2 * kRadius_m);
    const Vec3d normal{std::sqrt(1 - up * up), -up, 0};  // from a to b
    const double closing = kSpeed_mps * normal.x;
    const double reduced = blow.mass_ratio / (1 + blow.mass_ratio);
    const Vec3d impulse = normal * ((1 + kE) * closing * reduced);
    const Vec3d expected_a = Vec3d{kSpeed_mps, 0, 0} - impulse / blow.mass_ratio;
    const double off = std::max(glm::distance(rig.velocity(a), expected_a),
                                glm::distance(rig.velocity(b), impulse));
    expect_at_most(row + " velocities", off / kSpeed_mps, 0.01);
    expect_at_most(row + " momentum",
                   glm::distance(rig.world.momentum_kgmps(), momentum) / glm::length(momentum),
                   2 * kRounding);
}

TEST(Impact, A22TwoBallsPartAsNewtonSays) {
    for (const double ratio : {1.0, 10.0, 100.0, 1000.0, 0.001}) {
        for (const double aside : {0.0, 1.0}) {
            const std::string row =
                fmt::format("A22 ratio {} {} ", ratio, aside > 0 ? "oblique" : "head on");
            expect_blow(row + "balanced", {ratio, aside}, balanced());
            expect_blow(row + "S=16", {ratio, aside}, exactly(16));
            expect_blow(row + "240 Hz", {ratio, aside}, balanced(240));
        }
    }
}

/// A ball that comes down with slip and spin leaves as rigid Coulomb friction says.
struct Spun {
    Vec3d velocity;
    Vec3d spin;
};
Spun after_floor(const Spun& before, double radius_m, double mu, double e) {
    const Vec3d arm{0, -radius_m, 0};
    Vec3d slip = before.velocity + glm::cross(before.spin, arm);
    slip.y = 0;
    const double down = -before.velocity.y;
    const double length = glm::length(slip);
    const double limit = mu * (1 + e) * down;
    Vec3d change{0, 0, 0};  // of velocity, across
    if (length > 0) change = -slip / length * std::min(limit, length * 2 / 7);
    const double inertia = 0.4 * radius_m * radius_m;
    Spun after{before.velocity + change, before.spin + glm::cross(arm, change) / inertia};
    after.velocity.y = e * down;
    return after;
}

TEST(Impact, A23ASpinningBallLeavesTheFloorTheSameInEveryDirection) {
    constexpr double kRadius_m = 0.5;
    constexpr double kE = 0.7;
    constexpr double kDown_mps = 5;
    struct Incidence {
        double along_mps;
        double topspin_radps;
        double sidespin_radps;
    };
    const Incidence incidences[] = {
        {0, 8, 0}, {1, 0, 0}, {3, 0, 0}, {5, -10, 5}, {10, 20, 10}, {20, 0, 0}};
    for (const double mu : {0.1, 0.5}) {
        for (const Setting& setting : {Setting{"balanced", balanced()}, {"S=16", exactly(16)}}) {
            double off = 0;
            double spread = 0;
            for (const Incidence& incidence : incidences) {
                double least = 1e9;
                double most = 0;
                for (int i = 0; i < 24; ++i) {
                    const double azimuth = i * kPiD / 12;
                    const Vec3d ahead{std::cos(azimuth), 0, std::sin(azimuth)};
                    const Vec3d axis = glm::cross(Vec3d{0, 1, 0}, ahead);
                    const Spun before{
                        ahead * incidence.along_mps - Vec3d{0, kDown_mps, 0},
                        axis * incidence.topspin_radps + ahead * incidence.sidespin_radps};
                    Rig rig(afloat(setting.def));
                    rig.floor(mu, kE);
                    const BodyId ball = rig.ball({0, 0.9, 0},
                                                 kRadius_m,
                                                 {.friction = mu,
                                                  .restitution = kE,
                                                  .velocity_mps = before.velocity,
                                                  .spin_radps = before.spin});
                    rig.run(0.3);
                    const Spun expected = after_floor(before, kRadius_m, mu, kE);
                    const double speed = glm::length(expected.velocity);
                    off =
                        std::max(off, glm::distance(rig.velocity(ball), expected.velocity) / speed);
                    off = std::max(
                        off, kRadius_m * glm::distance(rig.spin(ball), expected.spin) / speed);
                    const double found = glm::length(rig.velocity(ball)) / speed;
                    least = std::min(least, found);
                    most = std::max(most, found);
                }
                spread = std::max(spread, most - least);
            }
            const std::string row = fmt::format("A23 mu={} {} ", mu, setting.name);
            expect_at_most(row + "velocity and spin", off, 1e-3);
            expect_at_most(row + "azimuth spread", spread, 1e-3);
        }
    }
}

TEST(Impact, A24ACradleSendsOneBallOut) {
    constexpr double kRadius_m = 0.1;
    for (const double gap_m : {0.0, 1e-3}) {
        for (const int hz : {60, 240}) {
            for (const Setting& setting : every_s(hz)) {
                Rig rig(afloat(setting.def));
                std::vector<BodyId> balls;
                for (int i = 0; i < 5; ++i) {
                    const Stuff stuff{.friction = 0,
                                      .restitution = 1,
                                      .velocity_mps = {i == 0 ? 2.0 : 0.0, 0, 0}};
                    const double start_m = i == 0 ? -0.3 : 0;
                    balls.push_back(
                        rig.ball({start_m + i * (2 * kRadius_m + gap_m), 0, 0}, kRadius_m, stuff));
                }
                rig.run(1);
                double rest = 0;
                for (int i = 0; i < 4; ++i)
                    rest = std::max(rest,
                                    glm::length(rig.velocity(balls[static_cast<std::size_t>(i)])));
                const std::string row =
                    fmt::format("A24 cradle gap {} {} Hz {} ", gap_m, hz, setting.name);
                expect_at_most(row + "last ball", std::abs(rig.velocity(balls[4]).x / 2 - 1), 0.01);
                expect_at_most(row + "the others", rest / 2, 0.01);
            }
        }
    }
}

/// Two in, two out.
TEST(Impact, A24ACradleSendsTwoBallsOut) {
    constexpr double kRadius_m = 0.1;
    Rig rig(afloat(balanced()));
    std::vector<BodyId> balls;
    for (int i = 0; i < 5; ++i) {
        balls.push_back(
            rig.ball({(i < 2 ? -0.3 : 0) + i * 2 * kRadius_m, 0, 0},
                     kRadius_m,
                     {.friction = 0, .restitution = 1, .velocity_mps = {i < 2 ? 2.0 : 0.0, 0, 0}}));
    }
    rig.run(1);
    double off = 0;
    for (std::size_t i = 0; i < 5; ++i)
        off = std::max(off, std::abs(rig.velocity(balls[i]).x - (i < 3 ? 0 : 2)));
    expect_at_most("A24 cradle two in two out", off / 2, 0.01);
}

/// H25: a light box and one of a hundred times its mass meet without bouncing.
TEST(Impact, H25UnequalBoxesGoOnTogether) {
    for (const double mass_kg : {100.0, 0.01}) {
        for (const int hz : {30, 60, 240}) {
            Rig rig(afloat(balanced(hz)));
            const BodyId a = rig.box({-3, 0, 0}, {1, 1, 1}, {.velocity_mps = {20, 0, 0}});
            const BodyId b = rig.box({0, 0, 0}, {1, 1, 1}, {.mass_kg = mass_kg});
            rig.run(1);
            const double common = 20 / (1 + mass_kg);
            const std::string row = fmt::format("H25 1 kg on {} kg {} Hz ", mass_kg, hz);
            expect_at_most(row + "velocity", std::abs(rig.velocity(b).x / common - 1), 0.01);
            expect_at_most(
                row + "rebound", std::abs(rig.velocity(a).x - rig.velocity(b).x) / 20, 0.01);
        }
    }
}

}  // namespace
}  // namespace plumbline::physics
