#include "game/commands/stability_command.h"

#include "engine/core/io/files.h"
#include "engine/core/io/output.h"
#include "engine/core/log.h"
#include "engine/core/process/interrupt.h"
#include "engine/core/text/printable.h"
#include "engine/study/gallery/stability.h"
#include "engine/study/machine.h"
#include "engine/study/workers/worker_pool.h"
#include "game/command_line/program_words.h"
#include "game/command_line/refuse.h"
#include "game/command_line/shard_option.h"
#include "game/commands/simulate_cli.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <array>
#include <iostream>

namespace plumbline::game {
namespace {

namespace fs = std::filesystem;
using physics::Solver;

constexpr int kImageWidth_px = 240;
constexpr int kImageHeight_px = 150;

std::vector<Solver> solvers_of(const StabilityOptions& options) {
    if (options.solver) return {*options.solver};
    return {physics::kSolvers.begin(), physics::kSolvers.end()};
}

/// The command of the whole that a shard is of.
std::string whole_command(const StabilityOptions& options) {
    std::string text = "plumbline stability";
    for (const std::string& id : options.cases) text += " " + id;
    text += " --tier " + options.tier;
    if (options.solver) text += fmt::format(" --solver {}", physics::solver_name(*options.solver));
    return options.rates ? text + " --rates" : text;
}

constexpr const char* kTable = "stability.json";
constexpr const char* kStabilityPage = "stability.html";

/// What the shards have run, as one table.
Result<study::StabilityTable> merged_of(const StabilityOptions& options,
                                        const std::vector<study::CaseEntry>& all) {
    const Result<std::vector<std::string>> shards = read_shards(options.merge, kTable);
    if (!shards) return shards.error();
    return study::merged_tables(*shards, all);
}

Result<study::StabilityTable> planned(const StabilityOptions& options) {
    const Result<DataFolders> folders = find_data_folders();
    if (!folders) return folders.error();
    const Result<std::vector<study::CaseEntry>> all = study::find_cases(*folders);
    if (!all) return all.error();
    if (!options.merge.empty()) return merged_of(options, *all);
    Result<std::vector<study::CaseEntry>> chosen =
        study::select_cases(*all, options.cases, options.tier == "all");
    if (!chosen) return chosen.error();
    const auto engines = study::installed_engines(options.engines);
    if (!engines) return engines.error();
    study::StabilityTable table =
        study::plan_table(std::move(*chosen),
                          solvers_of(options),
                          options.rates ? std::vector<int>{30, 60, 240} : std::vector<int>{60},
                          *engines);
    table.command = options.command;
    table.machine = study::machine_text();
    table.build = version_text() + ", " + study::build_text();
    table.made_on = study::today_text();
    if (options.shard) {
        table.shard = options.shard;
        table.shard->what = whole_command(options);
    }
    return table;
}

Result<Done> write_files(const study::StabilityTable& table, const fs::path& folder) {
    const Result<Done> json = write_output(folder / kTable, study::stability_json(table));
    if (!json) return json;
    const Result<std::string> page = study::stability_page(table);
    if (!page) return page.error();
    return write_output(folder / kStabilityPage, *page);
}

/// What is asked of the outcome, once it is told and written.
ExitCode judged(const study::StabilityTable& table, bool expect_green) {
    if (!table.complete) return ExitCode::Interrupted;
    const std::vector<std::string> faults = table.known_red_faults();
    for (const std::string& fault : faults) {
        if (expect_green)
            log_error("{}", fault);
        else
            log_note("{}", fault);
    }
    return expect_green && !faults.empty() ? ExitCode::Differs : ExitCode::Good;
}

}  // namespace

CLI::App* add_stability(CLI::App& app, StabilityOptions& options) {
    CLI::App* stability = app.add_subcommand(
        "stability", "Run the hard cases with every solver and report which pass");
    stability->add_option("cases", options.cases, "Case ids such as H05; default: all of the tier");
    stability->add_option_function<std::string>(
        "--solver",
        [&options](const std::string& name) { take_solver(name, options.solver); },
        "Solver; default: all");
    stability->add_option("--tier", options.tier, "ci, or all to include the long cases")
        ->check(CLI::IsMember({"ci", "all"}));
    CLI::Option* out =
        stability->add_option("--out", options.out, "Folder for stability.json and stability.html");
    add_shard_options(*stability, *out, options.shard, options.merge);
    stability
        ->add_option(
            "--engines",
            options.engines,
            "Run these engines too: jolt, rapier, physx, havok, bullet, ode, with commas, or all")
        ->excludes("--shard", "--merge");
    stability->add_option("--jobs", options.jobs, "Parallel runs; default: number of cores")
        ->check(CLI::Range(1, 256));
    stability->add_flag("--rates", options.rates, "Also run at 30 and 240 Hz");
    stability->add_flag(
        "!--no-pictures", options.images, "Do not render images of the final states");
    stability->add_flag("--expect-green",
                        options.expect_green,
                        "Exit with code 5 if small_step fails a rule not listed in known_red, or "
                        "passes one that is");
    return stability;
}

ExitCode run_stability(const StabilityOptions& options) {
    Result<study::StabilityTable> table = planned(options);
    if (!table) return refuse(table.error());
    if (!options.out.empty()) {
        const Result<Done> open = make_output_folder(options.out, {kTable, kStabilityPage});
        if (!open) return refuse(open.error());
    }
    const PollsInterrupts polls;
    const int workers = options.jobs > 0 ? options.jobs : study::default_workers();
    const std::size_t all = table->runs.size();
    const Result<bool> finished =
        study::run_table(*table, workers, [&](const study::StabilityRun& run, std::size_t done) {
            log_note("{} of {}: {}", done, all, study::run_line(*table, run));
        });
    if (!finished) return refuse(finished.error());
    std::cout << study::stability_text(*table);
    if (!options.out.empty()) {
        if (options.images && table->complete && !table->shard) {
            study::take_images(*table, workers, kImageWidth_px, kImageHeight_px);
            if (!table->no_images.empty()) log_note("{}", table->no_images);
        }
        if (const Result<Done> written = write_files(*table, options.out); !written)
            return refuse(written.error());
        std::cout << printable((options.out / kStabilityPage).string()) << '\n';
    }
    return judged(*table, options.expect_green);
}

}  // namespace plumbline::game
