#include "engine/physics/world/pair_walk.h"

#include "engine/physics/world/body_record.h"

#include <algorithm>

namespace plumbline::physics {
namespace {

/// An impact is handed on from body to body at most so often within a step.
constexpr int kImpactRounds = 16;

/// The pairs with points, in order.
void list_met(std::span<BodyRecord* const> bodies, std::vector<Pair*>& met) {
    met.clear();
    for (const BodyRecord* record : bodies) {
        for (const PairLink& link : record->small.pairs) {
            if (!link.pair->touches) continue;
            const bool listed = link.other < record->id && pushable(partner(*link.pair, *record));
            if (!listed) met.push_back(link.pair);
        }
    }
}

void list_manifolds(Pair& pair, std::vector<Manifold*>& list) {
    for (Manifold& manifold : pair.manifolds) {
        if (!manifold.points.empty()) list.push_back(&manifold);
    }
}

}  // namespace

std::uint32_t PairWalk::collide(AwakeBodies& bodies, std::vector<Manifold*>& touching) {
    ++number_;
    looks_ = 0;
    nearest_.begin_step();
    met_.clear();
    struck_.clear();
    if (nearest_.needed()) complete_crowds(bodies);
    for (BodyRecord* record : bodies.dynamic()) look_at(*record, bodies);
    for (BodyRecord* record : bodies.kinematic()) look_at(*record, bodies);
    // What was woken looks at its own pairs, which may wake more.
    bool met_in_order = true;
    std::size_t looked = 0;
    do {
        for (; looked < bodies.woken().size(); ++looked) {
            BodyRecord& woken = *bodies.woken()[looked];
            if (woken.crowd != nullptr) nearest_.complete(woken);
            look_at(woken, bodies);
        }
        if (!struck_.empty()) met_in_order = false;
    } while (spread_impacts(bodies) || looked < bodies.woken().size());
    if (bodies.admit_woken()) met_in_order = false;
    if (!met_in_order) list_met(bodies.dynamic(), met_);
    for (Pair* pair : met_) list_manifolds(*pair, touching);
    return looks_;
}

void PairWalk::complete_crowds(const AwakeBodies& bodies) {
    for (const auto moving : {bodies.dynamic(), bodies.kinematic()}) {
        for (BodyRecord* record : moving) {
            if (record->crowd != nullptr) nearest_.complete(*record);
        }
    }
}

void PairWalk::look_at(BodyRecord& body, AwakeBodies& bodies) {
    for (std::size_t i = 0; i < body.small.pairs.size();) {
        Pair& pair = *body.small.pairs[i].pair;
        if (pair.seen == number_ || keep(pair, bodies))
            ++i;
        else
            engine_.drop(pair);
    }
}

/// Looks at the pair, once a walk. Whether it goes on being one.
bool PairWalk::keep(Pair& pair, AwakeBodies& bodies) {
    pair.seen = number_;
    if (!boxes_overlap(pair)) {
        if (pair.touches) collider_.separate(pair);
        return !boxes_are_far(pair);
    }
    if (!nearest_.take(*pair.a, *pair.b)) return false;
    look(pair, bodies);
    if (pair.touches) met_.push_back(&pair);
    return true;
}

void PairWalk::look(Pair& pair, AwakeBodies& bodies) {
    ++looks_;
    collider_.collide(pair, step_);
    if (!pair.touches) return;
    if (sleeps(*pair.a)) bodies.wake(*pair.a);
    if (sleeps(*pair.b)) bodies.wake(*pair.b);
    const PairImpact impact = impact_of(pair, step_);
    note_impact(*pair.a, impact.on_a);
    note_impact(*pair.b, impact.on_b);
}

/// Every body hands its impact on once.
void PairWalk::note_impact(BodyRecord& record, const PredictedChange& impact) {
    const Vec3& known = record.small.predicted.change_mps;
    if (record.small.predicted.spread ||
        glm::dot(impact.change_mps, impact.change_mps) <= glm::dot(known, known)) {
        return;
    }
    if (known == Vec3{0, 0, 0}) struck_.push_back(&record);
    record.small.predicted = impact;
}

/// Looks again, farther, at the pairs of bodies that were struck. Whether any was.
bool PairWalk::spread_impacts(AwakeBodies& bodies) {
    if (struck_.empty()) return false;
    for (int round = 0; round < kImpactRounds && !struck_.empty(); ++round) {
        std::swap(spreading_, struck_);
        struck_.clear();
        std::sort(spreading_.begin(), spreading_.end(), by_id);
        for (BodyRecord* record : spreading_) record->small.predicted.spread = true;
        for (BodyRecord* record : spreading_) {
            for (const PairLink& link : record->small.pairs) {
                if (boxes_overlap(*link.pair) && knows_less(*link.pair, step_) &&
                    nearest_.takes_part(*link.pair->a, *link.pair->b))
                    look(*link.pair, bodies);
            }
        }
    }
    struck_.clear();
    return true;
}

}  // namespace plumbline::physics
