#include "engine/physics/bullet/shape/hull.h"

#include "engine/physics/query.h"
#include "tests/engine/physics/bullet/shape/shape_rig.h"

#include <cmath>

namespace plumbline::physics {
namespace {

TEST(ShapeNotes, FlatHullsBecomeThinBoxes) {
    TestWorld test;
    std::vector<std::string> notes;
    const HullShape card{
        {{0, 0, 0}, {0.6_r, 0, 0}, {0.6_r, 0.4_r, 0}, {0, 0.4_r, 0}, {0.3_r, 0.2_r, 0}}};
    const auto shape = test.world.create_shape(card, &notes);
    ASSERT_TRUE(shape.ok());
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_NE(notes[0].find("its points are flat"), std::string::npos) << notes[0];
    const BodyId body = test.world.create_body(
        {.kind = BodyKind::Dynamic, .shape = *shape, .world_from_body = {.position = {5, 5, 5}}});
    Vec3 low;
    Vec3 high;
    bounds(test.world, body, low, high);
    EXPECT_NEAR(static_cast<double>(high.x - low.x), 0.6, 0.01);
    EXPECT_NEAR(static_cast<double>(high.y - low.y), 0.4, 0.01);
    EXPECT_LT(high.z - low.z, 0.01_r);
}

TEST(ShapeNotes, RoundHullsLoseCorners) {
    TestWorld test;
    HullShape ball;
    for (int i = 0; i < 400; ++i) {
        const Real y = 1 - 2 * (static_cast<Real>(i) + 0.5_r) / 400;
        const Real ring = std::sqrt(1 - y * y);
        const Real angle = 2.399963_r * static_cast<Real>(i);
        ball.points_m.push_back({ring * std::cos(angle), y, ring * std::sin(angle)});
    }
    std::vector<std::string> notes;
    const auto shape = test.world.create_shape(ball, &notes);
    ASSERT_TRUE(shape.ok());
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_NE(notes[0].find("400 corners, reduced to 64"), std::string::npos) << notes[0];
    const BodyId body =
        test.world.create_body({.kind = BodyKind::Dynamic, .shape = *shape, .mass_kg = 10});
    const Vec3d moments{test.world.state(body).mass.inertia_kgm2};
    EXPECT_NEAR(moments.x, 4.0, 0.5) << "a ball of radius 1 has 4 kg m2";
}

TEST(ShapeMass, HullOffItsOriginKnowsItsCentreAndInertia) {
    TestWorld test;
    const MassProperties mass = weigh(test, HullShape{corners_of_box({1, 2, 3}, {2, 4, 6})}, 12);
    expect_near(mass.center_of_mass_m, {1.5, 3, 4.5}, 50 * kRounding);
    expect_near(mass.inertia_kgm2, {13, 10, 5}, 200 * kRounding);
}

}  // namespace
}  // namespace plumbline::physics
