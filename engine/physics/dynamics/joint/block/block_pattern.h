// Which 3x3 blocks of a sparse factor L are not zero, and in which order to eliminate.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace plumbline::physics {

/// An order of elimination for a graph and the neighbours each vertex has left at its turn, those
/// that its elimination joins included: the columns of L.
struct EliminationOrder {
    std::vector<std::uint32_t> order;               ///< vertices, first eliminated first
    std::vector<std::vector<std::uint32_t>> later;  ///< by vertex; ascending
    std::vector<std::uint32_t> component_begin;     ///< in `order`; one past the last as well
    double multiply_adds{0};                        ///< of blocks, in one factorisation
    bool too_dear{false};                           ///< stopped: the rest is not valid
};

/// Minimum degree, one connected component after the other. `weights`
/// are the blocks a vertex stands for. Gives up once more than `most_multiply_adds` are needed.
EliminationOrder minimum_degree_order(std::vector<std::vector<std::uint32_t>> neighbours,
                                      std::span<const std::uint32_t> weights,
                                      double most_multiply_adds);

/// The blocks of L below the diagonal by columns, numbered in the order of elimination.
struct BlockPattern {
    std::uint32_t columns{0};
    std::vector<std::uint32_t> begin;  ///< of each column in `rows`; columns + 1 of them
    std::vector<std::uint32_t> rows;   ///< ascending within a column
    /// For each column and each pair p > q of its rows, in the order (1,0) (2,0) (2,1) (3,0)...:
    /// the block at (row p, column row q), which the column's elimination changes.
    std::vector<std::uint32_t> targets;
    std::vector<std::uint32_t> target_begin;  ///< of each column in `targets`

    /// `later` of each column must hold what its elimination fills in.
    static BlockPattern from_columns(std::span<const std::vector<std::uint32_t>> later);
    /// The index of the block at (row, column), row > column, which must be there.
    std::uint32_t block_at(std::uint32_t row, std::uint32_t column) const;
};

}  // namespace plumbline::physics
