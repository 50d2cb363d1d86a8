#include "engine/physics/bullet/contact/mesh_contact.h"

#include "engine/physics/bullet/contact/mesh_points.h"

#include <BulletCollision/BroadphaseCollision/btBroadphaseProxy.h>
#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btConvexConcaveCollisionAlgorithm.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>

#include <algorithm>
#include <array>
#include <new>
#include <vector>

namespace plumbline::physics {
namespace {

/// Faces one body can press on at once: a corner of a room has three.
constexpr std::size_t kMaxFaces = 4;

/// Takes points out of the manifold that are not among the new ones.
void forget_others(btPersistentManifold& manifold,
                   const std::vector<MeshPoint>& points,
                   const btTransform& world_from_convex,
                   btScalar near) {
    for (int i = manifold.getNumContacts() - 1; i >= 0; --i) {
        const btVector3& old = manifold.getContactPoint(i).m_localPointA;
        const bool found = std::any_of(points.begin(), points.end(), [&](const MeshPoint& point) {
            return world_from_convex.invXform(point.on_convex).distance2(old) < near * near;
        });
        if (!found) manifold.removeContactPoint(i);
    }
}

/// Which of the two objects of a pair is the mesh.
enum class MeshPlace { First, Second };

class MeshAlgorithm final : public btCollisionAlgorithm, public ManifoldByFace {
public:
    MeshAlgorithm(const btCollisionAlgorithmConstructionInfo& info, MeshPlace place)
        : btCollisionAlgorithm(info), place_(place) {}
    ~MeshAlgorithm() override {
        for (btPersistentManifold* manifold : manifolds_) {
            if (manifold == nullptr) continue;
            m_dispatcher->clearManifold(manifold);
            m_dispatcher->releaseManifold(manifold);
        }
    }
    MeshAlgorithm(const MeshAlgorithm&) = delete;
    MeshAlgorithm& operator=(const MeshAlgorithm&) = delete;

    void processCollision(const btCollisionObjectWrapper* first,
                          const btCollisionObjectWrapper* second,
                          const btDispatcherInfo& info,
                          btManifoldResult* result) override;

    btScalar calculateTimeOfImpact(btCollisionObject*,
                                   btCollisionObject*,
                                   const btDispatcherInfo&,
                                   btManifoldResult*) override {
        return 1;  // sweeping is the step's business
    }

    void getAllContactManifolds(btManifoldArray& manifolds) override {
        for (btPersistentManifold* manifold : manifolds_) {
            if (manifold != nullptr) manifolds.push_back(manifold);
        }
    }

    std::uint32_t used_faces() const override {
        std::uint32_t used = 0;
        for (std::size_t i = 0; i < kMaxFaces; ++i) {
            if (manifolds_[i] != nullptr) used |= 1U << i;
        }
        return used;
    }
    void use_faces(std::uint32_t used,
                   const btCollisionObjectWrapper& first,
                   const btCollisionObjectWrapper& second) override {
        const bool mesh_first = place_ == MeshPlace::First;
        for (std::size_t i = 0; i < kMaxFaces; ++i) {
            if ((used >> i & 1U) != 0)
                make(i, mesh_first ? second : first, mesh_first ? first : second);
        }
    }

private:
    void make(std::size_t face,
              const btCollisionObjectWrapper& convex,
              const btCollisionObjectWrapper& mesh);
    btPersistentManifold* manifold_for(const btVector3& normal,
                                       std::array<bool, kMaxFaces>& taken,
                                       const btCollisionObjectWrapper& convex,
                                       const btCollisionObjectWrapper& mesh);

