// Casts rays into a RenderFrame: full meshes, alpha masks by their texture. Light indoors is computed
// with them, and they are the exact reference for shadow maps and coarser meshes. Embree finds the
// triangles.
#pragma once

#include "engine/render/render_frame.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

namespace plumbline::render {

struct RayHit {
    Vec3f position_world{0.0F};
    Vec3f normal_world{
        0.0F, 1.0F, 0.0F};  ///< of the triangle; unit, towards where the ray came from
    float distance_m{0.0F};
    bool two_sided{false};
    bool from_behind{false};  ///< the back of a one-sided surface; its normal points along the ray
    Vec3f albedo{0.5F};       ///< mean of the part that was hit
};

/// Whether rays see the backs of one-sided surfaces; the image looks through them.
enum class Backs : std::uint8_t { LookedThrough, Seen };

class RayScene {
public:
    /// Copies all triangles but those of Blend materials, which neither hide nor cast. Decodes the
    /// base colour maps of masks once more; `library` is not needed later.
    /// Of the frame's items `wanted` says which are in it; null: all.
    RayScene(const RenderFrame& frame,
             assets::AssetLibrary& library,
             const std::function<bool(const DrawItem&)>& wanted = {});
    ~RayScene();
    RayScene(const RayScene&) = delete;
    RayScene& operator=(const RayScene&) = delete;

    /// `direction_world`: unit.
    std::optional<RayHit> first_hit(const Vec3f& origin_world,
                                    const Vec3f& direction_world,
                                    Backs backs = Backs::LookedThrough) const;
    /// Whether a thing that casts shadows lies between the place and a light infinitely far off.
    /// `to_light_world`: unit. Leaves do not shade their own backs, through which light comes.
    bool is_shaded(const RayHit& place, const Vec3f& to_light_world) const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace plumbline::render
