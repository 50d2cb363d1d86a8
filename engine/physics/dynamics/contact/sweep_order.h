// In which order a sweep solves an island's constraints, and which of them may be solved at once.
//
// Few: pairs that move in the order of their bodies, then those that something immovable bounds. Many: the island's bodies
// are halved again and again by their numbers, as those that were made one after the other mostly lie side by side (nested
// dissection; George, Nested dissection of a regular finite element mesh, 1973). Constraints within a cell come first, then
// those between the cells of each cut, the smallest first, and those of immovable bodies last. Parts of one stage share
// no body that moves: what is solved does not depend on who solves them when.
#pragma once

#include "engine/physics/dynamics/contact/contact_constraint.h"

#include <cstdint>
#include <span>
#include <vector>

namespace plumbline::physics {

/// A constraint and what tells whether a sweep passes it by.
struct SweepPlace {
    std::uint32_t constraint;
    std::uint32_t a;
    std::uint32_t b;
    bool jointed;
};

class SweepOrder {
public:
    /// Of constraints between `bodies`; by these two alone, however many threads there are.
    void build(std::span<const ContactConstraint> constraints, std::span<const SolverBody> bodies);

    /// Stages come one after the other; parts of one stage in any order or at once.
    std::size_t stages() const { return static_cast<std::size_t>(cuts_) + 2; }
    std::span<const std::span<const SweepPlace>> parts(std::size_t stage) const;

    /// Each body is of one cell, and so is each constraint: who solves a cell's parts in a sweep finds them near when it
    /// does something else with them.
    std::size_t cells() const { return std::size_t{1} << cuts_; }
    std::span<const std::uint32_t> bodies_of(std::size_t cell) const;
    /// Calls `work` with the parts whose constraints are the cell's.
    template <typename Work>
    void each_part_of(std::size_t cell, const Work& work) const {
        for (int height = 0; height <= cuts_; ++height) {
            if (cell % (std::size_t{1} << height) == 0)
                work(parts_[first_part(height) + (cell >> height)]);
        }
        work(parts_[first_part(cuts_) + 1 + cell]);
    }

private:
    void count_parts(std::span<const ContactConstraint> constraints,
                     std::span<const SolverBody> bodies);
    void number_cells(std::span<const SolverBody> bodies);
    std::size_t part_of(const ContactConstraint& constraint, bool against_immovable) const;
    /// Of those between `height` cuts, counted from the cells.
    std::size_t first_part(int height) const { return 2 * cells() - (2 * cells() >> height); }

    int cuts_{0};                         ///< of the island, one after the other: 2^cuts_ cells
    std::vector<std::uint32_t> cells_;    ///< of each body
    std::vector<std::uint32_t> sorted_;   ///< bodies, cell by cell
    std::vector<std::size_t> cell_ends_;  ///< in sorted_
    std::vector<std::uint32_t> part_;     ///< of each constraint
    std::vector<std::size_t> part_ends_;  ///< in places_
    std::vector<SweepPlace> places_;      ///< part by part
    std::vector<std::span<const SweepPlace>> parts_;  ///< stage by stage
};

}  // namespace plumbline::physics
