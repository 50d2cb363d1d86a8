// One hard case in a worker process: the scene, stepped as `simulate` would, and its judge.
#include "engine/study/findings/json_fields_impl.h"
#include "engine/study/gallery/gallery.h"
#include "engine/study/played_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumbline::study {

void fields(const auto& field, Like<physics::Interventions> auto& done) {
    field("braked_J", done.braked_J);
    field("braked_islands", done.braked_islands);
    field("clamped_bodies", done.clamped_bodies);
    field("unresolved_islands", done.unresolved_islands);
    field("restored_islands", done.restored_islands);
    field("limited_bodies", done.limited_bodies);
    field("impacts", done.impacts);
    field("oversized_islands", done.oversized_islands);
    field("left_out_pairs", done.left_out_pairs);
}

void fields(const auto& field, Like<RuleResult> auto& rule) {
    field("text", rule.text);
    field("allowed", rule.allowed.kind);
    field("limit", rule.allowed.limit);
    field("within", rule.allowed.within);
    field("value", rule.value);
    field("margin", rule.margin);
    field("passed", rule.passed);
    field("worst_of", rule.worst_of);
    field("worst_at_s", rule.worst_at_s);
}

void fields(const auto& field, Like<CaseResult> auto& result) {
    field("ran", result.ran);
    field("passed", result.passed);
    field("gave_up", result.gave_up);
    field("why", result.why);
    field("simulated_s", result.simulated_s);
    field("cpu_ms_per_s", result.cpu_ms_per_s);
    field("step_ms_max", result.step_ms_max);
    field("work_per_s", result.work_per_s);
    field("interventions", result.interventions);
    field("rules", result.rules);
}

void fields(const auto& field, Like<CaseRun> auto& run) {
    field("scene", run.scene);
    field("solver", run.solver);
    field("step_hz", run.step_hz);
    field("cpu_limit_s", run.cpu_limit_s);
}

namespace {

std::vector<RuleResult> results_of(const HardCaseJudge& judge) {
    std::vector<RuleResult> results;
    for (const RuleState& state : judge.rules()) {
        if (!state.seen && !judge.has_ended()) continue;  // given up before its time came
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
CaseResult run_to_the_end(PlayedScene& scene, HardCaseJudge& judge, double cpu_limit_s) {
    const scene::Simulation& simulation = scene.simulation();
    scene.start();
    CaseResult result{.ran = true};
    double cpu_ms = 0;
    double work = 0;
    while (!judge.has_ended() && cpu_ms < cpu_limit_s * 1e3) {
        scene.step();
        const physics::StepCost& cost = simulation.physics.report().cost;
        cpu_ms += cost.total_ms;
        result.step_ms_max = std::max(result.step_ms_max, cost.total_ms);
        work += static_cast<double>(cost.row_solves) + static_cast<double>(cost.contacts);
        judge.after_step(simulation);
    }
    result.simulated_s = simulation.time_s();
    result.cpu_ms_per_s = cpu_ms / result.simulated_s;
    result.work_per_s = work / result.simulated_s;
    result.passed = judge.has_ended() && judge.verdict() == Verdict::Pass;
    result.interventions = judge.interventions();
    result.rules = results_of(judge);
    if (!judge.has_ended()) {
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
    const Result<scene::OpenedScene> opened =
        open_for_study(run.scene, {.solver = run.solver, .step_hz = run.step_hz});
    if (!opened) return opened.error();
    assets::AssetLibrary library;
    Result<PlayedScene> scene = PlayedScene::create(*opened, library);
    if (!scene) return scene.error();
    Result<HardCaseJudge> judge = HardCaseJudge::create(scene->simulation());
    if (!judge) return judge.error();
    return run_to_the_end(*scene, *judge, run.cpu_limit_s);
}

std::string case_result_json(const CaseResult& result) {
    return text_of(Json(result));
}

std::string case_job_body(const CaseRun& run) {
    return text_of(Json(run));
}

Result<std::string> run_hard_case_job(const std::string& body) {
    const Result<CaseRun> run = read_text<CaseRun>(body, "expected a hard case to run");
    if (!run) return run.error();
    const Result<CaseResult> result = run_case(*run);
    if (!result) return result.error();
    return case_result_json(*result);
}

Result<CaseResult> parse_case_result(const std::string& text) {
    Result<CaseResult> result = read_text<CaseResult>(text, "not the result of a hard case");
    if (!result) return result;
    for (RuleResult& rule : result->rules) {
        if (std::isnan(rule.margin)) rule.margin = -std::numeric_limits<double>::infinity();
    }
    return result;
}

}  // namespace plumbline::study
