#include "engine/physics/bullet/archive/contact_archive.h"

#include "engine/physics/bullet/archive/bullet_fields.h"

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btCompoundCompoundCollisionAlgorithm.h>
#include <BulletCollision/CollisionDispatch/btHashedSimplePairCache.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>

#include <algorithm>
#include <array>
#include <map>

namespace plumbline::physics {
namespace {

/// What a compound's algorithm keeps of its children, which Bullet shows to derived classes only.
struct CompoundAlgorithm : btCompoundCollisionAlgorithm {
    static auto& children_of(btCompoundCollisionAlgorithm& compound) {
        return compound.*(&CompoundAlgorithm::m_childCollisionAlgorithms);
    }
    static bool is_swapped(const btCompoundCollisionAlgorithm& compound) {
        return compound.*(&CompoundAlgorithm::m_isSwapped);
    }
};

// ... and that of two compounds to nobody. An explicit instantiation may name what is private.
btHashedSimplePairCache* pair_cache_of(btCompoundCompoundCollisionAlgorithm& compounds);
template <btHashedSimplePairCache* btCompoundCompoundCollisionAlgorithm::*kCache>
struct PairCacheOf {
    friend btHashedSimplePairCache* pair_cache_of(btCompoundCompoundCollisionAlgorithm& compounds) {
        return compounds.*kCache;
    }
};
template struct PairCacheOf<&btCompoundCompoundCollisionAlgorithm::m_childCollisionAlgorithmCache>;

const btCompoundShape& compound_of(const btCollisionObjectWrapper& wrap) {
    return static_cast<const btCompoundShape&>(*wrap.getCollisionShape());
}

btTransform world_from_child(const btCollisionObjectWrapper& wrap, int child) {
    return wrap.getWorldTransform() * compound_of(wrap).getChildTransform(child);
}

constexpr std::string_view kTooManyPoints = "a contact has too many points";

void serialize_point(Archive& archive, btManifoldPoint& p) {
    archive(p.m_localPointA,
            p.m_localPointB,
            p.m_positionWorldOnB,
            p.m_positionWorldOnA,
            p.m_normalWorldOnB,
            p.m_distance1,
            p.m_combinedFriction,
            p.m_combinedRollingFriction,
            p.m_combinedSpinningFriction,
            p.m_combinedRestitution,
            p.m_partId0,
            p.m_partId1,
            p.m_index0,
            p.m_index1,
            p.m_contactPointFlags,
            p.m_appliedImpulse,
            p.m_prevRHS,
            p.m_appliedImpulseLateral1,
            p.m_appliedImpulseLateral2,
            p.m_contactMotion1,
            p.m_contactMotion2,
            p.m_contactCFM,
            p.m_contactERP,
            p.m_frictionCFM,
            p.m_lifeTime,
            p.m_lateralFrictionDir1,
            p.m_lateralFrictionDir2);
}

void serialize_manifold(Archive& archive, btPersistentManifold& manifold) {
    int count = manifold.getNumContacts();
    btScalar breaking_m = manifold.getContactBreakingThreshold();
    btScalar processing_m = manifold.getContactProcessingThreshold();
    archive(count, breaking_m, processing_m, manifold.m_companionIdA);
    if (!archive.expect(count >= 0 && count <= MANIFOLD_CACHE_SIZE, kTooManyPoints)) return;
    if (archive.reads()) {
        manifold.clearManifold();
        manifold.setNumContacts(count);
        manifold.setContactBreakingThreshold(breaking_m);
        manifold.setContactProcessingThreshold(processing_m);
    }
    for (int i = 0; i < count; ++i) {
        btManifoldPoint& point = manifold.getContactPoint(i);
        if (archive.reads()) point = btManifoldPoint();
        serialize_point(archive, point);
    }
}

constexpr std::string_view kOtherContacts = "its contacts are not those of these shapes";

}  // namespace

void ContactArchive::pair(btCollisionAlgorithm*& found, btRigidBody& first, btRigidBody& second) {
    const btCollisionObjectWrapper a(
        nullptr, first.getCollisionShape(), &first, first.getWorldTransform(), -1, -1);
    const btCollisionObjectWrapper b(
        nullptr, second.getCollisionShape(), &second, second.getWorldTransform(), -1, -1);
    // Some algorithms give bodies that sleep no manifold.
    const int state_of_first = first.getActivationState();
    const int state_of_second = second.getActivationState();
    first.forceActivationState(ACTIVE_TAG);
    second.forceActivationState(ACTIVE_TAG);
    algorithm(found, a, b);
    first.forceActivationState(state_of_first);
    second.forceActivationState(state_of_second);
}

void ContactArchive::forget(btCollisionAlgorithm*& algorithm) {
    if (algorithm == nullptr) return;
    algorithm->~btCollisionAlgorithm();
    dispatcher_.freeCollisionAlgorithm(algorithm);
    algorithm = nullptr;
}

void ContactArchive::algorithm(btCollisionAlgorithm*& found,
                               const btCollisionObjectWrapper& first,
                               const btCollisionObjectWrapper& second) {
    bool is_there = found != nullptr;
    archive_(is_there);
    if (archive_.failed()) return;
    if (archive_.reads() && !is_there) forget(found);
    if (archive_.reads() && is_there && found == nullptr)
        found = dispatcher_.findAlgorithm(&first, &second, nullptr, BT_CONTACT_POINT_ALGORITHMS);
    if (!is_there || found == nullptr) return;
    if (auto* compound = dynamic_cast<btCompoundCollisionAlgorithm*>(found)) {
        children(*compound, first, second);
        if (dynamic_cast<btCompoundCompoundCollisionAlgorithm*>(found) != nullptr)
            child_pairs(*found, first, second);
    } else {
        single(*found, first, second);
    }
}

void ContactArchive::children(btCompoundCollisionAlgorithm& compound,
                              const btCollisionObjectWrapper& first,
                              const btCollisionObjectWrapper& second) {
    const bool swapped = CompoundAlgorithm::is_swapped(compound);
    const btCollisionObjectWrapper& whole = swapped ? second : first;
    const btCollisionObjectWrapper& other = swapped ? first : second;
    auto& children = CompoundAlgorithm::children_of(compound);
    for (int i = 0; i < children.size(); ++i) {
        const btCollisionObjectWrapper child(&whole,
                                             compound_of(whole).getChildShape(i),
                                             whole.getCollisionObject(),
                                             world_from_child(whole, i),
                                             -1,
                                             i);
        algorithm(children[i], child, other);
    }
}

void ContactArchive::child_pairs(btCollisionAlgorithm& compounds,
                                 const btCollisionObjectWrapper& first,
                                 const btCollisionObjectWrapper& second) {
    btHashedSimplePairCache& cache =
        *pair_cache_of(static_cast<btCompoundCompoundCollisionAlgorithm&>(compounds));
    const std::size_t size =
        archive_.count(static_cast<std::size_t>(cache.getNumOverlappingPairs()));
    for (std::size_t i = 0; i < size && !archive_.failed(); ++i) {
        std::array<int, 2> index{};
        if (!archive_.reads()) {
            const btSimplePair& pair = cache.getOverlappingPairArray()[static_cast<int>(i)];
            index = {pair.m_indexA, pair.m_indexB};
        }
        archive_(index);
        const auto is_child = [](int child, const btCollisionObjectWrapper& of) {
            return child >= 0 && child < compound_of(of).getNumChildShapes();
        };
        if (!archive_.expect(is_child(index[0], first) && is_child(index[1], second),
                             kOtherContacts))
            return;
        const btCollisionObjectWrapper a(&first,
                                         compound_of(first).getChildShape(index[0]),
                                         first.getCollisionObject(),
                                         world_from_child(first, index[0]),
                                         -1,
                                         index[0]);
        const btCollisionObjectWrapper b(&second,
                                         compound_of(second).getChildShape(index[1]),
                                         second.getCollisionObject(),
                                         world_from_child(second, index[1]),
                                         -1,
                                         index[1]);
        btCollisionAlgorithm* child = nullptr;
        if (!archive_.reads())
            child = static_cast<btCollisionAlgorithm*>(
                cache.getOverlappingPairArray()[static_cast<int>(i)].m_userPointer);
        algorithm(child, a, b);
        if (archive_.reads() && child != nullptr)
            cache.addOverlappingPair(index[0], index[1])->m_userPointer = child;
    }
}

void ContactArchive::single(btCollisionAlgorithm& single,
                            const btCollisionObjectWrapper& first,
                            const btCollisionObjectWrapper& second) {
    btManifoldArray list;
    single.getAllContactManifolds(list);
    int count = list.size();
    archive_(count);
    if (archive_.reads() && list.size() < count) {
        // Some make theirs when they first look; what they find now is written over.
        btManifoldResult result(&first, &second);
        single.processCollision(&first, &second, info_, &result);
        list.resize(0);
        single.getAllContactManifolds(list);
    }
    if (!archive_.expect(list.size() == count, kOtherContacts)) return;
    for (int i = 0; i < count; ++i) {
        serialize_manifold(archive_, *list[i]);
        manifolds_.push_back(list[i]);
    }
}

void ContactArchive::order() {
    const int count = dispatcher_.getNumManifolds();
    if (!archive_.expect(static_cast<std::size_t>(count) == manifolds_.size(), kOtherContacts))
        return;
    std::vector<int> places;
    for (const btPersistentManifold* manifold : manifolds_) places.push_back(manifold->m_index1a);
    archive_(places);
    std::vector<int> sorted = places;
    std::ranges::sort(sorted);
    bool each_once = places.size() == manifolds_.size();
    for (int i = 0; i < count && each_once; ++i)
        each_once = sorted[static_cast<std::size_t>(i)] == i;
    if (!archive_.expect(each_once, kOtherContacts) || !archive_.reads()) return;
    btPersistentManifold** listed = dispatcher_.getInternalManifoldPointer();
    for (std::size_t i = 0; i < places.size(); ++i) {
        listed[places[i]] = manifolds_[i];
        manifolds_[i]->m_index1a = places[i];
    }
}

}  // namespace plumbline::physics
