// How far the image is opened: eyes that get used to the dark and to the sun. Exists while a frame's
// post asks for it.
#pragma once

#include "engine/render/gl/buffer.h"
#include "engine/render/gl/framebuffer.h"
#include "engine/render/gl/texture.h"
#include "engine/render/passes/pass_context.h"

#include <chrono>
#include <cstddef>
#include <optional>

namespace plumbline::render {

/// Of a scene whose luminance is `mean` (geometric): 1 for a day's, up to 5 for a night's, less in glare.
/// Less than would make all alike: nights stay dark.
float exposure_for(float mean);

/// Where eyes that saw by `now` are after so long, on the way to `wanted`: dark takes them longer.
float adapted(float now, float wanted, float seconds);

class ExposureMeter {
public:
    enum class Reading {
        Now,    ///< of this frame, waited for: each image by itself, the same every time
        Later,  ///< of the frame before, and eyes take their time
    };

    /// What to multiply this frame's light with.
    float measure(const gl::Texture& scene, Reading reading, PassContext context);
    void free() { *this = {}; }
    std::size_t bytes() const { return cells_.bytes() + read_back_.size(); }

private:
    using Clock = std::chrono::steady_clock;

    void make();
    /// The mean that the cells hold, or held when they were last copied.
    float read_cells();
    float read_copy();

    gl::Texture cells_;
    gl::Framebuffer framebuffer_;
    gl::Buffer read_back_;
    bool copied_{false};
    std::optional<float> exposure_;
    Clock::time_point seen_{};
};

}  // namespace plumbline::render
