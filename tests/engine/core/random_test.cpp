#include "engine/core/random.h"

#include <gtest/gtest.h>

#include <array>

namespace plumbline {
namespace {

// The output of the reference implementation (pcg32_oneseq, seed 42).
TEST(Random, IsPcg32) {
    Random random(42);
    for (const std::uint32_t expected :
         {0xc2f57bd6U, 0x6b07c4a9U, 0x72b7b29bU, 0x44215383U, 0xf5af5eadU}) {
        EXPECT_EQ(random.next(), expected);
    }
}

TEST(Random, SeedsDiffer) {
    EXPECT_NE(Random(0).next(), Random(1).next());
}

TEST(Random, UniformStaysBelowOneAndFillsTheRange) {
    Random random(7);
    double sum = 0.0;
    constexpr int kCount = 100'000;
    for (int i = 0; i < kCount; ++i) {
        const float number = random.uniform();
        ASSERT_GE(number, 0.0F);
        ASSERT_LT(number, 1.0F);
        sum += static_cast<double>(number);
    }
    // Five standard deviations of the mean of 1e5 uniform numbers: 5 * sqrt(1/12) / sqrt(1e5).
    EXPECT_NEAR(sum / kCount, 0.5, 0.0046);
}

TEST(Random, RangesAreKept) {
    Random random(8);
    std::array<int, 6> faces{};
    for (int i = 0; i < 6'000; ++i) {
        const float number = random.uniform(-3.0F, 2.0F);
        ASSERT_GE(number, -3.0F);
        ASSERT_LE(number, 2.0F);
        ++faces.at(random.below(6));
    }
    // Five standard deviations of a binomial count: 5 * sqrt(6000 * 1/6 * 5/6) = 144.
    for (const int count : faces) EXPECT_NEAR(count, 1'000, 144);
}

}  // namespace
}  // namespace plumbline
