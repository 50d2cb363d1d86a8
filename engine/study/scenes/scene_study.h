// A study of a scene without a closed form: it makes a reference, runs the grid of settings, and
// compares them with the reference.
#pragma once

#include "engine/study/engines/engine_table.h"
#include "engine/study/scenes/scene_grid.h"
#include "engine/study/scenes/scene_plan.h"

#include <filesystem>
#include <optional>

namespace plumbline::study {

struct SceneStudy {
    Subject subject;
    double seconds{0};  ///< simulated
    double from_s{
        0};  ///< of the scene's time: where its runs began; 0 also where they began as the scene does
    bool chaotic{false};
    bool complete{true};  ///< false: interrupted; the points are those done by then
};
/// Told what is known so far: after each point, and where a better reference moves all of them.
using TellStudy = std::function<void(const SceneStudy&)>;

struct SceneStudyOptions {
    std::filesystem::path scene{};      ///< a file; find_scene() makes one of a name
    std::optional<SceneStart> start{};  ///< none: from the scene's own start
    std::optional<double> seconds{};    ///< simulated; none: 3, fewer where that takes too long
    GridSize grid{GridSize::Full};
    std::optional<double> wall_s{};  ///< to be done within; none: 50, more for many bodies
    /// Simulated: where `wall_s` is too short for it, the study takes up to three times as long.
    double least_seconds{0};
    Workers workers{};
    std::vector<const EngineRow*> engines{};  ///< after the grid, and beyond `wall_s`
    std::vector<int>
        threads{};  ///< likewise: the scene's own setting with so many, one run at a time
    ReportProgress progress{};
    TellStudy tell{};
};

/// Refused (exit code 4): a scene that does not load, has no dynamic bodies, or goes through no
/// reference. Where every setting of the grid ends early the points say how.
Result<SceneStudy> study_scene(const SceneStudyOptions& options);

}  // namespace plumbline::study
