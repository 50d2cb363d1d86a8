// Continuous collision of jointed bodies.
#include "engine/physics/query.h"
#include "engine/physics/totals.h"
#include "tests/engine/physics/joint_bench.h"

#include <algorithm>
#include <array>

namespace plumbline::physics {
namespace {

const BodyDef kSweptBody{.kind = BodyKind::Dynamic, .mass_kg = 2};

class JointSweeping : public JointTest {};
INSTANTIATE_TEST_SUITE_P(Solvers, JointSweeping, testing::ValuesIn(kJointBars), name_of);

TEST_P(JointSweeping, FastLinksAreNotStoppedByEachOther) {
    // Faster than their own size a step, so continuous collision sweeps them; they overlap.
    TestWorld test(bar().world({0, 0, 0}));
    const BodyId a = test.add(BoxShape{.size_m = {0.2_r, 0.2_r, 0.2_r}}, {0, 0, 0}, kSweptBody);
    const BodyId b =
        test.add(BoxShape{.size_m = {0.2_r, 0.2_r, 0.2_r}}, {0.15_r, 0, 0}, kSweptBody);
    const JointId joint = join(test, {.kind = JointKind::Fixed, .a = a, .b = b});
    test.world.set_velocity(a, {20, 0, 0}, {0, 0, 0});
    test.world.set_velocity(b, {20, 0, 0}, {0, 0, 0});
    test.run(1);
    EXPECT_NEAR(test.at(a).x, 20, 1e-4);
    EXPECT_LT(test.world.joint(joint).state.error_m, 1e-5);
    EXPECT_TRUE(
        overlaps(test.world, test.shape(BoxShape{}), {.position = {20, 0, 0}}, 0, {.ignored = a})
            .empty());
}

TEST_P(JointSweeping, AFastPairStopsAtAThinWallTogether) {
    TestWorld test(bar().world({0, 0, 0}));
    test.add(BoxShape{.size_m = {0.02_r, 4, 4}}, {5, 0, 0}, {.kind = BodyKind::Static});
    std::array<BodyId, 3> train;
    for (std::size_t i = 0; i < train.size(); ++i) {
        const Real x = 0.3_r * static_cast<Real>(i);
        train[i] = test.add(BoxShape{.size_m = {0.2_r, 0.2_r, 0.2_r}}, {x, 0, 0}, kSweptBody);
        test.world.set_velocity(train[i], {40, 0, 0}, {0, 0, 0});
        if (i > 0) {
            join(test,
                 {.kind = JointKind::Fixed,
                  .a = train[i],
                  .b = train[i - 1],
                  .anchor_a_world = {x, 0, 0}});
        }
    }
    double error_m = 0;
    for (int i = 0; i < 60; ++i) {
        test.world.step();
        error_m = std::max(error_m, max_joint_error_m(test.world));
        for (const BodyId body : train) EXPECT_LT(test.at(body).x, 5);
    }
    EXPECT_LT(error_m, bar().crash_m);
}

}  // namespace
}  // namespace plumbline::physics
