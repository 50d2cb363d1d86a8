// One hard case in a worker process: the scene, stepped as `simulate` would, and its judge.
#include "engine/core/io/files.h"
#include "engine/effects/advance.h"
#include "engine/scene/formats/json_read.h"
#include "engine/scene/formats/json_text.h"
#include "engine/scene/open_scene.h"
#include "engine/scene/state_report.h"
#include "engine/study/gallery/case_events.h"
#include "engine/study/gallery/gallery.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace plumbline::study {
namespace {

using scene::JsonText;

/// Numbers that are none travel as null.
double number_or_nan(const nlohmann::json& value) {
    return value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

constexpr std::array<std::string_view, 3> kAllowedNames{"below", "above", "near"};

Allowed::Kind kind_called(const std::string& name) {
    const auto found = std::ranges::find(kAllowedNames, name);
    if (found == kAllowedNames.end()) throw std::invalid_argument(name + " is no kind of limit");
    return static_cast<Allowed::Kind>(found - kAllowedNames.begin());
}

physics::Interventions interventions_from(const nlohmann::json& json) {
    return {.braked_J = json.at("braked_J"),
            .braked_islands = json.at("braked_islands"),
            .clamped_bodies = json.at("clamped_bodies"),
            .unresolved_islands = json.at("unresolved_islands"),
            .restored_islands = json.at("restored_islands"),
            .limited_bodies = json.at("limited_bodies"),
            .impacts = json.at("impacts"),
            .oversized_islands = json.at("oversized_islands"),
            .left_out_pairs = json.at("left_out_pairs")};
}

std::vector<RuleResult> results_of(const HardCaseJudge& judge) {
    std::vector<RuleResult> results;
    for (const RuleState& state : judge.rules()) {
        if (!state.seen && !judge.over()) continue;  // given up before its time came
        results.push_back({.text = state.text,
                           .allowed = state.allowed,
                           .value = state.seen ? state.value : std::nan(""),
                           .margin = state.margin(),
                           .passed = state.verdict == Verdict::Pass,
                           .worst_of = state.worst_of,
                           .worst_at_s = state.worst_at_s});
    }
    return results;
}

/// Steps until the judge has seen the case's whole time.
CaseResult run_to_the_end(scene::Simulation& simulation, HardCaseJudge& judge, double cpu_limit_s) {
    scene::NoGame game(simulation.description().camera);
    effects::EffectRuntime effects(simulation, {.frame = false, .sound = false});
    CaseResult result{.ran = true};
    double cpu_ms = 0;
    double work = 0;
    while (!judge.over() && cpu_ms < cpu_limit_s * 1e3) {
        effects::advance(simulation, effects, game, {});
        const physics::StepCost& cost = simulation.physics.cost();
        cpu_ms += cost.total_ms;
        result.step_ms_max = std::max(result.step_ms_max, cost.total_ms);
        work += static_cast<double>(cost.row_solves) + static_cast<double>(cost.contacts);
        judge.after_step(simulation);
    }
    result.simulated_s = simulation.time_s();
    result.cpu_ms_per_s = cpu_ms / result.simulated_s;
    result.work_per_s = work / result.simulated_s;
    result.passed = judge.over() && judge.verdict() == Verdict::Pass;
    result.interventions = judge.interventions();
    result.rules = results_of(judge);
    if (!judge.over()) {
        result.gave_up = judge.verdict() != Verdict::Fail;
        result.why = fmt::format("given up after {:g} s of CPU time, {:.2g} s simulated",
                                 cpu_limit_s,
                                 result.simulated_s);
    }
    return result;
}

}  // namespace

const RuleResult* CaseResult::worst() const {
    const auto least = [](const RuleResult& a, const RuleResult& b) { return a.margin < b.margin; };
    const auto found = std::ranges::min_element(rules, least);
    return found != rules.end() ? &*found : nullptr;
}

Result<CaseResult> run_case(const CaseRun& run) {
    const Result<DataFolders> folders = find_data_folders();
    if (!folders) return folders.error();
    Diagnostics faults;
    const Result<scene::OpenedScene> opened = scene::open_scene(
        run.scene,
        {.folders = *folders, .overrides = {.solver = run.solver, .step_hz = run.step_hz}},
        faults);
    if (!opened) return opened.error();
    assets::AssetLibrary library;
    const Result<std::unique_ptr<scene::Simulation>> simulation = opened->build(library);
    if (!simulation) return simulation.error();
    play_case_events(**simulation);
    Result<HardCaseJudge> judge = HardCaseJudge::create(**simulation);
    if (!judge) return judge.error();
    return run_to_the_end(**simulation, *judge, run.cpu_limit_s);
}

std::string case_result_json(const CaseResult& result) {
    JsonText json(scene::JsonLayout::OneLine);
    json.begin_object();
    json.key("ran").boolean(result.ran).key("passed").boolean(result.passed);
    json.key("gave_up").boolean(result.gave_up);
    json.key("why").text(result.why);
    json.key("simulated_s").number(result.simulated_s);
    json.key("cpu_ms_per_s").number(result.cpu_ms_per_s);
    json.key("step_ms_max").number(result.step_ms_max);
    json.key("work_per_s").number(result.work_per_s);
    json.key("interventions").raw(scene::interventions_json(result.interventions));
    json.key("rules").begin_array();
    for (const RuleResult& rule : result.rules) {
        json.begin_object().key("text").text(rule.text);
        json.key("allowed").text(kAllowedNames[static_cast<std::size_t>(rule.allowed.kind)]);
        json.key("limit").number(rule.allowed.limit).key("within").number(rule.allowed.within);
        json.key("value").number(rule.value).key("margin").number(rule.margin);
        json.key("passed").boolean(rule.passed);
        json.key("worst_of").text(rule.worst_of).key("worst_at_s").number(rule.worst_at_s);
        json.end_object();
    }
    return json.end_array().end_object().str();
}

std::string case_job_body(const CaseRun& run) {
    JsonText json(scene::JsonLayout::OneLine);
    json.begin_object().key("scene").text(run.scene.string());
    json.key("solver").text(physics::solver_name(run.solver));
    json.key("step_hz").number(run.step_hz).key("cpu_limit_s").number(run.cpu_limit_s);
    return json.end_object().str();
}

std::string run_hard_case_job(const std::string& body) {
    const auto refused = [](std::string why) { return case_result_json({.why = std::move(why)}); };
    nlohmann::json job;
    try {
        job = scene::read_json<nlohmann::json>(body);
    } catch (const std::exception&) {
        job = nullptr;
    }
    if (!job.is_object() || !job.contains("scene") || !job.contains("solver") ||
        !job.contains("step_hz") || !job.contains("cpu_limit_s"))
        return refused("expected a job with scene, solver, step_hz and cpu_limit_s");
    const auto solver = physics::solver_from_name(job["solver"].get<std::string>());
    if (!solver) return refused("unknown solver");
    const Result<CaseResult> result = run_case({.scene = job["scene"].get<std::string>(),
                                                .solver = *solver,
                                                .step_hz = job["step_hz"].get<int>(),
                                                .cpu_limit_s = job["cpu_limit_s"].get<double>()});
    return result ? case_result_json(*result) : refused(result.error().message);
}

Result<CaseResult> parse_case_result(const std::string& text) {
    try {
        const nlohmann::json json = scene::read_json<nlohmann::json>(text);
        CaseResult result{.ran = json.at("ran"),
                          .passed = json.at("passed"),
                          .gave_up = json.at("gave_up"),
                          .why = json.at("why"),
                          .simulated_s = json.at("simulated_s"),
                          .cpu_ms_per_s = json.at("cpu_ms_per_s"),
                          .step_ms_max = json.at("step_ms_max"),
                          .work_per_s = json.at("work_per_s")};
        result.interventions = interventions_from(json.at("interventions"));
        for (const nlohmann::json& rule : json.at("rules")) {
            const double margin = number_or_nan(rule.at("margin"));
            result.rules.push_back(
                {.text = rule.at("text"),
                 .allowed = {.kind = kind_called(rule.at("allowed")),
                             .limit = rule.at("limit"),
                             .within = rule.at("within")},
                 .value = number_or_nan(rule.at("value")),
                 .margin = std::isnan(margin) ? -std::numeric_limits<double>::infinity() : margin,
                 .passed = rule.at("passed"),
                 .worst_of = rule.at("worst_of"),
                 .worst_at_s = rule.at("worst_at_s")});
        }
        return result;
    } catch (const std::exception& fault) {
        return Error{.message = fmt::format("not the result of a hard case: {}", fault.what()),
                     .exit_code = ExitCode::RunFailed};
    }
}

}  // namespace plumbline::study
