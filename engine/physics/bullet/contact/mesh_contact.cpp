#include "engine/physics/bullet/contact/mesh_contact.h"

#include <BulletCollision/BroadphaseCollision/btBroadphaseProxy.h>
#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btConvexConcaveCollisionAlgorithm.h>
#include <BulletCollision/CollisionDispatch/btInternalEdgeUtility.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/CollisionShapes/btConcaveShape.h>
#include <BulletCollision/CollisionShapes/btConvexPolyhedron.h>
#include <BulletCollision/CollisionShapes/btTriangleInfoMap.h>
#include <BulletCollision/CollisionShapes/btTriangleShape.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <vector>

namespace plumbline::physics {
namespace {

/// Face against face by separating axes costs the product of the edge counts: for boxes and the
/// like, not for rounded hulls.
constexpr int kMaxFaceCorners = 16;
/// Points whose normals differ by less than 18 degrees press on one face and share four points.
constexpr btScalar kSameMeshFace = btScalar(0.95);
/// Faces one body can press on at once: a corner of a room has three.
constexpr std::size_t kMaxFaces = 4;

bool meets_by_faces(const btCollisionShape& shape) {
    if (!shape.isPolyhedral()) return false;
    const btConvexPolyhedron* hull =
        static_cast<const btPolyhedralConvexShape&>(shape).getConvexPolyhedron();
    return hull != nullptr && hull->m_vertices.size() <= kMaxFaceCorners;
}

/// A contact point as a triangle gave it, its normal mended at edges inside the mesh.
struct Candidate {
    btVector3 normal;  ///< from the mesh to the convex shape
    btVector3 on_mesh;
    btVector3 on_convex;
    btScalar distance;
};

/// Keeps what the pair algorithms find instead of putting it into a manifold of four.
class Collector final : public btManifoldResult {
public:
    Collector(const btCollisionObjectWrapper* convex,
              const btCollisionObjectWrapper* mesh,
              btScalar rim,
              std::vector<Candidate>& found)
        : btManifoldResult(convex, mesh), rim_(rim), found_(found) {}

    void meet(const btCollisionObjectWrapper* triangle, int part, int index) {
        setBody1Wrap(triangle);
        setShapeIdentifiersA(-1, -1);
        setShapeIdentifiersB(part, index);
        part_ = part;
        index_ = index;
    }

    void addContactPoint(const btVector3& normal,
                         const btVector3& on_mesh,
                         btScalar distance) override {
        if (distance > m_manifoldPtr->getContactBreakingThreshold()) return;
        const btVector3 on_convex = on_mesh + normal * distance;
        btManifoldPoint point(m_body0Wrap->getWorldTransform().invXform(on_convex),
                              m_body1Wrap->getWorldTransform().invXform(on_mesh),
                              normal,
                              distance);
        point.m_positionWorldOnA = on_convex;
        point.m_positionWorldOnB = on_mesh;
        btAdjustInternalEdgeContacts(point, m_body1Wrap, m_body0Wrap, part_, index_);
        if (!plausible(point)) return;
        if (point.m_normalWorldOnB != normal) touch_along_normal(point, on_mesh);
        found_.push_back({.normal = point.m_normalWorldOnB,
                          .on_mesh = point.m_positionWorldOnB,
                          .on_convex = point.m_positionWorldOnA,
                          .distance = point.getDistance()});
    }

private:
    /// A ball touches where its normal says: under its middle on a floor, not at the seam ahead of
    /// it, where the point would brake its rolling.
    void touch_along_normal(btManifoldPoint& point, const btVector3& on_mesh) const {
        if (m_body0Wrap->getCollisionShape()->getShapeType() != SPHERE_SHAPE_PROXYTYPE) return;
        const auto& ball = static_cast<const btSphereShape&>(*m_body0Wrap->getCollisionShape());
        const btVector3& normal = point.m_normalWorldOnB;
        const btVector3 lowest =
            m_body0Wrap->getWorldTransform().getOrigin() - normal * ball.getRadius();
        point.m_distance1 = (lowest - on_mesh).dot(normal);
        point.m_positionWorldOnA = lowest;
        point.m_positionWorldOnB = lowest - normal * point.m_distance1;
    }