    MeshPlace place_;
    std::array<btPersistentManifold*, kMaxFaces> manifolds_{};
};

// The dispatcher's pool hands out blocks of the largest size Bullet itself needs.
static_assert(sizeof(MeshAlgorithm) <= sizeof(btConvexConcaveCollisionAlgorithm));

void MeshAlgorithm::make(std::size_t face,
                         const btCollisionObjectWrapper& convex,
                         const btCollisionObjectWrapper& mesh) {
    if (manifolds_[face] != nullptr) return;
    // The convex body first, whatever the pair's order.
    manifolds_[face] =
        m_dispatcher->getNewManifold(convex.getCollisionObject(), mesh.getCollisionObject());
}

/// The manifold that pressed along this normal in the step before, else a free one: points found
/// again there keep their impulses.
btPersistentManifold* MeshAlgorithm::manifold_for(const btVector3& normal,
                                                  std::array<bool, kMaxFaces>& taken,
                                                  const btCollisionObjectWrapper& convex,
                                                  const btCollisionObjectWrapper& mesh) {
    std::size_t chosen = kMaxFaces;
    for (std::size_t i = 0; i < kMaxFaces; ++i) {
        if (taken[i]) continue;
        const bool used = manifolds_[i] != nullptr && manifolds_[i]->getNumContacts() > 0;
        if (used &&
            manifolds_[i]->getContactPoint(0).m_normalWorldOnB.dot(normal) > kSameMeshFace) {
            chosen = i;
            break;
        }
        if (!used && chosen == kMaxFaces) chosen = i;
    }
    if (chosen == kMaxFaces) {
        chosen =
            static_cast<std::size_t>(std::find(taken.begin(), taken.end(), false) - taken.begin());
    }
    taken[chosen] = true;
    make(chosen, convex, mesh);
    return manifolds_[chosen];
}

void MeshAlgorithm::processCollision(const btCollisionObjectWrapper* first,
                                     const btCollisionObjectWrapper* second,
                                     const btDispatcherInfo& info,
                                     btManifoldResult* result) {
    const btCollisionObjectWrapper& convex = place_ == MeshPlace::First ? *second : *first;
    const btCollisionObjectWrapper& mesh = place_ == MeshPlace::First ? *first : *second;
    make(0, convex, mesh);
    // Fast pairs search farther than the distance within which points are the same.
    const btScalar reach = manifolds_[0]->getContactBreakingThreshold();
    const btScalar near =
        std::min(convex.getCollisionObject()->getCollisionShape()->getContactBreakingThreshold(
                     gContactBreakingThreshold),
                 reach);
    const bool by_faces = meets_by_faces(*convex.getCollisionShape());
    const MeshPair pair{
        .convex = convex, .mesh = mesh, .by_faces = by_faces, .reach = reach, .near = near};
    std::vector<MeshPoint> found = find_mesh_points(pair, *manifolds_[0], *m_dispatcher, info);

    // Deepest first: it leads its face, and the faces that press hardest get a manifold.
    std::stable_sort(found.begin(), found.end(), [](const MeshPoint& a, const MeshPoint& b) {
        return a.distance < b.distance;
    });
    std::array<bool, kMaxFaces> taken{};
    for (std::size_t face = 0; face < kMaxFaces && !found.empty(); ++face) {
        const btVector3 normal = found.front().normal;
        const auto rest =
            std::stable_partition(found.begin(), found.end(), [&normal](const MeshPoint& point) {
                return point.normal.dot(normal) > kSameMeshFace;
            });
        const std::vector<MeshPoint> points(found.begin(), rest);
        found.erase(found.begin(), rest);
        btPersistentManifold* manifold = manifold_for(normal, taken, convex, mesh);
        const std::vector<MeshPoint> best = four_of(points);
        if (by_faces) forget_others(*manifold, best, convex.getWorldTransform(), near);
        result->setPersistentManifold(manifold);
        for (const MeshPoint& point : best) {
            result->addContactPoint(point.normal, point.on_mesh, point.distance);
        }
    }
    for (std::size_t i = 0; i < kMaxFaces; ++i) {
        if (manifolds_[i] == nullptr) continue;
        // Faces are found whole each time; round shapes gather their points over several steps.
        if (by_faces && !taken[i]) m_dispatcher->clearManifold(manifolds_[i]);
        result->setPersistentManifold(manifolds_[i]);
        result->refreshContactPoints();
    }
    result->setPersistentManifold(nullptr);
}

class MeshMaker final : public btCollisionAlgorithmCreateFunc {
public:
    explicit MeshMaker(MeshPlace place) : place_(place) {}

    btCollisionAlgorithm* CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
                                                   const btCollisionObjectWrapper*,
                                                   const btCollisionObjectWrapper*) override {
        void* memory = info.m_dispatcher1->allocateCollisionAlgorithm(sizeof(MeshAlgorithm));
        return new (memory) MeshAlgorithm(info, place_);
    }

private:
    MeshPlace place_;
};

}  // namespace

MeshContacts::MeshContacts(btCollisionDispatcher& dispatcher)
    : convex_first_(std::make_unique<MeshMaker>(MeshPlace::Second)),
      mesh_first_(std::make_unique<MeshMaker>(MeshPlace::First)) {
    for (int type = 0; type < CONCAVE_SHAPES_START_HERE; ++type) {
        dispatcher.registerCollisionCreateFunc(
            type, TRIANGLE_MESH_SHAPE_PROXYTYPE, convex_first_.get());
        dispatcher.registerCollisionCreateFunc(
            TRIANGLE_MESH_SHAPE_PROXYTYPE, type, mesh_first_.get());
    }
}

}  // namespace plumbline::physics
