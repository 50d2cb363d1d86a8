#include "engine/study/workers/worker.h"

#include "engine/core/process/process.h"
#include "engine/scene/formats/json_read.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <iostream>
#include <vector>

namespace plumbline::study {
namespace {

constexpr std::string_view kDone = "done";
constexpr std::string_view kFailed = "failed";

std::string answer_line(std::string_view status, const std::string& body) {
    // Text that is no UTF-8 must not end the worker.
    return nlohmann::json{{"status", status}, {"body", body}}.dump(
        -1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string failed(const std::string& why) {
    return answer_line(kFailed, why);
}

/// Answers lines of jobs, and holds what their kinds keep.
class JobServer {
public:
    explicit JobServer(std::span<const JobKind> kinds) : kinds_(kinds), made_(kinds.size()) {}

    std::string answer_to(const std::string& line) {
        nlohmann::json job;
        try {
            job = scene::read_json<nlohmann::json>(line);
        } catch (const std::exception&) {
            job = nullptr;
        }
        if (!job.is_object() || !job.contains("kind") || !job["kind"].is_string() ||
            !job.contains("body") || !job["body"].is_string())
            return failed("expected a job: {\"kind\": text, \"body\": text} on one line");
        const std::string kind = job["kind"];
        const auto found = std::ranges::find(kinds_, kind, &JobKind::name);
        if (found == kinds_.end())
            return failed(fmt::format("there is no job of the kind \"{}\"", kind));
        try {
            RunJob& run = made_[static_cast<std::size_t>(found - kinds_.begin())];
            if (!run) run = found->make();
            return answer_line(kDone, run(job["body"].get<std::string>()));
        } catch (const std::exception& fault) {
            return failed(fmt::format("{}: {}", kind, fault.what()));
        }
    }

private:
    std::span<const JobKind> kinds_;
    std::vector<RunJob> made_;
};

}  // namespace

void serve_jobs(std::span<const JobKind> kinds, std::istream& in, std::ostream& out) {
    JobServer server(kinds);
    std::string line;
    while (std::getline(in, line) && out) out << server.answer_to(line) << '\n' << std::flush;
}

void run_worker(std::span<const JobKind> kinds) {
    end_with_parent();
    const AnswerPipe answers;
    JobServer server(kinds);
    std::string line;
    while (std::getline(std::cin, line)) {
        if (!answers.send_line(server.answer_to(line))) break;
    }
}

std::string job_line(const Job& job) {
    return nlohmann::json{{"kind", job.kind}, {"body", job.body}}.dump(
        -1, ' ', false, nlohmann::json::error_handler_t::replace);
}

Result<Answer> parse_answer_line(const std::string& line) {
    nlohmann::json answer;
    try {
        answer = scene::read_json<nlohmann::json>(line);
    } catch (const std::exception&) {
        answer = nullptr;
    }
    if (!answer.is_object() || !answer.contains("status") || !answer.contains("body") ||
        !answer["body"].is_string())
        return Error{.message = "a worker's answer cannot be read"};
    return Answer{.status = answer["status"] == kDone ? AnswerStatus::Done : AnswerStatus::Failed,
                  .body = answer["body"]};
}

}  // namespace plumbline::study
