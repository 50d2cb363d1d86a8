#include "engine/physics/dynamics/impact/impact_pass.h"

#include "tests/engine/physics/dynamics/contact/contact_rig.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace plumbline::physics {
namespace {

ContactRig contacts_afloat() {
    ContactRig rig;
    rig.settings.gravity_mps2 = 0;
    rig.gravity_mps2 = Vec3d{0, 0, 0};
    return rig;
}

TEST(ImpactPass, TwoBallsPartAsMomentumAndRestitutionSay) {
    for (double ratio : {1.0, 2.0, 10.0, 100.0, 1000.0}) {
        for (double e : {0.0, 0.5, 1.0}) {
            ContactRig rig = contacts_afloat();
            const std::uint32_t a = rig.add_ball(ratio, 0.5, Vec3d(0.5, 0, 0));
            const std::uint32_t b = rig.add_ball(1, 0.5, Vec3d(-0.5, 0, 0));
            rig.let_balls_meet(a, b, {.restitution = e});
            rig.set_velocity(a, Vec3d(-2, 0, 0));
            rig.set_velocity(b, Vec3d(3, 0, 0));
            rig.step();
            const double centre_mps = (-2 * ratio + 3) / (ratio + 1);
            const double tolerance = by_precision(5e-6, 1e-12);
            EXPECT_NEAR(rig.velocity(a).x, centre_mps + 5 * e / (ratio + 1), tolerance);
            EXPECT_NEAR(rig.velocity(b).x, centre_mps - 5 * e * ratio / (ratio + 1), tolerance);
            EXPECT_NEAR(rig.pressed_Ns(0), (1 + e) * 5 * ratio / (ratio + 1), 5 * tolerance);
        }
    }
}

TEST(ImpactPass, ElasticBlowsKeepEnergyAndMomentum) {
    for (double off_line : {0.0, 0.2, 0.4, 0.6}) {
        ContactRig rig = contacts_afloat();
        const std::uint32_t a =
            rig.add_ball(3, 0.5, Vec3d(std::sqrt(1 - off_line * off_line), off_line, 0));
        const std::uint32_t b = rig.add_ball(1, 0.5, Vec3d(0, 0, 0));
        rig.let_balls_meet(a, b, {.restitution = 1});
        rig.set_velocity(a, Vec3d(-4, 0, 0.5));
        rig.set_velocity(b, Vec3d(1, 0, 0));
        const double energy_J = rig.energy(a) + rig.energy(b);
        const Vec3d momentum = 3.0 * rig.velocity(a) + rig.velocity(b);
        rig.step();
        EXPECT_NEAR((rig.energy(a) + rig.energy(b)) / energy_J, 1, by_precision(1e-6, 1e-13));
        EXPECT_LT(glm::length(3.0 * rig.velocity(a) + rig.velocity(b) - momentum),
                  by_precision(1e-5, 1e-13));
    }
}

TEST(ImpactPass, SlowBlowsDoNotBounce) {
    ContactRig rig;
    rig.settings.substeps = 4;
    const std::uint32_t sphere = rig.add_ball(1, 0.5, Vec3d(0, 0.5, 0));
    rig.put_on_floor(sphere, {.restitution = 1});
    EXPECT_EQ(rig.step().impacts, 0U);
    // Slower than a fall of two sub-steps.
    rig.set_velocity(sphere, Vec3d(0, -1.9 * kFall_mps2 * kStep_s / 4, 0));
    EXPECT_EQ(rig.step().impacts, 0U);
    EXPECT_LT(rig.velocity(sphere).y, 1e-3);
    rig.set_velocity(sphere, Vec3d(0, -1, 0));
    EXPECT_GT(rig.step().impacts, 0U);
}

TEST(ImpactPass, NothingToDoWithoutRestitution) {
    ContactRig rig;
    const std::uint32_t sphere = rig.add_ball(1, 0.5, Vec3d(0, 0.5, 0));
    rig.put_on_floor(sphere, {});
    rig.set_velocity(sphere, Vec3d(0, -5, 0));
    EXPECT_EQ(rig.step().impacts, 0U);
    EXPECT_NEAR(rig.velocity(sphere).y, 0, by_precision(1e-5, 1e-12));
}

class Bouncing : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Substeps, Bouncing, testing::Values(1, 4, 16));

