// Where a shadow map looks. Pure arithmetic: tested without GL.
#pragma once

#include "engine/core/math.h"
#include "shaders/shared/limits.h"

#include <cstdint>

namespace plumbline::render {

struct ViewShape {
    Vec3f position_world{0.0F};
    Vec3f forward_world{0.0F, 0.0F, -1.0F};
    float fov_y_rad{1.0F};
    float aspect{1.0F};  ///< width / height
};

struct SunShadowFit {
    Mat4f clip_from_world{1.0F};
    float texel_m{0.0F};
};

/// So many times as deep as wide is the box that a map of the sun shows.
inline constexpr float kSunMapDepth = PL_SUN_MAP_DEPTH;

/// An orthographic box along the light that covers all points in sight within distance_m of the
/// camera. Its size depends on fov, aspect, distance and light only; its centre moves in steps of an
/// eighth of its width, each a whole number of texels, and in depth, where there is room, in steps of
/// its width. So the map is the same texel for texel while the camera stays within a step, the same but
/// for its place after one to the side, and shadow edges never crawl.
SunShadowFit fit_sun_shadow(const ViewShape& view,
                            const Vec3f& light_direction_world,
                            float distance_m,
                            std::uint32_t size_px);

/// The distance from the eye at which the cascade ends that is number `i` of `count`; the last ends at
/// `distance_m`. The practical split scheme: a weighted mean of equal ratios, by which a texel looks
/// equally large in all cascades, and of equal lengths (F. Zhang, H. Sun, L. Xu, L. K. Lun,
/// "Parallel-Split Shadow Maps for Large-scale Virtual Environments", 2006).
float cascade_end_m(std::uint32_t i, std::uint32_t count, float distance_m);

/// From texture coordinates and depth (0...1) in one fit to those in another of the same light:
/// xyz: offset, w: scale.
Vec4f cascade_from_first(const SunShadowFit& first, const SunShadowFit& other);

/// A perspective along the spot's axis, a little wider than its cone.
Mat4f fit_spot_shadow(const Vec3f& position_world,
                      const Vec3f& direction_world,
                      float outer_rad,
                      float radius_m);

}  // namespace plumbline::render
