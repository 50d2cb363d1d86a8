// Light and the codes that stand for it.
#pragma once

#include "engine/core/math.h"

#include <cmath>

namespace plumbline {

/// The sRGB transfer curve (IEC 61966-2-1) of one channel, 0…1.
template <class T>
T linear_from_srgb(T code) {
    if (code <= static_cast<T>(0.04045)) return code / static_cast<T>(12.92);
    return std::pow((code + static_cast<T>(0.055)) / static_cast<T>(1.055), static_cast<T>(2.4));
}

/// Its inverse, of light 0…1.
template <class T>
T srgb_from_linear(T light) {
    if (light <= static_cast<T>(0.0031308)) return light * static_cast<T>(12.92);
    return static_cast<T>(1.055) * std::pow(light, static_cast<T>(1.0 / 2.4)) -
           static_cast<T>(0.055);
}

/// How bright linear light looks, by the primaries of sRGB (ITU-R BT.709).
inline float luminance(const Vec3f& light) {
    return glm::dot(light, Vec3f{0.2126F, 0.7152F, 0.0722F});
}

}  // namespace plumbline
