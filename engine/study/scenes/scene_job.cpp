// SceneRun and SceneAnswer as the lines that worker and study exchange.
#include "engine/study/findings/findings_json_impl.h"
#include "engine/study/scenes/scene_run.h"

namespace plumbline::study {

void fields(const auto& field, Like<SceneRun> auto& run) {
    field("scene", run.scene);
    field("start", run.start);
    field("setting", run.setting);
    field("engine", run.engine);
    field("threads", run.threads);
    field("moments", run.moments);
    field("copies", run.copies);
    field("seed", run.seed);
    field("shift_m", run.shift_m);
    field("repeats", run.repeats);
    field("repeat_s", run.repeat_s);
    field("cpu_limit_s", run.cpu_limit_s);
}

void fields(const auto& field, Like<BodyPose> auto& pose) {
    field("at", pose.position_m);
    field("turn", pose.orientation);
    field("there", pose.there);
}

void fields(const auto& field, Like<Layout> auto& layout) {
    field("center_m", layout.center_m);
    field("top_m", layout.top_m);
    field("spread_m", layout.spread_m);
    field("reach_m", layout.reach_m);
}

void fields(const auto& field, Like<Moment> auto& moment) {
    field("time_s", moment.time_s);
    field("bodies", moment.bodies);
    field("layout", moment.layout);
    field("energy_J", moment.energy_J);
}

void fields(const auto& field, Like<Trace> auto& trace) {
    field("status", trace.status);
    field("why", trace.why);
    field("end_s", trace.end_s);
    field("moments", trace.moments);
    field("energy_turnover_J", trace.energy_turnover_J);
    field("penetration_m", trace.penetration_m);
    field("joint_error_m", trace.joint_error_m);
}

void fields(const auto& field, Like<SceneAnswer> auto& answer) {
    field("bodies", answer.bodies);
    field("joints", answer.joints);
    field("mass_kg", answer.mass_kg);
    field("gravity_mps2", answer.gravity_mps2);
    field("body_size_m", answer.body_size_m);
    field("effects", answer.effects);
    field("cpu_s", answer.cpu_s);
    field("wall_s", answer.wall_s);
    field("traces", answer.traces);
    field("engine_version", answer.engine_version);
    field("cost", answer.cost);
}

std::string scene_job_body(const SceneRun& run) {
    return text_of(Json(run));
}

RunJob scene_jobs() {
    // A std::function is copied; what it keeps is shared by its copies.
    return
        [runner = std::make_shared<SceneRunner>()](const std::string& body) -> Result<std::string> {
            const Result<SceneRun> run = read_text<SceneRun>(body, "expected a run of a scene");
            if (!run) return run.error();
            if (run->moments.empty() || run->copies < 1 || run->setting.step_hz < 1)
                return Error{.message =
                                 "expected a run of a scene with moments, copies and a step rate"};
            const Result<SceneAnswer> answer = runner->run(*run);
            if (!answer) return answer.error();
            return text_of(Json(*answer));
        };
}

Result<SceneAnswer> parse_scene_answer(const std::string& body) {
    return read_text<SceneAnswer>(body, "a worker's answer cannot be read");
}

}  // namespace plumbline::study
