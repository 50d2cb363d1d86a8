// What drawing a frame took, as plain data.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace plumbline::render {

/// One pass of the latest frame. Passes that did not run are not listed.
struct PassTiming {
    /// "shadow.sun", "shadow.flashlight", "shadow.lights", "opaque", "sky", "fog", "refraction",
    /// "translucent", "drops", "resolve", "occlusion", "shafts", "focus", "motion_blur", "post.bloom",
    /// "post.exposure", "image", "lines", "ui"
    std::string_view name;
    double cpu_ms{0};   ///< of the calling thread
    double gpu_ms{-1};  ///< timer query of an earlier frame; -1 where the driver has none
};

struct FrameStats {
    std::vector<PassTiming> passes;
    std::uint32_t draw_calls{0};
    std::uint64_t triangles{0};
    std::uint32_t instances{0};
    std::uint32_t shadow_passes_rendered{0};
    std::uint32_t shadow_passes_cached{0};
    std::uint32_t shadowed_lights{0};
    std::uint32_t unshadowed_lights{0};  ///< ask for shadows and are in sight, but too many
    std::uint32_t scene_width_px{0};     ///< of the image that the scene is drawn into
    std::uint32_t scene_height_px{0};
    /// Drawn with for the first time in this frame: its time tells nothing of the next.
    std::uint32_t new_programs{0};
};

}  // namespace plumbline::render
