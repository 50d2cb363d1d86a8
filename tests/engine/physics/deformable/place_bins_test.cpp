#include "engine/physics/deformable/place_bins.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <set>

namespace plumbline::physics {
namespace {

constexpr double kSide_m = 0.5;

std::vector<PlaceBins::Place> balls(std::size_t count, double spread_m) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> at(-spread_m, spread_m);
    std::uniform_real_distribution<double> radius(0.01, kSide_m / 2);
    std::vector<PlaceBins::Place> places;
    for (std::uint32_t i = 0; i < count; ++i)
        places.push_back({.middle_m = {at(random), at(random), 0.3 * at(random)},
                          .radius_m = radius(random),
                          .number = i});
    return places;
}

std::set<std::uint32_t> near_of(const PlaceBins& bins, const PlaceBins::Place& place) {
    std::set<std::uint32_t> found;
    bins.for_near(place, [&](std::uint32_t number) {
        EXPECT_TRUE(found.insert(number).second) << number << " is given twice";
    });
    return found;
}

// Close together, and so far apart that the cubes grow.
TEST(PlaceBins, GivesEveryBallThatTouchesOnce) {
    for (const double spread_m : {0.2, 3.0, 500.0}) {
        const std::vector<PlaceBins::Place> places = balls(300, spread_m);
        const PlaceBins bins(places, kSide_m);
        for (const PlaceBins::Place& place : places) {
            std::set<std::uint32_t> expected;
            for (const PlaceBins::Place& other : places) {
                const double apart_m = glm::distance(place.middle_m, other.middle_m);
                if (apart_m <= place.radius_m + other.radius_m) expected.insert(other.number);
            }
            EXPECT_EQ(near_of(bins, place), expected) << spread_m;
        }
    }
}

TEST(PlaceBins, GivesNothingFarOffOrNowhere) {
    const PlaceBins bins(balls(50, 2), kSide_m);
    EXPECT_TRUE(near_of(bins, {.middle_m = {1e300, 0, -1e300}, .radius_m = 0.1}).empty());
    const double none = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(near_of(bins, {.middle_m = {none, 0, 0}, .radius_m = 0.1}).empty());
    EXPECT_TRUE(near_of(PlaceBins({}, kSide_m), {.radius_m = 1}).empty());
}

// A body that has come apart is found out after its sub-step: until then it is only slow.
TEST(PlaceBins, BearsPlacesThatAreNowhere) {
    std::vector<PlaceBins::Place> places = balls(50, 2);
    places[10].middle_m.y = std::numeric_limits<double>::quiet_NaN();
    places[20].middle_m.x = std::numeric_limits<double>::infinity();
    const PlaceBins bins(places, kSide_m);
    EXPECT_TRUE(near_of(bins, places[30]).contains(30));
}

}  // namespace
}  // namespace plumbline::physics
