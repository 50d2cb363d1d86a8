// Many joints in a row or in a net, beside what the scenes H26, H28 and H31b have.
#include "engine/physics/totals.h"
#include "tests/scenarios/families/case_run.h"

namespace plumbline::study {
namespace {

/// Links of 1 m hanging straight down from (0, 0, 0), the last of mass `end_kg`.
std::vector<JointId> hang_chain(ScenarioWorld& world, int links, double end_kg, JointKind kind) {
    std::vector<JointId> joints;
    BodyId above{};
    for (int i = 0; i < links; ++i) {
        const BodyId link =
            world.box({0, -0.5 - i, 0}, {0.1, 1, 0.1}, {.mass_kg = i + 1 == links ? end_kg : 1});
        const Vec3 anchor = vec(0, -i, 0);
        joints.push_back(world.join({.kind = kind,
                                     .a = link,
                                     .b = above,
                                     .anchor_a_world = anchor,
                                     .anchor_b_world = anchor,
                                     .axis_world = {0, 0, 1}}));
        above = link;
    }
    return joints;
}

double stretch(const ScenarioWorld& world, int links) {
    return (-world.at(world.movers.back()).y - (links - 0.5)) / links;
}

void expect_chain(const std::string& row, int links, double seconds) {
    ScenarioWorld world(balanced());
    const std::vector<JointId> joints = hang_chain(world, links, 100, JointKind::BallAndSocket);
    const Watch seen = watch(world, seconds, seconds / 2);
    EXPECT_TRUE(seen.finite);
    expect_at_most(row + " stretch", std::abs(stretch(world, links)), 1e-5);
    expect_at_most(row + " speed m/s", seen.speed_mps, 0.01);
    double off = 0;
    for (std::size_t i = 0; i < joints.size(); ++i) {
        const double weight_N = kG_mps2 * (100 + static_cast<double>(joints.size() - 1 - i));
        off = std::max(
            off,
            std::abs(static_cast<double>(world.physics.joint(joints[i]).state.force_N) / weight_N -
                     1));
    }
    expect_at_most(row + " force is the weight below", off, 0.01);
}
TEST(Chain, H26AChainOfTenHoldsAHundredfoldEnd) {
    expect_chain("H26 10 links", 10, 10);
}
TEST(Chain, H28AChainOfFiftyHoldsAHundredfoldEnd) {
    expect_chain("H28 50 links", 50, 10);
}

/// A chain that is let go level, its first end at (0, 0, 0) and the last link of mass `end_kg`.
void lay_chain(ScenarioWorld& world, int links, double link_m, double end_kg, bool touches) {
    BodyId before{};
    for (int i = 0; i < links; ++i) {
        const BodyId link =
            world.box({(0.5 + i) * link_m, 0, 0},
                      {link_m, 0.1, 0.1},
                      {.mass_kg = i + 1 == links ? end_kg : 1.0, .touches = touches});
        const Vec3 anchor = vec(i * link_m, 0, 0);
        world.join({.kind = JointKind::BallAndSocket,
                    .a = link,
                    .b = before,
                    .anchor_a_world = anchor,
                    .anchor_b_world = anchor});
        before = link;
    }
}

TEST(Chain, H26AChainSwungKeepsItsLength) {
    ScenarioWorld world(balanced());
    lay_chain(world, 10, 1, 100, true);
    const double start_J = world.energy_J();
    double gap_m = 0;
    double gain_J = 0;
    for (int i = 0; i < 600; ++i) {
        world.physics.step();
        gap_m = std::max(gap_m, max_joint_error_m(world.physics));
        gain_J = std::max(gain_J, world.energy_J() - start_J);
    }
    expect_at_most("H26 10 links swung, gap m", gap_m, 5e-3);
    // Of the fall by its length.
    expect_at_most("H26 10 links swung, energy gain", gain_J / (100 * kG_mps2 * 10), 0.01);
}

/// It swings over, falls slack and snaps: links of 1 kg turn at hundreds of rad/s under 100 kg.
TEST(Chain, SnapsAndKeepsItsEnergy) {
    constexpr int kLinks = 50;
    constexpr double kLink_m = 0.4;
    ScenarioWorld world(balanced());
    lay_chain(world, kLinks, kLink_m, 100, false);
    const double start_J = world.energy_J();
    const double fall_J = 100 * kG_mps2 * kLinks * kLink_m;
    double off = 0;
    double gap_m = 0;
    for (int i = 0; i < 1200; ++i) {
        world.physics.step();
        off = std::max(off, std::abs(world.energy_J() - start_J) / fall_J);
        gap_m = std::max(gap_m, max_joint_error_m(world.physics));
    }
    expect_at_most("50 links swung for 20 s, energy", off, 0.02);
    expect_at_most("50 links swung for 20 s, gap m", gap_m, 5e-3);
}

/// The first quarter of a second of H31b: a net of 40 x 40 balls held along one edge and let swing.
TEST(Chain, ALargeNetSwingsAndHolds) {
    constexpr int kSide = 40;
    constexpr double kLink_m = 0.5;
    ScenarioWorld world(balanced());
    std::vector<std::vector<BodyId>> ball(kSide);
    const auto join = [&](BodyId a, BodyId b, const Vec3d& at_a, const Vec3d& at_b) {
        world.join({.kind = JointKind::BallAndSocket,
                    .a = a,
                    .b = b,
                    .anchor_a_world = Vec3((at_a + at_b) * 0.5),
                    .anchor_b_world = Vec3((at_a + at_b) * 0.5)});
    };
    for (int x = 0; x < kSide; ++x) {
        for (int z = 0; z < kSide; ++z) {
            const Vec3d at{kLink_m * x, 0, kLink_m * z};
            const auto column = static_cast<std::size_t>(x);
            ball[column].push_back(world.sphere(at, 0.1));
            const BodyId here = ball[column].back();
            if (z > 0)
                join(here,
                     ball[column][static_cast<std::size_t>(z - 1)],
                     at,
                     at - Vec3d{0, 0, kLink_m});
            if (x > 0)
                join(here,
                     ball[column - 1][static_cast<std::size_t>(z)],
                     at,
                     at - Vec3d{kLink_m, 0, 0});
            if (x == 0) join(here, {}, at, at);
        }
    }
    double gap_m = 0;
    double top = 0;
    for (int i = 0; i < 15; ++i) {
        world.physics.step();
        gap_m = std::max(gap_m, max_joint_error_m(world.physics));
        top = std::max(top, top_speed_mps(world));
    }
    EXPECT_TRUE(all_finite(world));
    expect_at_most("net 40 x 40 gap, share of a link", gap_m / kLink_m, 0.02);
    expect_at_most("net 40 x 40 speed m/s", top, 100);
}

}  // namespace
}  // namespace plumbline::study
