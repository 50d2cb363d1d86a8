// Springs that sub-steps do not follow: on bodies that fall to the ground, and under loads on light bodies.
#include "engine/physics/totals.h"
#include "tests/engine/physics/joint_bench.h"

#include <array>

namespace plumbline::physics {
namespace {

/// Two boxes, or balls that bounce, on each other's spring, 2.5 m above the ground.
struct SprungPair {
    SprungPair(const ShapeDef& shape, Real stiffness_Npm, Real restitution, JointMethod method)
        : test({.substeps = 4, .substeps_max = 16, .iterations = 1, .joints = method}) {
        test.ground(0.5_r, restitution);
        BodyDef body{.kind = BodyKind::Dynamic, .restitution = restitution, .can_sleep = false};
        lower = test.add(shape, {0, 3, 0}, body);
        body.world_from_body.orientation = glm::angleAxis(0.3_r, Vec3{1, 0, 0});
        upper = test.add(shape, {0.2_r, 5, 0}, body);
        join(test,
             {.kind = JointKind::Spring,
              .a = lower,
              .b = upper,
              .anchor_a_world = {0, 3, 0},
              .anchor_b_world = {0.2_r, 5, 0},
              .stiffness_Npm = stiffness_Npm});
    }
    /// Of motion and weight, without the spring's.
    double free_J() const {
        return energy(test.world).kinetic_J + kG * (test.at(lower).y + test.at(upper).y);
    }
    TestWorld test;
    BodyId lower{};
    BodyId upper{};
};

// An impact in the middle of a swing that the sub-step does not resolve gave up to 1e6 times the energy.
TEST(StiffSprings, GainNothingByImpacts) {
    const std::array<ShapeDef, 2> shapes{BoxShape{}, SphereShape{.radius_m = 0.4_r}};
    for (const JointMethod method : {JointMethod::Direct, JointMethod::Iterative}) {
        const double most = method == JointMethod::Direct ? 1.05 : 1.1;
        for (const Real restitution : {0.0_r, 1.0_r}) {
            for (const ShapeDef& shape : shapes) {
                for (const Real stiffness_Npm : {1e4_r, 1e5_r, 3e5_r, 1e6_r, 3e6_r, 1e8_r}) {
                    SprungPair pair(shape, stiffness_Npm, restitution, method);
                    const double start_J = total_energy_J(pair.test);
                    for (int i = 0; i < 240; ++i) {
                        pair.test.world.step();
                        // What a turn stretches the stiffest by in one step is nobody's motion.
                        const double now_J =
                            stiffness_Npm > 1e7_r ? pair.free_J() : total_energy_J(pair.test);
                        ASSERT_LT(now_J, most * start_J)
                            << stiffness_Npm << " N/m, restitution " << restitution << ", step "
                            << i << (method == JointMethod::Direct ? ", direct" : ", iterative");
                    }
                }
            }
        }
    }
}

/// 100 kg on half a kilogram that a spring holds to the world 60 m below.
struct PressedSpring {
    PressedSpring(const ShapeDef& shape, Real cube_at_m, const JointDef& spring)
        : test({.substeps = 2, .substeps_max = 16, .iterations = 1, .solver = Solver::SmallStep}) {
        BodyDef body{.kind = BodyKind::Dynamic, .mass_kg = 0.5_r, .can_sleep = false};
        light = test.add(shape, {0, 0, 0}, body);
        body.mass_kg = 100;
        cube = test.add(BoxShape{{1, 1, 1}}, {0, cube_at_m, 0}, body);
        JointDef def = spring;
        def.kind = JointKind::Spring;
        def.a = light;
        def.anchor_a_world = {0, 0, 0};
        def.anchor_b_world = {0, -60, 0};
        join(test, def);
    }
    TestWorld test;
    BodyId light{};
    BodyId cube{};
};
constexpr double kPressed_kg = 100.5;

struct PressedDamper : testing::TestWithParam<double> {};

// Damping saw the ball's speed without what presses on it: contacts sank in by centimetres, and where damping wins within a
// sub-step it acted twice. 91.6 and 300 N s/m: reached 3.0 and 2.0 m/s.
TEST_P(PressedDamper, SinksAsFastAsTheLoadAsksFor) {
    const double damping_Nspm = GetParam();
    constexpr double kTime_s = 2;
    PressedSpring on(SphereShape{0.5_r},
                     1,
                     {.stiffness_Npm = 0.01_r,
                      .damping_Nspm = static_cast<Real>(damping_Nspm),
                      .rest_length_m = 60});
    on.test.run(kTime_s);
    const double end_mps =
        kPressed_kg * kG / damping_Nspm * (1 - std::exp(-damping_Nspm * kTime_s / kPressed_kg));
    EXPECT_NEAR(-on.test.velocity(on.light).y / end_mps, 1, 0.02);
    EXPECT_NEAR(-on.test.velocity(on.cube).y / end_mps, 1, 0.02);
    EXPECT_LT(1 - (on.test.at(on.cube).y - on.test.at(on.light).y), 3e-3);
}

INSTANTIATE_TEST_SUITE_P(Dampings, PressedDamper, testing::Values(20, 91.6, 300, 1000, 5000));

// A stiff spring that swings was damped as if its plate of 0.5 kg stood alone: 0.38 of the swing was left.
TEST(StiffSprings, ALoadSwingsAndDiesAwayAsItsDampingSays) {
    const double sag_m = kPressed_kg * kG / 1e4;
    PressedSpring on(BoxShape{{1, 0.2_r, 1}},
                     0.6_r,
                     {.stiffness_Npm = 1e4_r,
                      .damping_Nspm = 130,
                      .rest_length_m = static_cast<Real>(60 + sag_m / 2)});
    on.test.run(2);
    double highest_m = -1;
    double lowest_m = 1;
    for (int i = 0; i < 40; ++i) {
        on.test.world.step();
        highest_m = std::max(highest_m, on.test.at(on.cube).y);
        lowest_m = std::min(lowest_m, on.test.at(on.cube).y);
    }
    // From extreme to extreme between 2 and 2.67 s, with exp(-c t / 2 m) of the first width left.
    const double rate = 130 / (2 * kPressed_kg);
    const double half_period_s = kPiD / std::sqrt(1e4 / kPressed_kg - rate * rate);
    const double first_s = std::ceil(2 / half_period_s) * half_period_s;
    const double width_m =
        sag_m / 2 * std::exp(-rate * first_s) * (1 + std::exp(-rate * half_period_s));
    EXPECT_NEAR((highest_m - lowest_m) / width_m, 1, 0.05);
}

}  // namespace
}  // namespace plumbline::physics
