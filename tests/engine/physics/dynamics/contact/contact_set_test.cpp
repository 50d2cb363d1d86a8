#include "engine/physics/dynamics/contact/contact_set.h"

#include "engine/core/random.h"
#include "tests/engine/physics/dynamics/contact/contact_rig.h"

#include <gtest/gtest.h>

#include <array>

namespace plumbline::physics {
namespace {

constexpr double kFriction = 0.5;

Vec3 random_vector(Random& random, float size) {
    return {Real{random.uniform(-size, size)},
            Real{random.uniform(-size, size)},
            Real{random.uniform(-size, size)}};
}

/// Two free bodies that overlap at four points of a tilted plane.
struct FreePair {
    std::vector<SolverBody> bodies{1};
    ContactSet contacts;
    std::array<Vec3d, 3> centre{};
    std::array<Vec3d, 3> inertia{};

    explicit FreePair(Random& random) {
        const Vec3 normal = glm::normalize(Vec3{0, 1, 0} + random_vector(random, 0.8F));
        ContactConstraint constraint;
        constraint.a = 1;
        constraint.b = 2;
        constraint.normal = normal;
        constraint.tangent[0] = glm::normalize(glm::cross(normal, Vec3{0, 0, 1}));
        constraint.tangent[1] = glm::cross(normal, constraint.tangent[0]);
        constraint.count = 1 + static_cast<std::int32_t>(random.below(kLanes));
        constraint.friction = Real{random.uniform(0.1F, 1.2F)};
        constraint.rolling_m = Real{random.uniform(0.0F, 0.1F)};
        constraint.spinning_m = Real{random.uniform(0.0F, 0.1F)};
        for (std::size_t i = 1; i <= 2; ++i) {
            const double mass_kg = static_cast<double>(random.uniform(0.2F, 5.0F));
            inertia[i] = mass_kg * Vec3d(0.2, 0.3, 0.25);
            centre[i] = Vec3d(normal) * (i == 1 ? 0.5 : -0.5) + Vec3d(random_vector(random, 0.1F));
            SolverBody body;
            body.inverse_mass = real(1 / mass_kg);
            body.inverse_inertia = {.xx = real(1 / inertia[i].x),
                                    .yy = real(1 / inertia[i].y),
                                    .zz = real(1 / inertia[i].z)};
            body.velocity_mps = random_vector(random, 3);
            body.spin_radps = random_vector(random, 3);
            bodies.push_back(body);
        }
        for (int i = 0; i < constraint.count; ++i) {
            const Vec3 across = constraint.tangent[0] * ((i & 1) != 0 ? 0.5_r : -0.5_r) +
                                constraint.tangent[1] * ((i & 2) != 0 ? 0.5_r : -0.5_r);
            set_lane(constraint.offset_a, i, Vec3(Vec3d(across) - centre[1]));
            set_lane(constraint.offset_b, i, Vec3(Vec3d(across) - centre[2]));
            constraint.start_separation_m[static_cast<std::size_t>(i)] =
                Real{random.uniform(-0.02F, 0.01F)};
        }
        contacts.constraints.push_back(constraint);
    }

