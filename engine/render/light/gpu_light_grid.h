// The frame's light grid as textures. Exists while a frame asks for indirect light.
#pragma once

#include "engine/render/gl/texture.h"
#include "engine/render/light/light_grid.h"

#include <cstddef>
#include <memory>
#include <set>

namespace plumbline::render {

struct FrameBlock;

/// What the frame's sun and sky send.
OutsideLight outside_light(const FrameBlock& block);

class GpuLightGrid {
public:
    /// Casts the rays when the box or what stands in it has changed, and lights the grid when the
    /// light outside has. Without indirect light in the frame everything is freed.
    void want(const RenderFrame& frame, const OutsideLight& outside, assets::AssetLibrary& library);
    void bind() const;
    /// Whether some of a thing may be indoors: of what is static by its triangles, else by its bounds.
    bool may_light(assets::MeshId mesh, bool is_static, const Aabb& bounds_world) const;

    bool ready() const { return grid_ != nullptr; }
    std::size_t bytes() const { return means_.bytes() + slopes_.bytes(); }

private:
    void find_inside(const RenderFrame& frame, const assets::AssetLibrary& library);

    std::unique_ptr<LightGrid> grid_;
    Aabb rooms_;
    std::set<std::uint32_t> inside_;  // meshes of static things with a triangle in the rooms
    std::uint64_t content_{0};        // hash of the box and of what stands in it
    OutsideLight outside_;            // that it is lit by
    float lit_at_s_{0.0F};
    gl::Texture means_;
    gl::Texture slopes_;
};

}  // namespace plumbline::render
