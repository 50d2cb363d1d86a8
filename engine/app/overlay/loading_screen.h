// What a window shows while its scene is read and made ready: how far that is.
#pragma once

#include "engine/platform/window.h"
#include "engine/render/loading_bar.h"

namespace plumbline::app {

class LoadingScreen {
public:
    explicit LoadingScreen(platform::Window& window) : window_(window) {}

    /// At most ten times a second: drawing it takes time that loading could have.
    void show(float share);
    /// As show(), while nobody knows how far it is.
    void show_waiting();

private:
    void show(const render::LoadingBar& bar);

    platform::Window& window_;
    double next_s_{0};
};

/// A bar while nobody knows how far it is: a piece of it goes to and fro.
render::LoadingBar waiting_bar_of(const platform::Window& window, double now_s);
/// The window's framebuffer, with the bar in it, which is not presented.
render::LoadingBar loading_bar_of(const platform::Window& window, float share);

}  // namespace plumbline::app
