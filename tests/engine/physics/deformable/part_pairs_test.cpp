#include "engine/physics/deformable/part_pairs.h"

#include "engine/core/io/archive.h"
#include "engine/core/io/pose_archive.h"
#include "engine/physics/sheet.h"

#include <gtest/gtest.h>

#include <set>

namespace plumbline::physics {
namespace {

constexpr double kPairStep_s = 1.0 / 60;
constexpr double kPairThick_m = 0.01;
constexpr double kPairCell_m = 0.1;

/// Of 0.1 m cells, its middle so high, turned about a slanting axis.
Sheet sheet_at(double high_m, double turn_rad) {
    return Sheet({.size_m = {0.6, 0.4},
                  .cells = {6, 4},
                  .position_m = {0, high_m, 0},
                  .orientation = glm::angleAxis(turn_rad, glm::normalize(Vec3d{2, 1, 0.5}))});
}

using Numbers = std::set<std::array<std::uint32_t, 3>>;

Numbers numbers_of(PartPairs& list) {
    Numbers numbers;
    for (const PartPair& pair : list.pairs())
        numbers.insert({pair.are_edges ? 1U : 0U, pair.first, pair.second});
    return numbers;
}

/// Of things at rest: all pairs, by their distance alone.
Numbers nearer_than(const PartPairs& list, double reach_m, bool of_two) {
    Numbers numbers;
    const auto try_pair = [&](const PartPair& pair) {
        const PartPlace place = list.place_of(pair);
        const bool are_two =
            list.is_of_second(place.points[0]) != list.is_of_second(place.points[3]);
        std::set<std::uint32_t> points(place.points.begin(), place.points.end());
        if (points.size() == 4 && are_two == of_two &&
            glm::length(place.difference(list.positions_m())) <= reach_m)
            numbers.insert({pair.are_edges ? 1U : 0U, pair.first, pair.second});
    };
    const auto points = static_cast<std::uint32_t>(list.positions_m().size());
    for (std::uint32_t i = 0; i < list.parts().triangles.size(); ++i) {
        for (std::uint32_t k = 0; k < points; ++k) try_pair({.first = k, .second = i});
    }
    for (std::uint32_t i = 0; i < list.parts().edges.size(); ++i) {
        for (std::uint32_t k = 0; k < i; ++k)
            try_pair({.first = k, .second = i, .are_edges = true});
    }
    return numbers;
}

constexpr double kPairMargin_m = kPairCell_m / 4;

TEST(PartPairs, ListsAllThatIsNearOfTwo) {
    const Sheet lower = sheet_at(0, 0.3);
    const Sheet upper = sheet_at(0.05, -0.2);
    PartPairs list(lower, &upper, kPairThick_m);
    list.begin_step(kPairStep_s);
    const Numbers expected = nearer_than(list, kPairThick_m + kPairMargin_m, true);
    EXPECT_GT(expected.size(), 50U);
    EXPECT_EQ(numbers_of(list), expected);
}

TEST(PartPairs, ListsAllThatIsNearOfOne) {
    const Sheet sheet = sheet_at(0, 0.3);
    PartPairs list(sheet, nullptr, 0.11);
    list.begin_step(kPairStep_s);
    const Numbers expected = nearer_than(list, 0.11 + kPairMargin_m, false);
    EXPECT_GT(expected.size(), 50U);
    EXPECT_EQ(numbers_of(list), expected);
}

// Nothing comes nearer than the thickness before it is listed anew, and what moves along with all is not listed anew.
TEST(PartPairs, KeepsItsListWhileNothingHasMovedByHalfOfTheMargin) {
    const Sheet lower = sheet_at(0, 0);
    Sheet upper = sheet_at(0.08, 0.3);
    PartPairs list(lower, &upper, kPairThick_m);
    list.begin_step(kPairStep_s);
    const Numbers start = numbers_of(list);
    const auto lift = [&](double by_m) {
        std::vector<Vec3d> places(upper.positions_m().begin(), upper.positions_m().end());
        for (Vec3d& at : places) at.y += by_m;
        upper.put_back(places);
    };
    lift(-0.02);  // by a centimetre from where both are on average
    EXPECT_FALSE(list.keep_up(1));
    list.begin_step(kPairStep_s);
    EXPECT_EQ(numbers_of(list), start);
    lift(-0.01);
    EXPECT_FALSE(list.keep_up(0)) << "so little is said to have moved that nobody looks";
    EXPECT_TRUE(list.keep_up(1));
    EXPECT_NE(numbers_of(list), start);
    EXPECT_EQ(numbers_of(list), nearer_than(list, kPairThick_m + kPairMargin_m, true));
}

TEST(PartPairs, RefuseNumbersThatAreNotThere) {
    const Sheet lower = sheet_at(0, 0);
    const Sheet upper = sheet_at(0.02, 0);
    std::vector<PartPair> wrong{{.first = 3, .second = 4000}};
    std::vector<Vec3d> nowhere;
    Archive out;
    out(wrong, nowhere);
    PartPairs list(lower, &upper, kPairThick_m);
    Archive in(out.written());
    list.serialize(in);
    EXPECT_NE(in.fault().find("what touches is not there"), std::string::npos) << in.fault();
    EXPECT_TRUE(list.pairs().empty());
}

}  // namespace
}  // namespace plumbline::physics
