// The contacts of one island as rows of the small-step solver. Knows nothing of Bullet.
//
// A sub-step sweeps them twice: once with bias, which pushes overlapping bodies apart and keeps
// approaching ones from overlapping, and once after the bodies moved ("relax"), without bias, which
// takes the pushing speed out again and solves friction with impulses that only load, not push.
#pragma once

#include "engine/physics/dynamics/contact/contact_block.h"
#include "engine/physics/dynamics/softness.h"

#include <cstdint>
#include <span>
#include <vector>

namespace plumbline::physics {

class ContactSet {
public:
    std::vector<ContactBlock> blocks;

    /// Masses and the order of the sweeps. `h` is the sub-step; `push_mps` the fastest that overlap
    /// pushes bodies apart, `bounce_mps` the slowest blow that restitution acts on.
    void begin_step(std::span<SolverBody> bodies, Real h, Real push_mps, Real bounce_mps);
    /// Adds the impulses that the blocks hold to the bodies' steady change.
    void warm_start();
    void solve_with_bias();
    void relax();
    /// Adds what the blocks hold to their totals.
    void end_substep();
    /// Separations now; where a ball touches, its arms follow it.
    void place(ContactBlock& block) const;

    std::uint64_t row_solves{0};  ///< since begin_step()
    Real substep_s() const { return h_; }

private:
    void place_balls(ContactBlock& block) const;
    void solve_with_bias(ContactBlock& block);
    void relax(ContactBlock& block);
    bool carry(ContactBlock& block);
    bool rub(ContactBlock& block);
    bool resist_rolling(ContactBlock& block);

    std::span<SolverBody> bodies_;
    std::vector<std::uint32_t> order_;  ///< of blocks in a sweep
    Softness between_movable_{};
    Softness against_immovable_{};
    Real h_{0};
    Real push_mps_{3};
    Real bounce_mps_{0};
};

}  // namespace plumbline::physics
