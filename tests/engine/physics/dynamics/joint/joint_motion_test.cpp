// Single and double pendulums and tops against their closed forms and reference integrations.
#include "tests/engine/physics/dynamics/joint/joint_rig.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace plumbline::physics {
namespace {

/// Mean time between the moments at which the value falls through zero.
double period_of(JointRig& rig,
                 int substeps,
                 double until_s,
                 const std::function<double()>& value) {
    double last = value();
    double first_s = -1;
    double last_s = -1;
    int periods = 0;
    while (rig.time_s < until_s) {
        const double start_s = rig.time_s;
        rig.step(kFrame_s, substeps);
        const double now = value();
        if (last > 0 && now <= 0) {
            last_s = start_s + kFrame_s * last / (last - now);
            if (first_s < 0) {
                first_s = last_s;
            } else {
                ++periods;
            }
        }
        last = now;
    }
    return (last_s - first_s) / periods;
}

double angle_from_down(const Vec3d& v) {
    return std::atan2(v.x, -v.y);
}

/// Two point masses on two rods of 1 m, let go horizontally.
struct DoublePendulum : JointRig {
    std::uint32_t inner{0};
    std::uint32_t outer{0};

    DoublePendulum() {
        inner = add_body(1, Vec3d(0), {1, 0, 0});
        outer = add_body(1, Vec3d(0), {2, 0, 0});
        rod(inner, 0, {1, 0, 0}, {0, 0, 0});
        rod(outer, inner, {2, 0, 0}, {1, 0, 0});
    }
    void rod(std::uint32_t a, std::uint32_t b, const Vec3& at_a, const Vec3& at_b) {
        add_joint(
            a, b, {.kind = JointKind::Distance, .anchor_a_world = at_a, .anchor_b_world = at_b});
    }
    /// Error of the two angles after 3 s; the reference agrees with two integrators to 1e-7.
    double error() const {
        const double first = angle_from_down(position(inner)) - 1.7857955;
        const double second = angle_from_down(position(outer) - position(inner)) - 1.1181075;
        return std::max(std::abs(first), std::abs(second));
    }
};

class JointMotionBothKicks : public testing::TestWithParam<Kick> {};
INSTANTIATE_TEST_SUITE_P(Kicks, JointMotionBothKicks, testing::Values(Kick::Halves, Kick::Steady));

TEST_P(JointMotionBothKicks, DoublePendulumEndsWhereTheReferenceDoes) {
    DoublePendulum pendulum;
    pendulum.kick = GetParam();
    pendulum.run(3, kFrame_s, 4);
    EXPECT_LT(pendulum.error(), 5e-4);
    EXPECT_NEAR(pendulum.energy(), 0, kFloat32 ? 1e-3 : 1e-5);
    EXPECT_LT(pendulum.max_error(), 1e-8);
}

TEST_P(JointMotionBothKicks, DoublePendulumIsSecondOrder) {
    double before = 0;
    for (const int substeps : {1, 2, 4, 8}) {
        DoublePendulum pendulum;
        pendulum.kick = GetParam();
        pendulum.run(3, kFrame_s, substeps);
        if (before > 0) {
            EXPECT_NEAR(before / pendulum.error(), 4, kFloat32 ? 0.6 : 0.1);
        }
        before = pendulum.error();
    }
}

TEST(JointMotion, DoublePendulumKeepsItsEnergyForAMinute) {
    DoublePendulum pendulum;
    double worst = 0;
    double mean = 0;
    for (int i = 0; i < 3600; ++i) {
        pendulum.step(kFrame_s, 4);
        worst = std::max(worst, std::abs(pendulum.energy()));
        if (i >= 3300) mean += pendulum.energy() / 300;
    }
    // Shares of m g L. In the wildest whips the energy shows the error of the step; it comes back.
    EXPECT_LT(worst / kG, 4e-3);
    EXPECT_NEAR(mean / kG, 0, 1e-3);
}

TEST(JointMotion, PendulumFrom90DegreesHasItsPeriod) {
    JointRig rig;
    const std::uint32_t ball = rig.add_ball_body(1, 0.05, {1, 0, 0});
    rig.add_ball(ball, 0, {0, 0, 0});
    const double period_s = period_of(rig, 4, 20, [&] { return rig.position(ball).x; });
    EXPECT_NEAR(period_s / 2.36903, 1, 4e-5);
    EXPECT_LT(rig.max_error(), 1e-9);
    EXPECT_NEAR(rig.energy(), 0, kFloat32 ? 1e-3 : 1e-4);
}

TEST(JointMotion, RodPendulumHasItsPeriodAndStaysInItsPlane) {
    JointRig rig;
    const Quatd lying = glm::angleAxis(-glm::half_pi<double>(), Vec3d{0, 0, 1});
    const std::uint32_t rod = rig.add_body(1, {1.0 / 12, 1e-6, 1.0 / 12}, {0.5, 0, 0}, lying);
    rig.add_joint(rod, 0, {.kind = JointKind::Hinge, .axis_world = {0, 0, 1}});
    const double period_s = period_of(rig, 4, 20, [&] { return rig.position(rod).x; });
    EXPECT_NEAR(period_s / 1.9333349, 1, 5e-5);
    EXPECT_LT(rig.max_error(), 1e-9);
    EXPECT_NEAR(rig.position(rod).z, 0, 1e-12);
}

TEST(JointMotion, ConicalPendulumKeepsItsConeForAMinute) {
    const double tilt = std::numbers::pi / 6;
    const double rate = 2 * std::numbers::pi / 1.8668554;
    const Vec3d start{std::sin(tilt), -std::cos(tilt), 0};
    JointRig rig;
    const std::uint32_t ball = rig.add_body(1, Vec3d(0), start);
    SolverJoint& rod =
        rig.add_joint(ball, 0, {.kind = JointKind::Distance, .anchor_a_world = Vec3(start)});
    rig.place_anchors(rod, start, {0, 0, 0});
    rod.rest_length_m = 1;
    rig.bodies[ball].velocity_mps = Vec3(Vec3d{0, 0, -rate * std::sin(tilt)});
    const double period_s = period_of(rig, 4, 60, [&] { return rig.position(ball).x; });
    EXPECT_NEAR(period_s / 1.8668554, 1, 2e-5);
    const Vec3d end = rig.position(ball);
    EXPECT_NEAR(std::atan2(std::hypot(end.x, end.z), -end.y), tilt, 1e-5);
    const double vertical = glm::cross(end, rig.velocity(ball)).y;
    EXPECT_NEAR(vertical / (rate * start.x * start.x), 1, kFloat32 ? 3e-5 : 1e-12);
}

/// A disc on a massless arm of 1 m, set going on its steady precession at 30 degrees.
struct Top : JointRig {
    double start_tilt{std::numbers::pi / 6};
    double turned_rad{0};
    double worst_tilt_rad{0};

