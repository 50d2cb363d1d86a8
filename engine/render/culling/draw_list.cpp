#include "engine/render/culling/draw_list.h"

#include "engine/render/culling/foliage_order.h"
#include "shaders/shared/limits.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace plumbline::render {
namespace {

// Each bin reaches half as far again as the one before.
constexpr float kBinRatioLog = 0.405F;

bool same_group(const VisibleItem& a, const VisibleItem& b) {
    return a.item->mesh == b.item->mesh && a.parts.data() == b.parts.data() &&
           a.in_beam == b.in_beam && std::ranges::equal(a.materials, b.materials);
}

Instance instance_of(const DrawItem& item) {
    const Mat4f rows = glm::transpose(item.world_from_body);
    return {.row_x = rows[0], .row_y = rows[1], .row_z = rows[2], .tint = Vec4f{item.tint, 0.0F}};
}

/// Fills what a draw of one part needs beyond its instances.
void set_part(DrawRun& run, const assets::SubMesh& part, const assets::MaterialData& look) {
    run.first_index = part.first_index;
    run.index_count = part.index_count;
    run.two_sided = look.two_sided;
}

/// The coarsest version that is fine enough.
std::span<const assets::SubMesh> parts_of(const DrawItem& item,
                                          const assets::MeshData& mesh,
                                          const CullView& view,
                                          float near_m) {
    const float allowed_m = view.error_m + view.error_rad * near_m;
    if (view.lods == nullptr || allowed_m <= 0.0F) return mesh.sub_meshes;
    const auto found = view.lods->find(item.mesh);
    if (found == view.lods->end()) return mesh.sub_meshes;
    const float scale = std::max({glm::length(Vec3f{item.world_from_body[0]}),
                                  glm::length(Vec3f{item.world_from_body[1]}),
                                  glm::length(Vec3f{item.world_from_body[2]})});
    const MeshLod* coarsest = nullptr;
    for (const MeshLod& lod : found->second) {
        if (lod.error_m * scale <= allowed_m) coarsest = &lod;
    }
    if (coarsest == nullptr) return mesh.sub_meshes;
    if (!view.sorts_foliage || coarsest->by_side.empty()) return coarsest->sub_meshes;
    const Vec3f to_eye = view.eye_world - Vec3f{item.world_from_body[3]};
    return coarsest->by_side[side_seen_from(glm::transpose(Mat3f{item.world_from_body}) * to_eye)];
}

struct SortEntry {
    int bin{0};
    std::uint32_t group{0};
    float distance_m{0.0F};
    std::uint32_t index{0};
};

/// Numbers the groups in the order of their first member.
std::vector<SortEntry> sort_entries(const std::vector<VisibleItem>& visible) {
    std::vector<SortEntry> entries;
    entries.reserve(visible.size());
    std::vector<const VisibleItem*> groups;
    std::uint32_t group = 0;
    for (std::uint32_t i = 0; i < visible.size(); ++i) {
        const VisibleItem& member = visible[i];
        if (groups.empty() || !same_group(*groups[group], member)) {
            const auto found = std::ranges::find_if(
                groups, [&](const VisibleItem* other) { return same_group(*other, member); });
            group = static_cast<std::uint32_t>(found - groups.begin());
            if (found == groups.end()) groups.push_back(&member);
        }
        const float distance_m = member.distance_m;
        const int bin = static_cast<int>(std::log(std::max(distance_m, 1.0F)) / kBinRatioLog);
        entries.push_back({bin, group, distance_m, i});
    }
    return entries;
}

/// Near to far by bins, joined by group within each; calls fn(first, last) for each join.
template <class Fn>
void for_each_group(const std::vector<VisibleItem>& visible, Fn&& fn) {
    std::vector<SortEntry> entries = sort_entries(visible);
    std::ranges::sort(entries, [](const SortEntry& a, const SortEntry& b) {
        if (a.bin != b.bin) return a.bin < b.bin;
        if (a.group != b.group) return a.group < b.group;
        if (a.distance_m != b.distance_m) return a.distance_m < b.distance_m;
        return a.index < b.index;
    });
    for (std::size_t first = 0; first < entries.size();) {
        std::size_t last = first;
        while (last < entries.size() && entries[last].bin == entries[first].bin &&
               entries[last].group == entries[first].group) {
            ++last;
        }
        fn(std::span{entries}.subspan(first, last - first));
        first = last;
    }
}

/// Appends the instances and tells which run of them they are.
DrawRun append_instances(const std::vector<VisibleItem>& visible,
                         std::span<const SortEntry> entries,
                         DrawList& list) {
    DrawRun run;
    run.mesh = visible[entries.front().index].item->mesh;
    run.first_instance = static_cast<std::uint32_t>(list.instances.size());
    run.instance_count = static_cast<std::uint32_t>(entries.size());
    run.in_beam = visible[entries.front().index].in_beam;
    if (entries.size() == 1) run.only_item = visible[entries.front().index].item;
    for (const SortEntry& entry : entries) {
        const VisibleItem& member = visible[entry.index];
        list.instances.push_back(instance_of(*member.item));
        run.bounds_world.include(member.bounds_world);
    }
    return run;
}

void build_opaque(const std::vector<VisibleItem>& visible,
                  const assets::AssetLibrary& library,
                  DrawList& list) {
    for_each_group(visible, [&](std::span<const SortEntry> entries) {
        const VisibleItem& first = visible[entries.front().index];
        DrawRun run = append_instances(visible, entries, list);
        for (const assets::SubMesh& part : first.parts) {
            run.material = material_of(first, part);
            const assets::MaterialData& look = look_of(library, run.material);
            if (look.alpha_mode == assets::AlphaMode::Blend) continue;
            set_part(run, part, look);
            list.runs.push_back(run);
        }
    });
}

std::vector<VisibleItem> far_to_near(std::vector<VisibleItem> visible) {
    std::ranges::stable_sort(visible, [](const VisibleItem& a, const VisibleItem& b) {
        return a.distance_m > b.distance_m;
    });
    return visible;
}

/// One instance a draw; of each item the parts that blend, or the others.
void build_one_by_one(const std::vector<VisibleItem>& visible,
                      const assets::AssetLibrary& library,
                      bool those_that_blend,
                      DrawList& list) {
    for (const VisibleItem& member : visible) {
        const DrawItem& item = *member.item;
        DrawRun run{.mesh = item.mesh,
                    .first_instance = static_cast<std::uint32_t>(list.instances.size()),
                    .instance_count = 1,
                    .in_beam = member.in_beam,
                    .bounds_world = member.bounds_world};
        bool has_part = false;
        for (const assets::SubMesh& part : member.parts) {
            run.material = material_of(member, part);
            const assets::MaterialData& look = look_of(library, run.material);
            if ((look.alpha_mode == assets::AlphaMode::Blend) != those_that_blend) continue;
            set_part(run, part, look);
            list.runs.push_back(run);
            has_part = true;
        }
        if (has_part) list.instances.push_back(instance_of(item));
    }
}

float farthest_m(const Aabb& box, const Vec3f& point) {
    return glm::length(glm::max(glm::abs(box.min - point), glm::abs(box.max - point)));
}

}  // namespace

