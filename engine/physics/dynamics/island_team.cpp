#include "engine/physics/dynamics/island_team.h"

#include "engine/core/time/trace_events.h"
#include "engine/physics/dynamics/body_motion.h"

#include <algorithm>
#include <utility>

namespace plumbline::physics {
namespace {

/// With fewer an island is one thread's: its contacts are one cell (SweepOrder).
constexpr std::size_t kManyManifolds = 2048;
/// Fewer are solved before a helper has noticed them.
constexpr std::size_t kFewManifolds = 8;
constexpr std::size_t kRangesOfThread = 16;

bool is_alone(const Island& island, bool has_fields) {
    const auto is_held = [](const BodyRecord* record) { return record->small.fields != 0; };
    return island.swept || island.carried ||
           (has_fields && std::ranges::any_of(island.bodies, is_held));
}

}  // namespace

std::span<const IslandResult> IslandTeam::solve(std::span<Island> islands, IslandStep step) {
    step.number = ++steps_;
    const int threads = step.team != nullptr ? step.team->threads() : 1;
    while (members_.size() < static_cast<std::size_t>(threads))
        members_.push_back(std::make_unique<Member>(points_));
    for (const auto& member : members_) member->parts.set_step(step_);
    results_.resize(islands.size());
    const bool has_fields = !step.fields.empty();
    for (std::size_t begin = 0; begin < islands.size();) {
        std::size_t end = begin;
        while (threads > 1 && end < islands.size() && !is_alone(islands[end], has_fields)) ++end;
        if (end > begin + 1) {
            solve_at_once(islands.subspan(begin, end - begin),
                          std::span(results_).subspan(begin, end - begin),
                          step);
            begin = end;
        } else {
            results_[begin] = solve_one(islands[begin], step, 0);
            ++begin;
        }
    }
    return results_;
}

void IslandTeam::solve_at_once(std::span<Island> islands,
                               std::span<IslandResult> results,
                               const IslandStep& step) {
    small_.clear();
    std::size_t manifolds = 0;
    for (std::uint32_t i = 0; i < islands.size(); ++i) {
        if (islands[i].manifolds.size() >= kManyManifolds) {
            results[i] = solve_one(islands[i], step, 0);
        } else {
            small_.push_back(i);
            manifolds += islands[i].manifolds.size() + islands[i].joints.size();
        }
    }
    const auto solve_range = [&](int member, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            results[small_[i]] =
                solve_one(islands[small_[i]], step, static_cast<std::size_t>(member));
    };
    if (manifolds < kFewManifolds) return solve_range(0, 0, small_.size());
    const std::size_t ranges = kRangesOfThread * static_cast<std::size_t>(step.team->threads());
    step.team->share(small_.size(), small_.size() / ranges + 1, solve_range);
}

IslandResult IslandTeam::solve_one(Island& island, const IslandStep& step, std::size_t member) {
    TraceSpan span("island");
    span.note("bodies", static_cast<std::int64_t>(island.bodies.size()));
    span.note("manifolds", static_cast<std::int64_t>(island.manifolds.size()));
    span.note("joints", static_cast<std::int64_t>(island.joints.size()));
    IslandStep own = step;
    if (island.manifolds.size() < kManyManifolds) own.team = nullptr;
    IslandResult result = members_[member]->parts.solve(island, own);
    if (restore_if_invalid(island, static_cast<Real>(step.step_s)))
        ++result.cost.interventions.restored_islands;
    for (BodyRecord* record : island.bodies)
        result.cost.interventions.limited_bodies += limit_speed(*record) ? 1U : 0U;
    span.note("substeps", result.report.substeps);
    return result;
}

}  // namespace plumbline::physics