TEST_P(Bouncing, ABallIsWhereTheBounceAtTheSurfacePutsIt) {
    for (double e : {0.5, 0.8, 1.0}) {
        for (double gap_m : {0.001, 0.01, 0.03, 0.06}) {
            ContactRig rig;
            rig.settings.substeps = GetParam();
            const std::uint32_t sphere = rig.add_ball(2, 0.5, Vec3d(0, 0.5 + gap_m, 0));
            rig.put_on_floor(sphere, {.restitution = e});
            rig.set_velocity(sphere, Vec3d(0, -4, 0));
            rig.step();
            const double hit_mps = std::sqrt(16 + 2 * kFall_mps2 * gap_m);
            const double left_s = kStep_s - (hit_mps - 4) / kFall_mps2;
            const double up_mps = e * hit_mps;
            EXPECT_NEAR(rig.velocity(sphere).y, up_mps - kFall_mps2 * left_s, 1e-5);
            EXPECT_NEAR(rig.position(sphere).y,
                        0.5 + up_mps * left_s - kFall_mps2 * left_s * left_s / 2,
                        1e-5)
                << e << " from " << gap_m;
        }
    }
}

TEST_P(Bouncing, AHundredElasticBouncesReachTheSameHeight) {
    ContactRig rig;
    rig.settings.substeps = GetParam();
    const std::uint32_t sphere = rig.add_ball(1, 0.5, Vec3d(0, 1.5, 0));
    rig.put_on_floor(sphere, {.restitution = 1});
    int bounces = 0;
    double apex_m = 0;
    while (bounces < 100) {
        const double before_mps = rig.velocity(sphere).y;
        rig.step();
        const double after_mps = rig.velocity(sphere).y;
        if (before_mps < 0 && after_mps > 0) ++bounces;
        apex_m = rig.position(sphere).y + after_mps * after_mps / (2 * kFall_mps2);
        ASSERT_NEAR(apex_m, 1.5, by_precision(5e-5, 1e-12)) << "after " << bounces;
    }
}

TEST_P(Bouncing, ABoxThatFallsFlatKeepsItsEnergy) {
    ContactRig rig;
    rig.settings.substeps = GetParam();
    const std::uint32_t box = rig.add_box(2, Vec3d(0.5, 0.25, 0.4), Vec3d(0, 1.25, 0));
    rig.put_on_floor(box, {.restitution = 1});
    const double energy_J = rig.energy(box);
    int bounces = 0;
    while (bounces < 10) {
        const double before_mps = rig.velocity(box).y;
        rig.step();
        if (before_mps < 0 && rig.velocity(box).y > 0) ++bounces;
        ASSERT_NEAR(rig.energy(box) / energy_J, 1, by_precision(2e-5, 1e-8)) << bounces;
    }
    EXPECT_LT(glm::length(rig.spin(box)), 1e-3);
}

TEST_P(Bouncing, ABoxThatTumblesGainsNoEnergy) {
    for (double friction : {0.0, 0.5}) {
        ContactRig rig;
        rig.settings.substeps = GetParam();
        const std::uint32_t box = rig.add_box(2, Vec3d(0.5, 0.25, 0.4), Vec3d(0, 1.25, 0));
        rig.put_on_floor(box, {.friction = friction, .restitution = 1});
        rig.loop.bodies[box].start_orientation =
            glm::angleAxis(0.3, glm::normalize(Vec3d(1, 0, 0.4)));
        const double energy_J = rig.energy(box);
        for (int i = 0; i < 60; ++i) {
            rig.step();
            const double share = rig.energy(box) / energy_J;
            EXPECT_LE(share, 1 + by_precision(2e-5, 1e-6)) << i;
            // Corners that are met off the surface cost a little.
            if (friction == 0) {
                EXPECT_GE(share, 0.995) << i;
            }
        }
    }
}

