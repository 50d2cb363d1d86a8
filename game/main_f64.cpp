// The program `plumbline-f64`: `simulate` in double precision, for references and for the question
// what the precision changes.

#include "engine/core/log.h"
#include "engine/core/process/interrupt.h"
#include "engine/study/study_worker.h"
#include "game/command_line/parse_error.h"
#include "game/command_line/program_words.h"
#include "game/commands/simulate_cli.h"
#include "game/program.h"

#include <CLI/CLI.hpp>

namespace plumbline::game {
namespace {

int run_commands(int argc, char** argv) {
    CLI::App app("Plumbline in double precision, without window or sound", "plumbline-f64");
    app.require_subcommand(1);
    app.fallthrough();
    bool verbose = false;
    bool quiet = false;
    app.add_flag("--verbose", verbose, "Verbose output");
    app.add_flag("--quiet", quiet, "Print errors only");
    SimulateOptions options;
    add_simulate(app, options);
    app.add_subcommand("study-worker", "Internal: run jobs for a study")->group("");
    add_program_words(app);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return static_cast<int>(answer_parse_error(app, error));
    }
    if (verbose) set_log_level(LogLevel::Debug);
    if (quiet) set_log_level(LogLevel::Error);
    if (app.got_subcommand("study-worker")) {
        study::run_study_worker();
        return static_cast<int>(ExitCode::Good);
    }
    catch_interrupts();
    return static_cast<int>(run_simulate(options));
}

}  // namespace
}  // namespace plumbline::game

int main(int argc, char** argv) {
    return plumbline::game::run_program(plumbline::game::run_commands, argc, argv);
}
