#include "engine/render/render_frame.h"

namespace plumbline::render {

void add_item(RenderFrame& frame, DrawItem item, std::span<const assets::MaterialId> materials) {
    item.first_material = static_cast<std::uint32_t>(frame.material_ids.size());
    item.material_count = static_cast<std::uint32_t>(materials.size());
    frame.material_ids.insert(frame.material_ids.end(), materials.begin(), materials.end());
    frame.items.push_back(item);
}

std::span<const assets::MaterialId> materials_of(const RenderFrame& frame, const DrawItem& item) {
    return std::span{frame.material_ids}.subspan(item.first_material, item.material_count);
}

}  // namespace plumbline::render
