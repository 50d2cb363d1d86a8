// The sky that a SkyModel asks for, in numbers: its radiance, and the light on what stands under it.
// No GL.
#pragma once

#include "engine/render/render_frame.h"
#include "engine/render/sky/atmosphere.h"
#include "engine/render/sky/sky_light.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace plumbline::render {

/// Clouds as they were baked, one direction: how they answer light from any side.
struct CloudTexel {
    float cover{0.0F};   ///< 0: none, 1: nothing shines through
    float lit{0.0F};     ///< share of the light that it sends on, on average over the light's sides
    Vec2f toward{0.0F};  ///< and so much more per unit of the light's direction, x and z
};

class ComputedSky {
public:
    /// A cube of clouds is `kSide` on a side, faces in the order of cube maps; empty: no clouds.
    static constexpr std::uint32_t kSide = 32;

    ComputedSky() = default;

    /// True: something is other than before. A sun that moved by less than a twentieth of a degree
    /// is where it was. Some milliseconds where it moved.
    bool want(const SkyModel& model, const Vec3f& sun_irradiance);
    void set_clouds(std::vector<CloudTexel> clouds) { clouds_ = std::move(clouds); }

    /// Of the air alone, any unit direction; below the horizon the lit ground fades in.
    Vec3f radiance(const Vec3f& direction) const;

    /// Sun or moon, whichever shines: never both. No light at all between them.
    struct KeyLight {
        Vec3f to_light_world{0.0F, 1.0F, 0.0F};
        Vec3f irradiance{0.0F};  ///< at the ground, of a surface that faces it
    };
    const KeyLight& key_light() const { return key_light_; }
    /// What falls on level ground, all in all.
    const Vec3f& irradiance() const { return irradiance_; }

    /// What a cloud sends on towards an eye that looks along `direction`: `ambient`, and `light`
    /// times what the cloud's texel says.
    struct CloudLight {
        Vec3f ambient{0.0F};
        Vec3f light{0.0F};
    };
    CloudLight cloud_light(const Vec3f& direction) const;
    const Vec3f& to_cloud_light() const { return cloud_key_.to_light_world; }

    /// What far things go over into, by the cosine of the angle between where they are and the light:
    /// the horizon's radiance is [0] + cosine [1] + cosine^2 [2].
    std::array<Vec3f, 3> horizon() const;
    /// Of sun or moon, whichever is the brighter in the sky: x and z, unit.
    Vec2f light_heading() const;

    /// With clouds: the faces of a small cube map.
    std::vector<RadianceImage> faces() const;

    const SkyModel& model() const { return model_; }
    const Vec3f& to_moon() const { return to_moon_; }
    /// Radiance of the discs, through the air; stars: 0 by day, 1 in the night.
    Vec3f sun_disc() const;
    Vec3f moon_disc() const;
    float stars() const { return stars_; }
    const Atmosphere& atmosphere() const { return *atmosphere_; }

private:
    /// The air under one light: a table over the sky's dome.
    struct LitAir {
        Vec3f to_light{0.0F, 1.0F, 0.0F};
        Vec3f irradiance{0.0F};  ///< outside the air; 0: no table
        std::vector<Atmosphere::Scattered> table;
        Vec3f at(const Vec3f& direction) const;
    };
    void light_up(LitAir& air, const Vec3f& to_light, const Vec3f& irradiance) const;
    Vec3f above(const Vec3f& direction) const;
    Vec3f gathered(const LitAir& air) const;
    void find_level();
    void find_key_light();

    SkyModel model_{};
    Vec3f sun_irradiance_{-1.0F};
    std::optional<Atmosphere> atmosphere_;
    LitAir sun_{};
    LitAir moon_{};
    Vec3f to_moon_{0.0F, -1.0F, 0.0F};
    float stars_{0.0F};
    Vec3f night_glow_{0.0F};
    Vec3f irradiance_{0.0F};
    Vec3f ground_{0.0F};
    Vec3f overhead_{0.0F};  ///< mean radiance of the upper half
    KeyLight key_light_{};
    KeyLight cloud_key_{};
    std::vector<CloudTexel> clouds_;
};

}  // namespace plumbline::render
