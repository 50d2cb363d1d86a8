// Every frame of `plumbline render` as a file of its own, or as a film.
#pragma once

#include "engine/app/capture/video_file.h"
#include "engine/app/offscreen_run.h"

#include <filesystem>
#include <memory>

namespace plumbline::game {

struct FrameFilesDef {
    std::filesystem::path folder;  ///< frame_00001.png and so on; empty: none
    std::filesystem::path video;   ///< empty: none
    std::uint32_t width_px{0};
    std::uint32_t height_px{0};
    int frames_per_s{60};
};

class FrameFiles {
public:
    /// Makes the folder; starts the film.
    static Result<FrameFiles> open(const FrameFilesDef& def);
    /// Keeps what was drawn last.
    Result<Done> take(const app::OffscreenRun& run);
    /// Waits until the film is whole.
    Result<Done> close();

private:
    std::filesystem::path folder_;
    std::unique_ptr<app::VideoFile> video_;
    int count_{0};
};

}  // namespace plumbline::game
