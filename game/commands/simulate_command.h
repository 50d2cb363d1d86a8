// `plumbline simulate`: a scene without window, image or sound, for numbers. Also the whole of
// plumbline-f64, so nothing here may need more than scene and effects.
#pragma once

#include "engine/core/process/exit_code.h"
#include "engine/physics/physics_world.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace plumbline::game {

struct SimulateOptions {
    std::string scene;
    double seconds{1.0};  ///< rounded to whole steps; with load_file so many more
    std::optional<physics::Solver> solver{};
    std::optional<int> step_hz{};
    std::optional<int> substeps{};
    std::optional<int> iterations{};
    std::optional<int> threads{};
    std::uint64_t seed{1};
    std::filesystem::path load_file;  ///< a saved game to go on from
    std::filesystem::path save_file;
    std::filesystem::path state_file;
    std::filesystem::path trace_file;
    std::filesystem::path trace_events_file;
    double trace_every_s{0.0};  ///< 0: every step
    std::optional<std::string> expect_hash{};
    std::optional<double> drive_fps{};  ///< steps come through the frame clock at this frame rate
};

/// Prints a summary to stdout and messages to the log. After Ctrl-C it writes what was done so far.
ExitCode run_simulate(const SimulateOptions& options);

}  // namespace plumbline::game
