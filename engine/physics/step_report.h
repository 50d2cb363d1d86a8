// What the latest step of a world did, what it cost, and what it left.
#pragma once

#include "engine/physics/contact.h"
#include "engine/physics/joint.h"

#include <cstdint>
#include <string_view>
#include <vector>

namespace plumbline::physics {

/// What the latest step did to motion beside solving for it. small_step only, but for the speed
/// limit, crowds and islands too large for a matrix.
struct Interventions {
    double braked_J{0};               ///< that the energy guard took out
    std::uint32_t braked_islands{0};  ///< from so many islands
    std::uint32_t clamped_bodies{
        0};  ///< that penetration pushed out too fast, and that were slowed
    std::uint32_t unresolved_islands{0};  ///< whose joints swung too fast for a sub-step: damped
    std::uint32_t restored_islands{0};    ///< without a sane state: stand as before the step
    std::uint32_t limited_bodies{0};      ///< at the speed limit of the world
    std::uint32_t impacts{0};             ///< contacts that bounced
    std::uint32_t oversized_islands{0};   ///< bullet_dantzig and bullet_pgs: swept, as by bullet_si
    std::uint64_t left_out_pairs{0};      ///< of crowded bodies, for others that were nearer

    void add(const Interventions& more);
};

/// CPU time of all threads and work of the latest step, by phase.
struct StepCost {
    double broad_ms{0};
    double narrow_ms{0};
    double solve_ms{0};
    double integrate_ms{0};
    double total_ms{0};           ///< whole step; the rest is "other"
    double helpers_ms{0};         ///< of it on other threads than the caller's
    double wall_ms{0};            ///< from its start to its end
    std::uint64_t row_solves{0};  ///< constraint rows times sweeps: work without a clock
    std::uint32_t contacts{0};    ///< contact points
    std::uint32_t belts{0};       ///< small_step: manifolds on belts, for each part of a step
    std::uint32_t pairs{0};       ///< small_step: pairs of bodies tested for contact points
    Interventions interventions{};
};

/// How often the optional parts of the latest step really ran.
struct FeatureUse {
    std::uint32_t swept_bodies{0};  ///< continuous collision
    std::uint32_t gyro_bodies{0};   ///< gyroscopic torque
    BodyId swept{};                 ///< the first of them
    BodyId turned{};
    std::uint32_t events{0};  ///< contact events listed
    double sweep_ms{0};
    double gyro_ms{0};
    double events_ms{0};
};

/// Who got how many sub-steps in the latest step, and why. small_step only.
struct IslandReport {
    std::uint64_t user{0};  ///< mark of its first body
    std::uint32_t bodies{0};
    std::uint32_t contacts{0};  ///< points
    std::uint32_t joints{0};
    int substeps{0};
    std::string_view
        reason;  ///< "least", "load", "height", "turning", "field", "error", "held", "fixed"
};

/// All of it; the next step overwrites it.
struct StepReport {
    StepCost cost{};
    FeatureUse use{};
    /// Touching pairs, in a reproducible order. Those that sleep are listed as they fell asleep.
    std::vector<ContactEvent> contacts{};
    /// Islands that were solved, in the order of their first bodies. small_step only.
    std::vector<IslandReport> islands{};
    /// Joints that broke, in the order of their ids. They stay, and carry nothing, until destroyed.
    std::vector<JointId> broken_joints{};
    /// Every body isolated so far for a non-finite state, in the order it happened.
    std::vector<BodyId> isolated{};
};

}  // namespace plumbline::physics
