// Chains, closed loops and redundant joints.
#include "tests/engine/physics/dynamics/joint/joint_rig.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::physics {
namespace {

constexpr double kLink_m = 0.4;
constexpr double kBall_kg = 100;

/// Links of 1 kg and 0.4 m from a fixed point, with a ball of 100 kg at their end.
struct Chain : JointRig {
    int links{50};
    double length_m{0};

    Chain(const Vec3d& direction, int count) : links(count), length_m(count * kLink_m) {
        const Quatd along = glm::angleAxis(std::atan2(direction.y, direction.x), Vec3d{0, 0, 1});
        const Vec3d inertia{0.005 / 3, 0.17 / 12, 0.17 / 12};
        std::uint32_t last = 0;
        Vec3d end{0, 0, 0};
        for (int i = 0; i < links; ++i) {
            const std::uint32_t link = add_body(1, inertia, end + direction * (kLink_m / 2), along);
            join(link, last, end);
            end += direction * kLink_m;
            last = link;
        }
        const std::uint32_t ball = add_ball_body(kBall_kg, 0.25, end + direction * 0.25);
        join(ball, last, end);
    }
    void join(std::uint32_t a, std::uint32_t b, const Vec3d& at) {
        place_anchors(add_ball(a, b, at), at, at);
    }
    double weight_N() const { return (kBall_kg + links) * kG; }
};

TEST(JointChain, HangingHeavyChainDoesNotStretch) {
    for (const int substeps : {1, 2, 4, 8}) {
        Chain chain({0, -1, 0}, 50);
        double worst_m = 0;
        for (int i = 0; i < 1200; ++i) {
            chain.step(kFrame_s, substeps);
            worst_m = std::max(worst_m, chain.sum_of_errors());
        }
        EXPECT_LT(worst_m / chain.length_m, 1e-9) << substeps;
        EXPECT_LT(chain.max_speed(), 1e-4) << substeps;
        EXPECT_NEAR(glm::length(chain.joints[0].total_impulse_Ns) / kFrame_s,
                    chain.weight_N(),
                    1e-5 * chain.weight_N());
        EXPECT_NEAR(glm::length(chain.joints[50].total_impulse_Ns) / kFrame_s, kBall_kg * kG, 0.01);
    }
}

TEST(JointChain, ThousandfoldLoadOnLightLinks) {
    Chain chain({0, -1, 0}, 50);
    SolverBody& ball = chain.bodies[51];
    ball.inverse_mass /= 10;
    ball.inertia_kgm2 *= 10.0;
    chain.run(5, kFrame_s, 4);
    EXPECT_LT(chain.sum_of_errors() / chain.length_m, 1e-7);
    EXPECT_NEAR(glm::length(chain.joints[0].total_impulse_Ns) / kFrame_s, 1050 * kG, 0.1);
}

TEST(JointChain, SwungChainNeitherStretchesNorGainsEnergy) {
    for (const int substeps : {1, 2, 4, 8}) {
        Chain chain({1, 0, 0}, 50);
        const double start_J = chain.energy();
        const double scale_J = chain.length_m * chain.weight_N();
        double worst_m = 0;
        double gained_J = 0;
        double lost_early_J = 0;
        for (int i = 0; i < 1200; ++i) {
            chain.step(kFrame_s, substeps);
            worst_m = std::max(worst_m, chain.sum_of_errors());
            gained_J = std::max(gained_J, chain.energy() - start_J);
            // The first swing there and back; later the chain folds and snaps straight.
            if (i < 360) lost_early_J = std::max(lost_early_J, start_J - chain.energy());
        }
        EXPECT_LT(worst_m / chain.length_m, 1e-4) << substeps;
        EXPECT_LT(gained_J / scale_J, 1e-3) << substeps;
        if (substeps >= 4) {
            EXPECT_LT(lost_early_J / scale_J, 1e-3) << substeps;
        }
    }
}

TEST(JointChain, CatenaryHasItsSagAndReactions) {
    const double pull_N = 33.089237;
    const double rod_m = 0.2;
    JointRig rig;
    Vec3d end{0, 0, 0};
    std::uint32_t last = 0;
    for (int i = 0; i < 10; ++i) {
        const double slope = std::atan((i - 4.5) * kG / pull_N);
        const Vec3d along{std::cos(slope), std::sin(slope), 0};
        const std::uint32_t rod = rig.add_body(1,
                                               {1e-5, rod_m * rod_m / 12, rod_m * rod_m / 12},
                                               end + along * (rod_m / 2),
                                               glm::angleAxis(slope, Vec3d{0, 0, 1}));
        rig.place_anchors(rig.add_ball(rod, last, end), end, end);
        end += along * rod_m;
        last = rod;
    }
    EXPECT_NEAR(end.x, 1.6, 1e-8);
    rig.place_anchors(rig.add_ball(last, 0, end), end, {1.6, 0, 0});
    rig.run(5, kFrame_s, 4);
    const double lowest = (rig.position(5) + rig.orientation(5) * Vec3d{rod_m / 2, 0, 0}).y;
    EXPECT_NEAR(lowest, -0.5337289, 2e-7);
    const Vec3d reaction = rig.joints[0].total_impulse_Ns / kFrame_s;
    EXPECT_NEAR(glm::length(reaction), 59.167560, 2e-5);
    EXPECT_NEAR(reaction.y, 49.05, 2e-5);
    EXPECT_LT(rig.max_error(), 1e-9);
}

/// Two cranks of 1 m and a bar of 2 m between them, on hinges: one row in each of the directions
/// out of the plane is more than needed.
struct FourBar : JointRig {
    explicit FourBar(double crank_rad) {
        const Vec3d crank{std::cos(crank_rad), std::sin(crank_rad), 0};
        const Vec3d right{2, 0, 0};
        const std::uint32_t a = rod({0, 0, 0}, crank);
        const std::uint32_t b = rod(crank, crank + right);
        const std::uint32_t c = rod(right, crank + right);
        hinge(a, 0, {0, 0, 0});
        hinge(b, a, crank);
        hinge(c, b, crank + right);
        hinge(c, 0, right);
    }
    std::uint32_t rod(const Vec3d& from, const Vec3d& to) {
        const Vec3d along = to - from;
        const double moment = glm::dot(along, along) / 12;
        return add_body(1,
                        {0.001, moment, moment},
                        (from + to) * 0.5,
                        glm::angleAxis(std::atan2(along.y, along.x), Vec3d{0, 0, 1}));
    }
    void hinge(std::uint32_t a, std::uint32_t b, const Vec3d& at) {
        SolverJoint& joint = add_joint(
            a, b, {.kind = JointKind::Hinge, .anchor_a_world = Vec3(at), .axis_world = {0, 0, 1}});
        place_anchors(joint, at, at);
    }
};

TEST(JointLoop, FourBarRestsWithoutBuzzing) {
    for (const Kick kick : {Kick::Halves, Kick::Steady}) {
        FourBar bars(-glm::half_pi<double>());
        bars.kick = kick;
        bars.run(3, kFrame_s, 4);
        EXPECT_LT(bars.max_speed(), 1e-6);
        EXPECT_LT(bars.max_error(), 1e-9);
    }
}

TEST(JointLoop, FourBarSwingsAsThePendulumItIs) {
    // A parallelogram: cranks turn about their ends, the bar only moves along. Effective inertia
    // 2/3 + 1, weight at 2 * 1/2 + 1: as a pendulum of length 5/6.
    FourBar bars(-glm::half_pi<double>() + 0.01);
    double last = 1;
    double first_s = 0;
    double last_s = 0;
    int periods = -1;
    while (bars.time_s < 20) {
        bars.step(kFrame_s, 4);
        const double now = bars.position(2).x - 1;
        if (last > 0 && now <= 0) {
            last_s = bars.time_s - kFrame_s * now / (now - last);
            if (periods < 0) first_s = last_s;
            ++periods;
        }
        last = now;
    }
    const double exact_s = 2 * glm::pi<double>() * std::sqrt(5.0 / 6 / kG) * (1 + 0.01 * 0.01 / 16);
    EXPECT_NEAR((last_s - first_s) / periods / exact_s, 1, 1e-4);
    EXPECT_NEAR(bars.position(1).z, 0, 1e-9);
    EXPECT_LT(bars.max_error(), 1e-8);
}

struct Door : JointRig {
    std::uint32_t leaf{0};

