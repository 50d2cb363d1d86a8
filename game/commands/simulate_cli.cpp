#include "game/commands/simulate_cli.h"

#include "engine/core/limits.h"
#include "engine/core/log.h"
#include "engine/core/text/nearest_name.h"
#include "game/command_line/option_ranges.h"
#include "game/command_line/threads_option.h"

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
    throw CLI::ValidationError(fmt::format(
        "--solver: there is no \"{}\"{}; known: {}", name, nearest_words(name, known), list));
}

CLI::App* add_simulate(CLI::App& app, SimulateOptions& options) {
    CLI::App* simulate =
        app.add_subcommand("simulate", "Run a scene without a window and report its final state");
    simulate
        ->add_option(
            "scene", options.scene, "Scene or model file, or a scene name from assets/scenes")
        ->required();
    simulate->add_option("--seconds", options.seconds, "Simulated time in seconds")
        ->check(between(0.0, kLongestRun_s));
    simulate->add_option_function<std::string>(
        "--solver",
        [&options](const std::string& name) { take_solver(name, options.solver); },
        "small_step, bullet_si, bullet_nncg, bullet_dantzig or bullet_pgs");
    simulate->add_option("--hz", options.step_hz, "Step rate, Hz")
        ->check(CLI::Range(limits::kStepHzMin, limits::kStepHzMax));
    simulate->add_option("--substeps", options.substeps, "Sub-steps per step (fixed count)")
        ->check(CLI::Range(1, 1'000));
    simulate->add_option("--iterations", options.iterations, "Solver iterations")
        ->check(CLI::Range(1, 10'000));
    simulate->add_option_function<std::string>(
        "--threads",
        [&options](const std::string& text) { options.threads = threads_from(text); },
        "Threads that share a step of small_step, or auto; the result is the same");
    simulate->add_option("--seed", options.seed, "Random seed");
    simulate
        ->add_option(
            "--load", options.load_file, "Continue from a saved game, for another --seconds")
        ->excludes("--solver", "--hz", "--substeps", "--iterations", "--seed");
    simulate->add_option("--save", options.save_file, "Save the game at the end");
    simulate->add_option("--state",
                         options.state_file,
                         "Write the final state as JSON; - writes to standard output");
    simulate->add_option("--trace",
                         options.trace_file,
                         "Write intermediate states as JSON lines, or as CSV to FILE.csv");
    simulate->add_option("--trace-events",
                         options.trace_events_file,
                         "Write what each thread was busy with, for Perfetto or chrome://tracing");
    simulate->add_option("--every", options.trace_every_s, "Simulated time between trace lines")
        ->check(between(0.0, kLongestRun_s));
    simulate->add_option("--expect-hash",
                         options.expect_hash,
                         "Exit with code 5 unless the final state has this hash");
    simulate
        ->add_option("--drive-fps",
                     options.drive_fps,
                     "Group steps as a window at this frame rate would; the result is the same")
        ->check(between(1.0, 100'000.0));
    return simulate;
}

}  // namespace plumbline::game
