// Places in space by where they are: which of them are near each other.
#pragma once

#include "engine/core/math.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace plumbline::physics {

/// Balls by the cubes of space that their middles lie in.
class PlaceBins {
public:
    struct Place {
        Vec3d middle_m{0, 0, 0};
        double radius_m{0};
        std::uint32_t number{0};
        std::uint32_t next{0};  ///< in the same bin
    };

    /// For `count` places; two that touch have middles no farther apart than `side_m`.
    void clear(std::size_t count, double side_m);
    void add(const Place& place);
    /// Gives the numbers of those that touch it.
    template <class F>
    void for_near(const Place& place, const F& visit) const;

private:
    std::size_t bin_of(const Vec3d& at_m, const std::array<int, 3>& away) const;

    static constexpr std::uint32_t kNoPlace = ~std::uint32_t{0};

    double side_m_{1};
    std::vector<Place> places_;
    std::vector<std::uint32_t> heads_;  ///< of the bins: numbers of places
};

template <class F>
void PlaceBins::for_near(const Place& place, const F& visit) const {
    std::array<std::size_t, 27> bins{};
    std::size_t count = 0;
    for (int x = -1; x <= 1; ++x) {
        for (int y = -1; y <= 1; ++y) {
            for (int z = -1; z <= 1; ++z) bins[count++] = bin_of(place.middle_m, {x, y, z});
        }
    }
    std::ranges::sort(bins);
    for (std::size_t i = 0; i < bins.size(); ++i) {
        if (i > 0 && bins[i] == bins[i - 1]) continue;  // two cubes in one bin
        for (std::uint32_t at = heads_[bins[i]]; at != kNoPlace; at = places_[at].next) {
            const Vec3d apart_m = places_[at].middle_m - place.middle_m;
            const double near_m = places_[at].radius_m + place.radius_m;
            if (glm::dot(apart_m, apart_m) <= near_m * near_m) visit(places_[at].number);
        }
    }
}

}  // namespace plumbline::physics
