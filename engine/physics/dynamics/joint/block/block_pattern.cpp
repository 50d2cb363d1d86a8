#include "engine/physics/dynamics/joint/block/block_pattern.h"

#include "engine/core/assert.h"

#include <algorithm>
#include <compare>
#include <set>
#include <utility>

namespace plumbline::physics {
namespace {

using Neighbours = std::vector<std::vector<std::uint32_t>>;

/// Eliminates vertices of one component after the other.
class Elimination {
public:
    Elimination(Neighbours neighbours, std::span<const std::uint32_t> weights)
        : neighbours_(std::move(neighbours)), weights_(weights), places_(neighbours_.size()) {}

    EliminationOrder run(double most_multiply_adds) {
        const auto count = static_cast<std::uint32_t>(neighbours_.size());
        result_.later.resize(count);
        std::vector<bool> seen(count, false);
        for (std::uint32_t i = 0; i < count && !result_.too_dear; ++i) {
            if (seen[i]) continue;
            result_.component_begin.push_back(static_cast<std::uint32_t>(result_.order.size()));
            queue_component(i, seen);
            while (!queue_.empty() && !result_.too_dear) {
                eliminate(queue_.begin()->vertex);
                result_.too_dear = result_.multiply_adds > most_multiply_adds;
            }
        }
        result_.component_begin.push_back(static_cast<std::uint32_t>(result_.order.size()));
        return std::move(result_);
    }

private:
    /// Of equals, the one whose neighbourhood has not changed for longest goes first: a chain is
    /// eliminated from both ends, in two strands that a processor works on at the same time.
    struct Place {
        std::uint32_t degree{0};
        std::uint32_t changed{0};
        std::uint32_t vertex{0};
        auto operator<=>(const Place&) const = default;
    };

    std::uint32_t degree_of(std::uint32_t vertex) const {
        std::uint32_t sum = 0;
        for (const std::uint32_t other : neighbours_[vertex]) sum += weights_[other];
        return sum;
    }

    void queue_component(std::uint32_t first, std::vector<bool>& seen) {
        std::vector<std::uint32_t> reached{first};
        seen[first] = true;
        for (std::size_t i = 0; i < reached.size(); ++i) {
            const std::uint32_t vertex = reached[i];
            places_[vertex] = {degree_of(vertex), 0, vertex};
            queue_.insert(places_[vertex]);
            for (const std::uint32_t other : neighbours_[vertex]) {
                if (!seen[other]) reached.push_back(other);
                seen[other] = true;
            }
        }
    }

    void eliminate(std::uint32_t vertex) {
        queue_.erase(places_[vertex]);
        std::vector<std::uint32_t>& clique = neighbours_[vertex];
        double below = places_[vertex].degree;
        for (std::uint32_t i = 0; i < weights_[vertex]; ++i) {
            const double rows = below + (weights_[vertex] - 1 - i);
            result_.multiply_adds += rows + rows * (rows + 1) / 2;
        }
        for (const std::uint32_t other : clique) {
            join(other, vertex, clique);
            queue_.erase(places_[other]);
            places_[other] = {degree_of(other), ++changes_, other};
            queue_.insert(places_[other]);
        }
        result_.order.push_back(vertex);
        result_.later[vertex] = std::move(clique);
    }

    /// The neighbours of `other` without `gone`, with the rest of the clique.
    void join(std::uint32_t other, std::uint32_t gone, const std::vector<std::uint32_t>& clique) {
        merged_.clear();
        std::set_union(neighbours_[other].begin(),
                       neighbours_[other].end(),
                       clique.begin(),
                       clique.end(),
                       std::back_inserter(merged_));
        std::erase_if(merged_, [&](std::uint32_t v) { return v == other || v == gone; });
        neighbours_[other].assign(merged_.begin(), merged_.end());
    }

    Neighbours neighbours_;
    std::span<const std::uint32_t> weights_;
    std::vector<Place> places_;  // by vertex
    std::set<Place> queue_;
    std::uint32_t changes_{0};
    std::vector<std::uint32_t> merged_;
    EliminationOrder result_;
};

}  // namespace

EliminationOrder minimum_degree_order(Neighbours neighbours,
                                      std::span<const std::uint32_t> weights,
                                      double most_multiply_adds) {
    for (std::vector<std::uint32_t>& list : neighbours) std::ranges::sort(list);
    return Elimination(std::move(neighbours), weights).run(most_multiply_adds);
}

BlockPattern BlockPattern::from_columns(std::span<const std::vector<std::uint32_t>> later) {
    BlockPattern pattern;
    pattern.columns = static_cast<std::uint32_t>(later.size());
    for (const std::vector<std::uint32_t>& rows : later) {
        pattern.begin.push_back(static_cast<std::uint32_t>(pattern.rows.size()));
        pattern.rows.insert(pattern.rows.end(), rows.begin(), rows.end());
    }
    pattern.begin.push_back(static_cast<std::uint32_t>(pattern.rows.size()));
    for (const std::vector<std::uint32_t>& rows : later) {
        pattern.target_begin.push_back(static_cast<std::uint32_t>(pattern.targets.size()));
        for (std::size_t p = 1; p < rows.size(); ++p) {
            for (std::size_t q = 0; q < p; ++q) {
                pattern.targets.push_back(pattern.block_at(rows[p], rows[q]));
            }
        }
    }
    return pattern;
}

std::uint32_t BlockPattern::block_at(std::uint32_t row, std::uint32_t column) const {
    const auto first = rows.begin() + begin[column];
    const auto last = rows.begin() + begin[column + 1];
    const auto found = std::lower_bound(first, last, row);
    PL_ASSERT(found != last && *found == row, "a block of the pattern");
    return static_cast<std::uint32_t>(found - rows.begin());
}

}  // namespace plumbline::physics
