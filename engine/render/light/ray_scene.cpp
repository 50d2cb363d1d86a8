#include "engine/render/light/ray_scene.h"

#include "engine/render/resources/mip_chain.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <deque>
#include <filesystem>
#include <limits>
#include <map>

namespace plumbline::render {
namespace {

using assets::AlphaMode;
using assets::ImageData;

/// One part of one thing, as the filters see it.
struct Surface {
    std::vector<Vec2f> uv;                  ///< three a triangle; empty without a mask
    std::shared_ptr<const ImageData> mask;  ///< its fourth channel; null: no mask
    float cutoff{0.5F};
    bool two_sided{false};
    Vec3f albedo{0.5F};
};

/// What a base colour map is taken for: most are wood, stone and plaster.
constexpr float kMeanOfMaps = 0.4F;

Vec3f albedo_of(const Vec3f& tint,
                const assets::MeshData& mesh,
                const assets::SubMesh& part,
                const assets::MaterialData& material) {
    Vec3f sum{0.0F};
    for (std::uint32_t i = 0; i < part.index_count; ++i)
        sum += mesh.vertices[mesh.indices[part.first_index + i]].color;
    const float maps = material.base_color_map.empty() ? 1.0F : kMeanOfMaps;
    return tint * material.base_color * sum * (maps / static_cast<float>(part.index_count));
}

/// What the filters know of the ray.
struct Query {
    RTCIntersectContext context{};
    Backs backs{Backs::LookedThrough};

    explicit Query(Backs wanted = Backs::LookedThrough) : backs(wanted) {
        rtcInitIntersectContext(&context);
    }
};

std::uint32_t wrapped(std::int64_t at, std::uint32_t size) {
    const auto count = static_cast<std::int64_t>(size);
    return static_cast<std::uint32_t>(((at % count) + count) % count);
}

/// Between the four nearest texels, repeated.
float alpha_at(const ImageData& image, const Vec2f& uv) {
    const float x = uv.x * static_cast<float>(image.width) - 0.5F;
    const float y = uv.y * static_cast<float>(image.height) - 0.5F;
    // Whole numbers before one is added: a float just below 0, plus 1, is 1.
    const auto left = static_cast<std::int64_t>(std::floor(x));
    const auto top = static_cast<std::int64_t>(std::floor(y));
    const auto texel = [&](std::int64_t at_x, std::int64_t at_y) {
        const std::size_t index =
            std::size_t{wrapped(at_y, image.height)} * image.width + wrapped(at_x, image.width);
        return static_cast<float>(image.bytes[index * 4 + 3]) / 255.0F;
    };
    const float right = x - std::floor(x);
    const float down = y - std::floor(y);
    return glm::mix(glm::mix(texel(left, top), texel(left + 1, top), right),
                    glm::mix(texel(left, top + 1), texel(left + 1, top + 1), right),
                    down);
}

bool is_hole(const Surface& surface, std::uint32_t triangle, float u, float v) {
    if (surface.mask == nullptr) return false;
    const Vec2f* corner = &surface.uv[std::size_t{triangle} * 3];
    return alpha_at(*surface.mask, (1.0F - u - v) * corner[0] + u * corner[1] + v * corner[2]) <
           surface.cutoff;
}

/// Embree asks for one ray at a time here.
const Surface& surface_of(const RTCFilterFunctionNArguments& asked) {
    return *static_cast<const Surface*>(asked.geometryUserPtr);
}

void let_through_holes(const RTCFilterFunctionNArguments* asked) {
    if (is_hole(surface_of(*asked),
                RTCHitN_primID(asked->hit, asked->N, 0),
                RTCHitN_u(asked->hit, asked->N, 0),
                RTCHitN_v(asked->hit, asked->N, 0)))
        asked->valid[0] = 0;
}

void let_through_holes_and_backs(const RTCFilterFunctionNArguments* asked) {
    const Vec3f normal{RTCHitN_Ng_x(asked->hit, asked->N, 0),
                       RTCHitN_Ng_y(asked->hit, asked->N, 0),
                       RTCHitN_Ng_z(asked->hit, asked->N, 0)};
    const Vec3f direction{RTCRayN_dir_x(asked->ray, asked->N, 0),
                          RTCRayN_dir_y(asked->ray, asked->N, 0),
                          RTCRayN_dir_z(asked->ray, asked->N, 0)};
    const auto* query = reinterpret_cast<const Query*>(asked->context);  // its first member
    if (query->backs == Backs::LookedThrough && !surface_of(*asked).two_sided &&
        glm::dot(normal, direction) > 0.0F)
        asked->valid[0] = 0;
    let_through_holes(asked);
}

RTCRay ray_of(const Vec3f& origin, const Vec3f& direction) {
    RTCRay ray{};
    ray.org_x = origin.x;
    ray.org_y = origin.y;
    ray.org_z = origin.z;
    ray.dir_x = direction.x;
    ray.dir_y = direction.y;
    ray.dir_z = direction.z;
    ray.tfar = std::numeric_limits<float>::infinity();
    ray.mask = ~0U;
    return ray;
}

}  // namespace

struct RayScene::Impl {
    RTCDevice device{rtcNewDevice(nullptr)};
    RTCScene seen{new_scene()};
    RTCScene casters{new_scene()};
    std::deque<Surface> surfaces;
    std::map<std::filesystem::path, std::shared_ptr<const ImageData>> masks;

