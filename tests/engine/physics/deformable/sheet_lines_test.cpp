// Lines of threads and of bending: momentum is kept, and what they take from motion is what a solution of the whole line says.
#include "engine/physics/sheet_lines.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace plumbline::physics {
namespace {

constexpr double kScale_s2 = 0.5;

/// As measure() leaves it.
Thread thread_along_x(std::uint32_t a, double stiffness_Npm) {
    const Vec3d x{1, 0, 0};
    return {.a = a,
            .b = a + 1,
            .stiffness_Npm = stiffness_Npm,
            .direction = x,
            .yields_a = x,
            .yields_b = x};
}

TEST(SheetLines, AThreadSlowsHowItsEndsPart) {
    ThreadFamily family;
    family.threads = {thread_along_x(0, 4)};
    family.per_line = 1;
    const std::array<double, 2> weights{1, 0.5};
    std::array<Vec3d, 2> velocities{Vec3d{0, 2, 0}, Vec3d{3, 0, 0}};
    std::array<Vec3d, 2> held{};
    family.factor(kScale_s2, weights);
    family.relax(weights, velocities, held);
    // 3 / (1 + 0.5 * 4 * 1.5)
    EXPECT_NEAR(velocities[1].x - velocities[0].x, 0.75, 1e-12);
    EXPECT_NEAR(velocities[0].x / weights[0] + velocities[1].x / weights[1], 6, 1e-12);
    EXPECT_EQ(velocities[0].y, 2);
}

TEST(SheetLines, AThreadIsMeasuredWhereItsEndsAre) {
    ThreadFamily family;
    family.threads = {{.a = 0, .b = 1}, {.a = 1, .b = 2}};
    family.measure(std::array{Vec3d{1, 2, 3}, Vec3d{1, 0, 3}, Vec3d{1, 0, 3}});
    EXPECT_EQ(family.threads[0].length_m, 2);
    EXPECT_EQ(family.threads[0].direction, (Vec3d{0, -1, 0}));
    EXPECT_EQ(family.threads[1].direction, (Vec3d{0, 0, 0})) << "both of its ends are in one place";
}

// Against the same matrix solved point by point, until nothing changes.
TEST(SheetLines, ALineIsSolvedAtOnce) {
    constexpr std::size_t kPoints = 6;
    ThreadFamily family;
    for (std::uint32_t i = 0; i + 1 < kPoints; ++i)
        family.threads.push_back(thread_along_x(i, 3.0 + i));
    family.per_line = kPoints - 1;
    std::array<double, kPoints> weights{1, 2, 0, 1, 3, 1};
    std::array<Vec3d, kPoints> velocities{};
    for (std::size_t i = 0; i < kPoints; ++i) velocities[i].x = static_cast<double>(i * i);
    const auto before = velocities;
    std::array<Vec3d, kPoints> held{};
    family.factor(kScale_s2, weights);
    family.relax(weights, velocities, held);
    for (std::size_t i = 0; i < kPoints; ++i) {
        double pulled = 0;
        if (i + 1 < kPoints)
            pulled += (3.0 + static_cast<double>(i)) * (velocities[i + 1].x - velocities[i].x);
        if (i > 0)
            pulled -= (2.0 + static_cast<double>(i)) * (velocities[i].x - velocities[i - 1].x);
        EXPECT_NEAR(velocities[i].x, before[i].x + weights[i] * kScale_s2 * pulled, 1e-9);
        if (weights[i] == 0) {
            EXPECT_NEAR(held[i].x, kScale_s2 * pulled, 1e-9);
        }
    }
}

// Against a normal that leans by 60 degrees from the thread: the end goes on along the normal, and what the thread does there is told.
TEST(SheetLines, ABracedEndYieldsAcrossItsNormalOnly) {
    ThreadFamily family;
    family.threads = {{.a = 0, .b = 1, .stiffness_Npm = 4}};
    const Vec3d normal{0.5, std::sqrt(0.75), 0};
    family.measure(std::array{Vec3d{0, 0, 0}, Vec3d{1, 0, 0}});
    family.brace(std::array{Vec3d{0, 0, 0}, normal});
    const std::array<double, 2> weights{1, 0.5};
    std::array<Vec3d, 2> velocities{Vec3d{0, 0, 0}, Vec3d{3, 0, 0}};
    const Vec3d before = velocities[1];
    std::array<Vec3d, 2> held{};
    family.factor(kScale_s2, weights);
    family.relax(weights, velocities, held);
    // 0.5 * 4 * 3 / (1 + 0.5 * 4 * (1 + 0.5 * sin2 60))
    const double pull = 6 / (1 + 2 * (1 + 0.5 * 0.75));
    EXPECT_NEAR(velocities[0].x, pull, 1e-12);
    EXPECT_NEAR(glm::dot(velocities[1] - before, normal), 0, 1e-12);
    EXPECT_NEAR(glm::distance(held[1], normal * (-pull * 0.5)), 0, 1e-12);
}

TEST(SheetLines, ATornThreadTakesNothing) {
    ThreadFamily family;
    family.threads = {thread_along_x(0, 0), thread_along_x(1, 1e9)};
    family.per_line = 2;
    const std::array<double, 3> weights{1, 1, 1};
    std::array<Vec3d, 3> velocities{Vec3d{-5, 0, 0}, Vec3d{0, 0, 0}, Vec3d{2, 0, 0}};
    std::array<Vec3d, 3> held{};
    family.factor(1, weights);
    family.relax(weights, velocities, held);
    EXPECT_EQ(velocities[0].x, -5);
    EXPECT_NEAR(velocities[1].x, 1, 1e-6);
    EXPECT_NEAR(velocities[2].x, 1, 1e-6);
}

// What turns as a whole does not bend.
TEST(SheetLines, BendingLeavesStraightMotionAlone) {
    StripFamily family;
    family.strips = {{.first = 0, .stride = 1, .count = 7, .stiffness_Npm = 50}};
    const std::array<double, 7> weights{2, 1, 1, 1, 1, 1, 2};
    std::array<Vec3d, 7> velocities{};
    for (std::size_t i = 0; i < 7; ++i) velocities[i] = {1, 0.5 * static_cast<double>(i), 0};
    const auto before = velocities;
    family.relax(1, weights, velocities);
    for (std::size_t i = 0; i < 7; ++i)
        EXPECT_NEAR(glm::distance(velocities[i], before[i]), 0, 1e-12);
    velocities[3].z = 4;
    double momentum = 4;
    family.relax(1, weights, velocities);
    EXPECT_LT(velocities[3].z, 2);
    for (std::size_t i = 0; i < 7; ++i) momentum -= velocities[i].z / weights[i];
    EXPECT_NEAR(momentum, 0, 1e-12);
}

TEST(SheetLines, AClampBendsOverHalfOfACell) {
    EXPECT_EQ(clamp_factor(0, 0, 1), 2);
    EXPECT_EQ(clamp_factor(1, 0, 0), 2);
    EXPECT_EQ(clamp_factor(1, 0, 1), 1);
    EXPECT_EQ(clamp_factor(0, 1, 1), 1);
}

}  // namespace
}  // namespace plumbline::physics
