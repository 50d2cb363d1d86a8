#include "game/commands/simulate_cli.h"

#include "engine/core/limits.h"
#include "engine/core/log.h"
#include "engine/core/text/nearest_name.h"
#include "game/command_line/option_ranges.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace plumbline::game {

void take_solver(const std::string& name, std::optional<physics::Solver>& solver) {
    solver = physics::solver_from_name(name);
    if (solver) return;
    std::vector<std::string_view> known;
    std::string list;
    for (const physics::Solver each : physics::kSolvers) {
        known.push_back(physics::solver_name(each));
        list += (list.empty() ? "" : ", ") + std::string(physics::solver_name(each));
    }
    const std::string_view nearest = nearest_name(name, known);
    std::string complaint = fmt::format("--solver: there is no \"{}\"", name);
    if (!nearest.empty()) complaint += fmt::format("; the nearest is \"{}\"", nearest);
    throw CLI::ValidationError(complaint + "; known: " + list);
}

CLI::App* add_simulate(CLI::App& app, SimulateOptions& options) {
    CLI::App* simulate =
        app.add_subcommand("simulate", "Steps a scene and writes what became of it");
    simulate
        ->add_option("scene", options.scene, "A scene or model file, or a name below assets/scenes")
        ->required();
    simulate->add_option("--seconds", options.seconds, "Simulated time")
        ->check(between(0.0, kLongestRun_s));
    simulate->add_option_function<std::string>(
        "--solver",
        [&options](const std::string& name) { take_solver(name, options.solver); },
        "small_step, bullet_si, bullet_nncg, bullet_dantzig or bullet_pgs");
    simulate->add_option("--hz", options.step_hz, "Steps a second")
        ->check(CLI::Range(limits::kStepHzMin, limits::kStepHzMax));
    simulate->add_option("--substeps", options.substeps, "Parts of each step, exactly")
        ->check(CLI::Range(1, 1'000));
    simulate->add_option("--iterations", options.iterations, "Solver sweeps")
        ->check(CLI::Range(1, 10'000));
    simulate->add_option("--seed", options.seed, "Of everything random");
    simulate
        ->add_option("--load", options.load_file, "Goes on from a saved game, for --seconds more")
        ->excludes("--solver", "--hz", "--substeps", "--iterations", "--seed");
    simulate->add_option("--save", options.save_file, "Saves the game at the end");
    simulate->add_option("--state",
                         options.state_file,
                         "Writes the state at the end (JSON); - is the standard output");
    simulate->add_option("--trace", options.trace_file, "Writes states on the way (JSON lines)");
    simulate->add_option("--every", options.trace_every_s, "Simulated time between trace lines")
        ->check(between(0.0, kLongestRun_s));
    simulate->add_option(
        "--expect-hash", options.expect_hash, "Exit code 5 unless the end state has this hash");
    simulate
        ->add_option("--drive-fps",
                     options.drive_fps,
                     "Takes the steps as a window with this frame rate would; same result")
        ->check(between(1.0, 100'000.0));
    return simulate;
}

}  // namespace plumbline::game
