// Places in space by where they are: which of them are near each other.
#pragma once

#include "engine/core/math.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace plumbline::physics {

/// Balls by the cubes of a grid round all of them that their middles lie in.
class PlaceBins {
public:
    struct Place {
        Vec3d middle_m{0, 0, 0};
        double radius_m{0};
        std::uint32_t number{0};
    };

    /// A place and another that touches it have middles no farther apart than `side_m`.
    PlaceBins(std::vector<Place> places, double side_m);
    /// Gives the numbers of those that touch it.
    template <class F>
    void for_near(const Place& place, const F& visit) const;

private:
    using Cube = std::array<std::size_t, 3>;

    /// The nearest cube to where the middle is, moved by so many of them along each axis.
    Cube cube_at(const Vec3d& at_m, int moved) const;
    std::size_t bin_of(const Cube& cube) const {
        return (cube[0] * counts_[1] + cube[1]) * counts_[2] + cube[2];
    }

    Vec3d low_m_{0, 0, 0};
    double side_m_;
    Cube counts_{1, 1, 1};              ///< of cubes
    std::vector<Place> places_;         ///< bin by bin
    std::vector<std::uint32_t> first_;  ///< of each bin its first place, and the end
};

template <class F>
void PlaceBins::for_near(const Place& place, const F& visit) const {
    const Cube low = cube_at(place.middle_m, -1);
    const Cube high = cube_at(place.middle_m, 1);
    for (std::size_t x = low[0]; x <= high[0]; ++x) {
        for (std::size_t y = low[1]; y <= high[1]; ++y) {
            // Bins along z lie one after the other.
            const std::uint32_t end = first_[bin_of({x, y, high[2]}) + 1];
            for (std::uint32_t at = first_[bin_of({x, y, low[2]})]; at < end; ++at) {
                const Vec3d apart_m = places_[at].middle_m - place.middle_m;
                const double near_m = places_[at].radius_m + place.radius_m;
                if (glm::dot(apart_m, apart_m) <= near_m * near_m) visit(places_[at].number);
            }
        }
    }
}

}  // namespace plumbline::physics
