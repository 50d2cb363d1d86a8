// Contact events, one line per touching pair, and contact points.
#include "engine/physics/query.h"
#include "engine/physics/totals.h"
#include "engine/physics/world/world_state.h"

#include <algorithm>

namespace plumbline::physics {
namespace {

Vec3 velocity_before_at(const BodyRecord& record, const Vec3& point) {
    const Vec3 arm = point - record.before.at.position_m;
    return record.before.velocity_mps + glm::cross(record.before.spin_radps, arm);
}

/// The pair's line from one manifold; false when its points only come near.
bool describe(const Manifold& manifold, ContactEvent& event) {
    const ManifoldPoint* hardest = nullptr;
    bool touches = false;
    for (const ManifoldPoint& point : manifold.points) {
        touches = touches || point.distance_m <= 0 || point.normal_Ns > 0;
        event.impulse_Ns += point.normal_Ns;
        const Real most_Ns = hardest != nullptr ? hardest->normal_Ns : Real{0};
        if (hardest == nullptr || point.normal_Ns > most_Ns ||
            (point.normal_Ns == most_Ns && point.distance_m < hardest->distance_m)) {
            hardest = &point;
        }
    }
    if (!touches) return false;

    const BodyRecord* a = manifold.a;
    const BodyRecord* b = manifold.b;
    Vec3 normal = hardest->normal_world;
    const Vec3& point = hardest->b.surface_m;
    if (b->id < a->id) {
        std::swap(a, b);
        normal = -normal;
    }
    const Vec3 relative = velocity_before_at(*a, point) - velocity_before_at(*b, point);
    const Real along = glm::dot(relative, normal);
    event.a = a->id;
    event.b = b->id;
    event.user_a = a->user;
    event.user_b = b->user;
    event.point_world = point;
    event.normal_world = normal;
    event.closing_speed_mps = -along;
    event.sliding_speed_mps = glm::length(relative - along * normal);
    return true;
}

bool same_pair(const ContactEvent& x, const ContactEvent& y) {
    return x.a == y.a && x.b == y.b;
}
std::pair<BodyId, BodyId> pair_of(const ContactEvent& event) {
    return {event.a, event.b};
}

/// One line per pair, in the order of ids: impulses add up, the place is where the pair pressed
/// hardest, the speeds are those of the moment in which it closed fastest.
std::vector<ContactEvent> merged(std::vector<ContactEvent> list) {
    std::stable_sort(list.begin(), list.end(), [](const ContactEvent& x, const ContactEvent& y) {
        return pair_of(x) < pair_of(y);
    });
    std::vector<ContactEvent> result;
    Real hardest_Ns = 0;
    for (const ContactEvent& event : list) {
        if (result.empty() || !same_pair(result.back(), event)) {
            result.push_back(event);
            hardest_Ns = event.impulse_Ns;
            continue;
        }
        ContactEvent& sum = result.back();
        sum.impulse_Ns += event.impulse_Ns;
        if (event.impulse_Ns > hardest_Ns) {
            hardest_Ns = event.impulse_Ns;
            sum.point_world = event.point_world;
            sum.normal_world = event.normal_world;
        }
        if (event.closing_speed_mps > sum.closing_speed_mps) {
            sum.closing_speed_mps = event.closing_speed_mps;
            sum.sliding_speed_mps = event.sliding_speed_mps;
        }
    }
    return result;
}

/// Whether the pair sleeps and is still asked for: then it touches as it did.
bool sleeps_on(const ContactEvent& event, const BodyTable& bodies) {
    const auto* a = bodies.find(event.a);
    const auto* b = bodies.find(event.b);
    if (a == nullptr || b == nullptr) return false;
    return !(*a)->small.awake && !(*b)->small.awake && (*a)->in_world && (*b)->in_world &&
           ((*a)->contact_events || (*b)->contact_events);
}

}  // namespace

void gather_events(const WorldState& world, bool all, std::vector<ContactEvent>& out) {
    const auto gather = [&out, all](const Manifold& manifold) {
        if (manifold.points.empty()) return;
        if (!all && !manifold.a->contact_events && !manifold.b->contact_events) return;
        ContactEvent event;
        if (describe(manifold, event)) out.push_back(event);
    };
    if (!world.small || all) return world.engine->each_manifold(gather);
    for (const Manifold* manifold : world.small->touching()) gather(*manifold);
}

std::vector<ContactEvent> finished_events(const WorldState& world,
                                          std::vector<ContactEvent> gathered,
                                          std::vector<ContactEvent> before) {
    std::vector<ContactEvent> events = merged(std::move(gathered));
    const auto earlier = [](const ContactEvent& x, const ContactEvent& y) {
        return pair_of(x) < pair_of(y);
    };
    for (ContactEvent& event : events) {
        event.began = !std::binary_search(before.begin(), before.end(), event, earlier);
    }
    if (!world.small) return events;
    const auto listed = static_cast<std::ptrdiff_t>(events.size());
    for (ContactEvent& event : before) {
        if (!sleeps_on(event, world.bodies)) continue;
        if (std::binary_search(events.begin(), events.begin() + listed, event, earlier)) continue;
        event.closing_speed_mps = 0;
        event.sliding_speed_mps = 0;
        event.began = false;
        events.push_back(event);
    }
    std::inplace_merge(events.begin(), events.begin() + listed, events.end(), earlier);
    return events;
}

std::vector<ContactEvent> all_contacts(const PhysicsWorld& world) {
    std::vector<ContactEvent> list;
    gather_events(internals(world), true, list);
    return merged(std::move(list));
}

void contact_points(const PhysicsWorld& world, std::vector<ContactPoint>& points) {
    points.clear();
    internals(world).engine->each_manifold([&points](const Manifold& manifold) {
        for (const ManifoldPoint& point : manifold.points) {
            points.push_back({.a = manifold.a->id,
                              .b = manifold.b->id,
                              .user_a = manifold.a->user,
                              .user_b = manifold.b->user,
                              .point_a_world = point.a.surface_m,
                              .point_b_world = point.b.surface_m,
                              .normal_world = point.normal_world,
                              .distance_m = point.distance_m,
                              .impulse_Ns = point.normal_Ns,
                              .age_steps = point.age_steps});
        }
    });
}

}  // namespace plumbline::physics
