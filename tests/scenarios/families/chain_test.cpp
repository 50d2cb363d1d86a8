// Many joints in a row or in a net: H26, H28, H30, H31, H44.
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
    const std::vector<JointId> joints = hang_chain(world, links, 100, JointKind::Ball);
    const Watch seen = watch(world, seconds, seconds / 2);
    EXPECT_TRUE(seen.finite);
    expect_at_most(row + " stretch", std::abs(stretch(world, links)), 1e-5);
    expect_at_most(row + " speed m/s", seen.speed_mps, 0.01);
    double off = 0;
    for (std::size_t i = 0; i < joints.size(); ++i) {
        const double weight_N = kG_mps2 * (100 + static_cast<double>(joints.size() - 1 - i));
        off = std::max(
            off,
            std::abs(static_cast<double>(world.physics.joint_state(joints[i]).force_N) / weight_N -
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

TEST(Chain, H26AChainSwungKeepsItsLength) {
    constexpr int kLinks = 10;
    ScenarioWorld world(balanced());
    BodyId before{};
    for (int i = 0; i < kLinks; ++i) {
        const BodyId link =
            world.box({0.5 + i, 0, 0}, {1, 0.1, 0.1}, {.mass_kg = i + 1 == kLinks ? 100.0 : 1.0});
        world.join({.kind = JointKind::Ball,
                    .a = link,
                    .b = before,
                    .anchor_a_world = vec(i, 0, 0),
                    .anchor_b_world = vec(i, 0, 0)});
        before = link;
    }
    const double start_J = world.energy_J();
    double gap_m = 0;
    double gain_J = 0;
    for (int i = 0; i < 600; ++i) {
        world.physics.step();
        gap_m = std::max(gap_m, world.physics.max_joint_error_m());
        gain_J = std::max(gain_J, world.energy_J() - start_J);
    }
    expect_at_most("H26 10 links swung, gap m", gap_m, 5e-3);
    // Of the fall by its length.
    expect_at_most("H26 10 links swung, energy gain", gain_J / (100 * kG_mps2 * kLinks), 0.01);
}

/// Planks of 1 m hinged into a shallow arc between two walls, and 500 kg that fall on its middle.
TEST(Chain, H30ABridgeCatchesAHeavyBox) {
    constexpr int kPlanks = 160;
    constexpr double kSpread_rad = 0.6;  // of the arc to either side: 6 % of slack
    const double radius_m = kPlanks / (2 * kSpread_rad);
    ScenarioWorld world(balanced());
    std::vector<JointId> joints;
    BodyId before{};
    const auto hinge = [&](BodyId a, BodyId b, double angle) {
        const Vec3 at = vec(radius_m * std::sin(angle), -radius_m * std::cos(angle), 0);
        return world.join({.kind = JointKind::Hinge,
                           .a = a,
                           .b = b,
                           .anchor_a_world = at,
                           .anchor_b_world = at,
                           .axis_world = {0, 0, 1}});
    };
    for (int i = 0; i < kPlanks; ++i) {
        const double angle = kSpread_rad * (2 * (i + 0.5) / kPlanks - 1);
        const BodyId plank =
            world.box({radius_m * std::sin(angle), -radius_m * std::cos(angle), 0},
                      {0.98, 0.25, 2},
                      {.mass_kg = 5, .turn = glm::angleAxis(angle, Vec3d{0, 0, 1})});
        joints.push_back(hinge(plank, before, kSpread_rad * (2.0 * i / kPlanks - 1)));
        before = plank;
    }
    joints.push_back(hinge(before, {}, kSpread_rad));
    world.run(2);
    const double middle_m = world.at(world.movers[kPlanks / 2]).y;
    const BodyId load = world.box({0, middle_m + 0.125 + 0.5 + 2, 0}, {1, 1, 1}, {.mass_kg = 500});
    double gap_m = 0;
    double steepest = 1;
    for (int i = 0; i < 360; ++i) {
        world.physics.step();
        gap_m = std::max(gap_m, world.physics.max_joint_error_m());
        for (int k = 0; k < kPlanks; ++k) {
            const Vec3d up = world.turn(world.movers[static_cast<std::size_t>(k)]) * Vec3d{0, 1, 0};
            steepest = std::min(steepest, up.y);
        }
    }
    EXPECT_TRUE(all_finite(world));
    expect_at_most("H30 bridge, hinge gap m", gap_m, 0.05);
    EXPECT_GT(steepest, 0) << "a plank turned over";
    EXPECT_LT(glm::distance(world.at(load), world.at(world.movers[kPlanks / 2])), 8)
        << "it fell through";
}

/// A net of balls held along one edge and let swing.
void expect_net(const std::string& row, int side, double seconds) {
    constexpr double kLink_m = 0.5;
    ScenarioWorld world(balanced());
    std::vector<std::vector<BodyId>> ball(static_cast<std::size_t>(side));
    const auto join = [&](BodyId a, BodyId b, const Vec3d& at_a, const Vec3d& at_b) {
        world.join({.kind = JointKind::Ball,
                    .a = a,
                    .b = b,
                    .anchor_a_world = Vec3((at_a + at_b) * 0.5),
                    .anchor_b_world = Vec3((at_a + at_b) * 0.5)});
    };
    for (int x = 0; x < side; ++x) {
        for (int z = 0; z < side; ++z) {
            const Vec3d at{kLink_m * x, 0, kLink_m * z};
            const auto column = static_cast<std::size_t>(x);
            ball[column].push_back(world.ball(at, 0.1));
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
    const int steps = steps_of(world, seconds);
    for (int i = 0; i < steps; ++i) {
        world.physics.step();
        gap_m = std::max(gap_m, world.physics.max_joint_error_m());
        top = std::max(top, top_speed_mps(world));
    }
    EXPECT_TRUE(all_finite(world));
    expect_at_most(row + " gap, share of a link", gap_m / kLink_m, 0.02);
    expect_at_most(row + " speed m/s", top, 100);
}
TEST(Chain, H31ANetSwingsAndHolds) {
    expect_net("H31 net 10 x 10", 10, 5);
}
TEST(Chain, H31ALargeNetSwingsAndHolds) {
    expect_net("H31 net 40 x 40", 40, 0.25);
}

TEST(Chain, H44ASnappedChainRecovers) {
    ScenarioWorld world(balanced());
    hang_chain(world, 10, 1, JointKind::Ball);
    world.run(1);
    world.physics.set_pose(world.movers[5], {vec(100, 0, 0), kNoRotation});
    double top = 0;
    double gap_m = 0;
    for (int i = 0; i < 300; ++i) {
        world.physics.step();
        top = std::max(top, top_speed_mps(world));
        if (i == 0) gap_m = world.physics.max_joint_error_m();
    }
    EXPECT_TRUE(all_finite(world));
    note("H44 gap a frame after the snap m", gap_m);
    // A fall of the 100 m would give 44 m/s.
    expect_at_most("H44 top speed m/s", top, 30);
    expect_at_most("H44 gap after 5 s m", world.physics.max_joint_error_m(), 0.01);
}

}  // namespace
}  // namespace plumbline::study
