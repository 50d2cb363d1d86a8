#include "engine/study/merged_findings.h"

#include "engine/study/scenarios/scenario_study.h"
#include "engine/study/workers/shard.h"

#include <algorithm>

namespace plumbline::study {
namespace {

/// A run or, of a scene, whose runs follow from each other, all of them.
struct Unit {
    const Subject* subject;
    std::span<const Point> points;
};

std::vector<Unit> units_of(const Findings& findings) {
    std::vector<Unit> units;
    for (const Subject& subject : findings.subjects) {
        const std::span points(subject.points);
        if (scenario_of(subject.id) == nullptr) {
            units.push_back({&subject, points});
            continue;
        }
        for (std::size_t i = 0; i < points.size(); ++i)
            units.push_back({&subject, points.subspan(i, 1)});
    }
    return units;
}

void add(Findings& whole, const Unit& unit) {
    if (scenario_of(unit.subject->id) == nullptr) {
        whole.subjects.push_back(*unit.subject);
        return;
    }
    auto subject = std::ranges::find(whole.subjects, unit.subject->id, &Subject::id);
    if (subject == whole.subjects.end()) {
        whole.subjects.push_back(*unit.subject);
        subject = std::prev(whole.subjects.end());
        subject->points.clear();
    }
    subject->points.insert(subject->points.end(), unit.points.begin(), unit.points.end());
}

}  // namespace

Result<Findings> merged(std::span<const Findings> shards) {
    std::vector<ShardHead> heads;
    for (const Findings& each : shards)
        heads.push_back({.shard = each.shard, .build = each.build, .complete = each.complete});
    const Result<std::vector<std::size_t>> order = order_of_shards(heads);
    if (!order) return order.error();
    std::vector<std::vector<Unit>> units;
    for (const std::size_t at : *order) units.push_back(units_of(shards[at]));
    Findings whole{.command = shards.front().shard->what,
                   .machine = shards.front().machine,
                   .build = shards.front().build,
                   .made_on = shards.front().made_on};
    // Shards take units in turn.
    for (std::size_t i = 0; i < units.front().size(); ++i) {
        for (const std::vector<Unit>& own : units) {
            if (i < own.size()) add(whole, own[i]);
        }
    }
    for (Subject& subject : whole.subjects) {
        if (const Scenario* scenario = scenario_of(subject.id))
            subject.verdicts = verdicts_of(subject.points, scenario->theory);
    }
    whole.clock_spread = clock_spread_of(whole.subjects);
    return whole;
}

}  // namespace plumbline::study
