#include "engine/render/draw_list.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace plumbline::render {
namespace {

// Each bin reaches half as far again as the one before.
constexpr float kBinRatioLog = 0.405F;

bool same_group(const VisibleItem& a, const VisibleItem& b) {
    return a.item->mesh == b.item->mesh && std::ranges::equal(a.materials, b.materials);
}

Instance instance_of(const DrawItem& item) {
    const Mat4f rows = glm::transpose(item.world_from_body);
    return {.row_x = rows[0], .row_y = rows[1], .row_z = rows[2], .tint = Vec4f{item.tint, 1.0F}};
}

/// The material of one part; {} where the item brings too few.
assets::MaterialId material_of(const VisibleItem& member, const assets::SubMesh& part) {
    return part.material < member.materials.size() ? member.materials[part.material]
                                                   : assets::MaterialId{};
}

const assets::MaterialData& look_of(const assets::AssetLibrary& library, assets::MaterialId id) {
    static const assets::MaterialData plain{};
    return id.value == 0 ? plain : library.material(id);
}

/// Fills what a draw of one part needs beyond its instances.
void set_part(DrawRun& run, const assets::SubMesh& part, const assets::MaterialData& look) {
    run.first_index = part.first_index;
    run.index_count = part.index_count;
    run.two_sided = look.two_sided;
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
        for (const assets::SubMesh& part : library.mesh(run.mesh).sub_meshes) {
            run.material = material_of(first, part);
            const assets::MaterialData& look = look_of(library, run.material);
            if (look.alpha_mode == assets::AlphaMode::Blend) continue;
            set_part(run, part, look);
            list.runs.push_back(run);
        }
    });
}

void build_translucent(std::vector<VisibleItem>& visible,
                       const assets::AssetLibrary& library,
                       DrawList& list) {
    std::ranges::stable_sort(visible, [](const VisibleItem& a, const VisibleItem& b) {
        return a.distance_m > b.distance_m;
    });
    for (const VisibleItem& member : visible) {
        const DrawItem& item = *member.item;
        DrawRun run{.mesh = item.mesh,
                    .first_instance = static_cast<std::uint32_t>(list.instances.size()),
                    .instance_count = 1,
                    .bounds_world = member.bounds_world};
        bool has_part = false;
        for (const assets::SubMesh& part : library.mesh(item.mesh).sub_meshes) {
            run.material = material_of(member, part);
            const assets::MaterialData& look = look_of(library, run.material);
            if (look.alpha_mode != assets::AlphaMode::Blend) continue;
            set_part(run, part, look);
            list.runs.push_back(run);
            has_part = true;
        }
        if (has_part) list.instances.push_back(instance_of(item));
    }
}

}  // namespace

std::vector<VisibleItem> cull(const RenderFrame& frame,
                              const assets::AssetLibrary& library,
                              const Frustum& frustum,
                              const Vec3f& eye_world) {
    std::vector<VisibleItem> visible;
    visible.reserve(frame.items.size());
    for (const DrawItem& item : frame.items) {
        if (item.mesh.value == 0) continue;
        const Aabb bounds = transformed(library.mesh(item.mesh).bounds, item.world_from_body);
        if (!frustum.may_touch(bounds)) continue;
        const float distance_m =
            glm::distance(eye_world, bounds.center()) + glm::length(bounds.size()) * 0.5F;
        visible.push_back({&item, materials_of(frame, item), bounds, distance_m});
    }
    return visible;
}

void build_draws(std::vector<VisibleItem> visible,
                 const assets::AssetLibrary& library,
                 DrawKind kind,
                 DrawList& list) {
    if (kind == DrawKind::Opaque) {
        build_opaque(visible, library, list);
    } else {
        build_translucent(visible, library, list);
    }
}

void build_depth_draws(std::vector<VisibleItem> visible,
                       const assets::AssetLibrary& library,
                       DrawList& list) {
    std::erase_if(visible, [](const VisibleItem& member) { return !member.item->casts_shadow; });
    for_each_group(visible, [&](std::span<const SortEntry> entries) {
        const VisibleItem& first = visible[entries.front().index];
        DrawRun run = append_instances(visible, entries, list);
        for (const assets::SubMesh& part : library.mesh(run.mesh).sub_meshes) {
            const assets::MaterialId material = material_of(first, part);
            const assets::MaterialData& look = look_of(library, material);
            if (look.alpha_mode == assets::AlphaMode::Blend) continue;
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
