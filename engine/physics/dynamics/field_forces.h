// What the fields of a step do to the bodies of one island, sub-step by sub-step.
#pragma once

#include "engine/physics/dynamics/solver_body.h"
#include "engine/physics/force_field.h"

#include <cstdint>
#include <span>
#include <vector>

namespace plumbline::physics {

/// Done by fields in a step.
struct FieldWork {
    double work_J{0};
    Vec3d impulse_Ns{0, 0, 0};
};

class FieldForces {
public:
    /// Forgets the island. `fields` outlive the step; at most kMostFields of them.
    void begin_island(std::span<ForceField* const> fields);
    /// `body`: its index in the island. `mask`: bit i says that field i acts on it.
    void add(std::uint32_t body, BodyId id, std::uint32_t mask);
    bool empty() const { return members_.empty(); }

    /// Adds to the increments of the bodies, which hold what else acts in the sub-step.
    void push(std::span<SolverBody> bodies, const FieldTime& time);
    /// After the bodies have moved: counts what was done to them.
    void count(std::span<const SolverBody> bodies);
    const FieldWork& work() const { return work_; }

private:
    struct Member {
        std::uint32_t body{0};
        std::uint32_t mask{0};
        BodyInField state{};
    };
    std::span<ForceField* const> fields_;
    std::vector<Member> members_;
    std::vector<BodyInField*> states_;  ///< of the members
    std::vector<std::uint32_t> masks_;
    FieldWork work_{};
};

/// Which of the fields act on the body.
std::uint32_t field_mask(std::span<ForceField* const> fields, BodyId id);

/// One sub-step's pushes on bodies that are in the middle of it already: velocities of `bodies` are changed, too.
void act_on_all(std::span<ForceField* const> fields,
                std::span<BodyInField* const> bodies,
                std::span<const std::uint32_t> masks,
                const FieldTime& time);

}  // namespace plumbline::physics
