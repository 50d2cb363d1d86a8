#include "engine/study/engines/engine_process.h"

#include "engine/core/time/stopwatch.h"
#include "engine/study/findings/json_fields_impl.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumbline::study {
namespace {

constexpr double kStart_s = 60;
constexpr std::size_t kLongestLine = 64UL << 20U;

Error refused(std::string why) {
    return {.message = std::move(why), .exit_code = ExitCode::Refused};
}

/// The answer, or what it complains of.
Result<Json> answer_from(const std::string& line) {
    try {
        Json json = Json::parse(line);
        if (json.contains("lacks"))
            return refused(fmt::format("it lacks {}", json.at("lacks").get<std::string>()));
        if (json.contains("failed")) return refused(json.at("failed").get<std::string>());
        return json;
    } catch (const std::exception& error) {
        return refused(fmt::format("its answer cannot be read: {}", error.what()));
    }
}

Json json_of(const EngineSteps& steps) {
    Json json{{"steps", steps.steps}};
    for (const auto& [body, numbers] : steps.set) {
        Json& line = json["set"].emplace_back(Json::array({body}));
        for (const double number : numbers) line.push_back(number);
    }
    if (!steps.gravity_mps2.empty()) json["gravity_mps2"] = steps.gravity_mps2;
    return json;
}

}  // namespace

Result<EngineProcess> EngineProcess::start(const ChildDef& program) {
    Result<ChildProcess> child = ChildProcess::start(program);
    if (!child) return refused(child.error().message);
    EngineProcess process(std::move(*child));
    const Result<std::string> line = process.read_line(kStart_s);
    if (!line) return line.error();
    const Result<Json> head = answer_from(*line);
    if (!head) return head.error();
    if (!head->contains("version") || !head->at("version").is_string())
        return refused("it does not say its version");
    process.version_ = head->at("version");
    return process;
}

Result<Done> EngineProcess::make(const std::string& scene) {
    const Result<std::string> line = ask(scene, kStart_s);
    if (!line) return line.error();
    const Result<Json> answer = answer_from(*line);
    if (!answer) return answer.error();
    return Done{};
}

Result<EngineMoved> EngineProcess::advance(const EngineSteps& steps, double limit_s) {
    const Result<std::string> line = ask(text_of(json_of(steps)), limit_s);
    if (!line) return line.error();
    const Result<Json> answer = answer_from(*line);
    if (!answer) return answer.error();
    EngineMoved moved;
    try {
        answer->at("cpu_ms").get_to(moved.cpu_ms);
        answer->at("step_ms").get_to(moved.step_ms);
        for (const Json& number : answer->at("states")) moved.states.push_back(number_from(number));
        moved.is_finite =
            std::ranges::all_of(moved.states, [](double each) { return std::isfinite(each); });
    } catch (const std::exception& error) {
        return refused(fmt::format("its answer cannot be read: {}", error.what()));
    }
    return moved;
}

Result<std::string> EngineProcess::ask(std::string line, double limit_s) {
    if (!child_.send_line(std::move(line))) {
        const ChildEnd end = child_.end(1);
        return refused(fmt::format("it {}", end.words));
    }
    return read_line(limit_s);
}

Result<std::string> EngineProcess::read_line(double limit_s) {
    const double start_s = wall_s();
    while (true) {
        const std::size_t end = rest_.find('\n');
        if (end != std::string::npos) {
            std::string line = rest_.substr(0, end);
            rest_.erase(0, end + 1);
            return line;
        }
        if (rest_.size() > kLongestLine) return refused("it answers with a line without end");
        const double left_s = limit_s - (wall_s() - start_s);
        if (left_s <= 0) return refused(fmt::format("it took longer than {:.3g} s", limit_s));
        const ChildProcess* child = &child_;
        if (!wait_for_output({&child, 1}, std::min(left_s, 1.0)).front()) continue;
        if (!child_.receive(rest_)) return refused(fmt::format("it {}", child_.end(1).words));
    }
}

}  // namespace plumbline::study
