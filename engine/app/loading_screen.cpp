#include "engine/app/loading_screen.h"

#include "engine/core/stopwatch.h"

#include <algorithm>

namespace plumbline::app {

namespace {

constexpr double kBetween_s = 0.1;

}  // namespace

render::LoadingBar loading_bar_of(const platform::Window& window, float share) {
    const platform::PixelSize size = window.framebuffer_size();
    return {.width_px = static_cast<std::uint32_t>(std::max(size.width, 0)),
            .height_px = static_cast<std::uint32_t>(std::max(size.height, 0)),
            .share = share};
}

void LoadingScreen::show(float share) {
    const double now_s = wall_s();
    if (now_s < next_s_ || window_.iconified()) return;
    render::draw_loading_bar(window_.gl_loader(), loading_bar_of(window_, share));
    window_.present();
    next_s_ = wall_s() + kBetween_s;
}

}  // namespace plumbline::app
