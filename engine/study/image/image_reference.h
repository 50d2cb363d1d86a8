// The reference image for shadow maps, coarse meshes and smoothed edges: the mean of many samples a
// pixel. An exact ray decides for each sample whether the sun lights it.
#pragma once

#include "engine/render/render_frame.h"
#include "engine/study/image/light_image.h"

#include <cstdint>
#include <functional>

namespace plumbline::study {

/// World; unit. `at`: 0…1 from the image's upper left corner.
Vec3f ray_through(const render::Camera& camera, float aspect, const Vec2f& at);

/// `at` as above: whether the sun is hidden from what is seen there.
using IsShaded = std::function<bool(const Vec2f& at)>;

/// `in_sun`, `without_sun`: the same image with the sun shining through everything, and without the
/// sun, `samples_per_side` times as wide and as high as the reference. Rays are asked for only where
/// the two differ.
LightImage reference_image(const assets::ImageData& in_sun,
                           const assets::ImageData& without_sun,
                           std::uint32_t samples_per_side,
                           const IsShaded& is_shaded);

/// Asks the rays of a frame: its camera, its things, its sun. Without [sun] or its shadow nothing is
/// shaded. `frame` may go afterwards.
IsShaded shaded_by_rays(const render::RenderFrame& frame, assets::AssetLibrary& library);

}  // namespace plumbline::study