    /// Away from a face's own normal only an edge or corner that sticks out can press. Where a flat
    /// thing lies on a face, the overlaps along and across differ by rounding alone; the wrong one
    /// may win, and edge repair leaves normals alone that are level with the face.
    bool plausible(const btManifoldPoint& point) const {
        const auto& triangle =
            static_cast<const btTriangleShape&>(*m_body1Wrap->getCollisionShape());
        btVector3 face;
        triangle.calcNormal(face);
        const btVector3 normal =
            m_body1Wrap->getWorldTransform().getBasis().transpose() * point.m_normalWorldOnB;
        if (std::abs(normal.dot(face)) > kSameMeshFace) return true;
        for (int i = 0; i < 3; ++i) {
            const btVector3& a = triangle.m_vertices1[i];
            const btVector3& b = triangle.m_vertices1[(i + 1) % 3];
            const btVector3 inward = face.cross((b - a).normalized());
            if (inward.dot(point.m_localPointB - a) < rim_ && sticks_out(i)) return true;
        }
        return false;
    }

    /// Whether the triangle's i-th edge is a rim or a ridge, not a seam or a valley.
    bool sticks_out(int i) const {
        const auto& mesh = static_cast<const btBvhTriangleMeshShape&>(
            *m_body1Wrap->getCollisionObject()->getCollisionShape());
        const btTriangleInfo* info = mesh.getTriangleInfoMap()->find(
            btHashInt((part_ << (31 - MAX_NUM_PARTS_IN_BITS)) | index_));
        if (info == nullptr) return true;  // no neighbours at all
        const std::array<btScalar, 3> angles{
            info->m_edgeV0V1Angle, info->m_edgeV1V2Angle, info->m_edgeV2V0Angle};
        constexpr std::array<int, 3> kConvex{
            TRI_INFO_V0V1_CONVEX, TRI_INFO_V1V2_CONVEX, TRI_INFO_V2V0_CONVEX};
        const auto edge = static_cast<std::size_t>(i);
        if (angles[edge] >= SIMD_2_PI) return true;
        return (info->m_flags & kConvex[edge]) != 0 && angles[edge] != 0;
    }

