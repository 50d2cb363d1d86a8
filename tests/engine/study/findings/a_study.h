// A small study of all kinds of values.
#pragma once

#include "engine/study/findings/findings.h"

#include <cmath>

namespace plumbline::study {

inline Findings a_study() {
    const Setting small{.step_hz = 240, .substeps = 4, .precision = Precision::Float64};
    const Setting stock{.solver = physics::Solver::BulletSi, .substeps = 1, .iterations = 10};
    Subject subject{.id = "A20 e=0.5",
                    .title = "Bounce, \"dropped\"",
                    .set_up = "A ball, falling.",
                    .reference = "apex_n = e^(2n) H",
                    .tier = Tier::TwoIntegrators,
                    .peer_scene = "bounce",
                    .metrics = {{"apex, first", "1 m"}, {"energy", "start"}},
                    .uncertainty = 0.1 / 7,
                    .euler_floor = {{1.0 / 60, 0.1 / 3}},
                    .points = {{.setting = small,
                                .errors = {1e-300, 0.1},
                                .cost = {.ms_per_s_min = 0.1,
                                         .ms_per_s_median = 0.2,
                                         .ms_per_s_max = 0.3,
                                         .clock_ms_per_s = 0.09,
                                         .repeats = 5,
                                         .step_ms_median = 0.004,
                                         .step_ms_p99 = 0.005,
                                         .step_ms_max = 0.006,
                                         .frame_ms_p99 = 0.007,
                                         .frame_ms_max = 0.008,
                                         .bodies = 9,
                                         .peak_bytes = 10,
                                         .work_per_s = 1234}},
                               {.setting = stock, .status = RunStatus::Crashed, .why = "signal 11"},
                               {.setting = stock, .errors = {std::nan(""), 2}}},
                    .verdicts = {{.knob = "step rate",
                                  .solver = physics::Solver::BulletSi,
                                  .held = "x 1, 10 it",
                                  .trend = Trend::Converges,
                                  .order = 1.01,
                                  .theory = 1,
                                  .halvings = 4},
                                 {.knob = "sub-steps", .trend = Trend::TooFew}},
                    .notes = {"a note"}};
    subject.threads = {{.threads = 2,
                        .same = true,
                        .cost = {.ms_per_s_min = 6, .clock_ms_per_s = 3.5, .repeats = 5}},
                       {.threads = 64, .status = RunStatus::Refused, .why = "too many"}};
    return {.command = "plumbline study A20",
            .machine = "a machine",
            .build = "0.1",
            .made_on = "2026-11-21",
            .complete = false,
            .clock_spread = 0.03,
            .subjects = {subject},
            .images = {{.scene = "garden.toml",
                        .width_px = 640,
                        .height_px = 360,
                        .samples_per_pixel = 16,
                        .mean_luminance = 0.1,
                        .rows = {{.name = "level high",
                                  .error = {.mean = 0.1 / 3, .rms = 0.1},
                                  .cpu_ms = 12.5,
                                  .more_ms = {.mean = -1e-3, .standard_error = 0.1, .pairs = 4},
                                  .unbeaten = true,
                                  .verdict = "\"so\""}}}},
            .effects = {{.scene = "yard.toml",
                         .seconds = 0.1 / 3,
                         .pairs = 6,
                         .width_px = 320,
                         .height_px = 180,
                         .rows = {{.name = "wind",
                                   .caller = "[wind]",
                                   .domain = "step",
                                   .step_ms = {.mean = 0.1 / 3, .standard_error = 0.1, .pairs = 4},
                                   .calls = 3,
                                   .bytes_cpu = 4,
                                   .bytes_gpu = 5}}}}};
}

}  // namespace plumbline::study
