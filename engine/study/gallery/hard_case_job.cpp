// One hard case in a worker process: the scene, stepped as `simulate` would, and its judge.
#include "engine/scene/formats/json_read.h"
#include "engine/study/findings/findings_json_impl.h"
#include "engine/study/gallery/gallery.h"
#include "engine/study/played_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace plumbline::study {
namespace {

constexpr std::array<std::string_view, 3> kAllowedNames{"below", "above", "near"};

Allowed::Kind kind_called(const std::string& name) {
    const auto found = std::ranges::find(kAllowedNames, name);
    if (found == kAllowedNames.end()) throw std::invalid_argument(name + " is no kind of limit");
    return static_cast<Allowed::Kind>(found - kAllowedNames.begin());
}

Json json_of(const physics::Interventions& done) {
    return {{"braked_J", done.braked_J},
            {"braked_islands", done.braked_islands},
            {"clamped_bodies", done.clamped_bodies},
            {"unresolved_islands", done.unresolved_islands},
            {"restored_islands", done.restored_islands},
            {"limited_bodies", done.limited_bodies},
            {"impacts", done.impacts},
            {"oversized_islands", done.oversized_islands},
            {"left_out_pairs", done.left_out_pairs}};
}

physics::Interventions interventions_from(const Json& json) {
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
    Json rules = Json::array();
    for (const RuleResult& rule : result.rules)
        rules.push_back({{"text", rule.text},
                         {"allowed", kAllowedNames[static_cast<std::size_t>(rule.allowed.kind)]},
                         {"limit", rule.allowed.limit},
                         {"within", rule.allowed.within},
                         {"value", study::json_of(rule.value)},
                         {"margin", study::json_of(rule.margin)},
                         {"passed", rule.passed},
                         {"worst_of", rule.worst_of},
                         {"worst_at_s", rule.worst_at_s}});
    return Json{{"ran", result.ran},
                {"passed", result.passed},
                {"gave_up", result.gave_up},
                {"why", result.why},
                {"simulated_s", result.simulated_s},
                {"cpu_ms_per_s", study::json_of(result.cpu_ms_per_s)},
                {"step_ms_max", result.step_ms_max},
                {"work_per_s", study::json_of(result.work_per_s)},
                {"interventions", json_of(result.interventions)},
                {"rules", std::move(rules)}}
        .dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string case_job_body(const CaseRun& run) {
    return Json{{"scene", run.scene.string()},
                {"solver", physics::solver_name(run.solver)},
                {"step_hz", run.step_hz},
                {"cpu_limit_s", run.cpu_limit_s}}
        .dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string run_hard_case_job(const std::string& body) {
    const auto refused = [](std::string why) { return case_result_json({.why = std::move(why)}); };
    Json job;
    try {
        job = scene::read_json<Json>(body);
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
        const Json json = scene::read_json<Json>(text);
        CaseResult result{.ran = json.at("ran"),
                          .passed = json.at("passed"),
                          .gave_up = json.at("gave_up"),
                          .why = json.at("why"),
                          .simulated_s = json.at("simulated_s"),
                          .cpu_ms_per_s = number_from(json.at("cpu_ms_per_s")),
                          .step_ms_max = json.at("step_ms_max"),
                          .work_per_s = number_from(json.at("work_per_s"))};
        result.interventions = interventions_from(json.at("interventions"));
        for (const Json& rule : json.at("rules")) {
            const double margin = number_from(rule.at("margin"));
            result.rules.push_back(
                {.text = rule.at("text"),
                 .allowed = {.kind = kind_called(rule.at("allowed")),
                             .limit = rule.at("limit"),
                             .within = rule.at("within")},
                 .value = number_from(rule.at("value")),
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
