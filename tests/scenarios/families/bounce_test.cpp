// Bodies that fall on the floor and leave it again: A20, A21, A25 and the peers' bounce.
#include "engine/study/scenarios/families/bounces.h"
#include "engine/study/scenarios/world/peer_scene.h"
#include "tests/scenarios/families/case_run.h"

namespace plumbline::study {
namespace {

void expect_drop(const std::string& row, const Drop& drop, const Setting& setting) {
    DroppedBody falls(setting, drop);
    const WorldDef& def = falls.world.physics.def();
    const double slowest_mps = 2 * kG_mps2 * def.step_s / def.substeps;
    double speed_mps = std::sqrt(2 * kG_mps2 * drop.height_m);
    int frame = 0;
    for (int n = 1; n <= 4; ++n) {
        const double from_s = drop.contact_s(n);
        const double to_s = drop.contact_s(n + 1);
        const int middle = static_cast<int>((from_s + to_s) / 2 / def.step_s + 0.5);
        const double sampled_s = middle * def.step_s;
        const std::string name = fmt::format("{} apex {}", row, n);
        // What is shorter than a frame no frame shows, and the solver lets what is slower than two
        // sub-steps of fall rest (PHYSICS.md d.14).
        const bool shown = from_s < sampled_s && sampled_s < to_s;
        if (!shown || speed_mps < slowest_mps) {
            note(name + " (below what frames show)", drop.apex_m(n));
            return;
        }
        for (; frame < middle; ++frame) falls.world.physics.step();
        expect_at_most(name, std::abs(falls.reach_m() / drop.apex_m(n) - 1), 5e-3);
        speed_mps *= drop.e;
    }
}

TEST(Bounce, A20DroppedBallsReachTheSquareOfRestitution) {
    for (const double e : {0.3, 0.5, 0.8, 1.0}) {
        for (const double height_m : {1.0, 5.0}) {
            for (const Setting& setting : every_s()) {
                const std::string row =
                    fmt::format("A20 ball e={} H={} {}", e, height_m, name_of(setting));
                expect_drop(row, {.height_m = height_m, .e = e}, setting);
            }
        }
    }
}

TEST(Bounce, A20AFlatBoxLandsOnFourCornersAtOnce) {
    for (const double e : {0.5, 1.0}) {
        const Drop drop{.height_m = 2, .e = e, .shape = Drop::Shape::Cube};
        for (const Setting& setting : every_s()) {
            DroppedBody falls(setting, drop);
            falls.world.run((drop.contact_s(1) + drop.contact_s(2)) / 2);
            expect_at_most(fmt::format("A20 flat box e={} {}", e, name_of(setting)),
                           std::abs(falls.reach_m() / drop.apex_m(1) - 1),
                           5e-3);
            expect_at_most(fmt::format("A20 flat box e={} {} tumbles rad/s", e, name_of(setting)),
                           glm::length(falls.world.spin(falls.body)),
                           5e-3);
        }
    }
}

TEST(Bounce, A20ElasticBallsStillReachTheirHeightAfterAMinute) {
    for (const int hz : {30, 60, 120, 240}) {
        for (const Setting& setting : every_s(hz)) {
            const auto opened = PeerScene::open("bounce", setting);
            ASSERT_TRUE(opened.ok()) << opened.error().message;
            ScenarioWorld& world = (*opened)->world;
            const auto reach_m = [&] {
                const double speed_mps = world.velocity(world.movers[0]).y;
                return world.at(world.movers[0]).y - 0.5 + speed_mps * speed_mps / (2 * kG_mps2);
            };
            const double drop_m = reach_m();
            world.run(60);
            expect_at_most(fmt::format("bounce e=1 60 s {} Hz {}", hz, name_of(setting)),
                           std::abs(reach_m() / drop_m - 1),
                           1e-5);
        }
    }
}

/// All bounces of a ball are over at the sum of the geometric series.
TEST(Bounce, A21BouncingEndsWhenTheSeriesDoes) {
    for (const double e : {0.5, 0.8}) {
        Stepper stepper(Stepper::Mode::Errors, balanced(240));
        const double last_s = bouncing_end_found_s(e, stepper);
        const double series_s = std::sqrt(2 / kG_mps2) * (1 + e) / (1 - e);
        EXPECT_LT(last_s, series_s + 0.005);
        expect_at_most(fmt::format("A21 end of bouncing e={}", e),
                       std::abs(last_s / bouncing_end(e).expected_s - 1),
                       0.01);
    }
}

TEST(Bounce, A25FortyNineElasticBallsKeepTheirEnergy) {
    for (const int hz : {30, 60, 120, 240}) {
        Stepper stepper(Stepper::Mode::Errors, balanced(hz));
        expect_at_most(fmt::format("A25 49 balls energy rms {} Hz", hz),
                       elastic_balls_energy_rms(stepper),
                       1e-5);
    }
}

}  // namespace
}  // namespace plumbline::study
