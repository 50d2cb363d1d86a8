// How far one run of a scene is from the reference: body by body, or, where the scene is chaotic,
// between the statistics of many copies. Pure functions.
#pragma once

#include "engine/study/scenes/scene_run.h"

#include <span>
#include <string>
#include <vector>

namespace plumbline::study {

/// What an error of 1 means. Taken from the reference.
struct Scales {
    double length_m{1};     ///< diagonal of the box round all bodies, from start to end
    double energy_J{1};     ///< largest energy turnover, and at least that of 1 % of the length
    double body_size_m{1};  ///< median diagonal of a body
    bool has_joints{false};
};
Scales scales_of(const SceneAnswer& reference);

/// Position, orientation, energy, penetration and, where there are joints, joint error.
std::vector<Metric> trajectory_metrics(const Scales& scales);
/// The largest over the moments; over bodies the root mean square. Penetration and joint error count
/// where they exceed the reference's. Not a number where the run has other moments.
std::vector<double> trajectory_errors(const Trace& run,
                                      const Trace& reference,
                                      const Scales& scales);

/// Centre of mass, height, spread, reach, energy, penetration and, where there are joints, joint
/// error: of copies.
std::vector<Metric> ensemble_metrics(const Scales& scales);
/// Between the medians over copies, the largest over the moments.
std::vector<double> ensemble_errors(std::span<const Trace> copies,
                                    std::span<const Trace> reference,
                                    const Scales& scales);
/// Half the way from the 5th to the 95th percentile of the copies, as ensemble_errors counts.
std::vector<double> ensemble_spread(std::span<const Trace> copies, const Scales& scales);

/// By how much a setting's median may be off by chance: its standard error, for each metric.
std::vector<double> ensemble_chance(std::span<const Trace> copies, const Scales& scales);

/// Why a Done run is to be taken as exploded; empty: it is not. Bodies ten scene sizes away, or a
/// hundred times the energy that the reference turns over.
std::string explosion_in(const Trace& run, const Trace& reference, const Scales& scales);

}  // namespace plumbline::study
