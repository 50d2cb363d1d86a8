// Which of many points with one normal carry a contact.
#pragma once

#include "engine/core/math.h"

#include <array>
#include <cstddef>
#include <span>

namespace plumbline::physics {

/// A point seen along the normal.
struct FlatPoint {
    glm::dvec2 place;
    double distance_m;  ///< negative: penetration
};

/// Indices of the chosen points, those that span most first.
struct PointChoice {
    static constexpr std::size_t kMost = 8;
    /// So many are all kept, in their order.
    static constexpr std::size_t kAllKept = 4;

    std::array<std::size_t, kMost> kept{};
    std::size_t count{0};

    std::span<const std::size_t> points() const { return {kept.data(), count}; }
};

/// Up to kAllKept points are all kept. Of more: the one farthest from the middle, the one farthest from that, those that make the
/// largest triangles on either side of the line between, and what sticks out most beyond each side of those four: a corner
/// that nothing holds would sink until it is the deepest, and the body would rock from one choice to the next. Points that
/// hardly touch are not chosen where the others span an area; what is deeper than all that is chosen, as the line of a ridge is,
/// comes last.
///
/// Of points that are as deep within `level_m`, or as good within 0.1 %, the first counts. `points` is not empty.
PointChoice choose_points(std::span<const FlatPoint> points, double level_m);

}  // namespace plumbline::physics
