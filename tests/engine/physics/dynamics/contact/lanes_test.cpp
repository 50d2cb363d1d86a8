#include "engine/physics/dynamics/contact/lanes.h"

#include "engine/core/random.h"

#include <gtest/gtest.h>

namespace plumbline::physics {
namespace {

TEST(Lanes, AMaskIsAnyWhereOneOfTheFourIs) {
    EXPECT_FALSE(any(Lanes{1, 2, 3, 4} < splat(1)));
    for (int i = 0; i < kLanes; ++i) {
        Lanes values = splat(1);
        values[i] = -1;
        EXPECT_TRUE(any(values < splat(0))) << i;
    }
}

TEST(Lanes, TheFirstAreThoseBelowTheCount) {
    for (int count = 0; count <= kLanes; ++count) {
        for (int i = 0; i < kLanes; ++i) EXPECT_EQ(first_lanes(count)[i] != 0, i < count);
    }
}

TEST(Lanes, SumsHaveTheBitsOfTheSameSumsOfNumbers) {
    Random random{3};
    const auto any_number = [&] { return Real{random.uniform(-10.0F, 10.0F)}; };
    for (int round = 0; round < 100; ++round) {
        LaneVec3 vectors{};
        Lanes weights{};
        for (int i = 0; i < kLanes; ++i) {
            set_lane(vectors, i, {any_number(), any_number(), any_number()});
            weights[i] = any_number();
        }
        const Vec3 direction{any_number(), any_number(), any_number()};
        const Lanes dots = dot_lanes(direction, vectors);
        for (int i = 0; i < kLanes; ++i) EXPECT_EQ(dots[i], glm::dot(direction, lane(vectors, i)));
        const Vec3 sum = weighted_sum(vectors, weights);
        for (int axis = 0; axis < 3; ++axis)
            EXPECT_EQ(sum[axis], sum_of(vectors[static_cast<std::size_t>(axis)] * weights));
        EXPECT_EQ(sum_of(weights), (weights[0] + weights[1]) + (weights[2] + weights[3]));
    }
}

}  // namespace
}  // namespace plumbline::physics
