// Pairs come and go with the boxes.
#include "tests/engine/physics/test_world.h"

namespace plumbline::physics {
namespace {

std::uint32_t pairs_looked_at(TestWorld& test) {
    test.world.step();
    return test.world.report().cost.pairs;
}

TEST(PairList, HasThePairsOfBodiesThatMeetAgain) {
    TestWorld test(weightless());
    const BodyId still = test.add(SphereShape{.radius_m = 0.5_r}, {0, 0, 0});
    const BodyId goes = test.add(SphereShape{.radius_m = 0.5_r}, {1.01_r, -0.3_r, 0});
    test.add(SphereShape{.radius_m = 0.5_r}, {0, 1.01_r, 0});
    const auto put = [&](BodyId id, const Vec3& at) {
        BodyState state = test.world.state(id);
        state.world_from_body.position = at;
        test.world.set_pose(id, state.world_from_body);
    };
    EXPECT_EQ(pairs_looked_at(test), 2U);
    for (int i = 0; i < 3; ++i) {
        put(goes, {9, 0, 0});
        EXPECT_EQ(pairs_looked_at(test), 1U);
        put(goes, {-1.01_r, -0.3_r, 0});
        EXPECT_EQ(pairs_looked_at(test), 2U);
    }
    test.world.destroy_body(still);
    EXPECT_EQ(pairs_looked_at(test), 0U);
}

}  // namespace
}  // namespace plumbline::physics
