// From the items of a frame to draws: culled, sorted near to far, equal ones joined. No GL.
#pragma once

#include "engine/assets/asset_library.h"
#include "engine/core/bounds.h"
#include "engine/render/culling/convex_volume.h"
#include "engine/render/culling/frustum.h"
#include "engine/render/culling/mesh_lods.h"
#include "engine/render/render_frame.h"

#include <cstdint>
#include <span>
#include <vector>

namespace plumbline::render {

/// As the vertex shaders read it: the first three rows of world_from_body, the tint, and in its w whether
/// air hides the instance: 1, or 0 where it is near.
struct Instance {
    Vec4f row_x{1.0F, 0.0F, 0.0F, 0.0F};
    Vec4f row_y{0.0F, 1.0F, 0.0F, 0.0F};
    Vec4f row_z{0.0F, 0.0F, 1.0F, 0.0F};
    Vec4f tint{1.0F};
};
static_assert(sizeof(Instance) == 64);

/// One instanced draw.
struct DrawRun {
    assets::MeshId mesh{};
    assets::MaterialId material{};
    std::uint32_t first_index{0};
    std::uint32_t index_count{0};
    std::uint32_t first_instance{0};
    std::uint32_t instance_count{0};
    bool two_sided{false};
    bool in_beam{false};  ///< the flashlight may reach it
    Aabb bounds_world;
    const DrawItem* only_item{nullptr};  ///< where there is one instance
};

std::uint64_t triangles(const DrawRun& run);
/// From the point to the nearest place of the box.
float distance_to(const Aabb& box, const Vec3f& point);

struct DrawList {
    std::vector<Instance> instances;
    std::vector<DrawRun> runs;

    void clear() {
        instances.clear();
        runs.clear();
    }
};

/// An item that passed the cull.
struct VisibleItem {
    const DrawItem* item{nullptr};
    std::span<const assets::MaterialId> materials;  ///< the frame's; one per sub-mesh material
    std::span<const assets::SubMesh> parts;         ///< the mesh's, as fine as the view needs them
    Aabb bounds_world;
    float distance_m{0.0F};  ///< from the eye to the far side of the bounds
    bool in_beam{false};     ///< the flashlight may reach it
};

/// The material of one part; {} where the item brings too few.
assets::MaterialId material_of(const VisibleItem& member, const assets::SubMesh& part);
/// The material's data; plain for {}.
const assets::MaterialData& look_of(const assets::AssetLibrary& library, assets::MaterialId id);

/// From where things are looked at, and how closely.
struct CullView {
    Frustum frustum;
    Vec3f eye_world{0.0F};
    const LodTable* lods{nullptr};      ///< null: full meshes only
    float error_m{0.0F};                ///< a mesh may be off by so much anywhere,
    float error_rad{0.0F};              ///< or by so much as seen from the eye
    float smallest_rad{0.0F};           ///< what looks smaller is left out
    bool sorts_foliage{false};          ///< where the table has it near to far
    const ConvexVolume* beam{nullptr};  ///< of the flashlight; null: there is none
};

/// Whether something may be drawn whose colour mixes with what is behind it.
bool mixes_colors(const RenderFrame& frame, const assets::AssetLibrary& library);

/// Items whose bounds touch the frustum, in the frame's order.
std::vector<VisibleItem> cull(const RenderFrame& frame,
                              const assets::AssetLibrary& library,
                              const CullView& view);

enum class DrawKind {
    Opaque,         ///< all but Blend materials; near to far
    OpaqueInOrder,  ///< all but Blend materials; in the frame's order, one instance a draw
    Translucent     ///< Blend materials only; far to near, one instance a draw
};

/// Distances are binned first, so that an instanced draw never spans near and far: overdraw is what
/// costs. Within a bin equal (mesh, materials, in the beam or not) join, nearest first.
void build_draws(const std::vector<VisibleItem>& visible,
                 const assets::AssetLibrary& library,
                 DrawKind kind,
                 DrawList& list);

/// Marks the instances that air hides. The air's light hangs on vertices: a large thing of few, as the
/// ground is, has none where it is near.
void mark_far_instances(DrawList& list, const Vec3f& eye_world);

enum class Emitters {
    Cast,
    LetThrough  ///< what shines casts no shadow: bulbs and lamp shades stand round their light
};

/// For depth-only passes, of the items that cast shadows: neighbouring opaque parts of a mesh join
/// (their run has no material), parts with an alpha mask stay apart. Blend materials cast none.
void build_depth_draws(std::vector<VisibleItem> visible,
                       const assets::AssetLibrary& library,
                       Emitters emitters,
                       DrawList& list);

}  // namespace plumbline::render
