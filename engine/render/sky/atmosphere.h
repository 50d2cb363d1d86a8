// Light in clear air round a planet. No GL.
#pragma once

#include "engine/core/math.h"

#include <vector>

namespace plumbline::render {

/// Air, haze and ozone above an eye on the ground. The first scattering is followed along each ray
/// (Nishita, Sirai, Tadamura and Nakamae, "Display of the Earth Taking into Account Atmospheric
/// Scattering", SIGGRAPH 1993, section 4: the earth's shadow and the red of low suns come from it);
/// all later ones count as even in all directions (Hillaire, "A Scalable and Production Ready Sky and
/// Atmosphere Rendering Technique", EGSR 2020, section 5.5). Air, haze and ozone as in table 1 there.
///
/// All radiance is for a light whose irradiance outside the air is 1 in each channel (a third of the
/// spectrum: red, green, blue). Some 10 ms to make; immutable after that.
class Atmosphere {
public:
    /// `haze`: times the dust and mist of a clear day; 0 to 20.
    explicit Atmosphere(float haze);

    /// The share of a far light's irradiance that reaches `altitude_m`, by the sine of the light's
    /// height above the horizon; its disc sinks below the horizon within half a degree. 0 at night.
    Vec3f transmittance(float sin_height, float altitude_m = 0.0F) const;

    /// What comes from a direction, apart from how the two phase functions weigh it.
    struct Scattered {
        Vec3f air{0.0F};    ///< times rayleigh_phase()
        Vec3f haze{0.0F};   ///< times haze_phase()
        Vec3f often{0.0F};  ///< scattered more than once
    };
    /// Of a ray up from the ground: sin_height ≥ 0 (below: as at the horizon). `cos_between` is the
    /// cosine of the angle between the ray's and the light's compass directions.
    Scattered scattered(float sin_height, float cos_between, float light_sin_height) const;

    static float rayleigh_phase(float cosine);
    static float haze_phase(float cosine);

private:
    struct Medium {
        Vec3f air;   ///< scattered, 1/m
        float haze;  ///< scattered, 1/m
        Vec3f lost;  ///< scattered and absorbed, 1/m
    };
    Medium medium_at(float altitude_m) const;
    Vec3f transmittance_along(float altitude_m, float sin_height) const;
    Vec3f often_at(float altitude_m, float light_sin_height) const;
    Vec3f often_from(float altitude_m, float light_sin_height) const;

    float haze_;
    std::vector<Vec3f> transmittance_;  ///< by altitude and sine
    std::vector<Vec3f> often_;  ///< by altitude and the light's sine; radiance from anywhere
};

}  // namespace plumbline::render
