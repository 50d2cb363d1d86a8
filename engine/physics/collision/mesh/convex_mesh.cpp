#include "engine/physics/collision/mesh/convex_mesh.h"

#include "engine/physics/collision/mesh/mesh_patches.h"
#include "engine/physics/collision/mesh/triangle_contact.h"

namespace plumbline::physics {

void collide_with_mesh(const PlacedShape& convex,
                       const MeshGeometry& mesh,
                       const Transform& world_from_mesh,
                       Real reach_m,
                       std::vector<MeshPatch>& patches) {
    patches.clear();
    const Vec3d origin{convex.world_from_shape.position_m};
    const auto reach = static_cast<double>(reach_m);
    const PlacedConvex core = placed_convex(convex, origin);
    const PlacedMesh placed(mesh, world_from_mesh, origin);
    TriangleContacts contacts(core, placed, reach);
    mesh.tree.visit(placed.bounds_round(core, reach),
                    [&contacts](std::uint32_t triangle) { contacts.add(triangle); });
    const std::vector<MeshPoint>& points = contacts.points();
    if (points.empty()) return;
    for (const PointGroup& group : group_points(core, placed, points, kMostMeshPatches)) {
        MeshPatch& patch = patches.emplace_back();
        patch.normal = Vec3(group.normal);
        for (std::size_t i = 0; i < group.count; ++i) {
            const MeshPoint& point = group.points[i];
            patch.points[patch.count++] = {Vec3(point.on_mesh + origin),
                                           static_cast<Real>(point.distance_m)};
        }
    }
}

}  // namespace plumbline::physics
