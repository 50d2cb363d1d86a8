#include "engine/physics/dynamics/joint/block/block_pattern.h"

#include "tests/engine/physics/dynamics/joint/block/block_graphs.h"

#include <gtest/gtest.h>

namespace plumbline::physics {
namespace {

TEST(BlockPattern, TreesFillNothingInWhereverTheyStart) {
    // A chain numbered at random, and a star of chains: a block of L for each edge, no more.
    EXPECT_EQ(
        pattern_of(order_of(graph_of(6, {{3, 0}, {0, 5}, {5, 1}, {1, 4}, {4, 2}}))).rows.size(),
        5U);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> star;
    for (std::uint32_t arm = 0; arm < 5; ++arm) {
        star.emplace_back(0, 1 + arm * 3);
        star.emplace_back(1 + arm * 3, 2 + arm * 3);
        star.emplace_back(2 + arm * 3, 3 + arm * 3);
    }
    EXPECT_EQ(pattern_of(order_of(graph_of(16, star))).rows.size(), star.size());
}

TEST(BlockPattern, ALoopFillsInOneBlockAVertex) {
    // Eliminating a vertex of a ring of n joins its neighbours: n - 3 new blocks beside the n.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> ring;
    for (std::uint32_t i = 0; i < 12; ++i) ring.emplace_back(i, (i + 1) % 12);
    EXPECT_EQ(pattern_of(order_of(graph_of(12, ring))).rows.size(), 12U + 12U - 3U);
}

TEST(BlockPattern, WorkGrowsInProportionToAChain) {
    const double one = order_of(chain(100)).multiply_adds;
    EXPECT_NEAR(order_of(chain(1000)).multiply_adds / one, 10, 0.2);
}

TEST(BlockPattern, ComponentsAreRangesOfTheirOwn) {
    const EliminationOrder order = order_of(graph_of(5, {{0, 3}, {1, 4}}));
    EXPECT_EQ(order.component_begin, (std::vector<std::uint32_t>{0, 2, 4, 5}));
}

TEST(BlockPattern, GivesUpWhereAFactorWouldCostTooMuch) {
    Graph all(40);
    for (std::uint32_t a = 0; a < 40; ++a) {
        for (std::uint32_t b = 0; b < 40; ++b) {
            if (a != b) all[a].push_back(b);
        }
    }
    const std::vector<std::uint32_t> weights(40, 1);
    EXPECT_FALSE(minimum_degree_order(all, weights, 1e6).too_dear);
    EXPECT_TRUE(minimum_degree_order(all, weights, 5000).too_dear);
}

}  // namespace
}  // namespace plumbline::physics
