#include "engine/bullet_world/foreign_shapes.h"

#include "engine/bullet_world/mirror.h"
#include "engine/core/hash.h"

#include <BulletCollision/CollisionShapes/btConvexPolyhedron.h>
#include <BulletCollision/CollisionShapes/btShapeHull.h>
#include <fmt/core.h>

#include <cmath>
#include <map>
#include <optional>
#include <type_traits>

namespace plumbline::bullet_world {
namespace {

using physics::CompoundChild;
using physics::CompoundShape;
using physics::ShapeDef;

/// Ours stand along y.
Quat from_y_to(int axis) {
    const Real half = std::sqrt(0.5_r);
    return axis == 0 ? Quat{half, 0, 0, -half} : Quat{half, half, 0, 0};
}

ShapeDef turned(const ShapeDef& def, int axis) {
    if (axis == 1) return def;
    return CompoundShape{{CompoundChild{def, Pose{.orientation = from_y_to(axis)}}}};
}

ShapeDef cylinder_of(const btCylinderShape& cylinder) {
    const int axis = cylinder.getUpAxis();
    return turned(physics::CylinderShape{.radius_m = cylinder.getRadius(),
                                         .height_m = 2 * cylinder.getHalfExtentsWithMargin()[axis]},
                  axis);
}

ShapeDef capsule_of(const btCapsuleShape& capsule) {
    return turned(physics::CapsuleShape{.radius_m = capsule.getRadius(),
                                        .height_m = 2 * capsule.getHalfHeight()},
                  capsule.getUpAxis());
}

ShapeDef cone_of(const btConeShape& cone) {
    return turned(physics::ConeShape{.radius_m = cone.getRadius(), .height_m = cone.getHeight()},
                  cone.getConeUpIndex());
}

ForeignShape plane_of(const btStaticPlaneShape& plane) {
    const Vec3 normal = vec_of(plane.getPlaneNormal());
    const Real d = plane.getPlaneConstant();
    const Real size = 2 * kPlaneHalf_m;
    return {.def = physics::PlaneShape{.size_m = {size, size}, .thickness_m = 10},
            .object_from_shape = {.position = normal * d,
                                  .orientation =
                                      quat_of(shortestArcQuat({0, 1, 0}, plane.getPlaneNormal()))},
            .is_mesh = true};
}

/// The corners that Bullet knows, or else where its support function leads.
ShapeDef hull_of(const btConvexShape& convex) {
    physics::HullShape hull;
    if (const auto* polyhedral = dynamic_cast<const btPolyhedralConvexShape*>(&convex);
        polyhedral != nullptr && polyhedral->getNumVertices() > 0) {
        for (int i = 0; i < polyhedral->getNumVertices(); ++i) {
            btVector3 corner;
            polyhedral->getVertex(i, corner);
            hull.points_m.push_back(vec_of(corner));
        }
        return hull;
    }
    btShapeHull sampled(&convex);
    sampled.buildHull(convex.getMargin(), 1);
    for (int i = 0; i < sampled.numVertices(); ++i)
        hull.points_m.push_back(vec_of(sampled.getVertexPointer()[i]));
    return hull;
}

/// Collects a mesh's triangles, with one vertex for each place.
struct TriangleCollector final : btTriangleCallback {
    void processTriangle(btVector3* triangle, int, int) override {
        std::array<std::uint32_t, 3> corners{};
        for (std::size_t i = 0; i < 3; ++i) corners[i] = index_of(triangle[i]);
        if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0])
            return;
        mesh.triangles.push_back(corners);
    }

    std::uint32_t index_of(const btVector3& at) {
        const std::array<btScalar, 3> key{at.x(), at.y(), at.z()};
        const auto [place, is_new] =
            known.emplace(key, static_cast<std::uint32_t>(mesh.vertices_m.size()));
        if (is_new) mesh.vertices_m.push_back(vec_of(at));
        return place->second;
    }

    std::map<std::array<btScalar, 3>, std::uint32_t> known;
    physics::MeshShape mesh;
};

ForeignShape mesh_of(const btConcaveShape& concave, bool dynamic) {
    TriangleCollector collector;
    const btScalar far = BT_LARGE_FLOAT / 4;
    concave.processAllTriangles(&collector, {-far, -far, -far}, {far, far, far});
    if (dynamic)
        return {.def = physics::HullShape{.points_m = std::move(collector.mesh.vertices_m)}};
    return {.def = std::move(collector.mesh), .is_mesh = true};
}

