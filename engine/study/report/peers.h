// What other engines measured on the same scenes: assets/data/peers.csv (assets/data/README.md says
// on which machine, when, and which versions).
#pragma once

#include "engine/core/result.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::study {

/// One figure. `substeps` whole steps were made in each 1/60 s.
struct PeerRow {
    std::string scene;
    std::string engine;
    int substeps{1};
    double cpu_ms_per_frame{0};
    double cost_ratio{0};  ///< to stock Bullet float32 in the same run
    std::string metric;
    double value{0};
};

/// `scene,engine,substeps,cpu_ms_per_frame,cost_ratio,metric,value` below one heading of these names;
/// empty lines and lines that begin with # do not count. Errors name the line and what it lacks.
Result<std::vector<PeerRow>> parse_peers(std::string_view csv);

/// A peer in a diagram.
struct PeerPoint {
    std::string engine;
    int substeps{1};
    double cpu_ms_per_s{0};
    double error{0};  ///< relative, as ours
};

/// Rows of `scene` whose figure is what `metric` measures, as errors in the metric's scale; at least 1
/// where the file says that what should stand fell (what fell may lie very still). None where
/// no figure of that scene is comparable (the list is in peers.cpp).
std::vector<PeerPoint> comparable_peers(std::span<const PeerRow> rows,
                                        std::string_view scene,
                                        std::string_view metric);

}  // namespace plumbline::study
