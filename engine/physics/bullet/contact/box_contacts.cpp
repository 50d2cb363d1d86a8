#include "engine/physics/bullet/contact/box_contacts.h"

#include "engine/physics/bullet/contact/contact_copy.h"
#include "engine/physics/bullet/convert.h"
#include "engine/physics/collision/narrow_phase/box_box.h"
#include "engine/physics/collision/narrow_phase/sphere_box.h"

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btCapsuleShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>

#include <algorithm>
#include <array>
#include <new>
#include <span>

namespace plumbline::physics {
namespace {

OrientedBox box_of(const btCollisionObjectWrapper& wrap) {
    const auto& shape = static_cast<const btBoxShape&>(*wrap.getCollisionShape());
    const btTransform& at = wrap.getWorldTransform();
    OrientedBox box{.center = from_bullet(at.getOrigin()),
                    .half_m = from_bullet(shape.getHalfExtentsWithMargin())};
    for (int k = 0; k < 3; ++k) box.axes[k] = from_bullet(at.getBasis().getColumn(k));
    return box;
}

/// The points of the step before, kept while the new ones are found: what they carried goes to the
/// new point that is nearest on either body.
class OldPoints {
public:
    explicit OldPoints(btPersistentManifold& manifold) : count_(manifold.getNumContacts()) {
        for (int i = 0; i < count_; ++i)
            points_[static_cast<std::size_t>(i)] = manifold.getContactPoint(i);
        while (manifold.getNumContacts() > 0)
            manifold.removeContactPoint(manifold.getNumContacts() - 1);
    }
    void give(btPersistentManifold& manifold, btScalar near_m) const {
        for (int i = 0; i < manifold.getNumContacts(); ++i) {
            btManifoldPoint& point = manifold.getContactPoint(i);
            const btManifoldPoint* old = nearest(point, near_m);
            if (old != nullptr) find_again(point, *old);
        }
    }

private:
    const btManifoldPoint* nearest(const btManifoldPoint& point, btScalar near_m) const {
        const btManifoldPoint* found = nullptr;
        btScalar least = near_m * near_m;
        for (int i = 0; i < count_; ++i) {
            const btManifoldPoint& old = points_[static_cast<std::size_t>(i)];
            const btScalar away2 = std::min(old.m_localPointA.distance2(point.m_localPointA),
                                            old.m_localPointB.distance2(point.m_localPointB));
            if (away2 >= least) continue;
            least = away2;
            found = &old;
        }
        return found;
    }

    std::array<btManifoldPoint, MANIFOLD_CACHE_SIZE> points_;
    int count_;
};

/// Holds the pair's manifold; it reaches as far as the manifold's breaking threshold says.
class OneManifold : public btCollisionAlgorithm {
public:
    OneManifold(const btCollisionAlgorithmConstructionInfo& info,
                const btCollisionObjectWrapper* first,
                const btCollisionObjectWrapper* second)
        : btCollisionAlgorithm(info),
          manifold_(info.m_dispatcher1->getNewManifold(first->getCollisionObject(),
                                                       second->getCollisionObject())) {}
    ~OneManifold() override { m_dispatcher->releaseManifold(manifold_); }

    void getAllContactManifolds(btManifoldArray& list) override { list.push_back(manifold_); }
    btScalar calculateTimeOfImpact(btCollisionObject*,
                                   btCollisionObject*,
                                   const btDispatcherInfo&,
                                   btManifoldResult*) override {
        return 1;
    }

protected:
    btPersistentManifold& manifold() { return *manifold_; }
    btScalar reach_m() const { return manifold_->getContactBreakingThreshold(); }

private:
    btPersistentManifold* manifold_;
};

class BoxesAlgorithm final : public OneManifold {
public:
    using OneManifold::OneManifold;

    void processCollision(const btCollisionObjectWrapper* first,
                          const btCollisionObjectWrapper* second,
                          const btDispatcherInfo&,
                          btManifoldResult* result) override {
        result->setPersistentManifold(&manifold());
        const OrientedBox a = box_of(*first);
        const OrientedBox b = box_of(*second);
        const BoxContact found = collide_boxes(a, b, reach_m());
        const OldPoints old(manifold());
        const btVector3 normal = to_bullet(found.normal);
        for (int i = 0; i < found.count; ++i) {
            const auto at = static_cast<std::size_t>(i);
            result->addContactPoint(normal, to_bullet(found.on_b[at]), found.distance_m[at]);
        }
        const Vec3 least = glm::min(a.half_m, b.half_m);
        old.give(manifold(), kNear * std::min({least.x, least.y, least.z}));
    }

private:
    /// Points that moved less are the same, as a share of the smaller box's least half edge.
    static constexpr btScalar kNear = btScalar(0.2);
};

/// A sphere or a capsule against a box: the points of spheres along the capsule's axis.
class RoundBoxAlgorithm final : public OneManifold {
public:
    using OneManifold::OneManifold;

