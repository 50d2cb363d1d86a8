#include "engine/physics/deformable/place_bins.h"

#include <cmath>

namespace plumbline::physics {
namespace {

/// Cubes for a place, at most; larger ones hold what is spread far.
constexpr double kMostCubes = 8;
/// What is spread farther, or is nowhere, lies in one cube.
constexpr double kMostSpread_m = 1e12;

}  // namespace

PlaceBins::PlaceBins(std::vector<Place> places, double side_m) : side_m_(side_m) {
    if (!places.empty()) low_m_ = places.front().middle_m;
    Vec3d high_m = low_m_;
    for (const Place& place : places) {
        low_m_ = glm::min(low_m_, place.middle_m);
        high_m = glm::max(high_m, place.middle_m);
    }
    if (glm::distance(low_m_, high_m) < kMostSpread_m) {
        const auto cubes = [&] { return glm::floor((high_m - low_m_) / side_m_) + 1.0; };
        const double most = kMostCubes * static_cast<double>(places.size() + 1);
        while (cubes().x * cubes().y * cubes().z > most) side_m_ *= 2;
        const Vec3d counts = cubes();
        counts_ = {static_cast<std::size_t>(counts.x),
                   static_cast<std::size_t>(counts.y),
                   static_cast<std::size_t>(counts.z)};
    }

    first_.assign(counts_[0] * counts_[1] * counts_[2] + 1, 0);
    std::vector<std::size_t> bins;
    for (const Place& place : places) {
        bins.push_back(bin_of(cube_at(place.middle_m, 0)));
        ++first_[bins.back() + 1];
    }
    for (std::size_t bin = 1; bin < first_.size(); ++bin) first_[bin] += first_[bin - 1];
    std::vector<std::uint32_t> next = first_;
    places_.resize(places.size());
    for (std::size_t i = 0; i < places.size(); ++i) places_[next[bins[i]]++] = places[i];
}

PlaceBins::Cube PlaceBins::cube_at(const Vec3d& at_m, int moved) const {
    Cube cube{};
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        const double number = std::floor((at_m[axis] - low_m_[axis]) / side_m_) + moved;
        const auto last = static_cast<double>(counts_[i] - 1);
        cube[i] = number > 0 ? static_cast<std::size_t>(std::min(number, last)) : 0;
    }
    return cube;
}

}  // namespace plumbline::physics
