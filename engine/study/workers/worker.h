// The worker's side of the study: jobs are answered line by line, each by the function of its kind.
#pragma once

#include "engine/study/workers/job.h"

#include <functional>
#include <iosfwd>
#include <span>
#include <string>
#include <string_view>

namespace plumbline::study {

/// Does one kind of job; why it refuses one, or what it throws, is the message of the answer. It may keep
/// things from one job to the next: a worker has one of each kind that it was asked for.
using RunJob = std::function<Result<std::string>(const std::string& body)>;

struct JobKind {
    std::string_view name;
    RunJob (*make)();
};
/// For kinds that keep nothing.
template <Result<std::string> (*kRun)(const std::string& body)>
RunJob each_by_itself() {
    return kRun;
}
/// Answers jobs from `in` until it ends.
void serve_jobs(std::span<const JobKind> kinds, std::istream& in, std::ostream& out);

/// Answers what comes on standard input until it ends, or until the program that started this one
/// does. Whatever else is printed goes to standard error.
void run_worker(std::span<const JobKind> kinds);

/// A job as the worker reads it, and an answer as the pool does: one line each, without its end.
std::string job_line(const Job& job);
Result<Answer> parse_answer_line(const std::string& line);

}  // namespace plumbline::study
