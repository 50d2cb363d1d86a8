// Messages between the game and the process of its ghost.
#pragma once

#include "engine/core/result.h"
#include "engine/study/scene_start.h"
#include "engine/study/setting.h"
#include "engine/study/workers/worker.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace plumbline::study {

/// A moving body, by its entity's name; world axes.
struct GhostBody {
    std::string name;
    Vec3d position_m{0, 0, 0};
    Quatd orientation{1, 0, 0, 0};
};

/// The state that a ghost goes on from. `bodies` are those that it is compared in.
struct GhostStart {
    std::filesystem::path scene{};
    Setting setting{};
    SceneStart from{};
    std::vector<GhostBody> bodies{};
};

/// Where the ghost's bodies are, in the order of GhostStart::bodies; what the scene does not have
/// (things dropped in play) stays where it was.
struct GhostState {
    double time_s{0};
    std::vector<GhostBody> bodies{};  ///< names empty
    double cpu_ms{0};                 ///< of the steps since the answer before
};

std::string start_body(const GhostStart& start);
/// As many simulated seconds further, rounded to whole steps.
std::string go_on_body(double seconds);
Result<GhostState> parse_ghost_state(const std::string& body);

/// The kind "ghost": a job of either body; the world stays in this process between them.
RunJob ghost_jobs();

}  // namespace plumbline::study
