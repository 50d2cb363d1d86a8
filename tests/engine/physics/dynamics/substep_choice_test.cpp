#include "engine/physics/dynamics/substep_choice.h"

#include "tests/engine/physics/dynamics/contact/contact_rig.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace plumbline::physics {
namespace {

SubstepChooser::Pair pressed(int a, int b, Real load_N, Real mass_kg = 1) {
    return {.a = a, .b = b, .load_N = load_N, .reduced_mass_kg = mass_kg, .size_m = 1};
}

SubstepChoice for_load(double load_N, double mass_kg, int least = 1, int most = 64) {
    SubstepChooser chooser;
    chooser.begin(1, kStep_s);
    chooser.add_contact(pressed(0, -1, real(load_N), real(mass_kg)));
    return chooser.choose(least, most);
}

SubstepChoice for_tower(int height, int least = 1, int most = 64) {
    SubstepChooser chooser;
    chooser.begin(static_cast<std::size_t>(height), kStep_s);
    for (int i = 0; i < height; ++i) chooser.add_contact(pressed(i, i - 1, 1e-3_r));
    return chooser.choose(least, most);
}

TEST(SubstepChoice, LeastWhereNothingAsks) {
    SubstepChooser chooser;
    chooser.begin(3, kStep_s);
    const SubstepChoice choice = chooser.choose(2, 16);
    EXPECT_EQ(choice.substeps, 2);
    EXPECT_EQ(choice.reason, SubstepReason::Least);
}

TEST(SubstepChoice, FixedWhereThereIsNoChoice) {
    for (int least : {1, 4, 9}) {
        const SubstepChoice choice = for_load(1e9, 1, least, least);
        EXPECT_EQ(choice.substeps, least);
        EXPECT_EQ(choice.reason, SubstepReason::Fixed);
        EXPECT_EQ(for_load(1e9, 1, least, least - 1).substeps, least);
    }
}

TEST(SubstepChoice, StaysBetweenLeastAndMost) {
    for (int least : {1, 3, 9}) {
        for (int most : {10, 11, 37, 64}) {
            for (double load_N = 1e-3; load_N < 1e12; load_N *= 7) {
                const int substeps = for_load(load_N, 1, least, most).substeps;
                EXPECT_GE(substeps, least);
                EXPECT_LE(substeps, most);
            }
        }
    }
}

TEST(SubstepChoice, GrowsWithTheLoadAndSaysSo) {
    int before = 1;
    std::set<int> seen;
    for (double load_N = 1; load_N < 1e6; load_N *= 1.05) {
        const SubstepChoice choice = for_load(load_N, 1);
        EXPECT_GE(choice.substeps, before) << load_N;
        before = choice.substeps;
        seen.insert(choice.substeps);
        EXPECT_EQ(choice.reason, choice.substeps == 1 ? SubstepReason::Least : SubstepReason::Load);
    }
    EXPECT_EQ(before, 64);
    EXPECT_GT(seen.size(), 10U);
}

TEST(SubstepChoice, FourTimesTheLoadAsksForTwiceAsMany) {
    // Sag falls with the square of the sub-steps.
    for (int substeps : {2, 4, 8, 16, 32}) {
        double load_N = 1;
        while (for_load(load_N, 1).substeps < substeps) load_N *= 1.001;
        EXPECT_LE(for_load(3.9 * load_N, 1).substeps, 2 * substeps);
        EXPECT_GT(for_load(4.1 * load_N, 1).substeps, for_load(3.9 / 2.25 * load_N, 1).substeps);
    }
}

TEST(SubstepChoice, GrowsWithTheHeightOfAStackAndSaysSo) {
    int before = 1;
    for (int height = 1; height <= 100; ++height) {
        const SubstepChoice choice = for_tower(height);
        EXPECT_GE(choice.substeps, before) << height;
        before = choice.substeps;
        if (choice.substeps > 1) {
            EXPECT_EQ(choice.reason, SubstepReason::Height);
        }
    }
    EXPECT_GT(for_tower(100).substeps, 2 * for_tower(20).substeps);
}

/// Blocks of 1 m and 1 kg, each pair's load known.
SubstepChoice for_blocks(int height, double step_s, int most) {
    SubstepChooser chooser;
    chooser.begin(static_cast<std::size_t>(height), step_s);
    for (int i = 0; i < height; ++i)
        chooser.add_contact(pressed(i, i - 1, real(9.81 * (height - i)), i > 0 ? 0.5_r : 1));
    return chooser.choose(2, most);
}

// What stands as if its joints were springs falls beyond the height that they bear (Greenhill 1881): from n^3 = 1.25 a / (g h^2) on.
TEST(SubstepChoice, ATowerGetsMoreThanTheMostBeforeItBuckles) {
    for (const double step_s : {1.0 / 30, 1.0 / 60}) {
        for (const int height : {40, 60}) {
            const SubstepChoice choice = for_blocks(height, step_s, 16);
            EXPECT_GT(choice.substeps, step_s * std::sqrt(9.81 * std::pow(height, 3) / 1.25));
        }
    }
    EXPECT_EQ(for_blocks(60, 1.0 / 60, 16).reason, SubstepReason::Height);
    EXPECT_EQ(for_blocks(20, 1.0 / 60, 16).substeps, 7) << "by its height alone";
}

TEST(SubstepChoice, AFloorFullOfBodiesIsNotHigh) {
    SubstepChooser chooser;
    chooser.begin(1000, kStep_s);
    for (int i = 0; i < 1000; ++i) {
        chooser.add_contact(pressed(-1, i, 1e-3_r));
        if (i > 0) chooser.add_contact(pressed(i - 1, i, 1e-3_r));
    }
    EXPECT_EQ(chooser.choose(1, 64).substeps, 1);
}

TEST(SubstepChoice, TheOrderOfTheContactsDoesNotMatter) {
    constexpr int kHeight = 40;
    std::vector<int> order(kHeight);
    for (int i = 0; i < kHeight; ++i) order[static_cast<std::size_t>(i)] = i * 17 % kHeight;
    SubstepChooser chooser;
    chooser.begin(kHeight, kStep_s);
    for (int i : order) chooser.add_contact(pressed(i - 1, i, 1e-3_r));
    EXPECT_EQ(chooser.choose(1, 64).substeps, for_tower(kHeight).substeps);
}

/// What stands on each other without a history of loads asks for as many sub-steps as with the loads that it will carry.
TEST(SubstepChoice, NewContactsCarryWhatStandsOnThem) {
    constexpr int kHeight = 20;
    const auto of_tower = [](bool is_known) {
        SubstepChooser chooser;
        chooser.begin(kHeight, kStep_s);
        for (int i = 0; i < kHeight; ++i) {
            chooser.set_body(i, 100, false);
            SubstepChooser::Pair pair = pressed(i, i - 1, 100);
            pair.is_load_known = is_known;
            if (is_known) pair.load_N = real(100 * (kHeight - i));
            chooser.add_contact(pair);
        }
        return chooser.choose(1, 64);
    };
    EXPECT_EQ(of_tower(false).needed, of_tower(true).needed);
    EXPECT_EQ(of_tower(false).reason, SubstepReason::Load);
}

/// A beam on two posts, with a block on it: half of both on each post.
TEST(SubstepChoice, SupportsShareALoad) {
    enum : int { Left, Right, Beam, Block, Count };
    const auto posts_carry = [](Real each_N, bool is_known) {
        SubstepChooser chooser;
        chooser.begin(Count, kStep_s);
        for (int body : {Left, Right}) chooser.set_body(body, 1000, false);
        chooser.set_body(Beam, 2000, false);
        chooser.set_body(Block, 4000, false);
        for (int post : {Left, Right}) {
            SubstepChooser::Pair foot = pressed(post, -1, each_N);
            foot.is_load_known = is_known;
            chooser.add_contact(foot);
            chooser.add_contact(pressed(Beam, post, 1));
        }
        chooser.add_contact(pressed(Block, Beam, 1));
        return chooser.choose(1, 64).needed;
    };
    EXPECT_EQ(posts_carry(1000, false), posts_carry(4000, true));
}

TEST(SubstepChoice, LoadsOnPlatesMayAskForFourTimesTheMost) {
    const auto for_plate = [](Real load_N, int most) {
        SubstepChooser chooser;
        chooser.begin(1, kStep_s);
        chooser.set_body(0, 0, true);
        chooser.add_contact(pressed(0, -1, load_N));
        return chooser.choose(2, most).substeps;
    };
    EXPECT_EQ(for_plate(1, 16), 2);
    EXPECT_EQ(for_plate(1e9_r, 16), 64);
    EXPECT_EQ(for_plate(1e9_r, 4), 16);
    EXPECT_EQ(for_load(1e9, 1, 2, 16).substeps, 16);
}

TEST(SubstepChoice, JointsAskByTheirSpinAndTheirError) {
    const auto of_joint = [](Real spin_radps, Real error) {
        SubstepChooser chooser;
        chooser.begin(2, kStep_s);
        chooser.add_joint(spin_radps, error);
        return chooser.choose(2, 64);
    };
    EXPECT_EQ(of_joint(0, 0).reason, SubstepReason::Least);
    EXPECT_EQ(of_joint(60, 0).reason, SubstepReason::Turning);
    EXPECT_EQ(of_joint(0, 0.1_r).reason, SubstepReason::Error);
    int before = 2;
    for (Real spin = 1; spin < 300; spin *= 1.2_r) {
        EXPECT_GE(of_joint(spin, 0).substeps, before);
        before = of_joint(spin, 0).substeps;
    }
    before = 2;
    for (Real error = 1e-4_r; error < 0.1_r; error *= 1.2_r) {
        EXPECT_GE(of_joint(0, error).substeps, before);
        before = of_joint(0, error).substeps;
    }
}

TEST(SubstepChoice, AtLeastFourWhereContactsPressOnJointedBodies) {
    for (const bool jointed : {false, true}) {
        for (const bool touching : {false, true}) {
            SubstepChooser chooser;
            chooser.begin(2, kStep_s);
            if (jointed) chooser.add_joint(0, 0);
            if (touching) chooser.add_contact(pressed(0, -1, 1e-3_r));
            EXPECT_EQ(chooser.choose(1, 64).substeps, jointed && touching ? 4 : 1);
        }
    }
}

TEST(SubstepChoice, BeginForgetsTheIslandBefore) {
    SubstepChooser chooser;
    chooser.begin(1, kStep_s);
    chooser.add_contact(pressed(0, -1, 1e6_r));
    chooser.add_joint(100, 1);
    EXPECT_GT(chooser.choose(1, 64).substeps, 1);
    chooser.begin(1, kStep_s);
    EXPECT_EQ(chooser.choose(1, 64).substeps, 1);
}

TEST(SubstepChoice, ReasonsHaveNamesOfTheirOwn) {
    std::set<std::string_view> names;
    for (int i = 0; i <= static_cast<int>(SubstepReason::Held); ++i)
        names.insert(reason_name(static_cast<SubstepReason>(i)));
    EXPECT_EQ(names.size(), 9U);
    EXPECT_EQ(names.count(""), 0U);
    EXPECT_EQ(reason_name(SubstepReason::Least), "least");
    EXPECT_EQ(reason_name(SubstepReason::Held), "held");
}

TEST(SubstepChoice, BodiesSagAsLittleAsWasForetold) {
    // A metre cube pressed by many times its weight: not deeper than 1.5 mm with what is chosen, and
    // deeper with half as many.
    for (double accel_mps2 : {100.0, 400.0, 1500.0, 5000.0}) {
        const int chosen = for_load(accel_mps2, 1).substeps;
        const auto sag_with = [&](int substeps) {
            ContactRig rig;
            rig.settings.substeps = substeps;
            rig.gravity_mps2 = Vec3d(0, -accel_mps2, 0);
            const std::uint32_t box =
                rig.add_box(1, Vec3d(0.5), Vec3d(0, 0.5 - sag_of(accel_mps2, kStep_s, true), 0));
            rig.put_on_floor(box, {});
            rig.steps(120);
            return 0.5 - rig.position(box).y;
        };
        EXPECT_LE(sag_with(chosen), 1.5e-3 * 1.01) << accel_mps2;
        EXPECT_GT(sag_with(std::max(chosen / 2, 1)), 1.5e-3) << accel_mps2;
        EXPECT_NEAR(sag_with(chosen) / sag_of(accel_mps2, kStep_s / chosen, true), 1, 0.01);
    }
}

}  // namespace
}  // namespace plumbline::physics
