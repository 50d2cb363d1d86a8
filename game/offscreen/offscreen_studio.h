// A scene drawn off screen again and again, to measure what drawing it costs.
#pragma once

#include "engine/app/offscreen_run.h"

#include <filesystem>
#include <memory>

namespace plumbline::game {

inline constexpr std::uint32_t kStudioWidth_px = 640;
inline constexpr std::uint32_t kStudioHeight_px = 360;

/// Of a session in which nobody plays.
std::unique_ptr<scene::Game> no_game(scene::Simulation& simulation);

struct OffscreenStudio {
    std::unique_ptr<app::Session> session;
    std::unique_ptr<app::OffscreenRun> run;  // after the session: it goes first
    std::uint32_t width_px{0};
    std::uint32_t height_px{0};

    /// Nobody plays. One image has been drawn. No usable GL: exit code 3.
    static Result<OffscreenStudio> open(const std::filesystem::path& scene);
    /// As open(), without an image. Shaders are the program's; a width of 0: the scene's own size.
    static Result<OffscreenStudio> open_undrawn(const std::filesystem::path& scene,
                                                app::OffscreenDef def = {
                                                    .shader_folder = {},
                                                    .width_px = kStudioWidth_px,
                                                    .height_px = kStudioHeight_px});
};

}  // namespace plumbline::game
