// Comparisons of vectors and rotations that say how far off they are:
// EXPECT_TRUE(near(found, expected, 1e-5)).
#pragma once

#include "engine/core/math.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace plumbline::test {

template <class T>
testing::AssertionResult near(const glm::vec<3, T>& found,
                              const glm::vec<3, T>& expected,
                              double tolerance) {
    const double off = static_cast<double>(glm::length(found - expected));
    if (off <= tolerance) return testing::AssertionSuccess();
    return testing::AssertionFailure()
           << "(" << found.x << ", " << found.y << ", " << found.z << ") is " << off << " from ("
           << expected.x << ", " << expected.y << ", " << expected.z << "), allowed " << tolerance;
}

/// Compares what the rotations do: q and -q are the same. Tolerance in radians.
template <class T>
testing::AssertionResult near(const glm::qua<T>& found,
                              const glm::qua<T>& expected,
                              double tolerance_rad) {
    const glm::qua<T> between = glm::conjugate(expected) * found;
    const double sine =
        static_cast<double>(glm::length(glm::vec<3, T>(between.x, between.y, between.z)));
    const double angle_rad = 2.0 * std::asin(std::min(1.0, sine));
    if (angle_rad <= tolerance_rad) return testing::AssertionSuccess();
    return testing::AssertionFailure()
           << "turned by " << angle_rad << " rad from what was expected, allowed " << tolerance_rad;
}

}  // namespace plumbline::test
