// SceneRun and SceneAnswer as the lines that worker and study exchange.
#include "engine/scene/formats/json_read.h"
#include "engine/study/findings/findings_json_impl.h"
#include "engine/study/scenes/scene_run.h"

#include <fmt/format.h>

namespace plumbline::study {
namespace {

Json vector_to_json(const Vec3d& v) {
    return {v.x, v.y, v.z};
}

Vec3d vector_from_json(const Json& value) {
    return {number_from(value.at(0)), number_from(value.at(1)), number_from(value.at(2))};
}

Json moment_to_json(const Moment& moment) {
    Json bodies = Json::array();
    for (const BodyPose& body : moment.bodies) {
        const Vec3d& p = body.position_m;
        const Quatd& q = body.orientation;
        bodies.push_back({p.x, p.y, p.z, q.w, q.x, q.y, q.z, body.there ? 1 : 0});
    }
    return {{"time_s", moment.time_s},
            {"bodies", std::move(bodies)},
            {"center_m", vector_to_json(moment.layout.center_m)},
            {"top_m", json_of(moment.layout.top_m)},
            {"spread_m", json_of(moment.layout.spread_m)},
            {"reach_m", json_of(moment.layout.reach_m)},
            {"energy_J", json_of(moment.energy_J)}};
}

Moment moment_from_json(const Json& value) {
    Moment moment{.time_s = value.at("time_s"),
                  .layout = {.center_m = vector_from_json(value.at("center_m")),
                             .top_m = number_from(value.at("top_m")),
                             .spread_m = number_from(value.at("spread_m")),
                             .reach_m = number_from(value.at("reach_m"))},
                  .energy_J = number_from(value.at("energy_J"))};
    for (const Json& body : value.at("bodies")) {
        moment.bodies.push_back({.position_m = vector_from_json(body),
                                 .orientation = Quatd(number_from(body.at(3)),
                                                      number_from(body.at(4)),
                                                      number_from(body.at(5)),
                                                      number_from(body.at(6))),
                                 .there = body.at(7).get<int>() != 0});
    }
    return moment;
}

Json trace_to_json(const Trace& trace) {
    Json moments = Json::array();
    for (const Moment& moment : trace.moments) moments.push_back(moment_to_json(moment));
    return {{"status", static_cast<int>(trace.status)},
            {"why", trace.why},
            {"end_s", trace.end_s},
            {"moments", std::move(moments)},
            {"energy_turnover_J", json_of(trace.energy_turnover_J)},
            {"penetration_m", json_of(trace.penetration_m)},
            {"joint_error_m", json_of(trace.joint_error_m)}};
}

RunStatus status_from(const Json& value) {
    const int number = value;
    if (number < 0 || number > static_cast<int>(RunStatus::Refused))
        throw std::runtime_error(fmt::format("unknown status {}", number));
    return static_cast<RunStatus>(number);
}

Trace trace_from_json(const Json& value) {
    Trace trace{.status = status_from(value.at("status")),
                .why = value.at("why"),
                .end_s = value.at("end_s"),
                .energy_turnover_J = number_from(value.at("energy_turnover_J")),
                .penetration_m = number_from(value.at("penetration_m")),
                .joint_error_m = number_from(value.at("joint_error_m"))};
    for (const Json& moment : value.at("moments"))
        trace.moments.push_back(moment_from_json(moment));
    return trace;
}

std::string refusal_text(const std::string& why) {
    return Json{{"refused", why}}.dump(-1, ' ', false, Json::error_handler_t::replace);
}

SceneRun run_from_json(const Json& job) {
    return {.scene = job.at("scene").get<std::string>(),
            .setting = setting_from(job.at("setting")),
            .moments = job.at("moments").get<std::vector<int>>(),
            .copies = job.at("copies"),
            .seed = job.at("seed"),
            .shift_m = job.at("shift_m"),
            .repeats = job.at("repeats"),
            .repeat_s = job.at("repeat_s"),
            .cpu_limit_s = job.at("cpu_limit_s")};
}

std::string answer_scene_job(SceneRunner& runner, const std::string& body) {
    SceneRun run;
    try {
        run = run_from_json(scene::read_json<Json>(body));
    } catch (const std::exception& fault) {
        return refusal_text(fmt::format("expected a run of a scene: {}", fault.what()));
    }
    if (run.moments.empty() || run.copies < 1 || run.setting.step_hz < 1)
        return refusal_text("expected a run of a scene with moments, copies and a step rate");
    const Result<SceneAnswer> answer = runner.run(run);
    if (!answer) return refusal_text(answer.error().message);
    Point measured;
    measured.setting = run.setting;
    measured.cost = answer->cost;
    Json traces = Json::array();
    for (const Trace& trace : answer->traces) traces.push_back(trace_to_json(trace));
    return Json{{"refused", ""},
                {"bodies", answer->bodies},
                {"joints", answer->joints},
                {"mass_kg", answer->mass_kg},
                {"gravity_mps2", answer->gravity_mps2},
                {"body_size_m", answer->body_size_m},
                {"cpu_s", answer->cpu_s},
                {"wall_s", answer->wall_s},
                {"traces", std::move(traces)},
                {"measured", json_of(measured)}}
        .dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

std::string scene_job_body(const SceneRun& run) {
    return Json{{"scene", run.scene.string()},
                {"setting", json_of(run.setting)},
                {"moments", run.moments},
                {"copies", run.copies},
                {"seed", run.seed},
                {"shift_m", run.shift_m},
                {"repeats", run.repeats},
                {"repeat_s", run.repeat_s},
                {"cpu_limit_s", run.cpu_limit_s}}
        .dump(-1, ' ', false, Json::error_handler_t::replace);
}

RunJob scene_jobs() {
    // A std::function is copied; what it keeps is shared by its copies.
    return [runner = std::make_shared<SceneRunner>()](const std::string& body) {
        return answer_scene_job(*runner, body);
    };
}

Result<SceneAnswer> parse_scene_answer(const std::string& body) {
    try {
        const Json value = scene::read_json<Json>(body);
        SceneAnswer answer{.refused = value.at("refused")};
        if (!answer.refused.empty()) return answer;
        answer.bodies = value.at("bodies");
        answer.joints = value.at("joints");
        answer.mass_kg = value.at("mass_kg");
        answer.gravity_mps2 = value.at("gravity_mps2");
        answer.body_size_m = value.at("body_size_m");
        answer.cpu_s = value.at("cpu_s");
        answer.wall_s = value.at("wall_s");
        answer.cost = point_from(value.at("measured")).cost;
        for (const Json& trace : value.at("traces"))
            answer.traces.push_back(trace_from_json(trace));
        return answer;
    } catch (const std::exception& fault) {
        return Error{.message = fmt::format("a worker's answer cannot be read: {}", fault.what())};
    }
}

}  // namespace plumbline::study
