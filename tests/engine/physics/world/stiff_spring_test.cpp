// Springs that sub-steps do not follow, on bodies that fall to the ground.
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

}  // namespace
}  // namespace plumbline::physics
