// Stress in a body's bonds against strength of materials.
#include "engine/physics/fracture.h"
#include "tests/engine/physics/test_world.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace plumbline::physics {
namespace {

constexpr double kDensity_kgpm3 = 2000;
constexpr double kBarLength_m = 2;
constexpr double kBarSide_m = 0.1;

/// A bar along x in pieces.
struct BreakableBar {
    explicit BreakableBar(std::uint32_t pieces, std::uint64_t seed = 1) {
        TestWorld rig;
        const BodyId bar = rig.add(BoxShape{Vec3(Vec3d{kBarLength_m, kBarSide_m, kBarSide_m})}, {});
        pattern = fracture_pattern(rig.world, bar, pieces, seed);
        std::vector<std::uint32_t> all(pattern.pieces.size());
        std::iota(all.begin(), all.end(), 0U);
        network.emplace(pattern, all, std::vector<std::uint32_t>{}, kDensity_kgpm3);
    }
    double most_Pa(const std::vector<BodyLoad>& loads, const Vec3d& spin_radps = {0, 0, 0}) {
        return std::ranges::max(network->stress_Pa(loads, spin_radps));
    }

    FracturePattern pattern;
    std::optional<FractureNetwork> network;
};

std::vector<BodyLoad> pulled_by(double force_N) {
    return {{.point_m = {-kBarLength_m / 2, 0, 0}, .force_N = {-force_N, 0, 0}},
            {.point_m = {kBarLength_m / 2, 0, 0}, .force_N = {force_N, 0, 0}}};
}

/// On two supports at its ends, pressed in the middle.
std::vector<BodyLoad> bent_by(double force_N) {
    return {{.point_m = {-kBarLength_m / 2, -kBarSide_m / 2, 0}, .force_N = {0, force_N / 2, 0}},
            {.point_m = {kBarLength_m / 2, -kBarSide_m / 2, 0}, .force_N = {0, force_N / 2, 0}},
            {.point_m = {0, kBarSide_m / 2, 0}, .force_N = {0, -force_N, 0}}};
}

double bending_Pa(double force_N) {
    return 3 * force_N * kBarLength_m / (2 * kBarSide_m * kBarSide_m * kBarSide_m);
}

// However oblique the cuts.
TEST(FractureNetwork, UniformTensionIsForceByArea) {
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
        BreakableBar bar(20, seed);
        EXPECT_NEAR(bar.most_Pa(pulled_by(1000)) / (1000 / (kBarSide_m * kBarSide_m)), 1, 1e-3)
            << seed;
    }
}

// Short by how far the nearest cut is from the middle, and by how oblique it is.
TEST(FractureNetwork, ABeamBendsWithinItsCells) {
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
        for (const std::uint32_t pieces : {10U, 20U, 41U, 100U}) {
            BreakableBar bar(pieces, seed);
            const double share = bar.most_Pa(bent_by(100)) / bending_Pa(100);
            EXPECT_LT(share, 1.01) << seed << " " << pieces;
            EXPECT_GT(share, 0.88) << seed << " " << pieces;
        }
    }
}

TEST(FractureNetwork, ASpinningRodPullsAtItsMiddle) {
    const double spin_radps = 10;
    const double asked_Pa =
        kDensity_kgpm3 * spin_radps * spin_radps * kBarLength_m * kBarLength_m / 8;
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
        BreakableBar bar(20, seed);
        EXPECT_NEAR(bar.most_Pa({}, {0, 0, spin_radps}) / asked_Pa, 1, 2e-3) << seed;
    }
}

// 0.208 a3; oblique cuts are bent as well.
TEST(FractureNetwork, ATwistedBarIsShearedAtItsSides) {
    const double bears_m3 = 0.208 * kBarSide_m * kBarSide_m * kBarSide_m;
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
        BreakableBar bar(20, seed);
        const double share =
            bears_m3 * bar.most_Pa({{.point_m = {-1, 0, 0}, .torque_Nm = {-1, 0, 0}},
                                    {.point_m = {1, 0, 0}, .torque_Nm = {1, 0, 0}}});
        EXPECT_GT(share, 1 - 0.01) << seed;
        EXPECT_LT(share, 1.25) << seed;
    }
}

TEST(FractureNetwork, StressIsThatOfTheLoadAndNoneInFreeFall) {
    BreakableBar bar(20);
    EXPECT_NEAR(bar.most_Pa(bent_by(200)) / bar.most_Pa(bent_by(100)), 2, 1e-9);
    EXPECT_EQ(bar.most_Pa({}), 0);
}

TEST(FractureNetwork, BreaksWhereItIsPulledTooHardAndNowhereElse) {
    BreakableBar bar(20);
    const double most_Pa = bar.most_Pa(bent_by(100));
    EXPECT_FALSE(bar.network->crack(bent_by(100), {0, 0, 0}, 1.001 * most_Pa, 0.2, 10));
    EXPECT_EQ(bar.network->parts().size(), 1U);
    EXPECT_TRUE(bar.network->crack(bent_by(100), {0, 0, 0}, 0.9 * most_Pa, 0, 100));
    const auto parts = bar.network->parts();
    ASSERT_EQ(parts.size(), 2U);
    EXPECT_EQ(parts[0].size() + parts[1].size(), 20U);
    // Its halves fall freely but for what still presses them.
    EXPECT_LT(bar.most_Pa({}), 1e-6);
}

// A crack that does not go through weakens what is left.
TEST(FractureNetwork, CracksStay) {
    BreakableBar bar(100, 1);
    const std::vector<double> stress = bar.network->stress_Pa(pulled_by(1000), {0, 0, 0});
    const double most_Pa = std::ranges::max(stress);
    const auto worst =
        static_cast<std::uint32_t>(std::ranges::max_element(stress) - stress.begin());
    std::vector<std::uint32_t> all(bar.pattern.pieces.size());
    std::iota(all.begin(), all.end(), 0U);
    FractureNetwork cracked(bar.pattern, all, std::vector{worst}, kDensity_kgpm3);
    EXPECT_EQ(cracked.cracked(), std::vector{worst});
    EXPECT_GT(std::ranges::max(cracked.stress_Pa(pulled_by(1000), {0, 0, 0})), 1.05 * most_Pa);
}

}  // namespace
}  // namespace plumbline::physics
