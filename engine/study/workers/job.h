// Runs in worker processes: `plumbline study-worker` and `plumbline-f64 study-worker` read one job a
// line and answer with one line each. A run that crashes or hangs takes its worker along, not the
// study; float64 is another program; and Bullet's packaged build has unguarded static state, so two
// worlds never step at once in one process.
#pragma once

#include "engine/study/findings/findings.h"

#include <string>

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

}  // namespace plumbline::study
