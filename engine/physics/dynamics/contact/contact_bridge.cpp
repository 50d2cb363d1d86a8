#include "engine/physics/dynamics/contact/contact_bridge.h"

#include <algorithm>
#include <utility>

namespace plumbline::physics {
namespace {

/// How fast the lasting load follows what a step carried, down and up: impacts hardly count.
constexpr Real kFallShare = 0.25_r;
constexpr Real kRiseShare = 0.02_r;
constexpr std::uint32_t kKnown_steps = 10;  ///< fewer say more of the first impact

bool is_new(const ManifoldPoint& point) {
    return point.load.normal_N == 0 && point.age_steps <= 1;
}

void start_constraint(ContactConstraint& constraint,
                      const Manifold& manifold,
                      const ManifoldPoint& point,
                      ManifoldEnds ends) {
    // What gives way to nothing is always a constraint's b.
    const Real sign = ends.a_moves ? Real{1} : Real{-1};
    constraint.a = ends.a_moves ? ends.a : ends.b;
    constraint.b = ends.a_moves ? ends.b : ends.a;
    constraint.belt = ends.belt;
    constraint.normal = sign * point.normal_world;
    const ContactSide& side_a = ends.a_moves ? point.a : point.b;
    const ContactSide& side_b = ends.a_moves ? point.b : point.a;
    constraint.radius_a = side_a.radius_m;
    constraint.radius_b = side_b.radius_m;
    const std::array<Vec3, 2> tangents = tangents_of(point.normal_world);
    for (std::size_t t = 0; t < 2; ++t) constraint.tangent[t] = sign * tangents[t];
    constraint.axis_a = side_a.axis;
    constraint.axis_b = side_b.axis;
    constraint.rolls = side_a.axis != Vec3{0, 0, 0} || side_b.axis != Vec3{0, 0, 0};
    constraint.face_turns = side_a.is_moving_face || side_b.is_moving_face;
    constraint.friction = manifold.material.friction;
    constraint.restitution = manifold.material.restitution;
    constraint.rolling_m = manifold.material.rolling_m;
    constraint.spinning_m = manifold.material.spinning_m;
}

void add_lane(ContactConstraint& constraint,
              const ManifoldPoint& point,
              ManifoldEnds ends,
              Real h) {
    const auto at = static_cast<std::size_t>(constraint.count);
    set_lane(constraint.offset_a, constraint.count, (ends.a_moves ? point.a : point.b).offset_m);
    set_lane(constraint.offset_b, constraint.count, (ends.a_moves ? point.b : point.a).offset_m);
    constraint.start_separation_m[at] = point.distance_m;
    constraint.normal_Ns[at] = point.load.normal_N * h;
    constraint.tangent_Ns[0] += point.load.friction_N[0] * h;
    constraint.tangent_Ns[1] += point.load.friction_N[1] * h;
    constraint.twist_Nms += point.load.twist_Nm * h;
    ++constraint.count;
}

}  // namespace

void ContactBridge::begin_island(std::uint64_t step) {
    step_ = step;
    entries_.clear();
    manifolds_.clear();
}

const ManifoldLoad* ContactBridge::last_load(const Manifold& manifold) const {
    const std::uint64_t step = manifold.load.step;
    return step != 0 && (step == step_ || step + 1 == step_) ? &manifold.load : nullptr;
}

Real ContactBridge::lasting_load_N(const Manifold& manifold) const {
    const ManifoldLoad* last = last_load(manifold);
    return last != nullptr && last->age_steps >= kKnown_steps ? last->lasting_N : Real{0};
}

void ContactBridge::add(Manifold& manifold, ManifoldEnds ends, Real h, ContactSet& contacts) {
    const std::size_t first_constraint = contacts.constraints.size();
    const std::size_t first_entry = entries_.size();
    for (ManifoldPoint& point : manifold.points) {
        const Vec3 facing = ends.a_moves ? point.normal_world : -point.normal_world;
        const bool joins = contacts.constraints.size() > first_constraint &&
                           contacts.constraints.back().count < kLanes &&
                           contacts.constraints.back().normal == facing;
        if (!joins) start_constraint(contacts.constraints.emplace_back(), manifold, point, ends);
        ContactConstraint& constraint = contacts.constraints.back();
        entries_.push_back(
            {.point = &point,
             .manifold = &manifold,
             .constraint = static_cast<std::uint32_t>(contacts.constraints.size() - 1),
             .lane = static_cast<std::uint32_t>(constraint.count)});
        add_lane(constraint, point, ends, h);
    }
    ManifoldLoad load{.step = step_};
    if (const ManifoldLoad* last = last_load(manifold)) {
        share_lost(*last, h, contacts, first_constraint, first_entry);
        load.lasting_N = last->lasting_N;
        load.age_steps = last->age_steps;
        ContactConstraint& first = contacts.constraints[first_constraint];
        first.load_before_Ns = last->before_N * h;
        if (first.rolling_m > 0 || first.spinning_m > 0) first.rolling_Nms = last->rolling_Nm * h;
    }
    manifold.load = load;
    manifolds_.push_back(&manifold);
}

void ContactBridge::share_lost(const ManifoldLoad& last,
                               Real h,
                               ContactSet& contacts,
                               std::size_t first_constraint,
                               std::size_t first_entry) const {
    Real lost_N = last.normal_N;
    Vec3 lost_friction_N = last.friction_N;
    int fresh = 0;
    for (std::size_t i = first_entry; i < entries_.size(); ++i) {
        const ManifoldPoint& point = *entries_[i].point;
        lost_N -= point.load.normal_N;
        if (is_new(point)) ++fresh;
    }
    if (fresh == 0 || lost_N <= 0) return;
    for (std::size_t i = first_constraint; i < contacts.constraints.size(); ++i) {
        const ContactConstraint& constraint = contacts.constraints[i];
        lost_friction_N -= (constraint.tangent[0] * constraint.tangent_Ns[0] +
                            constraint.tangent[1] * constraint.tangent_Ns[1]) /
                           h;
    }
    const Real share = h / static_cast<Real>(fresh);
    for (std::size_t i = first_entry; i < entries_.size(); ++i) {
        if (!is_new(*entries_[i].point)) continue;
        ContactConstraint& constraint = contacts.constraints[entries_[i].constraint];
        constraint.normal_Ns[entries_[i].lane] = lost_N * share;
        for (int t = 0; t < 2; ++t)
            constraint.tangent_Ns[t] += glm::dot(lost_friction_N, constraint.tangent[t]) * share;
    }
}

void ContactBridge::count_impulses(const ContactSet& contacts) {
    for (const Entry& entry : entries_)
        entry.point->normal_Ns += contacts.constraints[entry.constraint].total_Ns[entry.lane];
}

void ContactBridge::ease_loads(Real share) {
    for (Manifold* manifold : manifolds_) {
        ManifoldLoad& load = manifold->load;
        if (load.normal_N <= 0) continue;
        const Real kept = std::clamp(
            lasting_load_N(*manifold) / load.normal_N, std::min(share, Real{1}), Real{1});
        load.normal_N *= kept;
        load.friction_N *= kept;
        load.rolling_Nm *= kept;
        for (ManifoldPoint& point : manifold->points) {
            point.load.normal_N *= kept;
            for (Real& friction_N : point.load.friction_N) friction_N *= kept;
            point.load.twist_Nm *= kept;
        }
    }
}

void ContactBridge::write_back(const ContactSet& contacts, Real h) {
    const Real per_s = 1 / h;
    for (const Entry& entry : entries_) {
        const ContactConstraint& constraint = contacts.constraints[entry.constraint];
        PointLoad& point = entry.point->load;
        const Real share = per_s / static_cast<Real>(constraint.count);
        point.normal_N = constraint.normal_Ns[entry.lane] * per_s;
        point.friction_N = {constraint.tangent_Ns[0] * share, constraint.tangent_Ns[1] * share};
        point.twist_Nm = constraint.twist_Nms * share;
        entry.point->normal_Ns += constraint.total_Ns[entry.lane];
        ManifoldLoad& load = entry.manifold->load;
        load.normal_N += point.normal_N;
        if (entry.lane == 0) load.before_N += constraint.load_before_Ns * per_s;
        if (entry.lane == 0 && load.rolling_Nm == Vec3{0, 0, 0})
            load.rolling_Nm = constraint.rolling_Nms * per_s;
        load.friction_N += constraint.tangent[0] * point.friction_N[0] +
                           constraint.tangent[1] * point.friction_N[1];
    }
    for (Manifold* manifold : manifolds_) {
        ManifoldLoad& load = manifold->load;
        ++load.age_steps;
        const bool first = load.age_steps == 1;
        const Real share = first ? 1 : load.normal_N < load.lasting_N ? kFallShare : kRiseShare;
        load.lasting_N += share * (load.normal_N - load.lasting_N);
    }
}

}  // namespace plumbline::physics
