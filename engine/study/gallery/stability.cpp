#include "engine/study/gallery/stability.h"

#include "engine/core/text/nearest_name.h"
#include "engine/core/text/text_case.h"
#include "engine/scene/open_scene.h"
#include "engine/study/workers/worker_pool.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace plumbline::study {
namespace {

namespace fs = std::filesystem;

// CPU time that a run may take, and how much more wall time on a busy machine.
constexpr double kCiLimit_s = 10;
constexpr double kNightlyLimit_s = 600;
constexpr double kWallPerCpu = 30;

Result<CaseEntry> load_entry(const fs::path& file, const DataFolders& folders) {
    Diagnostics faults;
    Result<scene::OpenedScene> opened = scene::open_scene(file, {.folders = folders}, faults);
    if (!opened) return opened.error();
    scene::SceneDescription& scene = opened->description;
    if (!scene.hard_case) {
        return Error{.message = fmt::format("{} has no [hard_case]", file.string()),
                     .exit_code = ExitCode::Refused};
    }
    CaseEntry entry{.scene = file, .title = scene.title, .hard = std::move(*scene.hard_case)};
    if (entry.title.starts_with(entry.hard.id + " "))
        entry.title.erase(0, entry.hard.id.size() + 1);
    return entry;
}

/// "hard/h05.toml" and "h05" as "H05".
std::string plain_id(const std::string& asked) {
    std::string id = fs::path(asked).stem().string();
    if (!id.empty()) id[0] = to_upper(id[0]);
    return id;
}

/// What is wrong with one rule against what is known of it, or empty.
std::string red_fault(const RuleResult& rule, std::span<const scene::HardCaseRed> known) {
    const auto red = std::ranges::find(known, rule.text, &scene::HardCaseRed::rule);
    if (red == known.end())
        return rule.passed ? ""
                           : fmt::format("\"{}\" is broken ({:.4g}), and no known_red says why",
                                         rule.text,
                                         rule.value);
    if (rule.passed)
        return fmt::format(
            "\"{}\" holds now ({:.4g}): strike its known_red off", rule.text, rule.value);
    if (red->gone)
        return std::isnan(rule.value) ? ""
                                      : fmt::format(
                                            "\"{}\" reaches {:.4g}, and its known_red "
                                            "says that a body of it is gone",
                                            rule.text,
                                            rule.value);
    const double reached = rule.allowed.margin(red->reached);
    if (!(rule.margin >= reached))
        return fmt::format(
            "\"{}\" got worse: {:.4g}, known to reach {:.4g}", rule.text, rule.value, red->reached);
    if (reached < kRedRoom * rule.margin)
        return fmt::format("\"{}\" reaches {:.4g}: write that down instead of {:.4g}",
                           rule.text,
                           rule.value,
                           red->reached);
    return "";
}

CaseResult result_of(const Answer& answer) {
    if (answer.status == RunStatus::TimedOut) return {.gave_up = true, .why = "took too long"};
    if (answer.status == RunStatus::Crashed) return {.why = "its worker crashed: " + answer.body};
    if (answer.status != RunStatus::Done) return {.refused = true, .why = answer.body};
    if (Result<CaseResult> result = parse_case_result(answer.body)) return *result;
    return {.why = "its worker's answer cannot be read"};
}

}  // namespace

std::string_view verdict_word(const StabilityRun& run) {
    if (run.lacks()) return "-";
    return run.result->passed ? "pass" : run.result->gave_up ? "slow" : "FAIL";
}

Result<std::vector<CaseEntry>> find_cases(const DataFolders& folders) {
    const fs::path folder = folders.assets / "scenes" / "hard";
    std::vector<CaseEntry> cases;
    std::error_code failed;
    for (fs::directory_iterator at(folder, failed), end; !failed && at != end;
         at.increment(failed)) {
        if (at->path().extension() != ".toml") continue;
        Result<CaseEntry> entry = load_entry(at->path(), folders);
        if (!entry) return entry.error();
        cases.push_back(std::move(*entry));
    }
    if (cases.empty()) {
        return Error{.message = fmt::format("no hard cases in {}", folder.string()),
                     .exit_code = ExitCode::Refused};
    }
    std::ranges::sort(cases, {}, [](const CaseEntry& entry) { return entry.hard.id; });
    return cases;
}

Result<std::vector<CaseEntry>> select_cases(const std::vector<CaseEntry>& all,
                                            const std::vector<std::string>& ids,
                                            bool with_nightly) {
    std::vector<CaseEntry> chosen;
    for (const std::string& asked : ids) {
        const std::string id = plain_id(asked);
        const auto found = std::ranges::find(all, id, [](const CaseEntry& e) { return e.hard.id; });
        if (found == all.end()) {
            std::vector<std::string_view> known;
            for (const CaseEntry& entry : all) known.push_back(entry.hard.id);
            const std::string_view nearest = nearest_name(id, known);
            return Error{.message = fmt::format(
                             "there is no hard case \"{}\"; {}",
                             asked,
                             nearest.empty() ? fmt::format("known: {}", fmt::join(known, ", "))
                                             : fmt::format("did you mean {}?", nearest)),
                         .exit_code = ExitCode::BadUsage};
        }
        chosen.push_back(*found);
    }
    if (!ids.empty()) return chosen;
    std::ranges::copy_if(all, std::back_inserter(chosen), [&](const CaseEntry& entry) {
        return with_nightly || !entry.hard.nightly;
    });
    return chosen;
}

