// What the game and the process of its ghost tell each other.
#pragma once

#include "engine/core/result.h"
#include "engine/study/setting.h"
#include "engine/study/worker.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace plumbline::study {

/// A moving body of the scene, by its entity's name; world axes.
struct GhostBody {
    std::string name;
    Vec3d position_m{0, 0, 0};
    Quatd orientation{1, 0, 0, 0};
    Vec3d velocity_mps{0, 0, 0};
    Vec3d angular_velocity_radps{0, 0, 0};
};

/// The state that a ghost goes on from. Bodies of the scene that are not listed are gone.
struct GhostStart {
    std::filesystem::path scene{};
    Setting setting{};
    double time_s{0};
    std::vector<GhostBody> bodies{};
};

/// Where the ghost's bodies are, in the order of GhostStart::bodies; what the scene does not have
/// (things dropped in play) stays where it was.
struct GhostState {
    double time_s{0};
    std::vector<GhostBody> bodies{};  ///< names empty, at rest: poses only
    double cpu_ms{0};                 ///< of the steps since the answer before
};

std::string start_body(const GhostStart& start);
/// As many simulated seconds further, rounded to whole steps.
std::string go_on_body(double seconds);
Result<GhostState> parse_ghost_state(const std::string& body);

/// The kind "ghost": a job of either body; the world stays in this process between them.
RunJob ghost_jobs();

}  // namespace plumbline::study
