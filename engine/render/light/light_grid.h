// Light indoors: what comes in by windows and goes from wall to wall, at the points of a grid. No GL.
//
// Each point keeps the mean radiance from all directions and where more of it comes from (Greger et
// al., "The Irradiance Volume", 1998, with order-1 harmonics). Rays are cast once; what they carry is
// computed anew whenever sun or sky change.
#pragma once

#include "engine/render/light/ray_scene.h"

#include <array>
#include <cstdint>
#include <memory>
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
    LightGrid(const IndirectLight& box, std::unique_ptr<const RayScene> rays);

    /// Computes what arrives at each point; no ray but those to the sun.
    void light(const OutsideLight& outside);

    /// Along x, y and z; points lie in the middle of equal cells, x runs fastest.
    const std::array<std::uint32_t, 3>& counts() const { return counts_; }
    /// rgb: mean radiance.
    std::span<const Vec4f> means() const { return means_; }
    /// xyz: radiance is mean * (1 + dot(it, direction)).
    std::span<const Vec4f> slopes() const { return slopes_; }
    std::uint64_t bytes() const;

private:
    /// Where a ray from a point ends on a surface within the box.
    struct Sample {
        std::uint32_t point{0};
        std::uint32_t direction{0};
        RayHit hit;
        float sun{0.0F};  ///< cosine to the sun; 0 in shadow
    };
    struct Escape {
        std::uint32_t point{0};
        std::uint32_t direction{0};
    };

    Vec3f place_of(std::uint32_t point) const;
    void cast_from(std::uint32_t point);
    /// What a matt white surface there sends out, by the grid.
    Vec3f diffuse_at(const Vec3f& place_world, const Vec3f& normal_world) const;
    void gather(const OutsideLight& outside);
    void fill_closed_points();

    IndirectLight box_;
    std::array<std::uint32_t, 3> counts_{};
    std::unique_ptr<const RayScene> rays_;
    std::vector<Vec3f> directions_;
    std::vector<Sample> samples_;
    std::vector<Escape> escapes_;
    std::vector<bool> is_closed_;  // within a wall
    std::vector<Vec4f> means_;
    std::vector<Vec4f> slopes_;
};

}  // namespace plumbline::render
