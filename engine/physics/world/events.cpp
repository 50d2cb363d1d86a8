// Contact events: Bullet's manifolds, one line per touching pair.
#include "engine/physics/bullet/convert.h"
#include "engine/physics/world/small_step_world.h"
#include "engine/physics/world/world_state.h"

#include <algorithm>

namespace plumbline::physics {
namespace {

Vec3 velocity_at(const BodyRecord& record, const btVector3& point) {
    const btVector3 arm = point - record.before.getOrigin();
    return from_bullet(record.velocity_before + record.spin_before.cross(arm));
}

/// Normal impulse of a point over the latest substep (bullet_*) or step (small_step).
using ImpulseAt = btScalar (*)(const btManifoldPoint&);

btScalar applied_impulse_Ns(const btManifoldPoint& point) {
    return point.getAppliedImpulse();
}

/// The pair's line from one manifold; false when its points only come near.
bool describe(const btPersistentManifold& manifold, ImpulseAt impulse_at, ContactEvent& event) {
    const btManifoldPoint* hardest = nullptr;
    btScalar most_Ns = 0;
    bool touches = false;
    for (int p = 0; p < manifold.getNumContacts(); ++p) {
        const btManifoldPoint& point = manifold.getContactPoint(p);
        const btScalar impulse_Ns = impulse_at(point);
        touches = touches || point.getDistance() <= 0 || impulse_Ns > 0;
        event.impulse_Ns += impulse_Ns;
        if (hardest == nullptr || impulse_Ns > most_Ns ||
            (impulse_Ns == most_Ns && point.getDistance() < hardest->getDistance())) {
            hardest = &point;
            most_Ns = impulse_Ns;
        }
    }
    if (!touches) return false;

    const BodyRecord* a = &record_of(*manifold.getBody0());
    const BodyRecord* b = &record_of(*manifold.getBody1());
    Vec3 normal = from_bullet(hardest->m_normalWorldOnB);
    const btVector3& point = hardest->getPositionWorldOnB();
    if (b->id < a->id) {
        std::swap(a, b);
        normal = -normal;
    }
    const Vec3 relative = velocity_at(*a, point) - velocity_at(*b, point);
    const Real along = glm::dot(relative, normal);
    event.a = a->id;
    event.b = b->id;
    event.user_a = a->user;
    event.user_b = b->user;
    event.point_world = from_bullet(point);
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
    const ImpulseAt impulse_at = small ? frame_impulse_Ns : applied_impulse_Ns;
    const auto gather = [&](const btPersistentManifold& manifold) {
        if (manifold.getNumContacts() == 0) return;
        if (!all && !record_of(*manifold.getBody0()).contact_events &&
            !record_of(*manifold.getBody1()).contact_events) {
            return;
        }
        ContactEvent event;
        if (describe(manifold, impulse_at, event)) out.push_back(event);
    };
    if (small && !all) {
        for (const btPersistentManifold* manifold : small->touching()) gather(*manifold);
        return;
    }
    for (int i = 0; i < dispatcher->getNumManifolds(); ++i) {
        gather(*dispatcher->getManifoldByIndexInternal(i));
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
