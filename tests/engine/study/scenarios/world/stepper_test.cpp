#include "engine/study/scenarios/world/stepper.h"

#include <gtest/gtest.h>

namespace plumbline::study {
namespace {

struct Calls {
    int before{0};
    int after{0};
};

/// A ball that falls, stepped for a second at 60 Hz.
Calls calls_of(Stepper& stepper, const Vec3d& velocity_mps = {0, 0, 0}, int end = 1000) {
    ScenarioWorld world(Setting{});
    const physics::BodyId ball = world.sphere({0, 10, 0}, 0.1, {});
    world.physics.set_velocity(ball, Vec3(velocity_mps), Vec3{0, 0, 0});
    Calls calls;
    stepper.run(world,
                1,
                {.before = [&](int) { ++calls.before; },
                 .after = [&](int) { ++calls.after; },
                 .until = [&] { return calls.before == end; }});
    return calls;
}

TEST(Stepper, MeasuresErrorsOrTimeButNotBoth) {
    Stepper errors(Stepper::Mode::Errors, {});
    const Calls measured = calls_of(errors);
    EXPECT_EQ(measured.before, 60);
    EXPECT_EQ(measured.after, 60);
    EXPECT_TRUE(errors.lap().step_ms.empty());
    EXPECT_EQ(errors.bodies(), 1U);
    Stepper time(Stepper::Mode::Time, {});
    const Calls timed = calls_of(time);
    EXPECT_EQ(timed.before, 60);
    EXPECT_EQ(timed.after, 0);
    EXPECT_EQ(time.lap().step_ms.size(), 60U);
    EXPECT_NEAR(time.lap().simulated_s, 1, 1e-9);
    EXPECT_EQ(time.status(), RunStatus::Done);
}

TEST(Stepper, EndsEarlyWhereItIsAskedTo) {
    Stepper stepper(Stepper::Mode::Errors, {});
    EXPECT_EQ(calls_of(stepper, {0, 0, 0}, 7).after, 7);
}

TEST(Stepper, KeepsTheWorstThatBecameOfAWorld) {
    Stepper stepper(Stepper::Mode::Errors, {});
    calls_of(stepper, {2000, 0, 0});
    EXPECT_EQ(stepper.status(), RunStatus::Exploded);
    calls_of(stepper);
    EXPECT_EQ(stepper.status(), RunStatus::Exploded) << "a later world is well";
    EXPECT_TRUE(stepper.refuse({.message = "no file"}).empty());
    EXPECT_EQ(stepper.status(), RunStatus::Refused);
    EXPECT_EQ(stepper.why_refused(), "no file");
}

}  // namespace
}  // namespace plumbline::study
