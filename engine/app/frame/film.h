// A film of what the window shows, from one press to the next.
#pragma once

#include "engine/app/capture/video_file.h"
#include "engine/app/frame/frame_state.h"
#include "engine/platform/window.h"

#include <memory>

namespace plumbline::app {

class Film {
public:
    /// State and window must outlive it.
    Film(FrameState& state, platform::Window& window) : state_(state), window_(window) {}

    void start_or_end();
    /// After each frame: hands the image to the film's thread. The film ends where the window has
    /// another size.
    void add_frame(const render::Renderer& renderer);
    /// What was filmed is whole then.
    void end();

private:
    FrameState& state_;
    platform::Window& window_;
    std::unique_ptr<VideoFile> file_;  ///< null: none is taken
    double next_s_{0};                 ///< when the next frame is due
};

}  // namespace plumbline::app
