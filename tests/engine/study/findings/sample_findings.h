// Findings that no study made: errors and costs after plain laws, so that tests can say what a page of
// them must hold.
#pragma once

#include "engine/study/findings/findings.h"

#include <cmath>
#include <string>
#include <utility>

namespace plumbline::test {

inline bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// Error falls with `order`, cost rises with the rate.
inline study::Point sample_point(const study::Setting& setting,
                                 double order,
                                 double error_at_60Hz) {
    const double ratio = setting.step_hz * std::max(1, setting.substeps) / 60.0;
    study::Point point;
    point.setting = setting;
    point.errors = {error_at_60Hz * std::pow(ratio, -order)};
    const double cost = 0.02 * ratio * setting.iterations;
    point.cost = {.ms_per_s_min = cost,
                  .ms_per_s_median = cost * 1.05,
                  .ms_per_s_max = cost * 1.3,
                  .repeats = 5,
                  .step_ms_median = cost / setting.step_hz,
                  .step_ms_p99 = 2 * cost / setting.step_hz,
                  .work_per_s = 1000 * ratio};
    return point;
}

/// small_step of first order with 1 and 4 sub-steps in both precisions, bullet_si that stalls at 7 %
/// with 10 and 50 iterations, at 30 to 960 Hz.
inline study::Subject sample_subject(std::string id) {
    using study::Precision;
    study::Subject subject;
    subject.id = std::move(id);
    subject.title = "a ball falls";
    subject.set_up = "A ball of 0.1 m falls 2 s from rest.";
    subject.reference = "height = g t^2 / 2";
    subject.metrics = {{"height at 2 s", "the way fallen, 19.62 m"}};
    for (const Precision precision : {Precision::Float32, Precision::Float64}) {
        for (const int substeps : {1, 4}) {
            for (int hz = 30; hz <= 960; hz *= 2) {
                subject.points.push_back(sample_point(
                    {.step_hz = hz, .substeps = substeps, .precision = precision}, 1, 0.02));
            }
        }
    }
    for (const int iterations : {10, 50}) {
        for (int hz = 30; hz <= 960; hz *= 2) {
            subject.points.push_back(sample_point({.solver = physics::Solver::BulletSi,
                                                   .step_hz = hz,
                                                   .substeps = 1,
                                                   .iterations = iterations},
                                                  0.05,
                                                  0.07));
        }
    }
    for (int hz = 30; hz <= 3840; hz *= 2) {
        subject.euler_floor.push_back({1.0 / hz, 0.5 / hz});
    }
    subject.verdicts = {{.knob = "step rate",
                         .held = "x 1",
                         .trend = study::Trend::Converges,
                         .order = 1.0,
                         .theory = 1.0,
                         .halvings = 5},
                        {.knob = "step rate",
                         .solver = physics::Solver::BulletSi,
                         .held = "10 it",
                         .trend = study::Trend::Stalls,
                         .order = 0.05,
                         .theory = 1.0,
                         .halvings = 5}};
    return subject;
}

inline study::Findings sample_findings() {
    return {.command = "plumbline study --only A01",
            .machine = "a test",
            .build = "0.1.0",
            .made_on = "2026-11-21",
            .complete = true,
            .clock_spread = 0.03,
            .subjects = {sample_subject("A01")}};
}

}  // namespace plumbline::test