    Door() {
        leaf = add_body(20, {20 * 4.0016 / 12, 20 * 1.0016 / 12, 20 * 5.0 / 12}, {0.5, 1, 0});
    }
    SolverJoint& hinge(const Vec3& at, const Vec3d& axis = {0, 1, 0}) {
        return add_joint(leaf,
                         0,
                         {.kind = JointKind::Hinge,
                          .anchor_a_world = at,
                          .axis_world = Vec3(glm::normalize(axis))});
    }
};

TEST(JointLoop, DoorOnTwoHingesHangsStillAndSwingsFreely) {
    Door door;
    door.hinge({0, 0.2_r, 0});
    door.hinge({0, 1.8_r, 0});
    door.run(3, kFrame_s, 4);
    EXPECT_LT(door.max_speed(), 1e-6);
    // Each carries its half.
    EXPECT_NEAR(door.joints[0].total_impulse_Ns.y / kFrame_s, 10 * kG, 0.1);
    EXPECT_NEAR(door.joints[1].total_impulse_Ns.y / kFrame_s, 10 * kG, 0.1);
    door.bodies[door.leaf].spin_radps = {0, 2, 0};
    door.bodies[door.leaf].velocity_mps = {0, 0, -1};
    door.run(5, kFrame_s, 4);
    EXPECT_NEAR(door.spin(door.leaf).y, 2, 1e-5);
    EXPECT_LT(door.max_error(), 1e-9);
}

TEST(JointLoop, MisalignedHingesJamWithoutBuzzing) {
    Door door;
    door.hinge({0, 0.2_r, 0});
    door.hinge({0.001_r, 1.8_r, 0}, {std::sin(0.5 * glm::pi<double>() / 180), 1, 0});
    door.bodies[door.leaf].spin_radps = {0, 2, 0};
    door.bodies[door.leaf].velocity_mps = {0, 0, -1};
    door.run(1, kFrame_s, 4);
    double worst = 0;
    for (int i = 0; i < 300; ++i) {
        door.step(kFrame_s, 4);
        worst = std::max(worst, door.max_speed());
    }
    EXPECT_LT(worst, 1e-6);
}

TEST(JointLoop, LoopThatCannotCloseStaysCalm) {
    // A rod of 1 m between anchors 1.01 m apart: neither can be right.
    JointRig rig;
    const std::uint32_t rod = rig.add_body(1, {0.001, 0.1, 0.1}, {0.5, 0, 0});
    rig.place_anchors(rig.add_ball(rod, 0, {0, 0, 0}), {0, 0, 0}, {0, 0, 0});
    rig.place_anchors(rig.add_ball(rod, 0, {1, 0, 0}), {1, 0, 0}, {1.01, 0, 0});
    double worst = 0;
    for (int i = 0; i < 600; ++i) {
        rig.step(kFrame_s, 4);
        if (i > 300) worst = std::max(worst, rig.max_speed());
    }
    EXPECT_LT(worst, 1e-3);
    EXPECT_NEAR(rig.position(rod).x, 0.505, 1e-3);
}

}  // namespace
}  // namespace plumbline::physics
