// Light indoors: what comes in by windows and goes from wall to wall, at the points of a grid. No GL.
//
// Each point keeps the mean radiance from all directions and where more of it comes from (Greger et
// al., "The Irradiance Volume", 1998, with order-1 harmonics). Rays are cast once; what they carry is
// computed anew whenever sun or sky change.
#pragma once

#include "engine/render/light/ray_scene.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace plumbline::render {

/// Light that falls on the box from outside, as a matt white surface sends it on.
struct OutsideLight {
    std::array<Vec3f, 4> sky{};            ///< radiance, harmonics of order 0 and 1 (y z x)
    Vec3f sun_radiance{0.0F};              ///< irradiance over pi, of a surface that faces it
    Vec3f to_sun_world{0.0F, 1.0F, 0.0F};  ///< unit
};

class LightGrid {
public:
    /// Casts all rays: some tenths of a second for a house.
    LightGrid(const IndirectLight& box, const RayScene& rays);

    /// Computes what arrives at each point; casts no rays but those to the sun.
    void light(const OutsideLight& outside, const RayScene& rays);

    /// Along x, y and z; points lie in the middle of equal cells, x runs fastest.
    const std::array<std::uint32_t, 3>& counts() const { return counts_; }
    /// rgb: mean radiance.
    std::span<const Vec4f> means() const { return means_; }
    /// xyz: radiance is mean * (1 + dot(it, direction)).
    std::span<const Vec4f> slopes() const { return slopes_; }

private:
    /// Where a ray ends on a surface within the box. There are some hundred thousand: packed.
    struct Sample {
        Vec3f place_world{0.0F};
        std::uint32_t ray{0};     ///< its point times the directions, plus its direction
        std::uint32_t normal{0};  ///< snorm4x8; w: two-sided
        std::uint32_t albedo{0};  ///< unorm4x8
        float sun{0.0F};          ///< cosine to the sun; 0 in shadow
    };

    Vec3f place_of(std::uint32_t point) const;
    void cast_from(std::uint32_t point, const RayScene& rays);
    void find_sun(const OutsideLight& outside, const RayScene& rays);
    /// What a matt white surface there sends out, by the grid.
    Vec3f diffuse_at(const Vec3f& place_world, const Vec3f& normal_world) const;
    void gather(const OutsideLight& outside);
    void fill_closed_points();

    IndirectLight box_;
    std::array<std::uint32_t, 3> counts_{};
    std::vector<Vec3f> directions_;
    std::vector<Sample> samples_;
    std::vector<std::uint32_t> escapes_;  // rays, as in Sample
    std::vector<bool> is_closed_;         // within a wall
    std::vector<Vec4f> means_;
    std::vector<Vec4f> slopes_;
};

}  // namespace plumbline::render