    Top(double spin, double precession) {
        const Quatd tilted = glm::angleAxis(-start_tilt, Vec3d{0, 0, 1});
        const Vec3d axis = tilted * Vec3d{0, 1, 0};
        const double side = 1.0633333333333 - 1.0;
        const std::uint32_t disc = add_body(1, {side, 0.125, side}, axis, tilted);
        SolverJoint& pivot = add_ball(disc, 0, {0, 0, 0});
        place_anchors(pivot, {0, 0, 0}, {0, 0, 0});
        const Vec3d turning =
            precession * Vec3d{0, 1, 0} + (spin - precession * std::cos(start_tilt)) * axis;
        bodies[disc].spin_radps = Vec3(turning);
        bodies[disc].velocity_mps = Vec3(glm::cross(turning, axis));
    }
    void watch(double duration_s, int substeps) {
        Vec3d last = position(1);
        while (time_s < duration_s - 1e-9) {
            step(kFrame_s, substeps);
            const Vec3d now = position(1);
            turned_rad += std::remainder(std::atan2(-now.z, now.x) - std::atan2(-last.z, last.x),
                                         2 * std::numbers::pi);
            const double tilt = std::atan2(std::hypot(now.x, now.z), now.y);
            worst_tilt_rad = std::max(worst_tilt_rad, std::abs(tilt - start_tilt));
            last = now;
        }
    }
};

TEST(JointMotion, HeavyTopPrecessesAtItsRate) {
    for (const auto& [spin, precession] : {std::pair{60.0, 1.6370510}, {100.0, 0.8363280}}) {
        Top top(spin, precession);
        top.watch(20, 4);
        EXPECT_NEAR(top.turned_rad / 20 / precession, 1, 2e-3) << spin;
        EXPECT_LT(top.worst_tilt_rad, 2e-3) << spin;
        EXPECT_LT(top.max_error(), 1e-9);
        Top finer(spin, precession);
        finer.watch(20, 8);
        EXPECT_NEAR(finer.turned_rad / 20 / precession, 1, 4e-4) << spin;
    }
}

TEST(JointMotion, SwingingBodyKeepsItsMomentumAboutAFreeJoint) {
    // Two rods on a ball joint, thrown: nothing outside holds them.
    JointRig rig;
    rig.gravity = {0, 0, 0};
    const Vec3d inertia{0.01, 0.1, 0.1};
    const std::uint32_t a = rig.add_body(1, inertia, {-0.5, 0, 0});
    const std::uint32_t b = rig.add_body(2, inertia * 2.0, {0.5, 0, 0});
    rig.add_ball(a, b, {0, 0, 0});
    rig.bodies[a].velocity_mps = {0, 1, 0};
    rig.bodies[a].spin_radps = {3, 1, 2};
    rig.bodies[b].spin_radps = {-1, 2, -2};
    rig.step(kFrame_s, 4);  // the joint takes what of this it does not allow
    const auto momenta = [&] {
        Vec3d linear{0, 0, 0};
        Vec3d angular{0, 0, 0};
        for (const std::uint32_t i : {a, b}) {
            const Vec3d p = rig.mass(i) * rig.velocity(i);
            const Quatd q = rig.orientation(i);
            linear += p;
            angular += glm::cross(rig.position(i), p) +
                       q * (rig.bodies[i].inertia_kgm2 * (glm::conjugate(q) * rig.spin(i)));
        }
        return std::pair{linear, angular};
    };
    const auto [linear, angular] = momenta();
    const double energy = rig.energy();
    rig.run(10, kFrame_s, 4);
    const auto [linear_after, angular_after] = momenta();
    EXPECT_LT(glm::length(linear_after - linear), kFloat32 ? 1e-4 : 1e-12);
    EXPECT_LT(glm::length(angular_after - angular), 2e-3);
    EXPECT_NEAR(rig.energy() / energy, 1, 2e-3);
}

}  // namespace
}  // namespace plumbline::physics
