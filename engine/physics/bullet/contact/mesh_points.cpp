#include "engine/physics/bullet/contact/mesh_points.h"

#include <BulletCollision/BroadphaseCollision/btBroadphaseProxy.h>
#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btInternalEdgeUtility.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/CollisionShapes/btConcaveShape.h>
#include <BulletCollision/CollisionShapes/btConvexPolyhedron.h>
#include <BulletCollision/CollisionShapes/btTriangleInfoMap.h>
#include <BulletCollision/CollisionShapes/btTriangleShape.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace plumbline::physics {
namespace {

/// Face against face by separating axes costs the product of the edge counts: for boxes and the
/// like, not for rounded hulls.
constexpr int kMaxFaceCorners = 16;

/// Keeps what the pair algorithms find instead of putting it into a manifold of four.
class Collector final : public btManifoldResult {
public:
    Collector(const btCollisionObjectWrapper* convex,
              const btCollisionObjectWrapper* mesh,
              btScalar rim,
              std::vector<MeshPoint>& found)
        : btManifoldResult(convex, mesh), rim_(rim), found_(found) {}

    void begin_triangle(const btCollisionObjectWrapper* triangle, int part, int index) {
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
    std::vector<MeshPoint>& found_;
    int part_{-1};
    int index_{-1};
};

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
        collector_.begin_triangle(&piece, part, index);
        btCollisionAlgorithm* algorithm =
            dispatcher_.findAlgorithm(&convex_, &piece, &scratch_, BT_CONTACT_POINT_ALGORITHMS);
        algorithm->processCollision(&convex_, &piece, info_, &collector_);
        algorithm->~btCollisionAlgorithm();
        dispatcher_.freeCollisionAlgorithm(algorithm);
    }

    std::vector<MeshPoint> found;

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

}  // namespace

bool meets_by_faces(const btCollisionShape& shape) {
    if (!shape.isPolyhedral()) return false;
    const btConvexPolyhedron* hull =
        static_cast<const btPolyhedralConvexShape&>(shape).getConvexPolyhedron();
    return hull != nullptr && hull->m_vertices.size() <= kMaxFaceCorners;
}

std::vector<MeshPoint> find_mesh_points(const MeshPair& pair,
                                        btPersistentManifold& scratch,
                                        btDispatcher& dispatcher,
                                        const btDispatcherInfo& info) {
    btDispatcherInfo piece_info = info;
    piece_info.m_enableSatConvex = pair.by_faces;
    TriangleVisitor visitor(
        dispatcher, scratch, pair.convex, pair.mesh, piece_info, pair.reach, pair.near);
    const btTransform mesh_from_convex =
        pair.mesh.getWorldTransform().inverse() * pair.convex.getWorldTransform();
    btVector3 low;
    btVector3 high;
    pair.convex.getCollisionShape()->getAabb(mesh_from_convex, low, high);
    const btVector3 rim(pair.reach, pair.reach, pair.reach);
    static_cast<const btConcaveShape*>(pair.mesh.getCollisionShape())
        ->processAllTriangles(&visitor, low - rim, high + rim);
    return std::move(visitor.found);
}

std::vector<MeshPoint> four_of(const std::vector<MeshPoint>& points) {
    if (points.size() <= 4) return points;
    const auto best = [&points](auto&& value) {
        const MeshPoint* chosen = &points.front();
        for (const MeshPoint& point : points) {
            if (value(point) > value(*chosen)) chosen = &point;
        }
        return *chosen;
    };
    const MeshPoint a = best([](const MeshPoint& p) { return -p.distance; });
    const MeshPoint b = best([&a](const MeshPoint& p) { return p.on_mesh.distance2(a.on_mesh); });
    const btVector3 across = (b.on_mesh - a.on_mesh).cross(a.normal);
    const auto side = [&](const MeshPoint& p) { return across.dot(p.on_mesh - a.on_mesh); };
    const MeshPoint c = best(side);
    const MeshPoint d = best([&side](const MeshPoint& p) { return -side(p); });
    return {a, b, c, d};
}

}  // namespace plumbline::physics