    btScalar rim_;  ///< as near an edge a point is on it
    std::vector<Candidate>& found_;
    int part_{-1};
    int index_{-1};
};

/// The four of `points` that carry best: the deepest, the one farthest from it, then those that
/// span the most on either side of the line between the two.
std::vector<Candidate> four_of(const std::vector<Candidate>& points) {
    if (points.size() <= 4) return points;
    const auto best = [&points](auto&& value) {
        const Candidate* chosen = &points.front();
        for (const Candidate& point : points) {
            if (value(point) > value(*chosen)) chosen = &point;
        }
        return *chosen;
    };
    const Candidate a = best([](const Candidate& p) { return -p.distance; });
    const Candidate b = best([&a](const Candidate& p) { return p.on_mesh.distance2(a.on_mesh); });
    const btVector3 across = (b.on_mesh - a.on_mesh).cross(a.normal);
    const auto side = [&](const Candidate& p) { return across.dot(p.on_mesh - a.on_mesh); };
    const Candidate c = best(side);
    const Candidate d = best([&side](const Candidate& p) { return -side(p); });
    return {a, b, c, d};
}

/// Takes points out of the manifold that are not among the new ones.
void forget_others(btPersistentManifold& manifold,
                   const std::vector<Candidate>& points,
                   const btTransform& world_from_convex,
                   btScalar near) {
    for (int i = manifold.getNumContacts() - 1; i >= 0; --i) {
        const btVector3& old = manifold.getContactPoint(i).m_localPointA;
        const bool found = std::any_of(points.begin(), points.end(), [&](const Candidate& point) {
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

/// Asks every triangle within reach for its contact points.
class TriangleVisitor final : public btTriangleCallback {
public:
    TriangleVisitor(btDispatcher& dispatcher,
                    btPersistentManifold& scratch,
                    const btCollisionObjectWrapper& convex,
                    const btCollisionObjectWrapper& mesh,
                    const btDispatcherInfo& info,
                    btScalar reach,
                    btScalar near)
        : dispatcher_(dispatcher),
          scratch_(scratch),
          convex_(convex),
          mesh_(mesh),
          info_(info),
          reach_(reach),
          collector_(&convex, &mesh, near, found) {
        collector_.setPersistentManifold(&scratch);
    }

    /// Corners come in the mesh's frame.
    void processTriangle(btVector3* corners, int part, int index) override {
        if (out_of_reach(corners)) return;
        btTriangleShape triangle(corners[0], corners[1], corners[2]);
        triangle.setMargin(mesh_.getCollisionShape()->getMargin());
        const btCollisionObjectWrapper piece(
            &mesh_, &triangle, mesh_.getCollisionObject(), mesh_.getWorldTransform(), part, index);
        collector_.meet(&piece, part, index);
        btCollisionAlgorithm* meet =
            dispatcher_.findAlgorithm(&convex_, &piece, &scratch_, BT_CONTACT_POINT_ALGORITHMS);
        meet->processCollision(&convex_, &piece, info_, &collector_);
        meet->~btCollisionAlgorithm();
        dispatcher_.freeCollisionAlgorithm(meet);
    }

    std::vector<Candidate> found;

private:
    /// Whether the convex shape lies wholly on one side of the triangle's plane, beyond reach.
    bool out_of_reach(const btVector3* corners) const {
        const btVector3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
        const btScalar length = normal.length();
        if (length <= 0) return true;
        const btTransform convex_from_mesh =
            convex_.getWorldTransform().inverse() * mesh_.getWorldTransform();
        const btVector3 across = convex_from_mesh.getBasis() * (normal / length);
        const btScalar plane = across.dot(convex_from_mesh(corners[0]));
        const auto& convex = static_cast<const btConvexShape&>(*convex_.getCollisionShape());
        const btScalar highest = across.dot(convex.localGetSupportingVertex(across));
        const btScalar lowest = across.dot(convex.localGetSupportingVertex(-across));
        return lowest > plane + reach_ || highest < plane - reach_;
    }

    btDispatcher& dispatcher_;
    btPersistentManifold& scratch_;
    const btCollisionObjectWrapper& convex_;
    const btCollisionObjectWrapper& mesh_;
    const btDispatcherInfo& info_;
    btScalar reach_;
    Collector collector_;
};

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
    // Fast pairs look farther than the distance within which points are the same.
    const btScalar reach = manifolds_[0]->getContactBreakingThreshold();
    const btScalar near =
        std::min(convex.getCollisionObject()->getCollisionShape()->getContactBreakingThreshold(
                     gContactBreakingThreshold),
                 reach);
    const bool by_faces = meets_by_faces(*convex.getCollisionShape());
    btDispatcherInfo piece_info = info;
    piece_info.m_enableSatConvex = by_faces;
    TriangleVisitor visitor(*m_dispatcher, *manifolds_[0], convex, mesh, piece_info, reach, near);

    const btTransform mesh_from_convex =
        mesh.getWorldTransform().inverse() * convex.getWorldTransform();
    btVector3 low;
    btVector3 high;
    convex.getCollisionShape()->getAabb(mesh_from_convex, low, high);
    const btVector3 rim(reach, reach, reach);
    static_cast<const btConcaveShape*>(mesh.getCollisionShape())
        ->processAllTriangles(&visitor, low - rim, high + rim);

    // Deepest first: it leads its face, and the faces that press hardest get a manifold.
    std::vector<Candidate>& found = visitor.found;
    std::stable_sort(found.begin(), found.end(), [](const Candidate& a, const Candidate& b) {
        return a.distance < b.distance;
    });
    std::array<bool, kMaxFaces> taken{};
    for (std::size_t face = 0; face < kMaxFaces && !found.empty(); ++face) {
        const btVector3 normal = found.front().normal;
        const auto rest =
            std::stable_partition(found.begin(), found.end(), [&normal](const Candidate& point) {
                return point.normal.dot(normal) > kSameMeshFace;
            });
        const std::vector<Candidate> points(found.begin(), rest);
        found.erase(found.begin(), rest);
        btPersistentManifold* manifold = manifold_for(normal, taken, convex, mesh);
        const std::vector<Candidate> best = four_of(points);
        if (by_faces) forget_others(*manifold, best, convex.getWorldTransform(), near);
        result->setPersistentManifold(manifold);
        for (const Candidate& point : best) {
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