std::uint64_t triangles(const DrawRun& run) {
    return std::uint64_t{run.index_count} / 3 * run.instance_count;
}

float distance_to(const Aabb& box, const Vec3f& point) {
    return glm::distance(point, glm::clamp(point, box.min, box.max));
}

assets::MaterialId material_of(const VisibleItem& member, const assets::SubMesh& part) {
    return part.material < member.materials.size() ? member.materials[part.material]
                                                   : assets::MaterialId{};
}

const assets::MaterialData& look_of(const assets::AssetLibrary& library, assets::MaterialId id) {
    static const assets::MaterialData plain{};
    return id.value == 0 ? plain : library.material(id);
}

bool mixes_colors(const RenderFrame& frame, const assets::AssetLibrary& library) {
    const bool has_stars = frame.sky && frame.sky->model;
    if (has_stars || frame.fog || !frame.drops.empty() || !frame.water_rings.empty()) return true;
    return std::ranges::any_of(frame.material_ids, [&](assets::MaterialId id) {
        return look_of(library, id).alpha_mode == assets::AlphaMode::Blend;
    });
}

std::vector<VisibleItem> cull(const RenderFrame& frame,
                              const assets::AssetLibrary& library,
                              const CullView& view) {
    std::vector<VisibleItem> visible;
    visible.reserve(frame.items.size());
    for (const DrawItem& item : frame.items) {
        if (item.mesh.value == 0) continue;
        const assets::MeshData& mesh = library.mesh(item.mesh);
        const Aabb bounds = transformed(mesh.bounds, item.world_from_body);
        if (!view.frustum.may_touch(bounds)) continue;
        const float size_m = glm::length(bounds.size());
        const float near_m =
            glm::distance(view.eye_world, glm::clamp(view.eye_world, bounds.min, bounds.max));
        if (size_m < view.smallest_rad * near_m) continue;
        visible.push_back({&item,
                           materials_of(frame, item),
                           parts_of(item, mesh, view, near_m),
                           bounds,
                           glm::distance(view.eye_world, bounds.center()) + size_m * 0.5F,
                           view.beam != nullptr && view.beam->reaches(bounds)});
    }
    return visible;
}

