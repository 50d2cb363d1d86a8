#include "engine/bullet_world/contact_copies.h"

#include "engine/physics/query.h"

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>

#include <algorithm>

namespace plumbline::bullet_world {
namespace {

constexpr std::size_t kPointsEach = MANIFOLD_CACHE_SIZE;

void copy(const physics::ContactPoint& from,
          const btPersistentManifold& manifold,
          btManifoldPoint& to) {
    to.m_positionWorldOnA = bullet_of(from.point_a_world);
    to.m_positionWorldOnB = bullet_of(from.point_b_world);
    to.m_localPointA = manifold.getBody0()->getWorldTransform().invXform(to.m_positionWorldOnA);
    to.m_localPointB = manifold.getBody1()->getWorldTransform().invXform(to.m_positionWorldOnB);
    to.m_normalWorldOnB = bullet_of(from.normal_world);
    to.m_distance1 = from.distance_m;
    to.m_appliedImpulse = from.impulse_Ns;
    to.m_lifeTime = from.age_steps;
}

btManifoldPoint fresh_point(const Mirror& a, const Mirror& b) {
    btManifoldPoint point({0, 0, 0}, {0, 0, 0}, {0, 1, 0}, 0);
    point.m_combinedFriction = gCalculateCombinedFrictionCallback(a.object, b.object);
    point.m_combinedRestitution = gCalculateCombinedRestitutionCallback(a.object, b.object);
    return point;
}

bool wants_added(const btCollisionObject& object) {
    return (object.getCollisionFlags() & btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK) != 0;
}

btCollisionObjectWrapper wrapped(const btCollisionObject& object) {
    return {nullptr, object.getCollisionShape(), &object, object.getWorldTransform(), -1, -1};
}

}  // namespace

void ContactCopies::write(const physics::PhysicsWorld& world) {
    physics::contact_points(world, points_);
    ++step_;
    filled_.clear();
    const auto same_pair = [this](std::size_t i, std::size_t j) {
        return points_[i].a == points_[j].a && points_[i].b == points_[j].b;
    };
    for (std::size_t first = 0; first < points_.size();) {
        std::size_t end = first + 1;
        while (end < points_.size() && same_pair(first, end)) ++end;
        fill(mirror_of(points_[first].user_a), mirror_of(points_[first].user_b), first, end);
        first = end;
    }
    for (auto entry = copies_.begin(); entry != copies_.end();) {
        if (entry->second.found == step_) {
            ++entry;
            continue;
        }
        Copies gone = std::move(entry->second);
        entry = copies_.erase(entry);
        release(gone, 0);
    }
    if (gContactProcessedCallback == nullptr && gContactAddedCallback == nullptr) return;
    for (std::size_t i = 0; i < filled_.size(); ++i) call_back(i);
}

void ContactCopies::fill(const Mirror& a, const Mirror& b, std::size_t first, std::size_t end) {
    Copies& copies = copies_[{a.body, b.body}];
    copies.found = step_;
    const std::size_t wanted = (end - first + kPointsEach - 1) / kPointsEach;
    release(copies, wanted);
    while (copies.manifolds.size() < wanted)
        copies.manifolds.push_back(world_.getDispatcher()->getNewManifold(a.object, b.object));
    for (btPersistentManifold* manifold : copies.manifolds) {
        const std::size_t count = std::min(kPointsEach, end - first);
        const auto count_before = static_cast<std::size_t>(manifold->getNumContacts());
        for (std::size_t i = 0; i < count; ++i, ++first) {
            if (i >= count_before) manifold->addManifoldPoint(fresh_point(a, b));
            copy(points_[first], *manifold, manifold->getContactPoint(static_cast<int>(i)));
        }
        for (std::size_t i = count_before; i > count; --i)
            manifold->removeContactPoint(static_cast<int>(i) - 1);
        if (count_before == 0 && gContactStartedCallback != nullptr)
            gContactStartedCallback(manifold);
        filled_.push_back(manifold);
    }
}

/// Any call may take the manifold away.
void ContactCopies::call_back(std::size_t place) {
    const auto there = [&] { return place < filled_.size() && filled_[place] != nullptr; };
    for (int i = 0; there() && i < filled_[place]->getNumContacts(); ++i) {
        btManifoldPoint& point = filled_[place]->getContactPoint(i);
        const auto* a = filled_[place]->getBody0();
        const auto* b = filled_[place]->getBody1();
        if (gContactAddedCallback != nullptr && point.m_lifeTime == 0 &&
            (wants_added(*a) || wants_added(*b))) {
            const auto side_a = wrapped(*a);
            const auto side_b = wrapped(*b);
            gContactAddedCallback(point, &side_a, -1, -1, &side_b, -1, -1);
        }
        if (gContactProcessedCallback == nullptr || !there()) continue;
        gContactProcessedCallback(
            point, const_cast<btCollisionObject*>(a), const_cast<btCollisionObject*>(b));
    }
}

/// Those beyond `kept`.
void ContactCopies::release(Copies& copies, std::size_t kept) {
    while (copies.manifolds.size() > kept) {
        btPersistentManifold* manifold = copies.manifolds.back();
        copies.manifolds.pop_back();
        world_.getDispatcher()->releaseManifold(manifold);
    }
}

void ContactCopies::forget(const btCollisionObject& object) {
    const Mirror* mirror = bodies_.find(object);
    if (mirror == nullptr || mirror->body == physics::BodyId{}) return;
    for (auto entry = copies_.begin(); entry != copies_.end();) {
        if (entry->first.first != mirror->body && entry->first.second != mirror->body) {
            ++entry;
            continue;
        }
        Copies gone = std::move(entry->second);
        entry = copies_.erase(entry);
        for (const btPersistentManifold* manifold : gone.manifolds)
            std::ranges::replace(filled_, manifold, nullptr);
        release(gone, 0);
    }
}

void ContactCopies::clear() {
    filled_.clear();
    while (!copies_.empty()) {
        Copies gone = std::move(copies_.begin()->second);
        copies_.erase(copies_.begin());
        release(gone, 0);
    }
}

}  // namespace plumbline::bullet_world
