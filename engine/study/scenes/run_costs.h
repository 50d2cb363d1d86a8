// What runs of settings will probably cost, from those that were measured before them.
#pragma once

#include "engine/study/findings/findings.h"

#include <span>
#include <string>
#include <vector>

namespace plumbline::study {

/// How often one setting is run, and what for.
struct RunCounts {
    bool chaotic{false};
    int copies{7};         ///< each sampled, of a chaotic scene
    int repeats{5};        ///< for the clock, of another one
    double repeat_s{0.4};  ///< SceneRun::repeat_s
};

class RunCosts {
public:
    /// `second_cpu_s`: of small_step at 60 Hz; `seconds`: of simulated time. The points outlive it and may grow.
    RunCosts(const std::vector<Point>& points, double second_cpu_s, double seconds)
        : points_(points), second_cpu_s_(second_cpu_s), seconds_(seconds) {}

    /// CPU time of one run: as its like at another rate took, else as guessed.
    double of_one_s(const Setting& setting) const;
    /// With its repeats or copies, and what loading and handing over take.
    double of_all_s(const Setting& setting) const;
    double sum_s(std::span<const Setting> settings) const;
    /// Fewer copies or repeats where `grid` would not fit else.
    void fit(std::span<const Setting> grid, double cpu_left_s);

    RunCounts counts{};

private:
    const std::vector<Point>& points_;
    double second_cpu_s_;
    double seconds_;
};

/// A clock that other work disturbs shows in runs of the same thing: says so where it did, else empty.
std::string clock_note(std::span<const Point> points);

}  // namespace plumbline::study
