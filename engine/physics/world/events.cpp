// Contact events: one line per touching pair.
#include "engine/physics/bullet/convert.h"
#include "engine/physics/world/small_step_world.h"
#include "engine/physics/world/world_state.h"

#include <algorithm>

namespace plumbline::physics {
namespace {

Vec3 velocity_before_at(const BodyRecord& record, const Vec3& point) {
    const btVector3 arm = to_bullet(point) - record.before.getOrigin();
    return from_bullet(record.velocity_before + record.spin_before.cross(arm));
}

/// What an event needs of a point. The normal impulse is that of the latest substep (bullet_*) or
/// step (small_step).
struct Touch {
    Vec3 point_b_world{0, 0, 0};
    Vec3 normal_world{0, 1, 0};
    Real distance_m{0};
    Real impulse_Ns{0};
};

/// A manifold of either kind.
struct Touching {
    const BodyRecord* a{nullptr};
    const BodyRecord* b{nullptr};
    std::vector<Touch> points;
};

/// The pair's line from one manifold; false when its points only come near.
bool describe(const Touching& manifold, ContactEvent& event) {
    const Touch* hardest = nullptr;
    bool touches = false;
    for (const Touch& point : manifold.points) {
        touches = touches || point.distance_m <= 0 || point.impulse_Ns > 0;
        event.impulse_Ns += point.impulse_Ns;
        const Real most_Ns = hardest != nullptr ? hardest->impulse_Ns : Real{0};
        if (hardest == nullptr || point.impulse_Ns > most_Ns ||
            (point.impulse_Ns == most_Ns && point.distance_m < hardest->distance_m)) {
            hardest = &point;
        }
    }
    if (!touches) return false;

    const BodyRecord* a = manifold.a;
    const BodyRecord* b = manifold.b;
    Vec3 normal = hardest->normal_world;
    const Vec3& point = hardest->point_b_world;
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

}  // namespace

void PhysicsWorld::Impl::gather_events(bool all, std::vector<ContactEvent>& out) const {
    Touching touching;
    const auto begin = [&](const BodyRecord& a, const BodyRecord& b) {
        touching.a = &a;
        touching.b = &b;
        touching.points.clear();
        return all || a.contact_events || b.contact_events;
    };
    const auto finish = [&] {
        ContactEvent event;
        if (!touching.points.empty() && describe(touching, event)) out.push_back(event);
    };
    const auto gather = [&](const Manifold& manifold) {
        if (!begin(*manifold.a, *manifold.b)) return;
        for (const ManifoldPoint& point : manifold.points) {
            touching.points.push_back({.point_b_world = point.b.surface_m,
                                       .normal_world = point.normal_world,
                                       .distance_m = point.distance_m,
                                       .impulse_Ns = point.normal_Ns});
        }
        finish();
    };
    if (small && all) return small->pairs().each_manifold(gather);
    if (small) {
        for (const Manifold* manifold : small->touching()) gather(*manifold);
        return;
    }
    for (int i = 0; i < dispatcher->getNumManifolds(); ++i) {
        const btPersistentManifold& manifold = *dispatcher->getManifoldByIndexInternal(i);
        if (!begin(record_of(*manifold.getBody0()), record_of(*manifold.getBody1()))) continue;
        for (int p = 0; p < manifold.getNumContacts(); ++p) {
            const btManifoldPoint& point = manifold.getContactPoint(p);
            touching.points.push_back({.point_b_world = from_bullet(point.getPositionWorldOnB()),
                                       .normal_world = from_bullet(point.m_normalWorldOnB),
                                       .distance_m = point.getDistance(),
                                       .impulse_Ns = point.getAppliedImpulse()});
        }
        finish();
    }
}

/// Whether the pair sleeps and is still asked for: then it touches as it did.
bool PhysicsWorld::Impl::sleeps_on(const ContactEvent& event) const {
    const auto* a = bodies.find(event.a);
    const auto* b = bodies.find(event.b);
    if (a == nullptr || b == nullptr) return false;
    return !(*a)->awake && !(*b)->awake && (*a)->in_world && (*b)->in_world &&
           ((*a)->contact_events || (*b)->contact_events);
}

void PhysicsWorld::Impl::finish_events() {
    if (slept_through && events_asleep) return;  // nothing that is listed changed
    events_asleep = slept_through;
    std::vector<ContactEvent> before = std::move(events);
    events = merged(std::move(gathered));
    gathered.clear();
    const auto earlier = [](const ContactEvent& x, const ContactEvent& y) {
        return pair_of(x) < pair_of(y);
    };
    for (ContactEvent& event : events) {
        event.began = !std::binary_search(before.begin(), before.end(), event, earlier);
    }
    if (!small) return;
    const auto listed = static_cast<std::ptrdiff_t>(events.size());
    for (ContactEvent& event : before) {
        if (!sleeps_on(event)) continue;
        if (std::binary_search(events.begin(), events.begin() + listed, event, earlier)) continue;
        event.closing_speed_mps = 0;
        event.sliding_speed_mps = 0;
        event.began = false;
        events.push_back(event);
    }
    std::inplace_merge(events.begin(), events.begin() + listed, events.end(), earlier);
}

std::vector<ContactEvent> PhysicsWorld::all_contacts() const {
    std::vector<ContactEvent> list;
    impl_->gather_events(true, list);
    return merged(std::move(list));
}

}  // namespace plumbline::physics
