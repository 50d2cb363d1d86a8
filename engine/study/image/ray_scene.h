// Casts rays into a RenderFrame: full meshes, alpha masks by their texture. It is the exact reference for
// shadow maps and coarser meshes. Embree finds the triangles.
#pragma once

#include "engine/render/render_frame.h"

#include <memory>
#include <optional>

namespace plumbline::study {

struct RayHit {
    Vec3f position_world{0.0F};
    Vec3f normal_world{
        0.0F, 1.0F, 0.0F};  ///< of the triangle; unit, towards where the ray came from
    float distance_m{0.0F};
    bool two_sided{false};
};

class RayScene {
public:
    /// Copies all triangles but those of Blend materials, which neither hide nor cast. Decodes the
    /// base colour maps of masks once more; `library` is not needed later.
    RayScene(const render::RenderFrame& frame, assets::AssetLibrary& library);
    ~RayScene();
    RayScene(const RayScene&) = delete;
    RayScene& operator=(const RayScene&) = delete;

    /// `direction_world`: unit. Like the image it looks through the backs of one-sided surfaces.
    std::optional<RayHit> first_hit(const Vec3f& origin_world, const Vec3f& direction_world) const;
    /// Whether a thing that casts shadows lies between the place and a light infinitely far off.
    /// `to_light_world`: unit. Leaves do not shade their own backs, through which light comes.
    bool is_shaded(const RayHit& place, const Vec3f& to_light_world) const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace plumbline::study
