// A scene drawn off screen again and again, to measure what drawing it costs.
#pragma once

#include "engine/app/offscreen_run.h"

#include <filesystem>
#include <memory>

namespace plumbline::game {

inline constexpr std::uint32_t kStudioWidth_px = 640;
inline constexpr std::uint32_t kStudioHeight_px = 360;

struct OffscreenStudio {
    std::unique_ptr<app::Session> session;
    std::unique_ptr<app::OffscreenRun> run;  // after the session: it goes first

    /// Nobody plays. One image has been drawn. No usable GL: exit code 3.
    static Result<OffscreenStudio> open(const std::filesystem::path& scene);
    /// As open(), without an image.
    static Result<OffscreenStudio> open_undrawn(const std::filesystem::path& scene);
};

}  // namespace plumbline::game
