// A work-precision diagram: settings of a study by their cost and their error, both on logarithmic axes.
// Places in it run from 0, 0 at the lower left to 1, 1. Pure functions.
#pragma once

#include "engine/core/math.h"
#include "engine/study/scenes/scene_study.h"

#include <optional>
#include <span>
#include <vector>

namespace plumbline::app {

/// Whole powers of ten at both ends.
struct LogAxis {
    int least_decade{-2};
    int most_decade{0};

    /// 0…1; what lies outside is put on the end.
    float place_of(double value) const;
};

struct DiagramPoint {
    std::size_t of{0};  ///< its place among the study's points
    Vec2f place{0, 0};
};

struct StudyDiagram {
    LogAxis ms{};                        ///< CPU of 1/60 s
    LogAxis error{};                     ///< 1: as large as what it is measured by
    std::vector<DiagramPoint> points{};  ///< those with an error
    std::vector<Vec2f> front{};          ///< those that no other beats, by rising cost
};
/// Errors below 1e-6 and above 10 are shown there.
StudyDiagram diagram_of(std::span<const study::Point> points);

/// The point nearest to `place` in a diagram of that size, if it is within `reach_px`.
std::optional<std::size_t> point_at(const StudyDiagram& diagram,
                                    const Vec2f& place,
                                    const Vec2f& size_px,
                                    float reach_px);

}  // namespace plumbline::app
