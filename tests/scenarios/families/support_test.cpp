// What holds what up: A35, A36, A39.
#include "engine/study/scenarios/families/supports.h"
#include "tests/scenarios/families/case_run.h"

namespace plumbline::study {
namespace {

TEST(Support, A35FourBallsStandFromTheFrictionTheyNeed) {
    for (const Setting& setting : {exactly(8), balanced(), exactly(16)}) {
        Stepper stepper(Stepper::Mode::Errors, setting);
        const double found_balls = threshold_of(0.2, 0.6, 8, [&](double mu) {
            return four_balls_stand({.between = mu, .on_floor = 0.5}, stepper);
        });
        const std::string name = name_of(setting);
        note("A35 critical friction of balls " + name, found_balls);
        expect_at_most("A35 balls " + name, std::abs(found_balls / four_balls_mu() - 1), 0.04);
        const double found_floor = threshold_of(0.05, 0.15, 8, [&](double mu) {
            return four_balls_stand({.between = 1, .on_floor = mu}, stepper);
        });
        note("A35 critical friction of floor " + name, found_floor);
        expect_at_most(
            "A35 floor " + name, std::abs(found_floor / four_balls_floor_mu() - 1), 0.04);
    }
}

/// How far blocks of that reach have moved in 20 s.
double overhang_moves_m(int blocks, double reach) {
    Overhang leans(balanced(), blocks, reach);
    leans.world.run(20);
    return leans.moved_m();
}

TEST(Support, A36BlocksLeanOutAsFarAsTheSeriesSays) {
    for (const int blocks : {1, 2, 4, 6}) {
        const auto falls = [&](double reach) { return overhang_moves_m(blocks, reach) > 0.01; };
        // Asked for are 99 %: to a ten-thousandth.
        expect_at_most(fmt::format("A36 {} blocks, share of the reach that falls", blocks),
                       1 - threshold_of(0.9, 1.01, 10, falls),
                       0.01);
        EXPECT_GT(overhang_moves_m(blocks, 1.01), 1) << blocks << " blocks";
    }
}

TEST(Support, A39ATowerPressesWithTheWeightAbove) {
    for (const Setting& setting : every_s()) {
        Stepper stepper(Stepper::Mode::Errors, setting);
        const PressErrors errors = tower_presses(stepper);
        expect_at_most("A39 tower of 10, weight above " + name_of(setting), errors.mean, 0.01);
        expect_at_most("A39 tower of 10, rms " + name_of(setting), errors.rms, 0.01);
    }
}

/// Posts that end in faces: where on them the load acts is theirs to choose.
TEST(Support, A39ABeamLeansOnItsPostsByTheLeverRule) {
    for (const Setting& setting : every_s()) {
        ScenarioWorld world(setting);
        const BodyId left = world.fixed_box({-1.5, 0.5, 0}, {0.2, 1, 1});
        const BodyId right = world.fixed_box({0.5, 0.5, 0}, {0.2, 1, 1});
        const BodyId beam = world.box({0, 1.1, 0}, {4, 0.2, 0.5}, {.mass_kg = 12});
        world.physics.set_contact_events(beam, true);
        // The load may stand anywhere on a post: its events' points say where.
        world.run(2);
        const double weight_Ns = 12 * kG_mps2 / 60;
        double left_Ns = 0;
        double right_Ns = 0;
        double jitter = 0;
        for (int i = 0; i < 60; ++i) {
            world.physics.step();
            left_Ns += impulse_between_Ns(world, left, beam) / 60;
            right_Ns += impulse_between_Ns(world, right, beam) / 60;
            jitter = std::max(jitter,
                              std::abs((impulse_between_Ns(world, left, beam) +
                                        impulse_between_Ns(world, right, beam)) /
                                           weight_Ns -
                                       1));
        }
        expect_at_most("A39 beam, sum " + name_of(setting),
                       std::abs((left_Ns + right_Ns) / weight_Ns - 1),
                       0.01);
        expect_at_most("A39 beam, jitter " + name_of(setting), jitter, 0.01);
        // Reactions act within the posts' 0.2 m: between the rules for the inner and outer edges.
        const double inner = weight_Ns * 0.4 / (0.4 + 1.4);
        const double outer = weight_Ns * 0.6 / (0.6 + 1.6);
        note("A39 beam, left over the mean of the two rules " + name_of(setting),
             left_Ns / ((inner + outer) / 2));
        EXPECT_GT(left_Ns, inner * 0.99) << name_of(setting);
        EXPECT_LT(left_Ns, outer * 1.01) << name_of(setting);
    }
}

/// Posts that end in balls: the load acts at a point, and the rule is exact.
TEST(Support, A39ABeamOnTwoBallsLeansExactly) {
    for (const Setting& setting : every_s()) {
        Stepper stepper(Stepper::Mode::Errors, setting);
        const PressErrors errors = beam_presses(stepper);
        expect_at_most("A39 beam on balls, reactions " + name_of(setting), errors.mean, 0.01);
        expect_at_most("A39 beam on balls, rms " + name_of(setting), errors.rms, 0.01);
    }
}

}  // namespace
}  // namespace plumbline::study
