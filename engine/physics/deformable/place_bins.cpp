#include "engine/physics/deformable/place_bins.h"

#include <bit>
#include <cmath>

namespace plumbline::physics {
namespace {

constexpr double kMostBin = 1e15;

}  // namespace

void PlaceBins::clear(std::size_t count, double side_m) {
    side_m_ = side_m;
    places_.clear();
    heads_.assign(std::bit_ceil(2 * count + 1), kNoPlace);
}

/// Of the cube that is so many cubes away.
std::size_t PlaceBins::bin_of(const Vec3d& at_m, const std::array<int, 3>& away) const {
    std::size_t hash = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double number =
            std::floor(at_m[axis] / side_m_) + away[static_cast<std::size_t>(axis)];
        // Any odd factor mixes them; numbers that are too large share a bin.
        const double kept = std::clamp(number, -kMostBin, kMostBin);
        hash =
            hash * 0x9E3779B97F4A7C15U + static_cast<std::size_t>(static_cast<std::int64_t>(kept));
    }
    return (hash ^ hash >> 32U) & (heads_.size() - 1);
}

void PlaceBins::add(const Place& place) {
    const std::size_t bin = bin_of(place.middle_m, {0, 0, 0});
    places_.push_back(place);
    places_.back().next = heads_[bin];
    heads_[bin] = static_cast<std::uint32_t>(places_.size() - 1);
}

}  // namespace plumbline::physics
