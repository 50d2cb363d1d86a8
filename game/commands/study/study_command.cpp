#include "game/commands/study/study_command.h"

#include "engine/assets/image/image_import.h"
#include "engine/core/io/files.h"
#include "engine/core/io/output.h"
#include "engine/core/log.h"
#include "engine/core/process/interrupt.h"
#include "engine/core/text/nearest_name.h"
#include "engine/core/text/printable.h"
#include "engine/scene/scene_file.h"
#include "engine/study/engines/engine_table.h"
#include "engine/study/fields/field_study.h"
#include "engine/study/findings/findings_json.h"
#include "engine/study/machine.h"
#include "engine/study/merged_findings.h"
#include "engine/study/progress.h"
#include "engine/study/report/page.h"
#include "engine/study/scenarios/scenario_study.h"
#include "engine/study/scenarios/scenario_text.h"
#include "engine/study/workers/shard.h"
#include "engine/study/workers/worker_pool.h"
#include "game/command_line/command_line.h"
#include "game/command_line/option_ranges.h"
#include "game/command_line/program_words.h"
#include "game/command_line/refuse.h"
#include "game/command_line/shard_option.h"
#include "game/commands/study/effects_command.h"
#include "game/commands/study/image_study_command.h"
#include "game/commands/study/scene_study_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>

