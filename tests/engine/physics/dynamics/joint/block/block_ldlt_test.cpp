#include "engine/physics/dynamics/joint/block/block_ldlt.h"

#include "tests/engine/physics/dynamics/joint/block/block_graphs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace plumbline::physics {
namespace {

/// A random matrix of the graph that is positive by being heavy on its diagonal.
struct Sample {
    BlockPattern pattern;
    BlockLdlt matrix;
    std::vector<double> floor;
    std::vector<Vec3d> solution;
    std::vector<Vec3d> right_side;

    explicit Sample(const Graph& graph) {
        const EliminationOrder order = order_of(graph);
        pattern = pattern_of(order);
        matrix.fit(pattern);
        matrix.clear_below(0, pattern.columns);
        floor.assign(pattern.columns, 1e-12);
        std::mt19937 random(7);
        std::uniform_real_distribution<double> number(-1, 1);
        const auto any = [&] { return Vec3d{number(random), number(random), number(random)}; };
        for (std::uint32_t k = 0; k < pattern.columns; ++k) {
            matrix.diagonal[k] = {30 + number(random),
                                  number(random),
                                  number(random),
                                  30 + number(random),
                                  number(random),
                                  30 + number(random)};
            solution.push_back(any());
        }
        right_side.assign(pattern.columns, Vec3d{0, 0, 0});
        for (std::uint32_t k = 0; k < pattern.columns; ++k) {
            right_side[k] += matrix.diagonal[k] * solution[k];
        }
        std::vector<std::uint32_t> column(order.order.size());
        for (std::uint32_t i = 0; i < order.order.size(); ++i) column[order.order[i]] = i;
        for (std::uint32_t a = 0; a < graph.size(); ++a) {
            for (const std::uint32_t b : graph[a]) {
                if (column[a] < column[b]) continue;
                Block3& block = matrix.below[pattern.block_at(column[a], column[b])];
                block = {{any(), any(), any()}};
                right_side[column[a]] += block * solution[column[b]];
                right_side[column[b]] += block.transposed_times(solution[column[a]]);
            }
        }
    }

    double largest_error() {
        matrix.factor(0, pattern.columns, floor);
        std::vector<Vec3d> x = right_side;
        matrix.solve(0, pattern.columns, x);
        double most = 0;
        for (std::size_t i = 0; i < x.size(); ++i) {
            most = std::max(most, glm::length(x[i] - solution[i]));
        }
        return most;
    }
};

TEST(BlockLdlt, SolvesChainsTreesLoopsAndGrids) {
    EXPECT_LT(Sample(chain(1)).largest_error(), 1e-13);
    EXPECT_LT(Sample(chain(40)).largest_error(), 1e-13);
    EXPECT_LT(Sample(graph_of(7, {{0, 1}, {0, 2}, {1, 3}, {1, 4}, {2, 5}, {2, 6}})).largest_error(),
              1e-13);
    EXPECT_LT(Sample(graph_of(5, {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 0}})).largest_error(), 1e-13);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> grid;
    for (std::uint32_t y = 0; y < 8; ++y) {
        for (std::uint32_t x = 0; x < 8; ++x) {
            if (x < 7) grid.emplace_back(y * 8 + x, y * 8 + x + 1);
            if (y < 7) grid.emplace_back(y * 8 + x, y * 8 + x + 8);
        }
    }
    EXPECT_LT(Sample(graph_of(64, grid)).largest_error(), 1e-13);
}

TEST(Block3, InverseIsTheInverseEvenWhenNearlySingular) {
    const Symmetric3 a{4, 1, -2, 3, 0.5, 5};
    const Symmetric3 b = factored(a, 1e-12).inverse();
    const Vec3d v{1, -2, 3};
    EXPECT_NEAR(glm::length(a * (b * v) - v), 0, 1e-14);
    // Rank one but for 1e-9 on the diagonal: finite, and exact in the direction that matters.
    const Symmetric3 poor{1 + 1e-9, 1, 1, 1 + 1e-9, 1, 1 + 1e-9};
    const Vec3d x = factored(poor, 5e-10).inverse() * Vec3d{3, 3, 3};
    EXPECT_NEAR(x.x + x.y + x.z, 3, 1e-5);
}

TEST(Block3, SmallTurnIsTheExponentialMap) {
    for (const double angle : {0.0, 1e-9, 1e-3, 0.05, 0.0999, 0.1001, 1.0, 3.0}) {
        const Vec3d axis = glm::normalize(Vec3d{1, 2, -2});
        const Quatd exact{std::cos(angle / 2), std::sin(angle / 2) * axis};
        const Quatd got = small_turn(axis * angle);
        EXPECT_NEAR(std::abs(exact.w - got.w) + std::abs(exact.x - got.x), 0, 1e-14) << angle;
    }
}

}  // namespace
}  // namespace plumbline::physics