    ContactConstraint& constraint() { return contacts.constraints.front(); }
    double mass(std::size_t i) const { return 1 / wide(bodies[i].inverse_mass); }
    Vec3d momentum() const {
        return Vec3d(bodies[1].velocity_mps) * mass(1) + Vec3d(bodies[2].velocity_mps) * mass(2);
    }
    Vec3d angular_momentum() const {
        Vec3d sum{0, 0, 0};
        for (std::size_t i = 1; i <= 2; ++i) {
            sum += mass(i) * glm::cross(centre[i], Vec3d(bodies[i].velocity_mps)) +
                   inertia[i] * Vec3d(bodies[i].spin_radps);
        }
        return sum;
    }
    Vec3d moved_mass() const {
        return Vec3d(bodies[1].delta_position_m) * mass(1) +
               Vec3d(bodies[2].delta_position_m) * mass(2);
    }
    void begin() { contacts.begin_step(bodies, {}); }
};

TEST(ContactSet, SweepsKeepTheMomentumOfFreeBodies) {
    Random random(1);
    for (int trial = 0; trial < 300; ++trial) {
        FreePair pair(random);
        pair.begin();
        const Vec3d momentum = pair.momentum();
        const Vec3d angular = pair.angular_momentum();
        for (int sweep = 0; sweep < 3; ++sweep) {
            pair.contacts.sweep_with_bias(ContactSet::Sweep::All);
            EXPECT_LT(glm::length(pair.momentum() - momentum), by_precision(2e-5, 1e-13));
            EXPECT_LT(glm::length(pair.angular_momentum() - angular), by_precision(2e-5, 1e-13));
            pair.contacts.relax(ContactSet::Sweep::All);
            EXPECT_LT(glm::length(pair.momentum() - momentum), by_precision(2e-5, 1e-13));
            EXPECT_LT(glm::length(pair.angular_momentum() - angular), by_precision(2e-5, 1e-13));
            EXPECT_LT(glm::length(pair.moved_mass()), by_precision(1e-7, 1e-15));
        }
    }
}

TEST(ContactSet, ImpulsesStayWithinTheirLimits) {
    Random random(2);
    int slid = 0;
    for (int trial = 0; trial < 500; ++trial) {
        FreePair pair(random);
        pair.begin();
        for (int sweep = 0; sweep < 3; ++sweep) {
            pair.contacts.sweep_with_bias(ContactSet::Sweep::All);
            pair.contacts.relax(ContactSet::Sweep::All);
            const ContactConstraint& constraint = pair.constraint();
            EXPECT_FALSE(any(constraint.normal_Ns < splat(0)));
            const double load = wide(sum_of(constraint.normal_Ns));
            const double limit = wide(constraint.friction) * load;
            const double twist_limit = limit * wide(constraint.twist_arm_m);
            const double force =
                std::hypot(wide(constraint.tangent_Ns[0]), wide(constraint.tangent_Ns[1]));
            // (force / limit)^2 + (twist / its limit)^2 <= 1, written without dividing by zero.
            EXPECT_LE(force, limit * (1 + 1e-5));
            EXPECT_LE(std::abs(wide(constraint.twist_Nms)), twist_limit * (1 + 1e-5));
            if (twist_limit > 0) {
                const double share =
                    std::hypot(force / limit, wide(constraint.twist_Nms) / twist_limit);
                EXPECT_LE(share, 1 + 1e-5);
                slid += share > 0.999 ? 1 : 0;
            }
            const Vec3d rolling{constraint.rolling_Nms};
            const double about = glm::dot(rolling, Vec3d(constraint.normal));
            EXPECT_LE(std::abs(about), wide(constraint.spinning_m) * load * (1 + 1e-5) + 1e-7);
            EXPECT_LE(glm::length(rolling - about * Vec3d(constraint.normal)),
                      wide(constraint.rolling_m) * load * (1 + 1e-5) + 1e-7);
        }
    }
    EXPECT_GT(slid, 100);
}

TEST(ContactSet, SweepsNeverAddEnergyWithoutOverlap) {
    // What touches without overlapping has nothing that pushes: sweeps only take energy.
    Random random(3);
    for (int trial = 0; trial < 300; ++trial) {
        FreePair pair(random);
        for (int i = 0; i < pair.constraint().count; ++i)
            pair.constraint().start_separation_m[static_cast<std::size_t>(i)] = 0;
        pair.begin();
        const auto energy = [&] {
            double sum = 0;
            for (std::size_t i = 1; i <= 2; ++i) {
                const Vec3d v{pair.bodies[i].velocity_mps};
                const Vec3d w{pair.bodies[i].spin_radps};
                sum += (pair.mass(i) * glm::dot(v, v) + glm::dot(w, pair.inertia[i] * w)) / 2;
            }
            return sum;
        };
        const double before = energy();
        pair.contacts.sweep_with_bias(ContactSet::Sweep::All);
        pair.contacts.relax(ContactSet::Sweep::All);
        EXPECT_LE(energy(), before * (1 + 1e-5));
    }
}

TEST(ContactSet, PointsThatStayApartChangeNothing) {
    Random random(4);
    for (int trial = 0; trial < 100; ++trial) {
        FreePair pair(random);
        for (int i = 0; i < pair.constraint().count; ++i)
            pair.constraint().start_separation_m[static_cast<std::size_t>(i)] = 1;
        pair.begin();
        const std::vector<SolverBody> before = pair.bodies;
        pair.contacts.sweep_with_bias(ContactSet::Sweep::All);
        pair.contacts.relax(ContactSet::Sweep::All);
        pair.contacts.end_substep();
        for (std::size_t i = 1; i <= 2; ++i) {
            EXPECT_EQ(pair.bodies[i].velocity_mps, before[i].velocity_mps);
            EXPECT_EQ(pair.bodies[i].spin_radps, before[i].spin_radps);
            EXPECT_EQ(pair.bodies[i].delta_position_m, before[i].delta_position_m);
        }
        EXPECT_EQ(sum_of(pair.constraint().total_Ns), 0);
    }
}

TEST(ContactSet, WarmStartIsTheWrenchOfWhatTheBlockHolds) {
    Random random(5);
    FreePair pair(random);
    pair.constraint().normal_Ns[0] = 2;
    pair.constraint().load_before_Ns = 2;
    pair.constraint().tangent_Ns[0] = 0.3_r;
    pair.constraint().twist_Nms = 0.1_r;
    pair.constraint().rolling_Nms = Vec3{0.1_r, 0.2_r, 0};
    pair.begin();
    pair.contacts.warm_start();
    const ContactConstraint& constraint = pair.constraint();
    const Vec3d push = Vec3d(constraint.normal) * 2.0 + Vec3d(constraint.tangent[0]) * 0.3;
    EXPECT_LT(glm::length(Vec3d(pair.bodies[1].velocity_increment_mps) * pair.mass(1) - push),
              1e-5);
    EXPECT_LT(glm::length(Vec3d(pair.bodies[2].velocity_increment_mps) * pair.mass(2) + push),
              1e-5);
    Vec3d angular{0, 0, 0};
    for (std::size_t i = 1; i <= 2; ++i) {
        angular += pair.mass(i) *
                       glm::cross(pair.centre[i], Vec3d(pair.bodies[i].velocity_increment_mps)) +
                   pair.inertia[i] * Vec3d(pair.bodies[i].spin_increment_radps);
    }
    EXPECT_LT(glm::length(angular), by_precision(1e-5, 1e-13));
}

// Twice the load before it goes on; the rest was an impact, and so is its friction.
TEST(ContactSet, AnImpactDoesNotGoOn) {
    Random random(5);
    FreePair pair(random);
    pair.constraint().normal_Ns[0] = 200;
    pair.constraint().load_before_Ns = 10;
    pair.constraint().tangent_Ns[0] = 40;
    pair.begin();
    pair.contacts.warm_start();
    EXPECT_NEAR(static_cast<double>(pair.constraint().normal_Ns[0]), 20, 1e-4);
    EXPECT_NEAR(static_cast<double>(pair.constraint().tangent_Ns[0]), 4, 1e-5);
    EXPECT_EQ(pair.constraint().load_before_Ns, Real{200});
}

class Resting : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Substeps, Resting, testing::Values(1, 4, 16));

TEST_P(Resting, ACubeIsCarriedByExactlyItsWeight) {
    ContactRig rig;
    rig.settings.substeps = GetParam();
    const std::uint32_t box = rig.add_box(3, Vec3d(0.5), Vec3d(0, 0.5, 0));
    rig.put_on_floor(box, {.friction = kFriction});
    rig.steps(120);
    const double weight_Ns = 3 * kFall_mps2 * kStep_s;
    EXPECT_NEAR(rig.pressed_Ns(0) / weight_Ns, 1, by_precision(1e-4, 1e-6));
    for (int i = 0; i < kLanes; ++i)
        EXPECT_NEAR(
            wide(rig.constraint(0).total_Ns[i]) / weight_Ns, 0.25, by_precision(1e-3, 1e-6));
    EXPECT_LT(glm::length(rig.velocity(box)), by_precision(1e-5, 1e-7));
    EXPECT_LT(glm::length(rig.spin(box)), by_precision(1e-5, 1e-7));
}

TEST_P(Resting, TheImpulsesOfEveryStepAreTheChangeOfMomentum) {
    ContactRig rig;
    rig.settings.substeps = GetParam();
    const std::uint32_t box = rig.add_box(3, Vec3d(0.5), Vec3d(0, 0.7, 0));
    rig.put_on_floor(box, {.friction = kFriction});
    for (int i = 0; i < 120; ++i) {
        const double before_mps = rig.velocity(box).y;
        rig.step();
        const double gained_Ns = 3 * (rig.velocity(box).y - before_mps + kFall_mps2 * kStep_s);
        EXPECT_NEAR(rig.pressed_Ns(0), gained_Ns, by_precision(2e-5, 1e-12)) << i;
    }
}

TEST_P(Resting, BodiesSagAsTheSpringUnderThemSays) {
    for (const bool sphere : {false, true}) {
        ContactRig rig;
        rig.settings.substeps = GetParam();
        const std::uint32_t body = sphere ? rig.add_ball(2, 0.5, Vec3d(0, 0.5, 0))
                                          : rig.add_box(2, Vec3d(0.5), Vec3d(0, 0.5, 0));
        rig.put_on_floor(body, {});
        rig.steps(300);
        const double sag_m = sag_of(kFall_mps2, kStep_s / GetParam(), true);
        EXPECT_NEAR((0.5 - rig.position(body).y) / sag_m, 1, by_precision(0.02, 1e-3)) << sphere;
    }
}

TEST_P(Resting, BallsPressedTogetherSagByTheirReducedMass) {
    ContactRig rig;
    rig.settings.substeps = GetParam();
    rig.settings.gravity_mps2 = 0;
    rig.gravity_mps2 = Vec3d{0, 0, 0};
    const std::uint32_t heavy = rig.add_ball(3, 0.5, Vec3d(0.5, 0, 0));
    const std::uint32_t light = rig.add_ball(1, 0.5, Vec3d(-0.5, 0, 0));
    rig.let_balls_meet(heavy, light, {});
    const double press_N = 30;
    rig.set_force(heavy, Vec3d(-press_N, 0, 0));
    rig.set_force(light, Vec3d(press_N, 0, 0));
    rig.steps(300);
    const double sag_m = sag_of(press_N / 0.75, kStep_s / GetParam(), false);
    const double apart_m = rig.position(heavy).x - rig.position(light).x;
    EXPECT_NEAR((1 - apart_m) / sag_m, 1, by_precision(0.02, 1e-3));
    EXPECT_NEAR(rig.pressed_Ns(0), press_N * kStep_s, 1e-3);
}

/// A box on a slope: gravity is tilted instead of the floor.
double slid_m(double slope_tangent, int substeps, int steps) {
    ContactRig rig;
    rig.settings.substeps = substeps;
    const std::uint32_t box = rig.add_box(2, Vec3d(0.5, 0.2, 0.5), Vec3d(0, 0.2, 0));
    rig.put_on_floor(box, {.friction = kFriction});
    rig.steps(60);
    const double angle = std::atan(slope_tangent);
    rig.gravity_mps2 = kFall_mps2 * Vec3d(std::sin(angle), -std::cos(angle), 0);
    const double start_m = rig.position(box).x;
    rig.steps(steps);
    return rig.position(box).x - start_m;
}

TEST_P(Resting, ABoxSticksBelowTheLimit) {
    EXPECT_LT(std::abs(slid_m(0.98 * kFriction, GetParam(), 300)), 1e-3);
    EXPECT_LT(std::abs(slid_m(0.5 * kFriction, GetParam(), 300)), 5e-4);
}

TEST_P(Resting, ABoxAboveTheLimitSlidesByTheRest) {
    const double angle = std::atan(2 * kFriction);
    const double accel_mps2 = kFall_mps2 * (std::sin(angle) - kFriction * std::cos(angle));
    EXPECT_NEAR(slid_m(2 * kFriction, GetParam(), 60) / (accel_mps2 / 2), 1, 0.01);
}

TEST_P(Resting, ABallAgainstRollingResistanceRollsAsFarAsItsEnergyGoes) {
    // Torque c m g works along the way: 7/10 m v^2 = c m g s / r.
    ContactRig rig;
    rig.settings.substeps = GetParam();
    const double radius_m = 0.25;
    const double rolling_m = 0.01;
    const std::uint32_t sphere = rig.add_ball(2, radius_m, Vec3d(0, radius_m, 0));
    rig.put_on_floor(sphere, {.friction = 0.8, .rolling_m = rolling_m});
    rig.steps(60);
    rig.set_velocity(sphere, Vec3d(2, 0, 0), Vec3d(0, 0, -2 / radius_m));
    rig.steps(900);
    EXPECT_LT(glm::length(rig.velocity(sphere)), 1e-4);
    const double way_m = 0.7 * 4 * radius_m / (rolling_m * kFall_mps2);
    EXPECT_NEAR(rig.position(sphere).x / way_m, 1, 0.005);
}

TEST_P(Resting, ASpinningBallStopsByItsSpinningResistance) {
    // 2/5 m r^2 w = c m g t.
    ContactRig rig;
    rig.settings.substeps = GetParam();
    const double radius_m = 0.25;
    const std::uint32_t sphere = rig.add_ball(2, radius_m, Vec3d(0, radius_m, 0));
    rig.put_on_floor(sphere, {.friction = 0.8, .spinning_m = 0.005});
    rig.steps(60);
    rig.set_velocity(sphere, Vec3d(0), Vec3d(0, 10, 0));
    rig.steps(60);
    const double slower_radps = 0.005 * kFall_mps2 / (0.4 * radius_m * radius_m);
    EXPECT_NEAR(rig.spin(sphere).y, 10 - slower_radps, 0.01);
    rig.steps(300);
    EXPECT_LT(glm::length(rig.spin(sphere)), 1e-4);
}

/// Cubes on each other, the lowest on the ground, that come down together.
struct FallingStack {
    std::vector<SolverBody> bodies{1};
    ContactSet contacts;

