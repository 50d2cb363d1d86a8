#include "engine/physics/dynamics/joint/block/block_ldlt.h"

#include <algorithm>

namespace plumbline::physics {
namespace {

/// d -= l * a^T, of which the result is known to be symmetric.
void subtract_product(Symmetric3& d, const Block3& l, const Block3& a) {
    d.xx -= glm::dot(l.row[0], a.row[0]);
    d.xy -= glm::dot(l.row[0], a.row[1]);
    d.xz -= glm::dot(l.row[0], a.row[2]);
    d.yy -= glm::dot(l.row[1], a.row[1]);
    d.yz -= glm::dot(l.row[1], a.row[2]);
    d.zz -= glm::dot(l.row[2], a.row[2]);
}

}  // namespace

void BlockLdlt::fit(const BlockPattern& pattern) {
    pattern_ = &pattern;
    const auto grow = [](auto& list, std::size_t size) {
        if (list.size() < size) list.resize(size);
    };
    grow(diagonal, pattern.columns);
    grow(pivots_, pattern.columns);
    grow(inverse_, pattern.columns);
    grow(below, pattern.rows.size());
    grow(lower_, pattern.rows.size());
}

void BlockLdlt::clear_below(std::uint32_t first, std::uint32_t last) {
    std::fill(
        below.begin() + pattern_->begin[first], below.begin() + pattern_->begin[last], Block3{});
}

void BlockLdlt::factor(std::uint32_t first, std::uint32_t last, std::span<const double> floor) {
    for (std::uint32_t k = first; k < last; ++k) {
        pivots_[k] = factored(diagonal[k], floor[k]);
        inverse_[k] = pivots_[k].inverse();
        eliminate(k);
    }
}

Vec3d BlockLdlt::divided(std::uint32_t column, const Vec3d& v) const {
    return pivots_[column].cancelled ? pivots_[column].substitute(v) : inverse_[column] * v;
}

void BlockLdlt::eliminate(std::uint32_t column) {
    const std::uint32_t begin = pattern_->begin[column];
    const std::uint32_t end = pattern_->begin[column + 1];
    const std::uint32_t* target = pattern_->targets.data() + pattern_->target_begin[column];
    for (std::uint32_t p = begin; p < end; ++p) {
        Block3 l;
        for (std::size_t i = 0; i < 3; ++i) l.row[i] = divided(column, below[p].row[i]);
        lower_[p] = l;
        subtract_product(diagonal[pattern_->rows[p]], l, below[p]);
        for (std::uint32_t q = begin; q < p; ++q, ++target) {
            subtract(below[*target], times_transposed(l, below[q]));
        }
    }
}

void BlockLdlt::solve(std::uint32_t first, std::uint32_t last, std::span<Vec3d> x) const {
    const BlockPattern& pattern = *pattern_;
    for (std::uint32_t k = first; k < last; ++k) {
        const Vec3d value = x[k];
        for (std::uint32_t p = pattern.begin[k]; p < pattern.begin[k + 1]; ++p) {
            x[pattern.rows[p]] -= lower_[p] * value;
        }
        x[k] = divided(k, value);
    }
    for (std::uint32_t k = last; k-- > first;) {
        Vec3d value = x[k];
        for (std::uint32_t p = pattern.begin[k]; p < pattern.begin[k + 1]; ++p) {
            value -= lower_[p].transposed_times(x[pattern.rows[p]]);
        }
        x[k] = value;
    }
}

}  // namespace plumbline::physics
