// Which images a frame is drawn into, how large they are, and which passes over them run. Plain data,
// computed without GL.
#pragma once

#include "engine/assets/asset_library.h"
#include "engine/render/render_frame.h"
#include "engine/render/resources/gpu_limits.h"

#include <cstdint>

namespace plumbline::render {

struct PixelSize {
    std::uint32_t width{0};
    std::uint32_t height{0};
    friend bool operator==(const PixelSize&, const PixelSize&) = default;
};

/// What a renderer draws with: the same for all its frames.
struct Device {
    GpuLimits limits;  ///< sizes are set, half_float_targets is as the driver has them
    bool is_software_gl{false};
    bool is_offscreen{false};  ///< the finished image is the renderer's own, not a window's
};

struct ImagePlan {
    Quality quality;           ///< in force: the frame's, or less where memory is short
    PixelSize scene_px;        ///< the scene's image
    PixelSize image_px;        ///< after its samples became pixels
    PixelSize present_px;      ///< the finished image
    std::uint32_t samples{1};  ///< of a pixel of the scene's image
    bool bloom{false};
    bool tone_curve{false};
    bool fxaa{false};
    bool keeps_depth{false};  ///< lines will be drawn over the image
    // Passes that need light in half floats.
    bool occlusion{false};
    bool shafts{false};
    bool refraction{false};
    bool focus{false};
    bool motion_blur{false};
    bool writes_codes{false};  ///< surfaces and sky write sRGB codes into the finished image

    float aspect() const {
        return static_cast<float>(present_px.width) / static_cast<float>(present_px.height);
    }
    bool is_scaled() const { return image_px != present_px; }
    bool has_samples() const { return scene_px != image_px; }
    /// Light has to be encoded, nothing else.
    bool only_encodes() const {
        return !bloom && !tone_curve && !fxaa && !is_scaled() && !has_samples() && samples == 1 &&
               !occlusion && !shafts && !refraction && !focus && !motion_blur;
    }
};

/// The frame's quality on that device; less of it after so many tries found no memory: half the render
/// scale after one, the lowest level after two.
Quality quality_in_force(const RenderFrame& frame, const Device& device, int failed_tries);

ImagePlan plan_image(const RenderFrame& frame,
                     const Quality& quality,
                     const Device& device,
                     const assets::AssetLibrary& library);

}  // namespace plumbline::render
