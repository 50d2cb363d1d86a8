// All islands of a step, on as many threads as the world has. Results do not depend on their number.
//
// Islands share nothing that moves, so that any threads solve them at once; those of many contacts come one after the other
// with all threads inside (SweepOrder). An island whose bodies are swept, that a moving kinematic body bounds or
// that a force field acts on reads or moves what others see: it is solved alone, in its turn.
#pragma once

#include "engine/core/io/archive.h"
#include "engine/physics/dynamics/island_parts.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace plumbline::physics {

class IslandTeam {
public:
    /// `points` outlives it.
    explicit IslandTeam(IslandPoints& points) : points_(points) {}

    void set_step(const CollideStep& step) { step_ = step; }
    /// Which step it was.
    void serialize(Archive& archive) { archive(steps_); }
    /// `step` gets its number; its team shares the work where there is one. A result for each island, in their order, until the next call.
    std::span<const IslandResult> solve(std::span<Island> islands, IslandStep step);

private:
    /// Scratch memory of one thread.
    struct Member {
        explicit Member(IslandPoints& points) : parts(points, solver) {}
        IslandSolver solver;
        IslandParts parts;
    };
    void solve_at_once(std::span<Island> islands,
                       std::span<IslandResult> results,
                       const IslandStep& step);
    IslandResult solve_one(Island& island, const IslandStep& step, std::size_t member);

    IslandPoints& points_;
    CollideStep step_{};
    std::uint64_t steps_{0};
    std::vector<std::unique_ptr<Member>> members_;
    std::vector<IslandResult> results_;
    std::vector<std::uint32_t> small_;
};

}  // namespace plumbline::physics