Result<ForeignShape> compound_of(const btCompoundShape& compound, bool dynamic) {
    CompoundShape def;
    for (int i = 0; i < compound.getNumChildShapes(); ++i) {
        // Our compounds hold no meshes: a mesh among others becomes its hull.
        const bool alone = compound.getNumChildShapes() == 1;
        auto child = foreign_shape(*compound.getChildShape(i), dynamic || !alone);
        if (!child) return child.error();
        const Pose place =
            compose(pose_of(compound.getChildTransform(i)), child->object_from_shape);
        if (alone && child->is_mesh)
            return ForeignShape{
                .def = std::move(child->def), .object_from_shape = place, .is_mesh = true};
        def.children.push_back({std::move(child->def), place});
    }
    return ForeignShape{.def = std::move(def)};
}

std::optional<ShapeDef> primitive_of(const btCollisionShape& shape) {
    switch (shape.getShapeType()) {
        case BOX_SHAPE_PROXYTYPE:
            return physics::BoxShape{
                .size_m =
                    vec_of(2 * static_cast<const btBoxShape&>(shape).getHalfExtentsWithMargin())};
        case SPHERE_SHAPE_PROXYTYPE:
            return physics::SphereShape{.radius_m =
                                            static_cast<const btSphereShape&>(shape).getRadius()};
        case CAPSULE_SHAPE_PROXYTYPE:
            return capsule_of(static_cast<const btCapsuleShape&>(shape));
        case CYLINDER_SHAPE_PROXYTYPE:
            return cylinder_of(static_cast<const btCylinderShape&>(shape));
        case CONE_SHAPE_PROXYTYPE:
            return cone_of(static_cast<const btConeShape&>(shape));
        default:
            return std::nullopt;
    }
}

/// Feeds a hash with a description's numbers, kind by kind.
class ShapeHash {
public:
    void add(const ShapeDef& def) {
        const std::size_t kind = def.index();
        hasher_.add(&kind, sizeof kind);
        std::visit([this](const auto& shape) { numbers(shape); }, def);
    }
    std::uint64_t digest() const { return hasher_.digest(); }

private:
    template <class T>
    void numbers(const T& shape) {  // nothing but Reals
        static_assert(std::is_trivially_copyable_v<T> && sizeof(T) % sizeof(Real) == 0);
        hasher_.add(&shape, sizeof shape);
    }
    void numbers(const physics::HullShape& hull) { list(hull.points_m); }
    void numbers(const physics::MeshShape& mesh) {
        list(mesh.vertices_m);
        list(mesh.triangles);
    }
    void numbers(const CompoundShape& compound) {
        for (const CompoundChild& child : compound.children) {
            add(child.shape);
            numbers(child.body_from_child);
        }
    }
    template <class T>
    void list(const std::vector<T>& items) {
        hasher_.add(items.data(), items.size() * sizeof(T));
    }

    Hasher hasher_;
};

}  // namespace

bool has_surface(const btCollisionShape& shape) {
    if (shape.isCompound())
        return static_cast<const btCompoundShape&>(shape).getNumChildShapes() > 0;
    return shape.getShapeType() != EMPTY_SHAPE_PROXYTYPE;
}

std::uint64_t shape_hash(const ShapeDef& def) {
    ShapeHash hash;
    hash.add(def);
    return hash.digest();
}

Result<ForeignShape> foreign_shape(const btCollisionShape& shape, bool dynamic) {
    if (auto primitive = primitive_of(shape)) return ForeignShape{.def = std::move(*primitive)};
    if (!has_surface(shape))
        return Error{
            fmt::format("a shape of Bullet's type \"{}\" has no surface", shape.getName())};
    if (shape.isCompound()) return compound_of(static_cast<const btCompoundShape&>(shape), dynamic);
    if (shape.getShapeType() == STATIC_PLANE_PROXYTYPE) {
        if (dynamic) return Error{"a plane is for bodies that are not dynamic"};
        return plane_of(static_cast<const btStaticPlaneShape&>(shape));
    }
    if (shape.isConvex())
        return ForeignShape{.def = hull_of(static_cast<const btConvexShape&>(shape))};
    if (shape.isConcave()) return mesh_of(static_cast<const btConcaveShape&>(shape), dynamic);
    return Error{fmt::format("shapes of Bullet's type \"{}\" are not known", shape.getName())};
}

}  // namespace plumbline::bullet_world