namespace plumbline::game {
namespace {

namespace fs = std::filesystem;

/// What the words of the command line mean.
struct Chosen {
    std::vector<const study::Scenario*> scenarios;
    std::vector<fs::path> scenes;
};

/// "A20" and "A20 H=1" stand for the scenarios that begin so.
std::vector<const study::Scenario*> scenarios_like(std::string_view word) {
    std::vector<const study::Scenario*> like;
    for (const study::Scenario& scenario : study::scenarios()) {
        if (scenario.id.starts_with(word)) like.push_back(&scenario);
    }
    return like;
}

Error unknown_case(const std::string& word) {
    std::vector<std::string_view> known;
    for (const study::Scenario& scenario : study::scenarios()) {
        known.emplace_back(scenario.id);
        known.emplace_back(std::string_view(scenario.id).substr(0, 3));
    }
    return {
        .message = fmt::format("there is no scenario and no scene \"{}\"{}; run `plumbline study "
                               "--list` to list all scenarios",
                               word,
                               nearest_words(word, known)),
        .exit_code = ExitCode::BadUsage};
}

Result<Chosen> chosen_by(const StudyOptions& options) {
    Chosen chosen;
    if (options.cases.empty()) chosen.scenarios = scenarios_like("");
    for (const std::string& word : options.cases) {
        const std::vector<const study::Scenario*> like = scenarios_like(word);
        for (const study::Scenario* scenario : like) {
            if (std::ranges::find(chosen.scenarios, scenario) == chosen.scenarios.end())
                chosen.scenarios.push_back(scenario);
        }
        if (!like.empty()) continue;
        const Result<DataFolders> folders = find_data_folders();
        if (!folders) return folders.error();
        const Result<fs::path> scene =
            scene::find_scene(word, scene::scene_folders(folders->assets));
        const bool is_a_file = word.find_first_of("./") != std::string::npos;
        if (!scene) return is_a_file ? scene.error() : unknown_case(word);
        chosen.scenes.push_back(*scene);
    }
    return chosen;
}

constexpr const char* kJson = "findings.json";
constexpr const char* kCsv = "findings.csv";
constexpr const char* kReportPage = "report.html";

/// The folder for the files, made; empty where just lines are asked for. Looked at before hours of
/// work, which leaves an earlier study's files alone until they can be replaced.
Result<fs::path> output_folder(const StudyOptions& options) {
    fs::path folder = options.out;
    if (folder.empty() && (options.tolerance || options.budget_ms)) return folder;
    if (folder.empty()) {
        const std::string name =
            options.cases.empty() ? "scenarios" : fs::path(options.cases.front()).stem().string();
        const Result<fs::path> unnamed = default_output("studies", name, "");
        if (!unnamed) return unnamed;
        folder = *unnamed;
    }
    if (const Result<Done> made = make_output_folder(folder, {kJson, kCsv, kReportPage}); !made)
        return made.error();
    return folder;
}

Result<Done> write_files(const study::Findings& findings, const fs::path& folder) {
    const std::pair<const char*, std::string> files[] = {{kJson, study::findings_to_json(findings)},
                                                         {kCsv, study::findings_to_csv(findings)}};
    for (const auto& [name, text] : files) {
        if (Result<Done> written = write_output(folder / name, text); !written) return written;
    }
    const Result<std::string> page = study::study_page(findings);
    if (!page) return page.error();
    return write_output(folder / kReportPage, *page);
}

/// The scenarios' part of the findings, printed: how many runs the whole has.
Result<std::size_t> add_scenarios(const StudyOptions& options,
                                  const Chosen& chosen,
                                  study::Findings& findings) {
    if (chosen.scenarios.empty()) return std::size_t{0};
    using Shown = study::ProgressBar::Shown;
    const auto effort = options.quick ? study::Effort::Quick : study::Effort::Full;
    Result<study::ScenarioStudy> made = [&] {
        study::ProgressBar bar(options.quiet ? Shown::No : Shown::Yes);
        return study::study_scenarios(
            {.scenarios = chosen.scenarios,
             .effort = effort,
             .shard = findings.shard,
             .workers = options.jobs > 0 ? options.jobs : study::default_workers(),
             .progress = [&](double share, double left_s) { bar.show(share, left_s); }});
    }();
    if (!made) return made.error();
    for (study::Subject& subject : made->subjects) {
        std::cout << study::subject_text(subject) << std::flush;
        findings.subjects.push_back(std::move(subject));
    }
    findings.clock_spread = made->clock_spread;
    findings.complete = made->complete;
    return made->runs;
}

/// A scene's runs follow from each other: of a shard's runs, which come after `runs_before`, they
/// count as one.
Result<Done> add_scenes(const StudyOptions& options,
                        const Chosen& chosen,
                        const std::vector<const study::EngineRow*>& engines,
                        std::size_t runs_before,
                        study::Findings& findings) {
    for (const fs::path& scene : chosen.scenes) {
        if (!findings.complete) break;
        if (findings.shard && !findings.shard->has(runs_before++)) continue;
        Result<study::SceneStudy> made = run_scene_study(
            {.scene = scene,
             .load_file = options.load_file,
             .seconds = options.seconds,
             .engines = engines,
             .threads = options.threads,
             .wish = {.tolerance = options.tolerance, .budget_ms = options.budget_ms}});
        if (!made) return made.error();
        findings.complete = made->complete;
        findings.subjects.push_back(std::move(made->subject));
    }
    return Done{};
}

void list_scenarios() {
    for (const study::Scenario& scenario : study::scenarios())
        std::cout << fmt::format("{:<18} {}\n", scenario.id, scenario.title);
    std::cout << "Not run:\n";
    for (const study::LeftOut& each : study::left_out())
        std::cout << fmt::format("{}: {}\n", each.what, each.why);
}

/// What an option that wants scenes is given; `option` for the message.
Result<std::vector<fs::path>> scenes_for(const char* option, const StudyOptions& options) {
    const Result<DataFolders> folders = find_data_folders();
    if (!folders) return folders.error();
    if (options.cases.empty())
        return Error{.message = fmt::format("{} needs a scene", option),
                     .exit_code = ExitCode::BadUsage};
    std::vector<fs::path> scenes;
    for (const std::string& word : options.cases) {
        const Result<fs::path> scene =
            scene::find_scene(word, scene::scene_folders(folders->assets));
        if (!scene) return scene.error();
        scenes.push_back(*scene);
    }
    return scenes;
}

/// What is measured of a scene instead of its accuracy: added to the findings, and printed.
using MeasureScene = Result<Done> (*)(const StudyOptions& options,
                                      const fs::path& scene,
                                      const fs::path& folder,
                                      study::Findings& findings);

Result<Done> add_effects(const StudyOptions& options,
                         const fs::path& scene,
                         const fs::path& /*folder*/,
                         study::Findings& findings) {
    Result<study::EffectFindings> made = study_effects(scene, options.seconds);
    if (!made) return made.error();
    std::cout << study::effects_text(*made) << std::flush;
    findings.complete = !interrupted();
    findings.effects.push_back(std::move(*made));
    return Done{};
}

/// The reference comes beside the page.
Result<Done> add_image(const StudyOptions& options,
                       const fs::path& scene,
                       const fs::path& folder,
                       study::Findings& findings) {
    Result<ImageStudy> made = study_image({.scene = scene,
                                           .seconds = options.seconds,
                                           .camera = options.camera,
                                           .levels_only = options.quick});
    if (!made) return made.error();
    std::cout << study::image_text(made->findings) << std::flush;
    findings.complete = made->complete;
    findings.images.push_back(std::move(made->findings));
    return assets::write_png(folder / (scene.stem().string() + "_reference.png"),
                             study::codes_of(made->reference));
}

/// The command of the whole that a shard is of.
std::string whole_command(const StudyOptions& options) {
    std::string text = "plumbline study";
    for (const std::string& word : options.cases)
        text += word.find(' ') == std::string::npos ? " " + word : fmt::format(" \"{}\"", word);
    if (options.seconds) text += fmt::format(" --seconds {}", *options.seconds);
    return options.quick ? text + " --quick" : text;
}

study::Findings empty_findings(const StudyOptions& options) {
    study::Findings findings{.command = options.command,
                             .machine = study::machine_text(),
                             .build = fmt::format("{}, {}", version_text(), study::build_text()),
                             .made_on = study::today_text(),
                             .shard = options.shard};
    if (findings.shard) findings.shard->what = whole_command(options);
    return findings;
}

/// Writes the files, and says how it went. An empty folder: nothing is written.
ExitCode finish_study(const study::Findings& findings, const fs::path& folder) {
    if (!folder.empty()) {
        if (const Result<Done> written = write_files(findings, folder); !written)
            return refuse(written.error());
        std::cout << printable((folder / kReportPage).string()) << '\n';
    }
    if (findings.complete) return ExitCode::Good;
    log_warning("interrupted: partial results are {}",
                folder.empty() ? "shown above" : "shown above and written");
    return ExitCode::Interrupted;
}

/// The effects that bodies feel against their references, without a scene: findings.json is the list of them alone.
ExitCode study_references(const StudyOptions& options) {
    const Result<fs::path> folder = output_folder(options);
    if (!folder) return refuse(folder.error());
    study::Findings findings = empty_findings(options);
    {
        using Shown = study::ProgressBar::Shown;
        study::ProgressBar bar(options.quiet ? Shown::No : Shown::Yes);
        findings.references =
            study::measure_references([&bar](double share) { bar.show(share, 0); });
    }
    findings.complete = !interrupted();
    std::cout << study::references_text(findings.references) << std::flush;
    const Result<std::string> page = study::study_page(findings);
    if (!page) return refuse(page.error());
    const std::pair<const char*, std::string> files[] = {
        {kJson, study::references_to_json(findings.references)}, {kReportPage, *page}};
    for (const auto& [name, text] : files) {
        if (const Result<Done> written = write_output(*folder / name, text); !written)
            return refuse(written.error());
    }
    std::cout << printable((*folder / kReportPage).string()) << '\n';
    return finish_study(findings, {});
}

/// Puts the shards' findings together and writes them as one run would.
ExitCode merge_study(const StudyOptions& options) {
    const Result<std::vector<std::string>> texts = read_shards(options.merge, kJson);
    if (!texts) return refuse(texts.error());
    std::vector<study::Findings> shards;
    for (std::size_t i = 0; i < texts->size(); ++i) {
        Result<study::Findings> findings = study::findings_from_json((*texts)[i]);
        if (!findings)
            return refuse(
                {.message = fmt::format(
                     "{}: {}", (options.merge[i] / kJson).string(), findings.error().message),
                 .exit_code = ExitCode::Refused});
        shards.push_back(std::move(*findings));
    }
    const Result<study::Findings> whole = study::merged(shards);
    if (!whole) return refuse(whole.error());
    const Result<fs::path> folder = output_folder(options);
    if (!folder) return refuse(folder.error());
    for (const study::Subject& subject : whole->subjects) std::cout << study::subject_text(subject);
    return finish_study(*whole, *folder);
}

ExitCode study_each_scene(const char* option, const StudyOptions& options, MeasureScene measure) {
    const Result<std::vector<fs::path>> scenes = scenes_for(option, options);
    if (!scenes) return refuse(scenes.error());
    const Result<fs::path> folder = output_folder(options);
    if (!folder) return refuse(folder.error());
    study::Findings findings = empty_findings(options);
    for (const fs::path& scene : *scenes) {
        if (!findings.complete) break;
        if (const Result<Done> added = measure(options, scene, *folder, findings); !added)
            return refuse(added.error());
    }
    return finish_study(findings, *folder);
}

}  // namespace

ExitCode run_study(const StudyOptions& options) {
    if (options.list) {
        list_scenarios();
        return ExitCode::Good;
    }
    if (!options.merge.empty()) return merge_study(options);
    const PollsInterrupts polls;
    if (options.effects && options.cases.empty()) return study_references(options);
    if (options.effects) return study_each_scene("--effects", options, add_effects);
    if (options.image) return study_each_scene("--picture", options, add_image);
    const Result<Chosen> chosen = chosen_by(options);
    if (!chosen) return refuse(chosen.error());
    if (!options.engines.empty() && chosen->scenes.empty())
        return refuse({.message = "--engines needs a scene", .exit_code = ExitCode::BadUsage});
    if (!options.threads.empty() && chosen->scenes.empty())
        return refuse({.message = "--threads needs a scene", .exit_code = ExitCode::BadUsage});
    if (!options.load_file.empty() && (chosen->scenes.size() != 1 || !chosen->scenarios.empty()))
        return refuse({.message = "--load needs one scene: that of the saved game",
                       .exit_code = ExitCode::BadUsage});
    if (const Result<Done> there = study::check_programs(); !there) return refuse(there.error());
    const auto engines = study::installed_engines(options.engines);
    if (!engines) return refuse(engines.error());
    const Result<fs::path> folder = output_folder(options);
    if (!folder) return refuse(folder.error());
    study::Findings findings = empty_findings(options);
    const Result<std::size_t> runs = add_scenarios(options, *chosen, findings);
    if (!runs) return refuse(runs.error());
    if (const Result<Done> added = add_scenes(options, *chosen, *engines, *runs, findings); !added)
        return refuse(added.error());
    return finish_study(findings, *folder);
}

}  // namespace plumbline::game
