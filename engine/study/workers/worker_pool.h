// The parent's side of the study: workers as child processes, given jobs and waited for.
#pragma once

#include "engine/core/process/process.h"
#include "engine/study/workers/job.h"

#include <array>
#include <filesystem>
#include <functional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

namespace plumbline::study {

/// What to start for jobs of each precision, and with which words behind it.
struct WorkerPrograms {
    std::filesystem::path float32;
    std::filesystem::path float64;
    std::vector<std::string> arguments{"study-worker"};
    Priority priority{Priority::Same};

    const std::filesystem::path& of(Precision precision) const {
        return precision == Precision::Float32 ? float32 : float64;
    }
};
/// plumbline and plumbline-f64 beside the running program.
WorkerPrograms sibling_programs();
Result<ChildProcess> start_worker(const WorkerPrograms& programs, Precision precision);
/// Before hours of work: is there what runs of these precisions need? Refused (exit code 1) with one line
/// that says what makes the program that is missing.
Result<Done> check_programs(const WorkerPrograms& programs = sibling_programs(),
                            std::span<const Precision> needed = kPrecisions);

/// Who does jobs, and until when.
struct Workers {
    int count{1};  ///< at once; below 1 counts as 1
    WorkerPrograms programs{sibling_programs()};
    std::stop_token stop{};
};
/// Jobs are handed out in order; `done` is called on the calling thread as each ends. Stops early, and
/// returns false, when interrupted (core/process/interrupt.h) or told to stop: jobs that had not ended have
/// no call. Refused: a program that they need is not there.
Result<bool> run_jobs(std::span<const Job> jobs,
                      const Workers& workers,
                      const std::function<void(std::size_t job, const Answer& answer)>& done);

/// Cores that this process may use; at least 1.
int default_workers();

}  // namespace plumbline::study