    FallingStack(int cubes, Real speed_mps) {
        for (int i = 0; i < cubes; ++i) {
            SolverBody& cube = bodies.emplace_back();
            cube.inverse_mass = 1;
            cube.inverse_inertia = {.xx = 6, .yy = 6, .zz = 6};
            cube.velocity_mps = {0, -speed_mps, 0};
            const auto below = static_cast<std::uint32_t>(i);
            ContactConstraint constraint = level_contact(below + 1, below, 0);
            set_lane(constraint.offset_a, 0, {0, -0.5_r, 0});
            set_lane(constraint.offset_b, 0, {0, i == 0 ? Real{0} : 0.5_r, 0});
            contacts.constraints.push_back(constraint);
        }
        contacts.begin_step(bodies, {});
    }
};

TEST(ContactSet, SweepsOfWhatIsRestlessStopAFallingStack) {
    FallingStack stack(5, 2);
    int sweeps = 0;
    for (bool is_restless = true; is_restless && sweeps < 100; ++sweeps)
        is_restless = stack.contacts.sweep_with_bias(sweeps == 0 ? ContactSet::Sweep::All
                                                                 : ContactSet::Sweep::Restless);
    EXPECT_GT(sweeps, 2);
    EXPECT_LT(sweeps, 100);
    EXPECT_LT(-stack.bodies.back().velocity_mps.y, 1.4_r) << "a tenth of what each has may stay";
}

TEST(ContactSet, WhatRestsIsSweptOnce) {
    FallingStack stack(5, 1e-5_r);
    EXPECT_FALSE(stack.contacts.sweep_with_bias(ContactSet::Sweep::All));
    const std::uint64_t rows = stack.contacts.row_solves();
    EXPECT_FALSE(stack.contacts.sweep_with_bias(ContactSet::Sweep::Restless));
    EXPECT_EQ(stack.contacts.row_solves(), rows);
}

}  // namespace
}  // namespace plumbline::physics