    ~Impl() {
        rtcReleaseScene(seen);
        rtcReleaseScene(casters);
        rtcReleaseDevice(device);
    }
    RTCScene new_scene() const {
        RTCScene scene = rtcNewScene(device);
        rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
        return scene;
    }
    std::shared_ptr<const ImageData> mask_of(const assets::MaterialData& material,
                                             assets::AssetLibrary& library) {
        if (material.alpha_mode != AlphaMode::Mask || material.base_color_map.empty()) return {};
        auto& mask = masks[material.base_color_map];
        if (!mask) {
            mask = in_bytes(library.take_image(material.base_color_map), MipContent::Color);
        }
        return mask && mask->format == assets::PixelFormat::Rgba8 ? mask : nullptr;
    }
    void add(const DrawItem& item,
             const assets::MeshData& mesh,
             const assets::SubMesh& part,
             const assets::MaterialData& material,
             assets::AssetLibrary& library);
};

void RayScene::Impl::add(const DrawItem& item,
                         const assets::MeshData& mesh,
                         const assets::SubMesh& part,
                         const assets::MaterialData& material,
                         assets::AssetLibrary& library) {
    const std::size_t triangles = part.index_count / 3;
    if (triangles == 0) return;
    surfaces.push_back({.mask = mask_of(material, library),
                        .cutoff = material.alpha_cutoff / std::max(material.alpha, 1e-4F),
                        .two_sided = material.two_sided,
                        .albedo = albedo_of(item.tint, mesh, part, material)});
    Surface& surface = surfaces.back();
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* positions = static_cast<float*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(Vec3f), triangles * 3));
    auto* corners = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(geometry,
                                                                        RTC_BUFFER_TYPE_INDEX,
                                                                        0,
                                                                        RTC_FORMAT_UINT3,
                                                                        3 * sizeof(std::uint32_t),
                                                                        triangles));
    for (std::uint32_t i = 0; i < triangles * 3; ++i) {
        const assets::Vertex& vertex = mesh.vertices[mesh.indices[part.first_index + i]];
        const Vec3f place{item.world_from_body * Vec4f{vertex.position_body, 1.0F}};
        std::memcpy(positions + std::size_t{i} * 3, &place, sizeof(place));
        corners[i] = i;
        if (surface.mask) surface.uv.push_back(vertex.uv);
    }
    rtcSetGeometryUserData(geometry, &surface);
    rtcSetGeometryIntersectFilterFunction(geometry, let_through_holes_and_backs);
    if (surface.mask) rtcSetGeometryOccludedFilterFunction(geometry, let_through_holes);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(seen, geometry);
    if (item.casts_shadow) rtcAttachGeometry(casters, geometry);
    rtcReleaseGeometry(geometry);
}

RayScene::RayScene(const RenderFrame& frame,
                   assets::AssetLibrary& library,
                   const std::function<bool(const DrawItem&)>& wanted)
    : impl_(std::make_unique<Impl>()) {
    for (const DrawItem& item : frame.items) {
        if (item.mesh.value == 0 || (wanted && !wanted(item))) continue;
        const assets::MeshData& mesh = library.mesh(item.mesh);
        const auto materials = materials_of(frame, item);
        for (const assets::SubMesh& part : mesh.sub_meshes) {
            const bool has_one =
                part.material < materials.size() && materials[part.material].value != 0;
            const assets::MaterialData material =
                has_one ? library.material(materials[part.material]) : assets::MaterialData{};
            if (material.alpha_mode != AlphaMode::Blend)
                impl_->add(item, mesh, part, material, library);
        }
    }
    rtcCommitScene(impl_->seen);
    rtcCommitScene(impl_->casters);
}

RayScene::~RayScene() = default;

std::optional<RayHit> RayScene::first_hit(const Vec3f& origin_world,
                                          const Vec3f& direction_world,
                                          Backs backs) const {
    RTCRayHit found{};
    found.ray = ray_of(origin_world, direction_world);
    found.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    Query query(backs);
    rtcIntersect1(impl_->seen, &query.context, &found);
    if (found.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
    const auto* surface = static_cast<const Surface*>(
        rtcGetGeometryUserData(rtcGetGeometry(impl_->seen, found.hit.geomID)));
    Vec3f normal = glm::normalize(Vec3f{found.hit.Ng_x, found.hit.Ng_y, found.hit.Ng_z});
    const bool from_behind = glm::dot(normal, direction_world) > 0.0F;
    if (from_behind && surface->two_sided) normal = -normal;
    return RayHit{.position_world = origin_world + found.ray.tfar * direction_world,
                  .normal_world = normal,
                  .distance_m = found.ray.tfar,
                  .two_sided = surface->two_sided,
                  .from_behind = from_behind && !surface->two_sided,
                  .albedo = surface->albedo};
}

bool RayScene::is_shaded(const RayHit& place, const Vec3f& to_light_world) const {
    // Off the surface by more than a float can be wrong about the place.
    const float off_m = 1e-4F + 2e-6F * (place.distance_m + glm::length(place.position_world));
    const bool from_behind = place.two_sided && glm::dot(place.normal_world, to_light_world) < 0.0F;
    const Vec3f side = from_behind ? -place.normal_world : place.normal_world;
    RTCRay ray = ray_of(place.position_world + side * off_m, to_light_world);
    Query query;
    rtcOccluded1(impl_->casters, &query.context, &ray);
    return ray.tfar < 0.0F;
}

}  // namespace plumbline::render