    void processCollision(const btCollisionObjectWrapper* first,
                          const btCollisionObjectWrapper* second,
                          const btDispatcherInfo&,
                          btManifoldResult* result) override {
        result->setPersistentManifold(&manifold());
        const bool round_first = first->getCollisionShape()->getShapeType() != BOX_SHAPE_PROXYTYPE;
        const btCollisionObjectWrapper& round = round_first ? *first : *second;
        const OrientedBox box = box_of(round_first ? *second : *first);
        const btTransform& at = round.getWorldTransform();
        const Vec3 middle = from_bullet(at.getOrigin());
        if (round.getCollisionShape()->getShapeType() == SPHERE_SHAPE_PROXYTYPE) {
            const auto& sphere = static_cast<const btSphereShape&>(*round.getCollisionShape());
            touch({&middle, 1}, sphere.getRadius(), box, round_first, *result);
            return;
        }
        const auto& capsule = static_cast<const btCapsuleShape&>(*round.getCollisionShape());
        const Vec3 half =
            from_bullet(at.getBasis().getColumn(capsule.getUpAxis())) * capsule.getHalfHeight();
        std::array<Vec3, 3> centers{middle - half, middle + half, middle};
        centers[2] = middle + half * (2 * nearest_on_segment(centers[0], centers[1], box) - 1);
        const auto distance_m = [&](const Vec3& center) {
            return collide_sphere_box(center, 0, box).distance_m;
        };
        // Nearer than both ends: an edge or a corner between them.
        const bool between =
            distance_m(centers[2]) < std::min(distance_m(centers[0]), distance_m(centers[1])) -
                                         kNearer * capsule.getRadius();
        touch({centers.data(), between ? 3U : 2U}, capsule.getRadius(), box, round_first, *result);
    }

private:
    static constexpr Real kNearer = 1e-3_r;

    /// Puts the points of spheres at `centers` that are within reach into the manifold.
    void touch(std::span<const Vec3> centers,
               Real radius_m,
               const OrientedBox& box,
               bool round_first,
               btManifoldResult& result) {
        const OldPoints old(manifold());
        for (const Vec3& center : centers) {
            const SphereContact found = collide_sphere_box(center, radius_m, box);
            if (found.distance_m > reach_m()) continue;
            const Vec3 normal = round_first ? found.normal : -found.normal;
            // Of the second body: the box's, or the sphere's lowest.
            const Vec3 on_second =
                round_first ? found.on_box : found.on_box + found.normal * found.distance_m;
            result.addContactPoint(to_bullet(normal), to_bullet(on_second), found.distance_m);
        }
        old.give(manifold(), BT_LARGE_FLOAT);
    }
};

template <class Algorithm>
struct Maker final : btCollisionAlgorithmCreateFunc {
    btCollisionAlgorithm* CreateCollisionAlgorithm(
        btCollisionAlgorithmConstructionInfo& info,
        const btCollisionObjectWrapper* first,
        const btCollisionObjectWrapper* second) override {
        void* memory = info.m_dispatcher1->allocateCollisionAlgorithm(sizeof(Algorithm));
        return new (memory) Algorithm(info, first, second);
    }
};

}  // namespace

BoxContacts::BoxContacts(btCollisionDispatcher& dispatcher)
    : makers_{std::make_unique<Maker<BoxesAlgorithm>>(),
              std::make_unique<Maker<RoundBoxAlgorithm>>()} {
    const auto meet = [&](int first, int second, std::size_t maker) {
        dispatcher.registerCollisionCreateFunc(first, second, makers_[maker].get());
        dispatcher.registerClosestPointsCreateFunc(first, second, makers_[maker].get());
    };
    meet(BOX_SHAPE_PROXYTYPE, BOX_SHAPE_PROXYTYPE, 0);
    meet(SPHERE_SHAPE_PROXYTYPE, BOX_SHAPE_PROXYTYPE, 1);
    meet(BOX_SHAPE_PROXYTYPE, SPHERE_SHAPE_PROXYTYPE, 1);
    meet(CAPSULE_SHAPE_PROXYTYPE, BOX_SHAPE_PROXYTYPE, 1);
    meet(BOX_SHAPE_PROXYTYPE, CAPSULE_SHAPE_PROXYTYPE, 1);
}

}  // namespace plumbline::physics
