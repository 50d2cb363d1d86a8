// Where a convex shape touches the triangles of a mesh.
#pragma once

#include <btBulletCollisionCommon.h>

#include <vector>

struct btCollisionObjectWrapper;

namespace plumbline::physics {

/// Points whose normals differ by less than 18 degrees press on one face and share four points.
inline constexpr btScalar kSameMeshFace = btScalar(0.95);

/// A contact point as a triangle gave it, its normal mended at edges inside the mesh.
struct MeshPoint {
    btVector3 normal;  ///< from the mesh to the convex shape
    btVector3 on_mesh;
    btVector3 on_convex;
    btScalar distance;
};

/// A convex shape and a mesh that may touch.
struct MeshPair {
    const btCollisionObjectWrapper& convex;
    const btCollisionObjectWrapper& mesh;
    bool by_faces{false};  ///< meets_by_faces()
    btScalar reach{0};     ///< points farther apart count as none
    btScalar near{0};      ///< within it points are the same
};

/// Whether faces are compared with faces: then each look finds all points of a face.
bool meets_by_faces(const btCollisionShape& shape);
/// The points that triangles within reach have, triangle by triangle. `scratch` is a manifold of the
/// pair, for the algorithms that want one.
std::vector<MeshPoint> find_mesh_points(const MeshPair& pair,
                                        btPersistentManifold& scratch,
                                        btDispatcher& dispatcher,
                                        const btDispatcherInfo& info);
/// The four of `points` that carry best: the deepest, the one farthest from it, then those that
/// span the most on either side of the line between the two.
std::vector<MeshPoint> four_of(const std::vector<MeshPoint>& points);

}  // namespace plumbline::physics
