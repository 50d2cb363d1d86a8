#include "engine/core/disjoint_sets.h"

#include "engine/core/random.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace plumbline {
namespace {

TEST(DisjointSets, StartAlone) {
    DisjointSets sets;
    sets.reset(3);
    for (std::uint32_t i = 0; i < 3; ++i) EXPECT_EQ(sets.find(i), i);
}

TEST(DisjointSets, AgreeWithRepaintingAndAreNamedByTheirSmallest) {
    constexpr std::uint32_t kCount = 200;
    DisjointSets sets;
    sets.reset(kCount);
    std::vector<std::uint32_t> color(kCount);
    for (std::uint32_t i = 0; i < kCount; ++i) color[i] = i;
    Random random(7);
    for (int join = 0; join < 150; ++join) {
        const auto a = random.below(kCount);
        const auto b = random.below(kCount);
        sets.join(a, b);
        const std::uint32_t low = std::min(color[a], color[b]);
        const std::uint32_t high = std::max(color[a], color[b]);
        std::replace(color.begin(), color.end(), high, low);
        for (std::uint32_t i = 0; i < kCount; ++i) ASSERT_EQ(sets.find(i), color[i]);
    }
}

}  // namespace
}  // namespace plumbline
