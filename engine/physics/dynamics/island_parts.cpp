#include "engine/physics/dynamics/island_parts.h"

#include "engine/physics/collision/pair_points.h"
#include "engine/physics/dynamics/part_choice.h"

#include <algorithm>

namespace plumbline::physics {
namespace {

/// In a step of an island; what meets after that is stopped by the sweep when the step is over.
constexpr std::size_t kMostImpacts = 64;
/// Fewer of many bodies: each impact is one more solution of the whole island.
constexpr std::size_t kMostBodiesTimesImpacts = 1024;
/// Shares of the step that are none.
constexpr double kLeastShare = 1e-9;

}  // namespace

IslandResult IslandParts::solve(Island& island, const IslandStep& whole_step) {
    IslandStep step = whole_step;
    result_ = {};
    carriers_.clear();
    double now = 0;
    if (may_be_parted(island, step.step_s)) {
        if (island.swept || island.carried) list_carriers(island);
        if (island.swept) solve_up_to_impacts(island, step, now);
    }
    solve_span(island, step, {now, 1});
    carry_to(0);
    return result_;
}

void IslandParts::list_carriers(const Island& island) {
    for (const BodyRecord* record : island.bodies) {
        for (const PairLink& link : record->small.pairs) {
            BodyRecord& other = partner(*link.pair, *record);
            if (other.kind != BodyKind::Kinematic || stands_still(other)) continue;
            if (std::ranges::find(carriers_, &other, &Carrier::record) == carriers_.end())
                carriers_.push_back({&other, other.motion->at});
        }
    }
}

void IslandParts::carry_to(double share) {
    const auto passed_s = static_cast<Real>(share) * step_.step_s;
    for (const auto& [record, start] : carriers_) {
        record->motion->at = start;
        if (share > 0) integrate_kinematic(*record, false, passed_s);
    }
}

void IslandParts::solve_up_to_impacts(Island& island, IslandStep& step, double& now) {
    const std::size_t most = std::min(kMostImpacts, kMostBodiesTimesImpacts / island.bodies.size());
    for (std::size_t impacts = 0; impacts < most; ++impacts) {
        const Outlook outlook{now, step.step_s, step.features.gyroscopic_torque};
        forecast_.begin(outlook);
        const double next = forecast_.next_impact(island.bodies);
        drop_points_ahead(island, outlook);
        if (next >= 1) return;
        if (next - now > kLeastShare) solve_span(island, step, {now, next});
        now = next;
        carry_to(now);
        find_points(island, 1 - now);
        for (BodyRecord* record : island.bodies) {
            record->sweep.came_mps = record->motion->velocity_mps;
            record->sweep.came_radps = record->motion->spin_radps;
        }
        solver_.solve_impacts(island, step, result_);
        find_points(island, 1 - now, true);  // as the bodies move from now on
        for (BodyRecord* record : island.bodies) {
            record->sweep.since = static_cast<Real>(now);
            record->sweep.from = record->motion->at;
        }
    }
}

void IslandParts::solve_span(Island& island, IslandStep& step, const Span& span) {
    double now = span.from;
    for (int left = most_parts(island); now < span.to; --left) {
        const double rest = span.to - now;
        const double rest_s = step.step_s * rest;
        const int parts = std::min(parts_of_step(island, rest_s), std::max(left, 1));
        const double next = parts == 1 ? span.to : now + rest / parts;
        step.part_s = rest_s / parts;
        step.start_s = now * step.step_s;
        step.last = next == 1;
        if (now > span.from) {
            carry_to(now);
            find_points(island, next - now);
        }
        solver_.solve(island, step, result_);
        step.first = false;
        now = next;
    }
}

void IslandParts::find_points(Island& island, double share, bool only_struck) {
    // Far enough ahead for what an impact within it brings near.
    const auto part = static_cast<Real>(std::min(2 * share, 1.0));
    points_.collide_again(island.bodies,
                          {.step_s = step_.step_s * part,
                           .drop_m = step_.drop_m * part * part,
                           .rules = step_.rules,
                           .again = true,
                           .only_struck = only_struck,
                           .turned_back = island.swept},
                          island.manifolds);
    result_.found_again = true;
}

void IslandParts::drop_points_ahead(Island& island, const Outlook& outlook) {
    bool dropped = false;
    for (const BodyRecord* record : island.bodies) {
        if (outruns_points(*record, outlook) && physics::drop_points_ahead(*record, outlook))
            dropped = true;
    }
    if (!dropped) return;
    points_.list(island.bodies, island.manifolds);
    result_.found_again = true;
}

bool drop_points_ahead(const BodyRecord& record, const Outlook& outlook) {
    if (!flies(record)) return false;
    bool dropped = false;
    for (const PairLink& link : record.small.pairs) {
        if (!link.pair->touches || !may_meet(record, partner(*link.pair, record), outlook))
            continue;
        separate(*link.pair);
        dropped = true;
    }
    return dropped;
}

}  // namespace plumbline::physics
