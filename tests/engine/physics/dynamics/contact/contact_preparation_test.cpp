// How stiff constraints are beside others.
#include "engine/physics/dynamics/contact/contact_set.h"
#include "tests/engine/physics/dynamics/contact/contact_rig.h"

#include <gtest/gtest.h>

namespace plumbline::physics {
namespace {

/// Four constraints between two bodies give way to a push as one does that is a quarter as often there.
TEST(ContactPreparation, ConstraintsOfAPairShareItsStiffness) {
    const auto pushed_mps = [](int constraints) {
        std::vector<SolverBody> bodies(2);
        bodies[1].inverse_mass = 1;
        ContactSet contacts;
        for (int i = 0; i < constraints; ++i)
            contacts.constraints.push_back(level_contact(1, 0, -0.001_r));
        contacts.begin_step(bodies, {});
        for (int i = 0; i < 200; ++i) {
            contacts.warm_start();
            bodies[1].velocity_mps = bodies[1].velocity_increment_mps;
            bodies[1].velocity_increment_mps = {0, 0, 0};
            bodies[1].velocity_mps.y -= 0.01_r;
            contacts.sweep_with_bias(ContactSet::Sweep::All);
        }
        return static_cast<double>(bodies[1].velocity_mps.y);
    };
    EXPECT_NEAR(pushed_mps(4), pushed_mps(1), 0.02 * std::abs(pushed_mps(1)) + 1e-5);
}

/// A body that `neighbours` of its own mass press from below: how much the first of the constraints gives way.
double compliance_among(int neighbours) {
    std::vector<SolverBody> bodies(static_cast<std::size_t>(neighbours) + 2);
    for (std::size_t i = 1; i < bodies.size(); ++i) bodies[i].inverse_mass = 1;
    ContactSet contacts;
    for (int i = 0; i < neighbours; ++i)
        contacts.constraints.push_back(level_contact(static_cast<std::uint32_t>(neighbours) + 1,
                                                     static_cast<std::uint32_t>(i) + 1,
                                                     -0.001_r));
    contacts.begin_step(bodies, {});
    return static_cast<double>(contacts.constraints.front().compliance[0]);
}

// Each presses with half of its own stiffness, and up to twice that is stable.
TEST(ContactPreparation, OnesOfACrowdedBodyGiveWayMore) {
    const double alone = compliance_among(1);
    EXPECT_NEAR(compliance_among(4), alone, 1e-6 * alone);
    EXPECT_NEAR(compliance_among(8), 2 * alone, 1e-5 * alone);
    EXPECT_NEAR(compliance_among(40), 10 * alone, 1e-4 * alone);
}

}  // namespace
}  // namespace plumbline::physics
