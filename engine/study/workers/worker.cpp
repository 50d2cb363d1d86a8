#include "engine/study/workers/worker.h"

#include "engine/core/process/process.h"
#include "engine/study/findings/json_fields_impl.h"

#include <algorithm>
#include <iostream>
#include <vector>

namespace plumbline::study {

void fields(const auto& field, Like<Job> auto& job) {
    field("kind", job.kind);
    field("body", job.body);
}

void fields(const auto& field, Like<Answer> auto& answer) {
    field("status", answer.status);
    field("body", answer.body);
}

namespace {

/// Answers lines of jobs, and holds what their kinds keep.
class JobServer {
public:
    explicit JobServer(std::span<const JobKind> kinds) : kinds_(kinds), made_(kinds.size()) {}

    std::string line_for(const std::string& line) { return text_of(Json(answer_to(line))); }

private:
    Answer answer_to(const std::string& line) {
        const Result<Job> job = read_text<Job>(line, "no job");
        if (!job) return refused("expected a job: {\"kind\": text, \"body\": text} on one line");
        const auto found = std::ranges::find(kinds_, job->kind, &JobKind::name);
        if (found == kinds_.end())
            return refused(fmt::format("there is no job of the kind \"{}\"", job->kind));
        try {
            RunJob& run = made_[static_cast<std::size_t>(found - kinds_.begin())];
            if (!run) run = found->make();
            Result<std::string> body = run(job->body);
            if (!body) return refused(body.error().message);
            return {.body = std::move(*body)};
        } catch (const std::exception& fault) {
            return refused(fmt::format("{}: {}", job->kind, fault.what()));
        }
    }
    static Answer refused(std::string why) {
        return {.status = RunStatus::Refused, .body = std::move(why)};
    }

    std::span<const JobKind> kinds_;
    std::vector<RunJob> made_;
};

}  // namespace

void serve_jobs(std::span<const JobKind> kinds, std::istream& in, std::ostream& out) {
    JobServer server(kinds);
    std::string line;
    while (std::getline(in, line) && out) out << server.line_for(line) << '\n' << std::flush;
}

void run_worker(std::span<const JobKind> kinds) {
    end_with_parent();
    const AnswerPipe answers;
    JobServer server(kinds);
    std::string line;
    while (std::getline(std::cin, line)) {
        if (!answers.send_line(server.line_for(line))) break;
    }
}

std::string job_line(const Job& job) {
    return text_of(Json(job));
}

Result<Answer> parse_answer_line(const std::string& line) {
    Result<Answer> answer = read_text<Answer>(line, "no answer");
    if (!answer) return Error{.message = "a worker's answer cannot be read"};
    return answer;
}

}  // namespace plumbline::study
