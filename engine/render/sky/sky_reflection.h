// The sky as rough mirrors see it: a level a roughness. No GL.
#pragma once

#include "engine/render/sky/sky_light.h"

#include <vector>

namespace plumbline::render {

/// From six square faces to levels of half the side each, down to one pixel: level i of n is what a mirror
/// of roughness i / (n - 1) sees, its mean over the lobe of GGX seen head on (B. Karis, "Real Shading in
/// Unreal Engine 4", 2013). The first is the faces themselves.
std::vector<std::vector<RadianceImage>> reflection_levels(std::vector<RadianceImage> faces);

}  // namespace plumbline::render
