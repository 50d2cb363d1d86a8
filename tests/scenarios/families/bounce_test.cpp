// Bodies that fall on the floor and leave it again: A20, A21, A25 and the peers' bounce.
#include "tests/scenarios/families/rig.h"

namespace plumbline::physics {
namespace {

/// Height that a ball would reach from where it is, by its energy.
double reach_m(const Rig& rig, BodyId ball, double radius_m) {
    const double speed = rig.velocity(ball).y;
    return rig.at(ball).y - radius_m + speed * speed / (2 * kG);
}

/// The instant of the n-th contact of a ball dropped from `height_m`; n from 1.
double contact_s(double height_m, double e, int n) {
    double total = std::sqrt(2 * height_m / kG);
    const double first = total;
    for (int i = 1; i < n; ++i) total += 2 * first * std::pow(e, i);
    return total;
}

void expect_drop(const std::string& row, double e, double height_m, const WorldDef& def) {
    constexpr double kRadius_m = 0.1;
    Rig rig(def);
    rig.floor(0.5, e);
    const BodyId ball =
        rig.ball({0, kRadius_m + height_m, 0}, kRadius_m, {.friction = 0, .restitution = e});
    const double slowest_mps = 2 * kG * def.step_s / def.substeps;
    double speed_mps = std::sqrt(2 * kG * height_m);
    int frame = 0;
    for (int n = 1; n <= 4; ++n) {
        const double apex_m = std::pow(e, 2 * n) * height_m;
        const double from_s = contact_s(height_m, e, n);
        const double to_s = contact_s(height_m, e, n + 1);
        const int middle = static_cast<int>((from_s + to_s) / 2 / def.step_s + 0.5);
        const double sampled_s = middle * def.step_s;
        const std::string name = fmt::format("{} apex {}", row, n);
        // What is shorter than a frame no frame shows, and the solver lets what is slower than two
        // sub-steps of fall rest (PHYSICS.md d.14).
        const bool shown = from_s < sampled_s && sampled_s < to_s;
        if (!shown || speed_mps < slowest_mps) {
            note(name + " (below what frames show)", apex_m);
            return;
        }
        for (; frame < middle; ++frame) rig.world.step();
        expect_at_most(name, std::abs(reach_m(rig, ball, kRadius_m) / apex_m - 1), 5e-3);
        speed_mps *= e;
    }
}

TEST(Bounce, A20DroppedBallsReachTheSquareOfRestitution) {
    for (const double e : {0.3, 0.5, 0.8, 1.0}) {
        for (const double height_m : {1.0, 5.0}) {
            const std::string row = fmt::format("A20 ball e={} H={} ", e, height_m);
            expect_drop(row + "balanced", e, height_m, balanced());
            for (const int s : {1, 4, 16})
                expect_drop(fmt::format("{}S={}", row, s), e, height_m, exactly(s));
        }
    }
}

TEST(Bounce, A20AFlatBoxLandsOnFourCornersAtOnce) {
    for (const double e : {0.5, 1.0}) {
        for (const Setting& setting : every_s()) {
            Rig rig(setting.def);
            rig.floor(0.5, e);
            const BodyId box = rig.box({0, 2.5, 0}, {1, 1, 1}, {.restitution = e});
            const double between_s = (contact_s(2, e, 1) + contact_s(2, e, 2)) / 2;
            rig.run(between_s);
            expect_at_most(fmt::format("A20 flat box e={} {}", e, setting.name),
                           std::abs(reach_m(rig, box, 0.5) / (2 * e * e) - 1),
                           5e-3);
            expect_at_most(fmt::format("A20 flat box e={} {} tumbles rad/s", e, setting.name),
                           glm::length(rig.spin(box)),
                           5e-3);
        }
    }
}

TEST(Bounce, A20ElasticBallsStillReachTheirHeightAfterAMinute) {
    for (const int hz : {30, 60, 120, 240}) {
        for (const Setting& setting : every_s(hz)) {
            Rig rig(setting.def);
            rig.floor(0, 1);
            const BodyId ball =
                rig.ball({0, 10.5, 0}, 0.5, {.mass_kg = 1000, .friction = 0, .restitution = 1});
            rig.run(60);
            expect_at_most(fmt::format("bounce e=1 60 s {} Hz {}", hz, setting.name),
                           std::abs(reach_m(rig, ball, 0.5) / 10 - 1),
                           1e-5);
        }
    }
}

/// All bounces of a ball are over at the sum of the geometric series.
TEST(Bounce, A21BouncingEndsWhenTheSeriesDoes) {
    for (const double e : {0.5, 0.8}) {
        Rig rig(balanced(240));
        rig.floor(0.5, e);
        const BodyId ball = rig.ball({0, 1.1, 0}, 0.1, {.restitution = e});
        const double expected_s = std::sqrt(2 / kG) * (1 + e) / (1 - e);
        double last_s = 0;
        for (int i = 1; i <= 240 * 6; ++i) {
            rig.world.step();
            if (reach_m(rig, ball, 0.1) > 1e-3) last_s = i / 240.0;
        }
        // The flights below 1 mm that are left out of both.
        const double left_s = std::sqrt(8 * 1e-3 / kG) / (1 - e);
        EXPECT_LT(last_s, expected_s + 0.005);
        expect_at_most(fmt::format("A21 end of bouncing e={}", e),
                       (expected_s - last_s) / expected_s,
                       left_s / expected_s + 0.01);
    }
}

TEST(Bounce, A25FortyNineElasticBallsKeepTheirEnergy) {
    constexpr double kHeight_m = 5;
    for (const int hz : {30, 60, 120, 240}) {
        Rig rig(balanced(hz));
        rig.floor(0.5, 1);
        for (int i = 0; i < 49; ++i) {
            rig.ball({0.5 * (i % 7), 0.1 + kHeight_m, 0.5 * static_cast<double>(i / 7)},
                     0.1,
                     {.mass_kg = 10, .restitution = 1});
        }
        const double fall_J = 49 * 10 * kG * kHeight_m;
        const double start_J = rig.energy_J();
        double sum = 0;
        const int steps = 20 * hz;
        for (int i = 0; i < steps; ++i) {
            rig.world.step();
            const double off = (rig.energy_J() - start_J) / fall_J;
            sum += off * off;
        }
        expect_at_most(
            fmt::format("A25 49 balls energy rms {} Hz", hz), std::sqrt(sum / steps), 1e-5);
    }
}

}  // namespace
}  // namespace plumbline::physics
