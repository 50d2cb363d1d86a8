#include "engine/physics/dynamics/island_parts.h"

#include "engine/physics/collision/pair_points.h"

#include <algorithm>

namespace plumbline::physics {
namespace {

/// In a step of an island; what meets after that is stopped by the sweep when the step is over.
constexpr std::size_t kMostImpacts = 64;
/// Fewer of many bodies: each impact is one more solution of the whole island.
constexpr std::size_t kMostBodiesTimesImpacts = 512;
/// Shares of the step that are none.
constexpr double kLeastShare = 1e-9;

}  // namespace

bool IslandParts::solve(Island& island, IslandStep& step, IslandReport& report) {
    found_again_ = false;
    report_ = {};
    step.first = true;
    double now = 0;
    if (island.swept && may_be_parted(island, step.step_s)) solve_up_to_impacts(island, step, now);
    solve_span(island, step, {now, 1});
    report = report_;
    return found_again_;
}

void IslandParts::solve_up_to_impacts(Island& island, IslandStep& step, double& now) {
    const std::size_t most = std::min(kMostImpacts, kMostBodiesTimesImpacts / island.bodies.size());
    for (std::size_t impacts = 0; impacts < most; ++impacts) {
        const Outlook outlook{now, step.step_s, step.features.gyroscopic_torque};
        const double next = next_impact(island, outlook);
        drop_points_ahead(island, outlook);
        if (next >= 1) return;
        if (next - now > kLeastShare) solve_span(island, step, {now, next});
        now = next;
        find_points(island, 1 - now);
        solver_.solve_impacts(island, step);
        for (BodyRecord* record : island.bodies) {
            record->sweep.since = static_cast<Real>(now);
            record->sweep.from = record->motion->at;
        }
    }
}

double IslandParts::next_impact(const Island& island, const Outlook& outlook) const {
    double next = 1;
    for (const BodyRecord* record : island.bodies) {
        if (!outruns_points(*record, outlook)) continue;
        next = std::min(next, predicted_impact(world_, *record, outlook).share);
    }
    return std::max(next, outlook.now);
}

void IslandParts::solve_span(Island& island, IslandStep& step, const Span& span) {
    const double share = span.to - span.from;
    const double span_s = span.is_whole() ? step.step_s : step.step_s * share;
    const int parts = parts_of_step(island, span_s);
    step.part_s = span_s / parts;
    for (int part = 0; part < parts; ++part) {
        step.last = span.to == 1 && part + 1 == parts;
        if (part > 0) find_points(island, share / parts);
        const int substeps = report_.substeps;
        report_ = solver_.solve(island, step);
        report_.substeps += substeps;
        step.first = false;
    }
}

void IslandParts::find_points(Island& island, double share) {
    const auto part = static_cast<Real>(share);
    points_.collide_again(island.bodies,
                          {.step_s = step_.step_s * part,
                           .drop_m = step_.drop_m * part * part,
                           .again = true,
                           .turned_back = island.swept},
                          island.manifolds);
    found_again_ = true;
}

void IslandParts::drop_points_ahead(Island& island, const Outlook& outlook) {
    bool dropped = false;
    for (const BodyRecord* record : island.bodies) {
        if (outruns_points(*record, outlook) && physics::drop_points_ahead(*record, outlook))
            dropped = true;
    }
    if (!dropped) return;
    points_.list(island.bodies, island.manifolds);
    found_again_ = true;
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
