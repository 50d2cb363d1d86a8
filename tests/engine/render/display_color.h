// What the shaders make of light, computed with the standard's own curves: images are predicted
// with it.
#pragma once

#include "engine/core/math.h"

#include <cmath>

namespace plumbline::render {

inline Vec3f srgb_from_linear(const Vec3f& light) {
    Vec3f code{0.0F};
    for (int i = 0; i < 3; ++i) {
        const float c = glm::clamp(light[i], 0.0F, 1.0F);
        code[i] = c <= 0.0031308F ? c * 12.92F : 1.055F * std::pow(c, 1.0F / 2.4F) - 0.055F;
    }
    return code;
}

inline Vec3f tone_mapped(const Vec3f& radiance, float exposure) {
    Vec3f c = glm::max(radiance, Vec3f{0.0F}) * exposure;
    const float luminance = glm::dot(c, Vec3f{0.2126F, 0.7152F, 0.0722F});
    c = glm::mix(c, Vec3f{luminance}, 0.35F * luminance / (luminance + 4.0F));
    return c * (6.7474777F * c + 0.6F) / (c * (6.7474777F * c + 3.3107095F) + 1.0F);
}

}  // namespace plumbline::render
