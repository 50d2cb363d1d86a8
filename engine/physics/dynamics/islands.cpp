#include "engine/physics/dynamics/islands.h"

#include "engine/physics/bullet/body.h"
#include "engine/physics/dynamics/part_choice.h"
#include "engine/physics/world/body_record.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumbline::physics {
namespace {

constexpr std::uint32_t kNoIsland = std::numeric_limits<std::uint32_t>::max();

bool is_member(const BodyRecord* record) {
    return record != nullptr && pushable(*record);
}

/// What bounds an island and moves by itself.
bool moves_by_itself(const BodyRecord& record) {
    return record.kind == BodyKind::Kinematic && record.small.awake;
}

/// Comparisons with NaN are false.
bool is_valid(const BodyRecord& record, Real step_s) {
    constexpr Real kFinite = std::numeric_limits<Real>::max();
    const Vec3 v = record.motion->velocity_mps;
    const Vec3 spin = record.motion->spin_radps;
    const Mat3& rotation = record.motion->at.rotation;
    const Vec3 moved = record.motion->at.position_m - record.before.at.position_m;
    const Real farthest_m = 2 * kMaxSpeed_mps * step_s;
    return glm::dot(moved, moved) <= farthest_m * farthest_m && glm::dot(v, v) <= kFinite &&
           glm::dot(spin, spin) <= kFinite && glm::dot(rotation[0], rotation[0]) <= kFinite;
}

/// A step that fails again and again slows the body down until it does not.
void restore(BodyRecord& record) {
    record.motion->ballistic.going = false;
    record.motion->at = record.before.at;
    record.motion->velocity_mps = record.before.velocity_mps / Real{2};
    record.motion->spin_radps = record.before.spin_radps / Real{2};
}

}  // namespace

bool restore_if_invalid(const Island& island, Real step_s) {
    const bool valid = std::ranges::all_of(
        island.bodies, [step_s](const BodyRecord* record) { return is_valid(*record, step_s); });
    if (valid) return false;
    for (BodyRecord* record : island.bodies) restore(*record);
    for (Manifold* manifold : island.manifolds) forget_loads(*manifold);
    for (JointRecord* joint : island.joints) {
        SolverJoint& solver = joint->solver;
        solver.bound_load = {};
        solver.mean_load = {};
        solver.elastic_speed = {};
        solver.error_m = 0;
        solver.position = 0;
        joint->state = {};
    }
    return true;
}

Island& IslandBuilder::island_of(std::uint32_t body) {
    return islands_[number_[sets_.find(body)]];
}

/// What holds an island from outside. `partner` is a dynamic member of it or none of its own.
void IslandBuilder::note_partner(std::uint32_t body, const BodyRecord* partner) {
    if (is_member(partner)) return;
    Island& island = island_of(body);
    island.supported = true;
    if (partner != nullptr && moves_by_itself(*partner)) island.carried = true;
}

/// Only as long as the island can still be solved impact by impact: among many that fly side by side each may meet the next.
void IslandBuilder::tie_what_may_follow(std::span<const SweptPath> swept) {
    if (std::ranges::none_of(swept, &SweptPath::after_impact)) return;
    size_.assign(held_.size(), 0);
    for (std::uint32_t i = 0; i < size_.size(); ++i) ++size_[sets_.find(i)];
    for (const SweptPath& path : swept) {
        if (!path.after_impact) continue;
        const std::uint32_t a = sets_.find(path.body->small.row);
        const std::uint32_t b = sets_.find(path.meets->small.row);
        const std::uint32_t both = size_[a] + size_[b];
        if (a == b || both > kMostBodiesInParts) continue;
        sets_.join(a, b);
        size_[sets_.find(a)] = both;
        held_[path.body->small.row] = held_[path.meets->small.row] = 1;
    }
}

/// Who is held by what, and with whom.
void IslandBuilder::tie(std::span<BodyRecord* const> bodies,
                        std::span<Manifold* const> manifolds,
                        std::span<JointRecord* const> joints,
                        std::span<const SweptPath> swept,
                        const FieldTies& fields) {
    sets_.reset(bodies.size());
    held_.assign(bodies.size(), 0);
    for (std::uint32_t i = 0; i < bodies.size(); ++i) {
        bodies[i]->small.row = i;
        if (bodies[i]->small.fields != 0) held_[i] = 1;
    }
    const auto join = [this](const BodyRecord* a, const BodyRecord* b) {
        if (is_member(a)) held_[a->small.row] = 1;
        if (is_member(b)) held_[b->small.row] = 1;
        if (is_member(a) && is_member(b)) sets_.join(a->small.row, b->small.row);
    };
    for (const Manifold* manifold : manifolds) join(manifold->a, manifold->b);
    for (const JointRecord* joint : joints) join(joint->a, joint->b);
    for (const auto& [a, b] : fields.pairs) join(a, b);
    for (const SweptPath& path : swept) {
        if (path.meets != nullptr && !path.after_impact) join(path.body, path.meets);
    }
}

void IslandBuilder::build(std::span<BodyRecord* const> bodies,
                          std::span<Manifold* const> manifolds,
                          std::span<JointRecord* const> joints,
                          std::span<const SweptPath> swept,
                          const FieldTies& fields) {
    tie(bodies, manifolds, joints, swept, fields);
    tie_what_may_follow(swept);

    number_.assign(bodies.size(), kNoIsland);
    free_.clear();
    count_ = 0;
    for (std::uint32_t i = 0; i < bodies.size(); ++i) {
        bodies[i]->small.island = kNoIsland;
        if (held_[i] == 0) {
            free_.push_back(bodies[i]);
            continue;
        }
        std::uint32_t& number = number_[sets_.find(i)];
        if (number == kNoIsland) {
            number = static_cast<std::uint32_t>(count_++);
            if (islands_.size() < count_) islands_.emplace_back();
            islands_[number].clear();
        }
        islands_[number].bodies.push_back(bodies[i]);
        bodies[i]->small.island = number;
        if ((bodies[i]->small.fields & fields.carrying) != 0) islands_[number].supported = true;
    }
    for (Manifold* manifold : manifolds) {
        const BodyRecord* member = is_member(manifold->a) ? manifold->a : manifold->b;
        island_of(member->small.row).manifolds.push_back(manifold);
        note_partner(member->small.row, member == manifold->a ? manifold->b : manifold->a);
    }
    for (const SweptPath& path : swept) {
        if (held_[path.body->small.row] != 0) island_of(path.body->small.row).swept = true;
    }
    for (JointRecord* joint : joints) {
        const BodyRecord* member = is_member(joint->a) ? joint->a : joint->b;
        island_of(member->small.row).joints.push_back(joint);
        note_partner(member->small.row, member == joint->a ? joint->b : joint->a);
    }
}

}  // namespace plumbline::physics
