// Time, measured three ways. Only for reports and the frame clock: nothing simulated reads it.
#pragma once

#include <cstdint>

namespace plumbline {

double wall_s();         ///< steady clock; the origin is arbitrary
double thread_cpu_s();   ///< of the calling thread
double process_cpu_s();  ///< of all threads, user and system
double seconds_since_process_start();

/// CPU milliseconds of the calling thread since construction.
class CpuTimer {
public:
    CpuTimer() : start_s_(thread_cpu_s()) {}
    double ms() const { return (thread_cpu_s() - start_s_) * 1e3; }

private:
    double start_s_;
};

/// Milliseconds on the wall, lap after lap: thirty times cheaper to read than a thread's CPU time,
/// which would be half the cost of a step with one body.
class LapTimer {
public:
    void start() { start_s_ = wall_s(); }
    double lap_ms() {
        const double lap_start_s = start_s_;
        start();
        return (start_s_ - lap_start_s) * 1e3;
    }

private:
    double start_s_{0};
};

}  // namespace plumbline
