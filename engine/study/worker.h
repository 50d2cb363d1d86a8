// The worker's side of the study: which kinds of jobs there are, and answering them line by line.
#pragma once

#include "engine/study/job.h"

namespace plumbline::study {

/// Does one kind of job. Never fails: what it refuses is part of its answer.
using RunJob = std::string (*)(const std::string& body);

struct JobKind {
    std::string_view name;
    RunJob run;
};
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
