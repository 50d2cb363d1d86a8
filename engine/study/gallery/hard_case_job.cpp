// One hard case in a worker process: the scene, stepped as `simulate` would, and its judge.
#include "engine/study/engines/engine_table.h"
#include "engine/study/engines/other_engine.h"
#include "engine/study/findings/findings_json_impl.h"
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
    field("engine", run.engine);
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

/// Rules that only our own physics can answer.
bool watches_forces(const HardCaseJudge& judge) {
    return std::ranges::any_of(judge.rules(), [](const RuleState& rule) {
        return rule.measure == "joint_force_N" || rule.measure == "contact_force_N";
    });
}

/// Steps until the judge has seen the case's whole time. The scene has started.
class CaseLoop {
public:
    CaseLoop(PlayedScene& scene, HardCaseJudge& judge, OtherEngine* engine, double cpu_limit_s)
        : scene_(scene), judge_(judge), engine_(engine), cpu_limit_s_(cpu_limit_s) {}

    CaseResult run() {
        const scene::Simulation& simulation = scene_.simulation();
        result_.ran = true;
        while (!judge_.has_ended() && cpu_ms_ < cpu_limit_s_ * 1e3) {
            scene_.step();
            if (engine_ == nullptr)
                count_own(simulation.physics.report().cost);
            else if (!catch_up())
                return result_;
            judge_.after_step(simulation, penetration_m_);
        }
        result_.simulated_s = simulation.time_s();
        result_.cpu_ms_per_s = cpu_ms_ / result_.simulated_s;
        result_.work_per_s = work_ / result_.simulated_s;
        result_.passed = judge_.has_ended() && judge_.verdict() == Verdict::Pass;
        result_.interventions = judge_.interventions();
        result_.rules = results_of(judge_);
        if (!judge_.has_ended()) {
            result_.gave_up = judge_.verdict() != Verdict::Fail;
            result_.why = fmt::format("given up after {:g} s of CPU time, {:.2g} s simulated",
                                      cpu_limit_s_,
                                      result_.simulated_s);
        }
        return result_;
    }

private:
    void count(double step_ms) {
        cpu_ms_ += step_ms;
        result_.step_ms_max = std::max(result_.step_ms_max, step_ms);
    }
    void count_own(const physics::StepCost& cost) {
        count(cost.total_ms);
        work_ += static_cast<double>(cost.row_solves) + static_cast<double>(cost.contacts);
    }
    /// False: the engine has failed, and so has the case.
    bool catch_up() {
        const Result<EngineMoved> moved = engine_->catch_up(cpu_limit_s_);
        if (!moved || !moved->is_finite) {
            result_.simulated_s = scene_.simulation().time_s();
            result_.why = fmt::format("{} by {:.2f} s",
                                      moved ? "a body has no finite state" : moved.error().message,
                                      result_.simulated_s);
            return false;
        }
        count(moved->cpu_ms);
        penetration_m_ = engine_->faults().penetration_m;
        return true;
    }

    PlayedScene& scene_;
    HardCaseJudge& judge_;
    OtherEngine* engine_;
    double cpu_limit_s_;
    CaseResult result_{};
    std::optional<double> penetration_m_{};  ///< that the engine's poses have
    double cpu_ms_{0};
    double work_{0};
};

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
    scene->start();
    if (!run.engine) return CaseLoop(*scene, *judge, nullptr, run.cpu_limit_s).run();
    if (watches_forces(*judge))
        return Error{.message = "its rules watch forces, which are not asked of other engines",
                     .exit_code = ExitCode::Refused};
    Result<EngineProcess> process = start_engine(*run.engine);
    if (!process) return process.error();
    const auto engine = OtherEngine::create(*run.engine, *process, *scene);
    if (!engine) return engine.error();
    return CaseLoop(*scene, *judge, engine->get(), run.cpu_limit_s).run();
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
