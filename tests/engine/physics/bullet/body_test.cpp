// Bullet's side of a body.
#include "engine/physics/query.h"
#include "tests/engine/physics/bullet/shape/shape_rig.h"

namespace plumbline::physics {
namespace {

TEST(Frozen, StandsInTheAirAndFallsAgain) {
    TestWorld test;
    const BodyId box = test.add(BoxShape{}, {0, 8, 0}, {.kind = BodyKind::Dynamic, .mass_kg = 3});
    test.run(0.5);
    test.world.set_frozen(box, true);
    const Vec3d held = test.at(box);
    test.run(1.0);
    EXPECT_EQ(test.at(box), held);
    EXPECT_TRUE(test.world.state(box).frozen);
    EXPECT_EQ(test.world.state(box).mass.mass_kg, 3);
    test.world.set_frozen(box, false);
    test.run(0.5);
    EXPECT_NEAR(test.at(box).y, held.y - 0.5 * kG * 0.25, 1e-5);
}

TEST(ShapeMass, OverridesHold) {
    TestWorld test;
    const BodyId body = test.add(BoxShape{},
                                 {1, 2, 3},
                                 {.kind = BodyKind::Dynamic,
                                  .mass_kg = 2,
                                  .inertia_kgm2 = Vec3{1, 2, 3},
                                  .center_of_mass_m = Vec3{0, -0.4_r, 0}});
    const MassProperties mass = test.world.state(body).mass;
    expect_near(mass.inertia_kgm2, {1, 2, 3}, kRounding);
    expect_near(mass.center_of_mass_m, {0, -0.4, 0}, kRounding);
    expect_near(test.world.state(body).world_from_body.position, {1, 2, 3}, 10 * kRounding);
    Vec3 low;
    Vec3 high;
    bounds(test.world, body, low, high);
    // The shape stays where the body's origin is.
    expect_near(low, {0.5, 1.5, 2.5}, 0.05);
    expect_near(high, {1.5, 2.5, 3.5}, 0.05);
}

TEST(ShapeMass, LowCentreOfMassRightsATumbler) {
    TestWorld test;
    test.ground();
    const BodyId tumbler = test.add(SphereShape{.radius_m = 0.5_r},
                                    {0, 0.5_r, 0},
                                    {.kind = BodyKind::Dynamic,
                                     .center_of_mass_m = Vec3{0, -0.3_r, 0},
                                     .friction = 1,
                                     .rolling_friction = 0.02_r,
                                     .angular_damping_per_s = 1});
    test.world.set_pose(
        tumbler, {.position = {0, 0.5_r, 0}, .orientation = glm::angleAxis(1.2_r, Vec3{0, 0, 1})});
    test.run(10.0);
    const Vec3 up = test.world.state(tumbler).world_from_body.orientation * Vec3{0, 1, 0};
    EXPECT_GT(up.y, 0.98_r);
}

}  // namespace
}  // namespace plumbline::physics
