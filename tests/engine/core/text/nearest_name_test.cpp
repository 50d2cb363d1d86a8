#include "engine/core/text/nearest_name.h"

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace plumbline {
namespace {

TEST(EditDistance, CountsInsertionsDeletionsSubstitutionsAndSwaps) {
    EXPECT_EQ(edit_distance("", ""), 0U);
    EXPECT_EQ(edit_distance("", "mass"), 4U);
    EXPECT_EQ(edit_distance("mass", ""), 4U);
    EXPECT_EQ(edit_distance("mass", "mas"), 1U);
    EXPECT_EQ(edit_distance("mass", "moss"), 1U);
    EXPECT_EQ(edit_distance("mass", "amss"), 1U) << "neighbours swapped";
    EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
}

TEST(EditDistance, IsSymmetric) {
    EXPECT_EQ(edit_distance("friction", "ficrtoin"), edit_distance("ficrtoin", "friction"));
}

constexpr std::array<std::string_view, 4> kKeys{"mass_kg", "friction", "restitution", "sleep"};

TEST(NearestName, FindsWhatWasMeant) {
    EXPECT_EQ(nearest_name("mass", std::array<std::string_view, 2>{"mast", "shape"}), "mast");
    EXPECT_EQ(nearest_name("masskg", kKeys), "mass_kg");
    EXPECT_EQ(nearest_name("firction", kKeys), "friction");
    EXPECT_EQ(nearest_name("restituton", kKeys), "restitution");
    EXPECT_EQ(nearest_name("sleep", kKeys), "sleep");
}

TEST(NearestName, KnowsANameWithoutItsUnit) {
    EXPECT_EQ(nearest_name("mass", kKeys), "mass_kg");
    EXPECT_EQ(nearest_name("mass", std::array<std::string_view, 2>{"mast", "mass_kg"}), "mass_kg");
    EXPECT_EQ(nearest_name("density", std::array<std::string_view, 1>{"density_kgpm3"}),
              "density_kgpm3");
    EXPECT_EQ(nearest_name("", std::array<std::string_view, 1>{"_"}), "_") << "one letter off";
}

TEST(NearestName, SaysNothingWhenNothingIsNear) {
    EXPECT_EQ(nearest_name("zzzz", kKeys), "");
    EXPECT_EQ(nearest_name("colour", kKeys), "");
    EXPECT_EQ(nearest_name("sleep", {}), "");
}

TEST(NearestName, HostileWordsCostNothing) {
    EXPECT_EQ(nearest_name(std::string(10'000'000, 'm'), kKeys), "");
}

TEST(NearestName, OfEquallyNearTheFirst) {
    EXPECT_EQ(nearest_name("bat", std::array<std::string_view, 2>{"cat", "hat"}), "cat");
}

}  // namespace
}  // namespace plumbline
