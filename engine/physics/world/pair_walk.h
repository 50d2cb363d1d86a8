// What touches what in a step of small_step, and who wakes by it.
#pragma once

#include "engine/core/threads/team.h"
#include "engine/physics/bullet/contact/nearest_pairs.h"
#include "engine/physics/bullet/engine.h"
#include "engine/physics/collision/pair_reach.h"
#include "engine/physics/dynamics/island_parts.h"
#include "engine/physics/world/awake_bodies.h"

#include <cstdint>
#include <vector>

namespace plumbline::physics {

/// Walks the pairs of the bodies that move: what sleeps costs nothing.
class PairWalk : public IslandPoints {
public:
    explicit PairWalk(BulletEngine& engine) : engine_(engine), nearest_(engine.nearest_pairs()) {}

    /// Of the steps from now on.
    void set_step(const CollideStep& step) { step_ = step; }
    /// Finds contact points. Touched bodies wake, and their pairs are visited too. `touching` gets the
    /// manifolds that have points, each awake body's pairs in the order of the other's id, a pair of
    /// two awake ones at the lower. `team` shares the work; null: nobody. Returns how often a pair was tested.
    std::uint32_t collide(AwakeBodies& bodies, std::vector<Manifold*>& touching, Team* team);
    void collide_again(std::span<BodyRecord* const> bodies,
                       const CollideStep& step,
                       std::vector<Manifold*>& manifolds) override;
    /// Finds the points of what has been woken since collide(), and lists all anew.
    void collide_woken(AwakeBodies& bodies, std::vector<Manifold*>& touching);
    void list(std::span<BodyRecord* const> bodies, std::vector<Manifold*>& manifolds) override;
    /// As collide() lists them, after a collide_again().
    void list_again(const AwakeBodies& bodies, std::vector<Manifold*>& touching);
    /// Whether which pairs take part is found out while they are asked for: by one thread at a time.
    bool crowded() const { return nearest_.needed(); }
    /// How many pairs the latest collide() left out of a crowd.
    std::uint64_t left_out() const { return nearest_.left_out(); }

private:
    void complete_crowds(const AwakeBodies& bodies);
    /// What a range of bodies' pairs showed.
    struct Found {
        std::vector<Pair*> near;      ///< tested for points
        std::vector<Pair*> touching;  ///< of these
        std::vector<Pair*> parted;    ///< to be dropped
        bool strikes{false};          ///< a touching pair may wake or drive a body

        void clear() {
            near.clear();
            touching.clear();
            parted.clear();
            strikes = false;
        }
    };
    void walk(AwakeBodies& bodies, Team* team);
    void look_at(Pair& pair, Found& found);
    void take_in(const Found& found, AwakeBodies& bodies);
    bool visit_woken(AwakeBodies& bodies);
    void take_in(const Pair& pair, AwakeBodies& bodies);
    void note_impact(BodyRecord& record, const PredictedChange& impact);
    bool spread_impacts(AwakeBodies& bodies);
    void spread_impact(Pair& pair, AwakeBodies& bodies);

    BulletEngine& engine_;
    NearestPairs& nearest_;
    CollideStep step_{};
    std::uint32_t number_{0};            ///< of the walk
    std::uint32_t tests_{0};             ///< of pairs in this walk
    std::vector<BodyRecord*> walkers_;   ///< whose pairs are looked at
    std::vector<Found> found_;           ///< of ranges of them
    std::vector<Pair*> touching_pairs_;  ///< with points
    bool foretells_{false};              ///< a body of the latest collide() has an impact
    std::vector<BodyRecord*> impacted_;
    std::vector<BodyRecord*> spreading_;
};

}  // namespace plumbline::physics
