#include "engine/physics/mesh_contact_impl.h"

#include <BulletCollision/BroadphaseCollision/btBroadphaseProxy.h>
#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btConvexConcaveCollisionAlgorithm.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/CollisionShapes/btConcaveShape.h>
#include <BulletCollision/CollisionShapes/btConvexPolyhedron.h>
#include <BulletCollision/CollisionShapes/btTriangleShape.h>

#include <new>

namespace plumbline::physics {
namespace {

/// Face against face by separating axes costs the product of the edge counts: for boxes and the
/// like, not for rounded hulls.
constexpr int kMaxFaceCorners = 16;

bool meets_by_faces(const btCollisionShape& shape) {
    if (!shape.isPolyhedral()) return false;
    const btConvexPolyhedron* hull =
        static_cast<const btPolyhedralConvexShape&>(shape).getConvexPolyhedron();
    return hull != nullptr && hull->m_vertices.size() <= kMaxFaceCorners;
}

/// Which of the two objects of a manifold is the mesh.
enum class MeshPlace { First, Second };

class MeshAlgorithm final : public btCollisionAlgorithm, private btTriangleCallback {
public:
    MeshAlgorithm(const btCollisionAlgorithmConstructionInfo& info,
                  const btCollisionObjectWrapper& first,
                  const btCollisionObjectWrapper& second,
                  MeshPlace place)
        : btCollisionAlgorithm(info), place_(place) {
        const btCollisionObjectWrapper& convex = place == MeshPlace::First ? second : first;
        const btCollisionObjectWrapper& mesh = place == MeshPlace::First ? first : second;
        // The convex body first, whatever the pair's order: edge repair looks for the mesh second.
        manifold_ =
            m_dispatcher->getNewManifold(convex.getCollisionObject(), mesh.getCollisionObject());
    }

    ~MeshAlgorithm() override {
        m_dispatcher->clearManifold(manifold_);
        m_dispatcher->releaseManifold(manifold_);
    }

    void processCollision(const btCollisionObjectWrapper* first,
                          const btCollisionObjectWrapper* second,
                          const btDispatcherInfo& info,
                          btManifoldResult* result) override {
        convex_ = place_ == MeshPlace::First ? second : first;
        mesh_ = place_ == MeshPlace::First ? first : second;
        result_ = result;
        btDispatcherInfo piece_info = info;
        piece_info.m_enableSatConvex = meets_by_faces(*convex_->getCollisionShape());
        info_ = &piece_info;
        reach_ = manifold_->getContactBreakingThreshold() + result->m_closestPointDistanceThreshold;
        result->setPersistentManifold(manifold_);

        const btTransform mesh_from_convex =
            mesh_->getWorldTransform().inverse() * convex_->getWorldTransform();
        btVector3 low;
        btVector3 high;
        convex_->getCollisionShape()->getAabb(mesh_from_convex, low, high);
        const btVector3 reach(reach_, reach_, reach_);
        static_cast<const btConcaveShape*>(mesh_->getCollisionShape())
            ->processAllTriangles(this, low - reach, high + reach);
        result->refreshContactPoints();
        result->setPersistentManifold(nullptr);
        info_ = nullptr;
    }

    btScalar calculateTimeOfImpact(btCollisionObject*,
                                   btCollisionObject*,
                                   const btDispatcherInfo&,
                                   btManifoldResult*) override {
        return 1;  // sweeping is the step's business
    }

    void getAllContactManifolds(btManifoldArray& manifolds) override {
        manifolds.push_back(manifold_);
    }

private:
    /// Corners come in the mesh's frame.
    void processTriangle(btVector3* corners, int part, int index) override {
        if (out_of_reach(corners)) return;
        btTriangleShape triangle(corners[0], corners[1], corners[2]);
        triangle.setMargin(mesh_->getCollisionShape()->getMargin());
        const btCollisionObjectWrapper piece(
            mesh_, &triangle, mesh_->getCollisionObject(), mesh_->getWorldTransform(), part, index);
        const bool mesh_is_a = result_->getBody0Internal() == mesh_->getCollisionObject();
        const btCollisionObjectWrapper* whole =
            mesh_is_a ? result_->getBody0Wrap() : result_->getBody1Wrap();
        if (mesh_is_a) {
            result_->setBody0Wrap(&piece);
            result_->setShapeIdentifiersA(part, index);
        } else {
            result_->setBody1Wrap(&piece);
            result_->setShapeIdentifiersB(part, index);
        }
        btCollisionAlgorithm* meet =
            m_dispatcher->findAlgorithm(convex_, &piece, manifold_, BT_CONTACT_POINT_ALGORITHMS);
        meet->processCollision(convex_, &piece, *info_, result_);
        meet->~btCollisionAlgorithm();
        m_dispatcher->freeCollisionAlgorithm(meet);
        if (mesh_is_a) {
            result_->setBody0Wrap(whole);
        } else {
            result_->setBody1Wrap(whole);
        }
    }

    /// Whether the convex shape lies wholly on one side of the triangle's plane, beyond reach.
    bool out_of_reach(const btVector3* corners) const {
        const btVector3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
        const btScalar length = normal.length();
        if (length <= 0) return true;
        const btTransform convex_from_mesh =
            convex_->getWorldTransform().inverse() * mesh_->getWorldTransform();
        const btVector3 across = convex_from_mesh.getBasis() * (normal / length);
        const btScalar plane = across.dot(convex_from_mesh(corners[0]));
        const auto& convex = static_cast<const btConvexShape&>(*convex_->getCollisionShape());
        const btScalar highest = across.dot(convex.localGetSupportingVertex(across));
        const btScalar lowest = across.dot(convex.localGetSupportingVertex(-across));
        return lowest > plane + reach_ || highest < plane - reach_;
    }

    MeshPlace place_;
    btPersistentManifold* manifold_;
    // Only while processCollision() runs.
    const btCollisionObjectWrapper* convex_{nullptr};
    const btCollisionObjectWrapper* mesh_{nullptr};
    btManifoldResult* result_{nullptr};
    const btDispatcherInfo* info_{nullptr};
    btScalar reach_{0};
};

class Maker final : public btCollisionAlgorithmCreateFunc {
public:
    explicit Maker(MeshPlace place) : place_(place) {}

    btCollisionAlgorithm* CreateCollisionAlgorithm(
        btCollisionAlgorithmConstructionInfo& info,
        const btCollisionObjectWrapper* first,
        const btCollisionObjectWrapper* second) override {
        void* memory = info.m_dispatcher1->allocateCollisionAlgorithm(sizeof(MeshAlgorithm));
        return new (memory) MeshAlgorithm(info, *first, *second, place_);
    }

private:
    MeshPlace place_;
};

// The dispatcher's pool hands out blocks of the largest size Bullet itself needs.
static_assert(sizeof(MeshAlgorithm) <= sizeof(btConvexConcaveCollisionAlgorithm));

}  // namespace

MeshContacts::MeshContacts(btCollisionDispatcher& dispatcher)
    : convex_first_(std::make_unique<Maker>(MeshPlace::Second)),
      mesh_first_(std::make_unique<Maker>(MeshPlace::First)) {
    for (int type = 0; type < CONCAVE_SHAPES_START_HERE; ++type) {
        dispatcher.registerCollisionCreateFunc(
            type, TRIANGLE_MESH_SHAPE_PROXYTYPE, convex_first_.get());
        dispatcher.registerCollisionCreateFunc(
            TRIANGLE_MESH_SHAPE_PROXYTYPE, type, mesh_first_.get());
    }
}

}  // namespace plumbline::physics
