// Ways to draw a scene's image that differ from level high in one thing each.
#pragma once

#include "engine/render/render_frame.h"

#include <functional>
#include <string>
#include <vector>

namespace plumbline::study {

inline constexpr std::size_t kImageLevels = 3;

struct ImageVariant {
    std::string name;
    std::function<void(render::RenderFrame&)> apply;  ///< to a frame of level high
};

/// Level high first, to which the others are compared, then the other levels. Those of shadows only where
/// the frame has a sun that casts them.
std::vector<ImageVariant> image_variants(const render::RenderFrame& frame);

}  // namespace plumbline::study
