// Each of Bullet's solvers.
#include "engine/physics/totals.h"
#include "tests/engine/physics/test_world.h"

namespace plumbline::physics {
namespace {

class EverySolver : public testing::TestWithParam<Solver> {};
INSTANTIATE_TEST_SUITE_P(
    Solvers,
    EverySolver,
    testing::Values(Solver::BulletSi, Solver::BulletNncg, Solver::BulletDantzig, Solver::BulletPgs),
    [](const auto& param_info) { return std::string(solver_name(param_info.param)); });

TEST_P(EverySolver, HoldsAStackOfThreeAndCountsItsWork) {
    WorldDef def;
    def.solver = GetParam();
    TestWorld test(def);
    test.ground();
    std::vector<BodyId> boxes;
    for (int i = 0; i < 3; ++i) {
        boxes.push_back(test.add(BoxShape{}, {0, 0.5_r + static_cast<Real>(i), 0}));
    }
    test.run(2.0);
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(test.at(boxes[static_cast<std::size_t>(i)]).y, 0.5 + i, 0.02);
    }
    EXPECT_GE(test.world.report().cost.contacts, 12U);
    EXPECT_GE(test.world.report().cost.row_solves, 2U * test.world.report().cost.contacts);
    EXPECT_LT(max_penetration_m(test.world), 0.02);
    EXPECT_EQ(solver_from_name(solver_name(GetParam())), GetParam());
}

}  // namespace
}  // namespace plumbline::physics
