// A sparse symmetric positive matrix of 3x3 blocks, factored as L D L^T.
#pragma once

#include "engine/physics/dynamics/joint/block/block3.h"
#include "engine/physics/dynamics/joint/block/block_pattern.h"

namespace plumbline::physics {

/// Fill in `diagonal` and `below`, then factor() and solve(). Connected components are ranges of
/// columns and may be factored and solved each for itself. The memory stays with the object.
class BlockLdlt {
public:
    std::vector<Symmetric3> diagonal;  ///< of the matrix; factor() overwrites it
    std::vector<Block3> below;         ///< as pattern.rows; factor() overwrites it

    /// Room for the pattern, which must outlive the use.
    void fit(const BlockPattern& pattern);
    /// Zeroes the blocks below the diagonal of the columns first to last - 1.
    void clear_below(std::uint32_t first, std::uint32_t last);
    /// The columns first to last - 1. Pivots below `floor` of their column count as that much.
    void factor(std::uint32_t first, std::uint32_t last, std::span<const double> floor);
    /// Solves for these columns in place.
    void solve(std::uint32_t first, std::uint32_t last, std::span<Vec3d> x) const;

private:
    void eliminate(std::uint32_t column);
    /// The inverse of the column's pivot times v.
    Vec3d divided(std::uint32_t column, const Vec3d& v) const;

    const BlockPattern* pattern_{nullptr};
    std::vector<Factored3> pivots_;
    std::vector<Symmetric3> inverse_;  // of the pivots; unused where a row of them cancelled
    std::vector<Block3> lower_;        // L below its unit diagonal
};

}  // namespace plumbline::physics
