#include "engine/render/light/shadow_reach.h"

#include <algorithm>
#include <vector>

namespace plumbline::render {
namespace {

constexpr std::size_t kFewIndices = 3 * 64;
constexpr float kFar_m = 1e5F;

/// Of the faces on which the light falls; positive outside.
std::vector<Vec4f> lit_planes(const assets::MeshData& mesh,
                              const Mat4f& world_from_body,
                              const Vec3f& light_direction_world) {
    const auto in_world = [&](std::uint32_t index) {
        return Vec3f{world_from_body * Vec4f{mesh.vertices[index].position_body, 1.0F}};
    };
    const Vec3f center{world_from_body * Vec4f{mesh.bounds.center(), 1.0F}};
    std::vector<Vec4f> planes;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const Vec3f a = in_world(mesh.indices[i]);
        Vec3f normal =
            glm::cross(in_world(mesh.indices[i + 1]) - a, in_world(mesh.indices[i + 2]) - a);
        const float length = glm::length(normal);
        if (length <= 0.0F) continue;
        normal /= glm::dot(normal, center - a) > 0.0F ? -length : length;
        if (glm::dot(normal, light_direction_world) < 0.0F)
            planes.emplace_back(normal, -glm::dot(normal, a));
    }
    return planes;
}

/// Of the box's points.
float least_height(const Vec4f& plane, const Aabb& box) {
    return glm::dot(Vec3f{plane}, box.center()) + plane.w -
           glm::dot(glm::abs(Vec3f{plane}), box.size() * 0.5F);
}

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

bool shades_nothing(const RenderFrame& frame,
                    const assets::AssetLibrary& library,
                    const DrawItem& caster,
                    const Vec3f& light_direction_world,
                    float sunk_m) {
    const assets::MeshData& mesh = library.mesh(caster.mesh);
    if (!is_convex(mesh)) return false;
    // From before such a face the way to the light leads away from it.
    const auto planes = lit_planes(mesh, caster.world_from_body, light_direction_world);
    return std::ranges::all_of(frame.items, [&](const DrawItem& item) {
        if (&item == &caster || item.mesh.value == 0) return true;
        const Aabb bounds = transformed(library.mesh(item.mesh).bounds, item.world_from_body);
        return std::ranges::any_of(
            planes, [&](const Vec4f& plane) { return least_height(plane, bounds) >= -sunk_m; });
    });
}

}  // namespace plumbline::render
