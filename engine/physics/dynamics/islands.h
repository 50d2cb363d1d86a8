// Which bodies push each other: islands by union-find.
#pragma once

#include "engine/core/disjoint_sets.h"
#include "engine/physics/dynamics/island.h"

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace plumbline::physics {

/// A body that may pass something unseen in this step, and what it will meet first.
struct SweptPath {
    BodyRecord* body{nullptr};
    BodyRecord* meets{nullptr};  ///< none: nothing; itself: who knows
    bool after_impact{false};    ///< `meets` is only what it may meet after its first impact
};

/// What the fields of a step tie together. A body with a bit of BodyRecord's `small.fields` is held by a field.
struct FieldTies {
    std::span<const std::pair<BodyRecord*, BodyRecord*>> pairs{};
    std::uint32_t carrying{0};  ///< fields that bodies may rest on, a bit each
};

/// Builds a step's islands and keeps their memory for the next step.
class IslandBuilder {
public:
    /// `bodies` are the awake dynamic ones in the order of their ids; `manifolds` touch at least
    /// one of them; `joints` hold at least one of them; `swept` are some of them. Orders are kept
    /// within each island; islands come by their first body.
    void build(std::span<BodyRecord* const> bodies,
               std::span<Manifold* const> manifolds,
               std::span<JointRecord* const> joints,
               std::span<const SweptPath> swept = {},
               const FieldTies& fields = {});

    std::span<Island> islands() { return {islands_.data(), count_}; }
    /// Bodies that nothing touches or holds, in the order of their ids.
    std::span<BodyRecord* const> free_bodies() const { return free_; }

private:
    Island& island_of(std::uint32_t body);
    void tie(std::span<BodyRecord* const> bodies,
             std::span<Manifold* const> manifolds,
             std::span<JointRecord* const> joints,
             std::span<const SweptPath> swept,
             const FieldTies& fields);
    void tie_what_may_follow(std::span<const SweptPath> swept);
    void note_partner(std::uint32_t body, const BodyRecord* partner);

    DisjointSets sets_;
    std::vector<std::uint8_t> held_;     ///< by body: touched or joined
    std::vector<std::uint32_t> size_;    ///< by body that stands for a set: how many are in it
    std::vector<std::uint32_t> number_;  ///< by body that stands for a set: of its island
    std::vector<Island> islands_;        ///< more than count_ of them, to keep their memory
    std::size_t count_{0};
    std::vector<BodyRecord*> free_;
};

/// Undoes a step that left a body of the island with numbers that are not finite, or farther away
/// than the speed limit takes it: all bodies get their poses back and half of their velocities, and
/// contacts and joints forget their loads. Returns whether the step was undone.
bool restore_if_invalid(const Island& island, Real step_s);

}  // namespace plumbline::physics
