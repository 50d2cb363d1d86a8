#include "engine/physics/dynamics/contact/contact_bridge.h"

#include <algorithm>
#include <utility>

namespace plumbline::physics {
namespace {

/// How fast the lasting load follows what a step carried, down and up: blows hardly count.
constexpr Real kFallShare = 0.25_r;
constexpr Real kRiseShare = 0.02_r;
constexpr std::uint32_t kKnown_steps = 10;  ///< fewer say more of the first blow

bool is_new(const ManifoldPoint& point) {
    return point.load.normal_N == 0 && point.age_steps <= 1;
}

void start_block(ContactBlock& block,
                 const Manifold& manifold,
                 const ManifoldPoint& point,
                 ManifoldEnds ends) {
    // What gives way to nothing is always a block's b.
    const Real sign = ends.a_moves ? Real{1} : Real{-1};
    block.a = ends.a_moves ? ends.a : ends.b;
    block.b = ends.a_moves ? ends.b : ends.a;
    block.normal = sign * point.normal_world;
    block.radius_a = ends.a_moves ? point.a.radius_m : point.b.radius_m;
    block.radius_b = ends.a_moves ? point.b.radius_m : point.a.radius_m;
    const std::array<Vec3, 2> tangents = tangents_of(point.normal_world);
    for (std::size_t t = 0; t < 2; ++t) block.tangent[t] = sign * tangents[t];
    block.friction = manifold.material.friction;
    block.restitution = manifold.material.restitution;
    block.rolling_m = manifold.material.rolling_m;
    block.spinning_m = manifold.material.spinning_m;
}

void add_lane(ContactBlock& block, const ManifoldPoint& point, ManifoldEnds ends, Real h) {
    const auto at = static_cast<std::size_t>(block.count);
    set_lane(block.offset_a, block.count, (ends.a_moves ? point.a : point.b).offset_m);
    set_lane(block.offset_b, block.count, (ends.a_moves ? point.b : point.a).offset_m);
    block.start_separation_m[at] = point.distance_m;
    block.normal_Ns[at] = point.load.normal_N * h;
    block.tangent_Ns[0] += point.load.friction_N[0] * h;
    block.tangent_Ns[1] += point.load.friction_N[1] * h;
    block.twist_Nms += point.load.twist_Nm * h;
    ++block.count;
}

}  // namespace

void ContactBridge::begin_step() {
    ++step_;
    begin_island();
}

void ContactBridge::begin_island() {
    entries_.clear();
    manifolds_.clear();
}

const ManifoldLoad* ContactBridge::last_load(const Manifold& manifold) const {
    return manifold.load.step != 0 && manifold.load.step + 1 == step_ ? &manifold.load : nullptr;
}

Real ContactBridge::lasting_load_N(const Manifold& manifold) const {
    const ManifoldLoad* last = last_load(manifold);
    return last != nullptr && last->age_steps >= kKnown_steps ? last->lasting_N : Real{0};
}

void ContactBridge::add(Manifold& manifold, ManifoldEnds ends, Real h, ContactSet& contacts) {
    const std::size_t first_block = contacts.blocks.size();
    const std::size_t first_entry = entries_.size();
    for (ManifoldPoint& point : manifold.points) {
        const Vec3 facing = ends.a_moves ? point.normal_world : -point.normal_world;
        const bool joins = contacts.blocks.size() > first_block &&
                           contacts.blocks.back().count < kLanes &&
                           contacts.blocks.back().normal == facing;
        if (!joins) start_block(contacts.blocks.emplace_back(), manifold, point, ends);
        ContactBlock& block = contacts.blocks.back();
        entries_.push_back({.point = &point,
                            .manifold = &manifold,
                            .block = static_cast<std::uint32_t>(contacts.blocks.size() - 1),
                            .lane = static_cast<std::uint32_t>(block.count)});
        add_lane(block, point, ends, h);
    }
    ManifoldLoad load{.step = step_};
    if (const ManifoldLoad* last = last_load(manifold)) {
        share_lost(*last, h, contacts, first_block, first_entry);
        load.lasting_N = last->lasting_N;
        load.age_steps = last->age_steps;
        ContactBlock& first = contacts.blocks[first_block];
        if (first.rolling_m > 0 || first.spinning_m > 0) first.rolling_Nms = last->rolling_Nm * h;
    }
    manifold.load = load;
    manifolds_.push_back(&manifold);
}

void ContactBridge::share_lost(const ManifoldLoad& last,
                               Real h,
                               ContactSet& contacts,
                               std::size_t first_block,
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
    for (std::size_t i = first_block; i < contacts.blocks.size(); ++i) {
        const ContactBlock& block = contacts.blocks[i];
        lost_friction_N -=
            (block.tangent[0] * block.tangent_Ns[0] + block.tangent[1] * block.tangent_Ns[1]) / h;
    }
    const Real share = h / static_cast<Real>(fresh);
    for (std::size_t i = first_entry; i < entries_.size(); ++i) {
        if (!is_new(*entries_[i].point)) continue;
        ContactBlock& block = contacts.blocks[entries_[i].block];
        block.normal_Ns[entries_[i].lane] = lost_N * share;
        for (int t = 0; t < 2; ++t)
            block.tangent_Ns[t] += glm::dot(lost_friction_N, block.tangent[t]) * share;
    }
}

void ContactBridge::write_back(const ContactSet& contacts, Real h) {
    const Real per_s = 1 / h;
    for (const Entry& entry : entries_) {
        const ContactBlock& block = contacts.blocks[entry.block];
        PointLoad& point = entry.point->load;
        const Real share = per_s / static_cast<Real>(block.count);
        point.normal_N = block.normal_Ns[entry.lane] * per_s;
        point.friction_N = {block.tangent_Ns[0] * share, block.tangent_Ns[1] * share};
        point.twist_Nm = block.twist_Nms * share;
        entry.point->normal_Ns = block.total_Ns[entry.lane];
        ManifoldLoad& load = entry.manifold->load;
        load.normal_N += point.normal_N;
        if (entry.lane == 0 && load.rolling_Nm == Vec3{0, 0, 0})
            load.rolling_Nm = block.rolling_Nms * per_s;
        load.friction_N +=
            block.tangent[0] * point.friction_N[0] + block.tangent[1] * point.friction_N[1];
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
