// What a window can show before a renderer is there: a bar.
#pragma once

#include "engine/render/renderer.h"

#include <cstdint>

namespace plumbline::render {

enum class LoadingBackground { Dark, AsItIs };

struct LoadingBar {
    std::uint32_t width_px{0};  ///< of the window
    std::uint32_t height_px{0};
    float from{0.0F};   ///< 0 to 1: it is filled from here
    float share{0.0F};  ///< 0 to 1: to here
    LoadingBackground background{LoadingBackground::Dark};
};

/// Draws into the window's framebuffer; its context is current. Nothing where `loader` has no OpenGL.
void draw_loading_bar(GlLoader loader, const LoadingBar& bar);

}  // namespace plumbline::render
