// `plumbline render` and `plumbline tour`: images without a window.
#pragma once

#include "game/command_line/command_line.h"

#include <optional>
#include <string>

namespace plumbline::game {

struct RenderOptions {
    std::string scene;
    std::filesystem::path out;
    std::string size;
    double at_s{0};      ///< simulated seconds before the image
    std::string camera;  ///< x,y,z,yaw,pitch; degrees
    std::filesystem::path camera_path;
    std::string shading;
    /// One fixed step before each frame after the first. More than one, and `out` without an ending:
    /// a folder that gets them all.
    std::uint64_t frames{1};
    std::filesystem::path video;  ///< a film of all frames
    double orbit_deg{0};          ///< so far the camera goes round during the frames
    double sun_degps{0};          ///< the sun turns
    std::optional<double> hour;   ///< of the day
    std::filesystem::path report;
    std::string level;         ///< of the image; empty: nothing is left out
    float render_scale{0.0F};  ///< with a level; 0: the level's own
    bool textures{false};      ///< of a JSON scene, whose colours hold otherwise
    bool shadows{false};       ///< in a JSON scene, which has none otherwise
    bool flashlight{false};
    bool fog{false};  ///< switched on even where the scene has none
};

ExitCode run_render(const RenderOptions& options, const CommonOptions& common);

struct TourOptions {
    std::string scene{"garden"};
    std::filesystem::path out{"out"};
    std::string size{"1280x720"};
};

/// A short walk through a scene as images and one contact sheet, for machines without a display.
ExitCode run_tour(const TourOptions& options, const CommonOptions& common);

}  // namespace plumbline::game
