// Runs in worker processes: `plumbline study-worker` and `plumbline-f64 study-worker` read one job a
// line and answer with one line each. A run that crashes or hangs takes its worker along, not the
// study; float64 is another program; and Bullet's packaged build has unguarded static state, so two
// worlds never step at once in one process.
#pragma once

#include "engine/core/result.h"
#include "engine/study/findings/findings.h"

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::study {

/// `kind` names the function that does it (study_worker.cpp has the table); `body` is its JSON object.
struct Job {
    std::string kind;
    std::string body;
    Precision precision{Precision::Float32};
    double limit_s{120};  ///< wall time; beyond it the worker is killed and the answer is TimedOut
};

struct Answer {
    RunStatus status{RunStatus::Done};  ///< Done, Refused, TimedOut or Crashed
    std::string body;                   ///< JSON of the job's kind when Done, a message otherwise
};

/// Jobs are handed out in order to as many workers at once; `done` is called on the calling thread
/// as each ends. Stops early, and returns false, when interrupted (core/process/interrupt.h): jobs that had
/// not ended have no call. Refused: the programs are not beside this one.
Result<bool> run_jobs(std::span<const Job> jobs,
                      int workers,
                      const std::function<void(std::size_t job, const Answer& answer)>& done);

/// Before hours of work: are both worker programs beside this one? Refused (exit code 1) with one
/// line that says what makes the one that is missing.
Result<Done> check_worker_programs();

/// Cores that this process may use; at least 1.
int default_workers();

}  // namespace plumbline::study
