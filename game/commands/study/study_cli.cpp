// The command-line words of `study`.
#include "game/command_line/option_ranges.h"
#include "game/command_line/shard_option.h"
#include "game/command_line/threads_option.h"
#include "game/commands/study/study_command.h"

#include <CLI/CLI.hpp>

namespace plumbline::game {

namespace {

void add_scene_options(CLI::App& study, StudyOptions& options) {
    study.add_option("--seconds", options.seconds, "Scenes: simulated time in seconds")
        ->check(positive_up_to(kLongestRun_s));
    study
        .add_option("--tolerance",
                    options.tolerance,
                    "Scenes: print only the settings for this maximum relative error")
        ->check(positive_up_to(1.0));
    study
        .add_option("--budget-ms",
                    options.budget_ms,
                    "Scenes: print only the settings for this CPU budget, ms per frame")
        ->check(positive_up_to(1e6));
    study
        .add_option("--load", options.load_file, "Scenes: continue from a saved game of the scene")
        ->excludes("--effects", "--picture", "--shard", "--merge");
    study
        .add_option("--engines",
                    options.engines,
                    "Scenes: measure these engines too: jolt, rapier, physx, havok, bullet, ode, "
                    "with commas, or all")
        ->excludes("--effects", "--picture", "--merge");
    study
        .add_option_function<std::vector<std::string>>(
            "--threads",
            [&options](const std::vector<std::string>& texts) {
                for (const std::string& text : texts) options.threads.push_back(threads_from(text));
            },
            "Scenes: measure these numbers of threads too, such as 1,2,4")
        ->delimiter(',')
        ->excludes("--effects", "--picture", "--merge", "--shard");
}

}  // namespace

CLI::App* add_study(CLI::App& app, StudyOptions& options) {
    CLI::App* study =
        app.add_subcommand("study", "Measure error against CPU time for scenarios or scenes");
    study->add_option(
        "cases",
        options.cases,
        "Scenarios (A20, or A for all starting with A) or scenes; default: all scenarios");
    CLI::Option* out = study->add_option(
        "--out",
        options.out,
        "Folder for report.html, findings.json and findings.csv; default: a new one in "
        "~/.local/share/plumbline/studies");
    add_shard_options(*study, *out, options.shard, options.merge);
    study->add_flag(
        "--quick", options.quick, "Two solvers and four step rates only; of --picture the levels");
    study->add_flag("--list", options.list, "List all scenarios");
    study
        ->add_flag("--effects",
                   options.effects,
                   "Effects against their references, or what each effect of a scene costs")
        ->excludes("--shard", "--merge");
    study
        ->add_flag("--picture",
                   options.image,
                   "Measure image cost and error against a reference with exact shadows")
        ->excludes("--effects", "--shard", "--merge");
    study->add_option("--camera", options.camera, "Of --picture: x,y,z,yaw,pitch (metres, degrees)")
        ->needs("--picture");
    study->add_option("--jobs", options.jobs, "Parallel runs; default: number of cores")
        ->check(CLI::Range(1, 256));
    add_scene_options(*study, options);
    return study;
}

}  // namespace plumbline::game