TEST_P(Bouncing, EachBounceLosesWhatRestitutionTakes) {
    ContactRig rig;
    rig.settings.substeps = GetParam();
    const std::uint32_t sphere = rig.add_ball(1, 0.5, Vec3d(0, 1.5, 0));
    rig.put_on_floor(sphere, {.restitution = 0.8});
    double height_m = 1;
    for (int bounce = 0; bounce < 5; ++bounce) {
        height_m *= 0.64;
        double before_mps = 0;
        do {
            before_mps = rig.velocity(sphere).y;
            rig.step();
        } while (before_mps >= 0 || rig.velocity(sphere).y <= 0);
        const double up_mps = rig.velocity(sphere).y;
        const double apex_m = rig.position(sphere).y - 0.5 + up_mps * up_mps / (2 * kFall_mps2);
        EXPECT_NEAR(apex_m / height_m, 1, by_precision(1e-4, 1e-9)) << bounce;
    }
}

TEST_P(Bouncing, ASpinningBallObeysCoulombsLaw) {
    // Rigid impact with friction: sticks where mu (1 + e) v_n >= 2/7 of the slip, slides elsewhere.
    const double radius_m = 0.3;
    const double down_mps = 5;
    for (double mu : {0.1, 0.3, 0.8}) {
        for (double e : {0.5, 0.7, 1.0}) {
            for (int i = 0; i < 24; ++i) {
                const double azimuth = 2 * 3.14159265358979323846 * i / 24;
                const Vec3d ahead{std::cos(azimuth), 0, std::sin(azimuth)};
                const Vec3d axis = glm::cross(Vec3d(0, 1, 0), ahead);  // rolls ahead
                for (double spin_radps : {-20.0, 0.0, 10.0}) {
                    const double along_mps = 3;
                    ContactRig rig = contacts_afloat();
                    rig.settings.substeps = GetParam();
                    const std::uint32_t sphere = rig.add_ball(1.5, radius_m, Vec3d(0, radius_m, 0));
                    rig.put_on_floor(sphere, {.friction = mu, .restitution = e});
                    rig.set_velocity(
                        sphere, along_mps * ahead - Vec3d(0, down_mps, 0), spin_radps * axis);
                    rig.step();
                    const double slip_mps = along_mps - radius_m * spin_radps;
                    const double most_mps = mu * (1 + e) * down_mps;
                    const double slower_mps =
                        std::copysign(std::min(most_mps, 2.0 / 7 * std::abs(slip_mps)), slip_mps);
                    const Vec3d velocity =
                        (along_mps - slower_mps) * ahead + Vec3d(0, e * down_mps, 0);
                    const Vec3d spin = (spin_radps + 2.5 * slower_mps / radius_m) * axis;
                    EXPECT_LT(glm::length(rig.velocity(sphere) - velocity),
                              by_precision(1e-5, 1e-12))
                        << mu << ' ' << e << ' ' << i << ' ' << spin_radps;
                    EXPECT_LT(glm::length(rig.spin(sphere) - spin), by_precision(1e-4, 1e-11))
                        << mu << ' ' << e << ' ' << i << ' ' << spin_radps;
                }
            }
        }
    }
}

TEST_P(Bouncing, ARowOfBallsHandsTheBlowOn) {
    ContactRig rig = contacts_afloat();
    rig.settings.substeps = GetParam();
    std::vector<std::uint32_t> spheres;
    for (int i = 0; i < 5; ++i) spheres.push_back(rig.add_ball(1, 0.5, Vec3d(i, 0, 0)));
    for (std::size_t i = 1; i < 5; ++i)
        rig.let_balls_meet(spheres[i], spheres[i - 1], {.restitution = 1});
    rig.set_velocity(spheres[0], Vec3d(2, 0, 0));
    rig.steps(2);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(rig.velocity(spheres[i]).x, 0, 1e-4) << i;
    EXPECT_NEAR(rig.velocity(spheres[4]).x, 2, 1e-4);
}

}  // namespace
}  // namespace plumbline::physics
