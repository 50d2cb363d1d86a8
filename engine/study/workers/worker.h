// The worker's side of the study: which kinds of jobs there are, and answering them line by line.
#pragma once

#include "engine/study/workers/job.h"

#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace plumbline::study {

/// Does one kind of job. Never fails: what it refuses is part of its answer. It may keep things from
/// one job to the next: a worker has one of each kind that it was asked for.
using RunJob = std::function<std::string(const std::string& body)>;

struct JobKind {
    std::string_view name;
    RunJob (*make)();
};
/// For kinds that keep nothing.
template <std::string (*kRun)(const std::string& body)>
RunJob each_by_itself() {
    return kRun;
}
/// All that this program can do.
std::span<const JobKind> job_kinds();

/// As serve_jobs(in, out), with other kinds.
void serve_jobs(std::span<const JobKind> kinds, std::istream& in, std::ostream& out);

/// The command `study-worker`: answers what comes on standard input until it ends, or until the
/// program that started it does. Whatever else is printed goes to standard error.
void run_study_worker();

/// A job as the worker reads it, and an answer as the pool does: one line each, without its end.
std::string job_line(const Job& job);
Result<Answer> parse_answer_line(const std::string& line);

}  // namespace plumbline::study
