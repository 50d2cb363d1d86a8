// Which bodies make a pair.
#include "tests/engine/physics/test_world.h"

namespace plumbline::physics {
namespace {

TEST(Filters, BothSidesMustAgree) {
    TestWorld test;
    test.add(PlaneShape{},
             {0, 0, 0},
             {.kind = BodyKind::Static, .filter = {.group = 2, .collides_with = 1}});
    const BodyId willing =
        test.add(BoxShape{},
                 {0, 0.5_r, 0},
                 {.kind = BodyKind::Dynamic, .filter = {.group = 1, .collides_with = 2}});
    const BodyId refuses =
        test.add(BoxShape{},
                 {3, 0.5_r, 0},
                 {.kind = BodyKind::Dynamic, .filter = {.group = 1, .collides_with = 4}});
    const BodyId unseen =
        test.add(BoxShape{},
                 {6, 0.5_r, 0},
                 {.kind = BodyKind::Dynamic, .filter = {.group = 4, .collides_with = 2}});
    test.run(0.5);
    EXPECT_NEAR(test.at(willing).y, 0.5, 0.01);
    const double fallen = 0.5 - 0.5 * kG * 0.25;
    EXPECT_NEAR(test.at(refuses).y, fallen, 1e-5);
    EXPECT_NEAR(test.at(unseen).y, fallen, 1e-5);
}

}  // namespace
}  // namespace plumbline::physics
