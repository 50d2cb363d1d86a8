// Shapes as bodies share them: pieces put together, weighed, and meshes made smooth to slide on.
#include "engine/core/limits.h"
#include "engine/core/slot_map.h"
#include "engine/physics/bullet/convert.h"
#include "engine/physics/bullet/shape/shape_parts.h"
#include "engine/physics/bullet/shape/shape_record.h"
#include "engine/physics/bullet/shape/shape_store.h"
#include "engine/physics/collision/shape/mesh_geometry.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumbline::physics {
namespace {

/// Places closer than this count as the same: a hundredth of the smallest shape allowed.
constexpr double kSamePlace_m = 1e-5;

Quatd double_of(const Quat& q) {
    return Quatd{static_cast<double>(q.w),
                 static_cast<double>(q.x),
                 static_cast<double>(q.y),
                 static_cast<double>(q.z)};
}

Quat real_of(const Quatd& q) {
    return Quat{static_cast<Real>(q.w),
                static_cast<Real>(q.x),
                static_cast<Real>(q.y),
                static_cast<Real>(q.z)};
}

SolidMass mass_in_body(const ShapePart& part) {
    return moved(
        part.mass, Vec3d{part.body_from_part.position}, double_of(part.body_from_part.orientation));
}

bool centred_and_straight(const SolidMass& mass) {
    return glm::length(mass.center_m) < kSamePlace_m &&
           principal_frame(mass.inertia).orientation == Quatd{1, 0, 0, 0};
}

void weigh(ShapeRecord& record, const SolidMass& mass, const PrincipalFrame& principal) {
    record.inertia_per_kg = principal.inertia / mass.volume_m3;
    record.mass_frame_is_body = record.body_from_mass.position == Vec3{0, 0, 0} &&
                                record.body_from_mass.orientation == kNoRotation;
}

Transform transform_of(const Pose& pose) {
    return {.rotation = glm::mat3_cast(pose.orientation), .position_m = pose.position};
}

/// The part as contacts see it, in the mass frame.
GeometryPart geometry_of(const ShapePart& part, const Pose& mass_from_part) {
    GeometryPart made{.shape = part.convex, .hull = part.hull};
    made.mass_from_part = transform_of(compose(mass_from_part, part.part_from_convex));
    made.bounds = bounds_of(made.shape, made.mass_from_part);
    return made;
}

/// One piece whose own frame serves as the mass frame: no compound in between.
void use_single(ShapeRecord& record, ShapePart part) {
    record.body_from_mass = part.body_from_part;
    weigh(record, part.mass, principal_frame(part.mass.inertia));
    record.inner_radius_m = part.inner_radius_m;
    record.geometry =
        std::make_shared<const BodyGeometry>(BodyGeometry{.parts = {geometry_of(part, Pose{})}});
    record.convex = part.shape.get();
    record.collision = part.shape.get();
    record.parts.push_back(std::move(part.shape));
}

void use_compound(ShapeRecord& record, std::vector<ShapePart> parts) {
    SolidMass whole = mass_in_body(parts.front());
    for (std::size_t i = 1; i < parts.size(); ++i) whole = joined(whole, mass_in_body(parts[i]));
    const PrincipalFrame principal = principal_frame(whole.inertia);
    record.body_from_mass = {.position = Vec3{whole.center_m},
                             .orientation = real_of(principal.orientation)};
    weigh(record, whole, principal);

    auto compound = std::make_unique<btCompoundShape>(true, static_cast<int>(parts.size()));
    const Pose mass_from_body = invert(record.body_from_mass);
    auto geometry = std::make_shared<BodyGeometry>();
    record.inner_radius_m = parts.front().inner_radius_m;
    for (ShapePart& part : parts) {
        const Pose mass_from_part = compose(mass_from_body, part.body_from_part);
        compound->addChildShape(to_bullet(mass_from_part), part.shape.get());
        geometry->parts.push_back(geometry_of(part, mass_from_part));
        record.inner_radius_m = std::min(record.inner_radius_m, part.inner_radius_m);
        if (parts.size() == 1) {
            record.convex = part.shape.get();
            record.mass_from_convex = to_bullet(mass_from_part);
        }
        record.parts.push_back(std::move(part.shape));
    }
    record.geometry = std::move(geometry);
    record.collision = compound.get();
    record.parts.push_back(std::move(compound));
}

std::string mesh_fault(const MeshShape& mesh) {
    if (mesh.vertices_m.size() > limits::kVertices) return "too many vertices";
    if (mesh.triangles.size() * 3 > limits::kIndices) return "too many triangles";
    if (mesh.triangles.empty()) return "it has no triangles";
    for (std::size_t i = 0; i < mesh.vertices_m.size(); ++i) {
        const Vec3& v = mesh.vertices_m[i];
        if (!is_finite(v)) return fmt::format("vertex {} is not finite", i);
        const Real farthest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
        if (static_cast<double>(farthest) > limits::kSizeMax_m) {
            return fmt::format("vertex {} lies {} m from the origin; the limit is {} m",
                               i,
                               farthest,
                               limits::kSizeMax_m);
        }
    }
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (const std::uint32_t index : mesh.triangles[t]) {
            if (index >= mesh.vertices_m.size()) {
                return fmt::format(
                    "triangle {} names vertex {} of {}", t, index, mesh.vertices_m.size());
            }
        }
    }
    return {};
}