void build_draws(const std::vector<VisibleItem>& visible,
                 const assets::AssetLibrary& library,
                 DrawKind kind,
                 DrawList& list) {
    switch (kind) {
        case DrawKind::Opaque:
            build_opaque(visible, library, list);
            break;
        case DrawKind::OpaqueInOrder:
            build_one_by_one(visible, library, false, list);
            break;
        case DrawKind::Translucent:
            build_one_by_one(far_to_near(visible), library, true, list);
            break;
    }
}

void mark_far_instances(DrawList& list, const Vec3f& eye_world) {
    constexpr std::uint64_t kFewTriangles = 1000;
    const auto is_far = [&](const DrawRun& run) {
        if (farthest_m(run.bounds_world, eye_world) < PL_AERIAL_FROM_M) return false;
        return triangles(run) > kFewTriangles ||
               distance_to(run.bounds_world, eye_world) > PL_AERIAL_FROM_M;
    };
    // The parts of one thing share its instances: one that is near speaks for all.
    std::vector<bool> is_near(list.instances.size());
    for (const DrawRun& run : list.runs)
        is_near[run.first_instance] = is_near[run.first_instance] || !is_far(run);
    for (const DrawRun& run : list.runs) {
        const float hidden = is_near[run.first_instance] ? 0.0F : 1.0F;
        for (std::uint32_t i = 0; i < run.instance_count; ++i)
            list.instances[run.first_instance + i].tint.w = hidden;
    }
}

void build_depth_draws(std::vector<VisibleItem> visible,
                       const assets::AssetLibrary& library,
                       Emitters emitters,
                       DrawList& list) {
    std::erase_if(visible, [](const VisibleItem& member) { return !member.item->casts_shadow; });
    for_each_group(visible, [&](std::span<const SortEntry> entries) {
        const VisibleItem& first = visible[entries.front().index];
        DrawRun run = append_instances(visible, entries, list);
        for (const assets::SubMesh& part : first.parts) {
            const assets::MaterialId material = material_of(first, part);
            const assets::MaterialData& look = look_of(library, material);
            if (look.alpha_mode == assets::AlphaMode::Blend) continue;
            if (emitters == Emitters::LetThrough && look.emissive != Vec3f{0.0F}) continue;
            const bool masked = look.alpha_mode == assets::AlphaMode::Mask;
            // Neighbouring opaque parts are one draw: depth does not tell materials apart.
            if (!masked && !list.runs.empty()) {
                DrawRun& before = list.runs.back();
                if (before.first_instance == run.first_instance && before.material.value == 0 &&
                    before.two_sided == look.two_sided &&
                    before.first_index + before.index_count == part.first_index) {
                    before.index_count += part.index_count;
                    continue;
                }
            }
            run.material = masked ? material : assets::MaterialId{};
            set_part(run, part, look);
            list.runs.push_back(run);
        }
    });
}

}  // namespace plumbline::render
