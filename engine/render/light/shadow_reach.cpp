#include "engine/render/light/shadow_reach.h"

#include <algorithm>

namespace plumbline::render {
namespace {

constexpr std::size_t kFewIndices = 3 * 64;
constexpr float kFar_m = 1e5F;

}  // namespace

bool is_convex(const assets::MeshData& mesh) {
    if (mesh.indices.size() > kFewIndices) return false;
    const float rounding_m = 1e-4F * glm::length(mesh.bounds.size());
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const Vec3f& a = mesh.vertices[mesh.indices[i]].position_body;
        const Vec3f& b = mesh.vertices[mesh.indices[i + 1]].position_body;
        const Vec3f& c = mesh.vertices[mesh.indices[i + 2]].position_body;
        const Vec3f normal = glm::cross(b - a, c - a);
        const float allowed = rounding_m * glm::length(normal);
        const bool all_behind = std::ranges::all_of(mesh.indices, [&](std::uint32_t index) {
            return glm::dot(normal, mesh.vertices[index].position_body - a) <= allowed;
        });
        if (!all_behind) return false;
    }
    return true;
}

std::optional<ConvexVolume> shadows_of_others(const RenderFrame& frame,
                                              const assets::AssetLibrary& library,
                                              const DrawItem& receiver,
                                              const Vec3f& light_direction_world,
                                              float margin_m) {
    const Mat4f along_from_world{axes_along(light_direction_world)};
    Aabb casters;
    for (const DrawItem& item : frame.items) {
        if (&item == &receiver || !item.casts_shadow || item.mesh.value == 0) continue;
        const Aabb bounds = transformed(library.mesh(item.mesh).bounds, item.world_from_body);
        casters.include(transformed(bounds, along_from_world));
    }
    if (casters.empty()) return {};
    casters.min -= margin_m;
    casters.max += margin_m;
    casters.max.z = std::max(casters.max.z, kFar_m);
    return ConvexVolume::prism(light_direction_world, casters);
}

}  // namespace plumbline::render