/// Copies the triangles that have an area; returns how many have none.
std::size_t copy_triangles(const MeshShape& mesh, TriangleStore& store) {
    std::size_t degenerate = 0;
    for (const Vec3& v : mesh.vertices_m) {
        for (int axis = 0; axis < 3; ++axis) store.coordinates.push_back(v[axis]);
    }
    for (const auto& triangle : mesh.triangles) {
        const Vec3 a = mesh.vertices_m[triangle[0]];
        const Vec3 b = mesh.vertices_m[triangle[1]];
        const Vec3 c = mesh.vertices_m[triangle[2]];
        const Real longest = std::max({glm::length(b - a), glm::length(c - b), glm::length(a - c)});
        // A needle narrower than a millionth of its length has no usable normal.
        if (!(glm::length(glm::cross(b - a, c - a)) > 1e-6_r * longest * longest)) {
            ++degenerate;
            continue;
        }
        for (const std::uint32_t index : triangle) store.indices.push_back(static_cast<int>(index));
    }
    return degenerate;
}

Result<std::unique_ptr<ShapeRecord>> build_mesh(const MeshShape& mesh,
                                                std::vector<std::string>* notes) {
    if (const std::string fault = mesh_fault(mesh); !fault.empty()) {
        return refused_shape("mesh: " + fault);
    }
    auto record = std::make_unique<ShapeRecord>();
    TriangleStore& store = record->triangles;
    const std::size_t degenerate = copy_triangles(mesh, store);
    if (store.indices.empty()) return refused_shape("mesh: none of its triangles has an area");
    if (degenerate > 0 && notes != nullptr) {
        notes->push_back(fmt::format("mesh: {} triangles without area left out", degenerate));
    }
    btIndexedMesh indexed;
    indexed.m_numTriangles = static_cast<int>(store.indices.size() / 3);
    indexed.m_triangleIndexBase = reinterpret_cast<const unsigned char*>(store.indices.data());
    indexed.m_triangleIndexStride = 3 * sizeof(int);
    indexed.m_numVertices = static_cast<int>(store.coordinates.size() / 3);
    indexed.m_vertexBase = reinterpret_cast<const unsigned char*>(store.coordinates.data());
    indexed.m_vertexStride = 3 * sizeof(btScalar);
    indexed.m_vertexType = sizeof(btScalar) == sizeof(float) ? PHY_FLOAT : PHY_DOUBLE;
    store.view = std::make_unique<btTriangleIndexVertexArray>();
    store.view->addIndexedMesh(indexed, PHY_INTEGER);

    auto shape = std::make_unique<btBvhTriangleMeshShape>(store.view.get(), true);
    shape->setMargin(0);  // things would hover by it
    record->collision = shape.get();
    record->parts.push_back(std::move(shape));
    record->static_only = true;
    record->mesh = true;
    auto geometry = std::make_shared<BodyGeometry>();
    geometry->mesh =
        std::make_shared<const MeshGeometry>(mesh_geometry(mesh.vertices_m, mesh.triangles));
    record->geometry = std::move(geometry);
    return record;
}

}  // namespace

TriangleStore::TriangleStore() = default;
TriangleStore::~TriangleStore() = default;

Result<std::unique_ptr<ShapeRecord>> build_shape(const ShapeDef& def,
                                                 std::vector<std::string>* notes) {
    if (const auto* mesh = std::get_if<MeshShape>(&def)) return build_mesh(*mesh, notes);
    auto built = build_parts(def, notes);
    if (!built) return built.error();
    auto record = std::make_unique<ShapeRecord>();
    record->static_only = built->static_only;
    std::vector<ShapePart>& parts = built->parts;
    if (parts.size() == 1 && centred_and_straight(parts.front().mass)) {
        use_single(*record, std::move(parts.front()));
    } else {
        use_compound(*record, std::move(parts));
    }
    return record;
}

struct ShapeStore::Impl {
    SlotMap<ShapeId, std::unique_ptr<ShapeRecord>> shapes;
};

ShapeStore::ShapeStore() : impl_(std::make_unique<Impl>()) {}
ShapeStore::~ShapeStore() = default;

Result<ShapeId> ShapeStore::create(const ShapeDef& def, std::vector<std::string>* notes) {
    auto built = build_shape(def, notes);
    if (!built) return built.error();
    return impl_->shapes.insert(std::move(built.value()));
}

const ShapeRecord& ShapeStore::get(ShapeId id) const {
    return *impl_->shapes.get(id);
}

}  // namespace plumbline::physics
