#include "engine/app/overlay/loading_screen.h"

#include "engine/core/time/stopwatch.h"

#include <algorithm>
#include <cmath>

namespace plumbline::app {

namespace {

constexpr double kBetween_s = 0.1;
constexpr double kToAndFro_s = 2.0;
constexpr float kPiece = 0.25F;  // of the bar

}  // namespace

render::LoadingBar loading_bar_of(const platform::Window& window, float share) {
    const platform::PixelSize size = window.framebuffer_size();
    return {.width_px = static_cast<std::uint32_t>(std::max(size.width, 0)),
            .height_px = static_cast<std::uint32_t>(std::max(size.height, 0)),
            .share = share};
}

render::LoadingBar waiting_bar_of(const platform::Window& window, double now_s) {
    const double turn = std::fmod(now_s / kToAndFro_s, 1.0);
    const auto along = static_cast<float>(1.0 - std::abs(2.0 * turn - 1.0));
    render::LoadingBar bar = loading_bar_of(window, along * (1.0F - kPiece) + kPiece);
    bar.from = along * (1.0F - kPiece);
    return bar;
}

void LoadingScreen::show(float share) {
    show(loading_bar_of(window_, share));
}

void LoadingScreen::show_waiting() {
    show(waiting_bar_of(window_, wall_s()));
}

void LoadingScreen::show(const render::LoadingBar& bar) {
    const double now_s = wall_s();
    if (now_s < next_s_ || window_.iconified()) return;
    render::draw_loading_bar(window_.gl_loader(), bar);
    window_.present();
    next_s_ = wall_s() + kBetween_s;
}

}  // namespace plumbline::app
