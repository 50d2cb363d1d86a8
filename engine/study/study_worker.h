// The command `study-worker`: which kinds of jobs a worker process does.
#pragma once

namespace plumbline::study {

/// Answers jobs on standard input until it ends, or until the program that started this one does.
void run_study_worker();

}  // namespace plumbline::study
