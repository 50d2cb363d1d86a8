// Contacts of convex shapes with triangle meshes.
//
// Takes the place of Bullet 3.24's own algorithm, which compares triangles in the mesh's frame with
// shapes in the world's and so misses contacts on every mesh that is moved or turned (mended in
// 3.25), which gives boxes one contact point per triangle, so that they rock as they slide, and
// which keeps four points for floor and walls together where floor and walls are one mesh.
#pragma once

#include <btBulletCollisionCommon.h>

#include <cstdint>
#include <memory>
#include <vector>

struct btCollisionObjectWrapper;

namespace plumbline::physics {

/// An algorithm that keeps a manifold for each face that is pressed on: which of them there are.
class ManifoldByFace {
public:
    virtual ~ManifoldByFace() = default;
    virtual std::uint32_t used_faces() const = 0;  ///< by bits
    /// Makes those that are not there yet, as the algorithm would.
    virtual void use_faces(std::uint32_t used,
                           const btCollisionObjectWrapper& first,
                           const btCollisionObjectWrapper& second) = 0;
};

/// Makes the algorithms; the dispatcher keeps pointers to these, so they must outlive it.
class MeshContacts {
public:
    /// From now on `dispatcher` meets meshes our way.
    explicit MeshContacts(btCollisionDispatcher& dispatcher);

private:
    std::unique_ptr<btCollisionAlgorithmCreateFunc> convex_first_;
    std::unique_ptr<btCollisionAlgorithmCreateFunc> mesh_first_;
};

}  // namespace plumbline::physics
