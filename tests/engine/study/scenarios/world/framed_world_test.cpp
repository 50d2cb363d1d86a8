#include "engine/study/scenarios/world/framed_world.h"

#include <gtest/gtest.h>

#include <cstddef>

namespace plumbline::study {
namespace {

const Frame kFrames[] = {{},
                         {.turn = glm::angleAxis(0.7, glm::normalize(Vec3d{1, 2, 3}))},
                         {.offset_m = {30, -20, 10}},
                         {.drift_mps = {3, -1, 2}},
                         {.scale = 4},
                         {.turn = glm::angleAxis(1.1, Vec3d{0, 0, 1}),
                          .offset_m = {5, 6, 7},
                          .drift_mps = {1, 0, 0},
                          .scale = 0.25,
                          .backwards = true}};

// A throw is the same parabola in every frame: t is the scene's own time.
TEST(FramedWorld, ReadsBackInTheScenesOwnLengthsAndTimes) {
    for (const Frame& frame : kFrames) {
        FramedWorld world(frame, {.step_hz = 240, .substeps = 4});
        const std::size_t ball = world.sphere({1, 2, 3}, 0.1, {.velocity_mps = {2, 4, 0}});
        const std::size_t other = world.sphere({9, 2, 3}, 0.1, {});
        world.build();
        EXPECT_LT(glm::distance(world.at(ball), Vec3d{1, 2, 3}), 1e-5);
        EXPECT_LT(glm::distance(world.velocity(ball), Vec3d{2, 4, 0}), 1e-5);
        Stepper stepper(Stepper::Mode::Time, {});
        world.run(stepper, 0.5);
        const Vec3d expected{2, 4 - 0.125 * kG_mps2, 3};
        EXPECT_LT(glm::distance(world.at(ball), expected), 1e-4);
        EXPECT_LT(glm::distance(world.velocity(ball), Vec3d{2, 4 - 0.5 * kG_mps2, 0}), 1e-4);
        EXPECT_LT(glm::distance(world.at(other), Vec3d{9, 2 - 0.125 * kG_mps2, 3}), 1e-4);
    }
}

TEST(FramedWorld, FloorsDriftAlongWithTheirScene) {
    for (const Frame& frame : kFrames) {
        FramedWorld world(frame, {.step_hz = 240, .substeps = 4});
        world.floor(0.5);
        const std::size_t box =
            world.box(physics::BodyKind::Dynamic, {0, 0.5, 0}, {1, 1, 1}, {.friction = 0.5});
        world.build();
        Stepper stepper(Stepper::Mode::Time, {});
        world.run(stepper, 1);
        EXPECT_LT(glm::distance(world.at(box), Vec3d{0, 0.5, 0}), 0.01) << "it lies still on it";
        EXPECT_LT(glm::length(world.velocity(box)), 0.01);
    }
}

// What rolls goes on rolling: its spin is scaled as its speed over its radius is.
TEST(FramedWorld, SpinsAreScaledWithTheirScene) {
    for (const Frame& frame : kFrames) {
        FramedWorld world(frame, {.step_hz = 240, .substeps = 4});
        world.floor(0.5);
        const std::size_t ball =
            world.sphere({0, 0.5, 0},
                         0.5,
                         {.friction = 0.5, .velocity_mps = {2, 0, 0}, .spin_radps = {0, 0, -4}});
        world.build();
        Stepper stepper(Stepper::Mode::Time, {});
        world.run(stepper, 1);
        EXPECT_NEAR(world.velocity(ball).x, 2, 0.02);
        EXPECT_NEAR(world.at(ball).x, 2, 0.02);
    }
}

}  // namespace
}  // namespace plumbline::study
