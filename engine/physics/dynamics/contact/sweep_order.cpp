#include "engine/physics/dynamics/contact/sweep_order.h"

#include <algorithm>
#include <bit>
#include <numeric>

namespace plumbline::physics {
namespace {

/// Fewer are solved sooner by one thread: what cores tell each other takes as long as some of them.
constexpr std::size_t kFewConstraints = 4096;
constexpr std::size_t kConstraintsOfCell = 256;
constexpr int kMostHalvings = 10;
/// With more of the constraints between the first two halves these have too little of their own.
constexpr double kMostBetweenHalves = 0.25;

int cuts_for(std::size_t constraints) {
    if (constraints < kFewConstraints) return 0;
    return std::min(static_cast<int>(std::bit_width(constraints / kConstraintsOfCell)) - 1,
                    kMostHalvings);
}

}  // namespace

void SweepOrder::build(std::span<const ContactConstraint> constraints,
                       std::span<const SolverBody> bodies) {
    cuts_ = cuts_for(constraints.size());
    count_parts(constraints, bodies);
    const std::size_t root = first_part(cuts_);
    const auto between_halves = static_cast<double>(part_ends_[root + 1]);
    if (cuts_ > 0 &&
        between_halves > kMostBetweenHalves * static_cast<double>(constraints.size())) {
        cuts_ = 0;
        count_parts(constraints, bodies);
    }
    std::partial_sum(part_ends_.begin(), part_ends_.end(), part_ends_.begin());
    places_.resize(constraints.size());
    for (std::uint32_t i = 0; i < constraints.size(); ++i) {
        const ContactConstraint& of = constraints[i];
        places_[part_ends_[part_[i]]++] = {
            i, of.a, of.b, bodies[of.a].jointed || bodies[of.b].jointed};
    }
    parts_.clear();
    std::size_t begin = 0;
    for (std::size_t part = 0; part + 1 < 3 * cells(); ++part) {
        parts_.push_back(std::span(places_).subspan(begin, part_ends_[part] - begin));
        begin = part_ends_[part];
    }
}

std::span<const std::span<const SweepPlace>> SweepOrder::parts(std::size_t stage) const {
    const auto height = static_cast<int>(stage);
    if (height > cuts_) return std::span(parts_).subspan(first_part(cuts_) + 1, cells());
    return std::span(parts_).subspan(first_part(height), cells() >> height);
}

std::span<const std::uint32_t> SweepOrder::bodies_of(std::size_t cell) const {
    const std::size_t begin = cell == 0 ? 0 : cell_ends_[cell - 1];
    return std::span(sorted_).subspan(begin, cell_ends_[cell] - begin);
}

/// In part_ends_: how many constraints the part before has.
void SweepOrder::count_parts(std::span<const ContactConstraint> constraints,
                             std::span<const SolverBody> bodies) {
    number_cells(bodies);
    part_.clear();
    part_ends_.assign(3 * cells(), 0);
    for (const ContactConstraint& of : constraints) {
        const bool immovable = !bodies[of.a].movable() || !bodies[of.b].movable();
        part_.push_back(static_cast<std::uint32_t>(part_of(of, immovable)));
        ++part_ends_[part_.back() + 1];
    }
}

/// What does not move is of the first cell.
void SweepOrder::number_cells(std::span<const SolverBody> bodies) {
    cells_.assign(bodies.size(), 0);
    sorted_.clear();
    const auto add = [&](bool movable) {
        for (std::uint32_t i = 0; i < bodies.size(); ++i) {
            if (bodies[i].movable() == movable) sorted_.push_back(i);
        }
    };
    add(false);
    const std::size_t first = sorted_.size();
    add(true);
    cell_ends_.clear();
    for (std::uint32_t cell = 0; cell < cells(); ++cell) {
        const std::size_t begin = cell == 0 ? first : cell_ends_.back();
        cell_ends_.push_back(first + (sorted_.size() - first) * (cell + 1) / cells());
        for (std::size_t i = begin; i < cell_ends_.back(); ++i) cells_[sorted_[i]] = cell;
    }
}

/// Those within a cell, then between cells that were one before the last cut, and so on, then those of what is immovable.
std::size_t SweepOrder::part_of(const ContactConstraint& constraint, bool against_immovable) const {
    if (against_immovable) return first_part(cuts_) + 1 + cells_[constraint.a];
    const std::uint32_t differ = cells_[constraint.a] ^ cells_[constraint.b];
    const auto height = static_cast<int>(std::bit_width(differ));
    return first_part(height) + (cells_[constraint.a] >> height);
}

}  // namespace plumbline::physics
