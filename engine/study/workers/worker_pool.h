// The parent's side of the study: workers as child processes, given jobs and waited for.
#pragma once

#include "engine/core/process/process.h"
#include "engine/study/workers/job.h"

#include <array>
#include <filesystem>

namespace plumbline::study {

/// What to start for jobs of each precision, and with which words behind it.
struct WorkerPrograms {
    std::filesystem::path float32;
    std::filesystem::path float64;
    std::vector<std::string> arguments{"study-worker"};
};
/// plumbline and plumbline-f64 beside the running program.
WorkerPrograms sibling_programs();
Result<ChildProcess> start_worker(const WorkerPrograms& programs, Precision precision);
/// Refused (exit code 1): one of the programs that runs of these precisions need is not there. The
/// message says what makes it.
Result<Done> check_programs(const WorkerPrograms& programs, std::span<const Precision> needed);

/// As run_jobs, with other programs.
Result<bool> run_jobs(const WorkerPrograms& programs,
                      std::span<const Job> jobs,
                      int workers,
                      const std::function<void(std::size_t job, const Answer& answer)>& done);

}  // namespace plumbline::study