const StabilityRun* StabilityTable::find(std::size_t entry,
                                         physics::Solver solver,
                                         int step_hz) const {
    const auto found = std::ranges::find_if(runs, [&](const StabilityRun& run) {
        return run.entry == entry && run.solver == solver && run.step_hz == step_hz &&
               run.engine == nullptr;
    });
    return found != runs.end() ? &*found : nullptr;
}

std::vector<std::string> StabilityTable::known_red_faults() const {
    std::vector<std::string> faults;
    for (const StabilityRun& run : runs) {
        const bool counts = run.engine == nullptr && run.solver == physics::Solver::SmallStep &&
                            run.step_hz == kGameRate_hz && run.result && !run.result->gave_up;
        if (!counts) continue;
        const scene::HardCase& hard = cases[run.entry].hard;
        if (!run.result->ran) faults.push_back(fmt::format("{}: {}", hard.id, run.result->why));
        for (const RuleResult& rule : run.result->rules) {
            const std::string fault = red_fault(rule, hard.known_red);
            if (!fault.empty()) faults.push_back(fmt::format("{}: {}", hard.id, fault));
        }
    }
    return faults;
}

StabilityTable plan_table(std::vector<CaseEntry> cases,
                          const std::vector<physics::Solver>& solvers,
                          const std::vector<int>& rates_hz,
                          const std::vector<const EngineRow*>& engines) {
    StabilityTable table;
    for (std::size_t entry = 0; entry < cases.size(); ++entry) {
        for (const physics::Solver solver : solvers) {
            for (const int rate_hz : rates_hz)
                table.runs.push_back({.entry = entry, .solver = solver, .step_hz = rate_hz});
        }
        for (const EngineRow* engine : engines)
            table.runs.push_back({.entry = entry, .step_hz = kGameRate_hz, .engine = engine});
    }
    table.cases = std::move(cases);
    table.images.resize(table.cases.size());
    return table;
}

Result<bool> run_table(StabilityTable& table,
                       int workers,
                       const std::function<void(const StabilityRun&, std::size_t)>& ended) {
    std::vector<Job> jobs;
    std::vector<std::size_t> run_of_job;
    for (std::size_t i = 0; i < table.runs.size(); ++i) {
        const StabilityRun& run = table.runs[i];
        if (run.result || (table.shard && !table.shard->has(i))) continue;
        const CaseEntry& entry = table.cases[run.entry];
        const double more_steps = std::max(1.0, static_cast<double>(run.step_hz) / kGameRate_hz);
        const double cpu_limit_s = more_steps * (entry.hard.nightly ? kNightlyLimit_s : kCiLimit_s);
        CaseRun job{.scene = entry.scene,
                    .solver = run.solver,
                    .step_hz = run.step_hz,
                    .cpu_limit_s = cpu_limit_s};
        if (run.engine != nullptr) job.engine = run.engine->ladder.front();
        jobs.push_back({.kind = "hard_case",
                        .body = case_job_body(job),
                        .limit_s = kWallPerCpu * cpu_limit_s});
        run_of_job.push_back(i);
    }
    std::size_t done = 0;
    const Result<bool> finished =
        run_jobs(jobs, {.count = workers}, [&](std::size_t job, const Answer& answer) {
            StabilityRun& run = table.runs[run_of_job[job]];
            run.result = result_of(answer);
            ended(run, ++done);
        });
    if (finished) table.complete = *finished;
    return finished;
}

std::string run_line(const StabilityTable& table, const StabilityRun& run) {
    const std::string head = fmt::format(
        "{:<5} {:<15}{:>4} Hz", table.cases[run.entry].hard.id, run.stepped_by(), run.step_hz);
    if (!run.result) return head + "  not run";
    if (!run.result->ran)
        return fmt::format("{}  {}  {}", head, verdict_word(run), run.result->why);
    const RuleResult* worst = run.result->worst();
    return fmt::format("{}  {}  {:>16}  {:>9.2f} ms/s  {}",
                       head,
                       verdict_word(run),
                       worst != nullptr ? margin_text(worst->margin) : "",
                       run.result->cpu_ms_per_s,
                       !run.result->why.empty() ? run.result->why
                       : worst != nullptr ? fmt::format("{}: {:.3g}", worst->text, worst->value)
                                          : "");
}

std::string stability_text(const StabilityTable& table) {
    std::string text;
    for (const StabilityRun& run : table.runs) text += run_line(table, run) + "\n";
    text += "\n";
    struct Sum {
        int green{0};
        int slow{0};
        int ran{0};
    };
    // In the order of the runs.
    std::vector<std::pair<std::string, Sum>> sums;
    for (const StabilityRun& run : table.runs) {
        const std::string name = fmt::format("{:<15}{:>4} Hz", run.stepped_by(), run.step_hz);
        auto sum = std::ranges::find(sums, name, &std::pair<std::string, Sum>::first);
        if (sum == sums.end()) sum = sums.insert(sums.end(), {name, {}});
        if (!run.result || run.lacks()) continue;
        ++sum->second.ran;
        sum->second.green += run.green() ? 1 : 0;
        sum->second.slow += run.result->gave_up ? 1 : 0;
    }
    for (const auto& [name, sum] : sums)
        text += fmt::format("{}  {} of {} pass{}\n",
                            name,
                            sum.green,
                            sum.ran,
                            sum.slow > 0 ? fmt::format(", {} given up", sum.slow) : "");
    return text;
}

}  // namespace plumbline::study
