#include "engine/physics/world/pair_walk.h"

#include "engine/core/time/trace_events.h"
#include "engine/physics/bullet/contact/pair_boxes.h"
#include "engine/physics/collision/ghost_contacts.h"
#include "engine/physics/collision/pair_points.h"
#include "engine/physics/world/body_record.h"

#include <algorithm>

namespace plumbline::physics {
namespace {

/// An impact is handed on from body to body at most so often within a step.
constexpr int kImpactRounds = 16;
constexpr std::size_t kBodiesAtOnce = 8;

/// The pairs with points, in order.
void list_touching(std::span<BodyRecord* const> bodies, std::vector<Pair*>& touching) {
    touching.clear();
    for (const BodyRecord* record : bodies) {
        for (const PairLink& link : record->small.pairs) {
            if (!link.pair->touches) continue;
            const bool listed = link.other < record->id && pushable(partner(*link.pair, *record));
            if (!listed) touching.push_back(link.pair);
        }
    }
}

bool is_struck(const BodyRecord& record) {
    return pushable(record) && (record.motion->velocity_mps != record.sweep.came_mps ||
                                record.motion->spin_radps != record.sweep.came_radps);
}

/// Of two that are awake: dynamic ones before kinematic ones, then by id.
bool comes_first(const BodyRecord& body, const PairLink& link) {
    if (body.kind == BodyKind::Dynamic && body.id < link.other) return true;
    const BodyRecord& other = partner(*link.pair, body);
    return !other.small.awake || (body.kind == BodyKind::Dynamic && other.kind != body.kind);
}

void list_manifolds(Pair& pair, std::vector<Manifold*>& list) {
    for (Manifold& manifold : pair.manifolds) {
        if (!manifold.points.empty()) list.push_back(&manifold);
    }
}

}  // namespace

std::uint32_t PairWalk::collide(AwakeBodies& bodies, std::vector<Manifold*>& touching, Team* team) {
    ++number_;
    tests_ = 0;
    foretells_ = false;
    nearest_.begin_step();
    touching_pairs_.clear();
    impacted_.clear();
    if (nearest_.needed()) complete_crowds(bodies);
    walkers_.assign(bodies.dynamic().begin(), bodies.dynamic().end());
    walkers_.insert(walkers_.end(), bodies.kinematic().begin(), bodies.kinematic().end());
    walk(bodies, crowded() ? nullptr : team);
    if (!visit_woken(bodies)) list_touching(bodies.dynamic(), touching_pairs_);
    drop_ghost_contacts(bodies.dynamic(), step_);
    for (Pair* pair : touching_pairs_) list_manifolds(*pair, touching);
    return tests_;
}

/// The pairs of woken bodies may wake more. Whether touching_pairs_ are in order.
bool PairWalk::visit_woken(AwakeBodies& bodies) {
    bool in_order = true;
    std::size_t visited = 0;
    do {
        walkers_.assign(bodies.woken().begin() + static_cast<std::ptrdiff_t>(visited),
                        bodies.woken().end());
        visited = bodies.woken().size();
        for (BodyRecord* woken : walkers_) {
            if (woken->crowd != nullptr) nearest_.complete(*woken);
        }
        walk(bodies, nullptr);
        if (!impacted_.empty()) in_order = false;
    } while (spread_impacts(bodies) || visited < bodies.woken().size());
    return !bodies.admit_woken() && in_order;
}

void PairWalk::collide_woken(AwakeBodies& bodies, std::vector<Manifold*>& touching) {
    if (bodies.woken().empty()) return;
    visit_woken(bodies);
    drop_ghost_contacts(bodies.dynamic(), step_);
    list_again(bodies, touching);
}

void PairWalk::collide_again(std::span<BodyRecord* const> bodies,
                             const CollideStep& step,
                             std::vector<Manifold*>& manifolds) {
    std::vector<Pair*> touching;
    for (const BodyRecord* record : bodies) {
        for (const PairLink& link : record->small.pairs) {
            const BodyRecord& other = partner(*link.pair, *record);
            if (pushable(other) && (other.id < record->id || !other.small.awake ||
                                    other.small.island != record->small.island))
                continue;
            const bool is_near =
                step.turned_back ? are_within_reach(*link.pair, step) : boxes_overlap(*link.pair);
            if (!link.pair->touches &&
                (!is_near || !nearest_.takes_part(*link.pair->a, *link.pair->b)))
                continue;
            if (!step.only_struck || is_struck(*record) || is_struck(other))
                find_points(*link.pair, step);
            if (link.pair->touches) touching.push_back(link.pair);
        }
    }
    drop_ghost_contacts(bodies, step);
    manifolds.clear();
    for (Pair* pair : touching) list_manifolds(*pair, manifolds);
}

void PairWalk::list(std::span<BodyRecord* const> bodies, std::vector<Manifold*>& manifolds) {
    list_touching(bodies, touching_pairs_);
    manifolds.clear();
    for (Pair* pair : touching_pairs_) list_manifolds(*pair, manifolds);
}

void PairWalk::list_again(const AwakeBodies& bodies, std::vector<Manifold*>& touching) {
    list(bodies.dynamic(), touching);
}

void PairWalk::complete_crowds(const AwakeBodies& bodies) {
    for (const auto moving : {bodies.dynamic(), bodies.kinematic()}) {
        for (BodyRecord* record : moving) {
            if (record->crowd != nullptr) nearest_.complete(*record);
        }
    }
}

/// Finds the points of the walkers' pairs, each once in a walk: at the body that comes to it first or, with others at work
/// too, at the one that would. They depend on the two bodies alone; what they do to others follows in order.
void PairWalk::walk(AwakeBodies& bodies, Team* team) {
    if (walkers_.empty()) return;
    const std::size_t ranges = (walkers_.size() + kBodiesAtOnce - 1) / kBodiesAtOnce;
    if (found_.size() < ranges) found_.resize(ranges);
    for (Found& found : found_) found.clear();
    const auto look = [&](int, std::size_t begin, std::size_t end) {
        const TraceSpan span("points of pairs");
        for (std::size_t i = begin; i < end; ++i) {
            const BodyRecord& body = *walkers_[i];
            for (const PairLink& link : body.small.pairs) __builtin_prefetch(link.pair);
            for (const PairLink& link : body.small.pairs) {
                if (team == nullptr ? link.pair->seen != number_ : comes_first(body, link))
                    look_at(*link.pair, found_[begin / kBodiesAtOnce]);
            }
        }
    };
    share(team, walkers_.size(), kBodiesAtOnce, look);
    for (const Found& found : found_) {
        take_in(found, bodies);
        for (Pair* pair : found.parted) engine_.drop(*pair);
    }
}

/// Later pairs see the impacts that earlier ones foretell.
void PairWalk::take_in(const Found& found, AwakeBodies& bodies) {
    tests_ += static_cast<std::uint32_t>(found.near.size());
    if (!foretells_ && !found.strikes) {
        touching_pairs_.insert(touching_pairs_.end(), found.touching.begin(), found.touching.end());
        return;
    }
    CollideStep with_impacts = step_;
    with_impacts.refined = true;
    for (Pair* pair : found.near) {
        if (foretells_ && predicted_mps(*pair) != pair->predicted_mps)
            find_points(*pair, with_impacts);
        if (!pair->touches) continue;
        take_in(*pair, bodies);
        touching_pairs_.push_back(pair);
    }
}

void PairWalk::look_at(Pair& pair, Found& found) {
    pair.seen = number_;
    if (!boxes_overlap(pair)) {
        if (pair.touches) separate(pair);
        if (boxes_are_far(pair)) found.parted.push_back(&pair);
        return;
    }
    if (!nearest_.takes_part(*pair.a, *pair.b)) {
        found.parted.push_back(&pair);
        return;
    }
    found.near.push_back(&pair);
    find_points(pair, step_);
    if (!pair.touches) return;
    found.touching.push_back(&pair);
    if (pair.reach_m > pair.base_m || sleeps(*pair.a) || sleeps(*pair.b)) found.strikes = true;
}

/// Touched bodies wake, and impacts are noted.
void PairWalk::take_in(const Pair& pair, AwakeBodies& bodies) {
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
    foretells_ = true;
    if (known == Vec3{0, 0, 0}) impacted_.push_back(&record);
    record.small.predicted = impact;
}

/// If a body of the pair will come farther than its points were looked for.
void PairWalk::spread_impact(Pair& pair, AwakeBodies& bodies) {
    if (!boxes_overlap(pair) || !knows_less(pair, step_) || !nearest_.takes_part(*pair.a, *pair.b))
        return;
    ++tests_;
    find_points(pair, step_);
    if (pair.touches) take_in(pair, bodies);
}

/// Finds points again, to a larger distance, for the pairs of bodies with new impacts. Whether any
/// body had one.
bool PairWalk::spread_impacts(AwakeBodies& bodies) {
    if (impacted_.empty()) return false;
    for (int round = 0; round < kImpactRounds && !impacted_.empty(); ++round) {
        std::swap(spreading_, impacted_);
        impacted_.clear();
        std::sort(spreading_.begin(), spreading_.end(), by_id);
        for (BodyRecord* record : spreading_) record->small.predicted.spread = true;
        for (BodyRecord* record : spreading_) {
            for (const PairLink& link : record->small.pairs) spread_impact(*link.pair, bodies);
        }
    }
    impacted_.clear();
    return true;
}

}  // namespace plumbline::physics
