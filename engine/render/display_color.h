// The curves of shaders/include/color.glsl on the CPU, for what is not drawn but cleared.
#pragma once

#include "engine/core/math.h"

namespace plumbline::render {

/// Exact sRGB, 0…1.
Vec3f srgb_from_linear(const Vec3f& light);
/// The tone curve with its loss of colour in highlights, 0…1.
Vec3f tone_mapped(const Vec3f& radiance, float exposure);

}  // namespace plumbline::render
