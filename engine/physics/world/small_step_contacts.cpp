// What touches what in a step of small_step, and who wakes by it.
#include "engine/physics/world/body_record.h"
#include "engine/physics/world/small_step_world.h"

#include <algorithm>

namespace plumbline::physics {
namespace {

/// An impact is handed on from body to body at most so often within a step.
constexpr int kImpactRounds = 16;

}  // namespace

void SmallStepWorld::collide_pairs() {
    ++walk_;
    met_.clear();
    met_in_order_ = true;
    struck_.clear();
    for (BodyRecord* record : awake_) look_at(*record);
    for (BodyRecord* record : kinematic_) look_at(*record);
    // What was woken looks at its own pairs, which may wake more.
    std::size_t looked = 0;
    do {
        for (; looked < fresh_.size(); ++looked) look_at(*fresh_[looked]);
    } while (spread_impacts() || looked < fresh_.size());
    if (!fresh_.empty()) met_in_order_ = false;
    admit_fresh();
    list_touching();
}

void SmallStepWorld::look_at(BodyRecord& body) {
    for (std::size_t i = 0; i < body.small.pairs.size();) {
        Pair& pair = *body.small.pairs[i].pair;
        if (pair.seen != walk_) {
            pair.seen = walk_;
            if (boxes_overlap(pair)) {
                look(pair);
                if (pair.touches) met_.push_back(&pair);
            } else {
                if (pair.touches) collider_.separate(pair);
                if (boxes_are_far(pair)) {
                    parts_.engine.drop(pair);
                    continue;
                }
            }
        }
        ++i;
    }
}

void SmallStepWorld::look(Pair& pair) {
    ++cost.pairs;
    collider_.collide(pair);
    if (!pair.touches) return;
    if (sleeps(*pair.a)) wake(*pair.a);
    if (sleeps(*pair.b)) wake(*pair.b);
    const PairImpact impact = collider_.impact_of(pair);
    note_impact(*pair.a, impact.on_a);
    note_impact(*pair.b, impact.on_b);
}

/// Every body hands its impact on once.
void SmallStepWorld::note_impact(BodyRecord& record, const PredictedChange& impact) {
    const Vec3& known = record.small.predicted.change_mps;
    if (record.small.predicted.spread ||
        glm::dot(impact.change_mps, impact.change_mps) <= glm::dot(known, known)) {
        return;
    }
    if (known == Vec3{0, 0, 0}) struck_.push_back(&record);
    record.small.predicted = impact;
}

/// Looks again, farther, at the pairs of bodies that were struck. Whether any was.
bool SmallStepWorld::spread_impacts() {
    if (struck_.empty()) return false;
    met_in_order_ = false;
    for (int round = 0; round < kImpactRounds && !struck_.empty(); ++round) {
        std::swap(spreading_, struck_);
        struck_.clear();
        std::sort(spreading_.begin(), spreading_.end(), by_id);
        for (BodyRecord* record : spreading_) record->small.predicted.spread = true;
        for (BodyRecord* record : spreading_) {
            for (const PairLink& link : record->small.pairs) {
                if (boxes_overlap(*link.pair) && collider_.knows_less(*link.pair)) look(*link.pair);
            }
        }
    }
    struck_.clear();
    return true;
}

/// Each awake body's pairs in the order of the other's id, a pair of two awake ones at the lower.
void SmallStepWorld::list_touching() {
    if (!met_in_order_) {
        met_.clear();
        for (const BodyRecord* record : awake_) {
            for (const PairLink& link : record->small.pairs) {
                if (!link.pair->touches) continue;
                const bool listed =
                    link.other < record->id && pushable(partner(*link.pair, *record));
                if (!listed) met_.push_back(link.pair);
            }
        }
    }
    for (Pair* pair : met_) collider_.list_manifolds(*pair, touching_);
}

void SmallStepWorld::list_joints() {
    joined_.clear();
    for (const BodyRecord* record : awake_) {
        for (const JointId id : record->joints) {
            JointRecord& joint = *parts_.joints.get(id);
            const BodyRecord* first = joint.a;
            if (!pushable(*first)) first = joint.b;
            if (first == record && !joint.state.broken) joined_.push_back(&joint);
        }
    }
    std::sort(joined_.begin(), joined_.end(), [](const JointRecord* a, const JointRecord* b) {
        return a->id < b->id;
    });
}

}  // namespace plumbline::physics
