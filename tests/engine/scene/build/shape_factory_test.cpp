#include "engine/scene/build/shape_factory.h"

#include "tests/support/near.h"

#include <gtest/gtest.h>

namespace plumbline::scene {
namespace {

using physics::BoxShape;
using physics::CapsuleShape;
using physics::CompoundChild;
using physics::CompoundShape;
using physics::ConeShape;
using physics::CylinderShape;
using physics::HullShape;
using physics::ShapeDef;
using physics::SphereShape;

TEST(Volumes, FollowTheFormulas) {
    const auto volume = [](const ShapeDef& shape) { return static_cast<double>(volume_of(shape)); };
    const double pi = glm::pi<double>();
    EXPECT_NEAR(volume(BoxShape{.size_m = {1, 2, 3}}), 6.0, 1e-6);
    EXPECT_NEAR(volume(SphereShape{.radius_m = 2}), 4.0 / 3.0 * pi * 8.0, 1e-4);
    EXPECT_NEAR(volume(CylinderShape{.radius_m = 2, .height_m = 3}), pi * 12.0, 1e-4);
    EXPECT_NEAR(volume(ConeShape{.radius_m = 2, .height_m = 3}), pi * 4.0, 1e-4);
    // Between the caps' centres a cylinder, the caps together a ball.
    EXPECT_NEAR(
        volume(CapsuleShape{.radius_m = 1, .height_m = 3}), pi * 3.0 + pi * 4.0 / 3.0, 1e-4);
    const CompoundShape two{
        .children = {{.shape = BoxShape{.size_m = {1, 1, 1}}, .body_from_child = {}},
                     {.shape = BoxShape{.size_m = {1, 1, 2}}, .body_from_child = {}}}};
    EXPECT_NEAR(volume(two), 3.0, 1e-6);
}

TEST(Scaling, KeepsRoundShapesRoundWhereItCan) {
    const ShapeDef even = scaled(SphereShape{.radius_m = 2}, Vec3{3, 3, 3});
    ASSERT_TRUE(std::holds_alternative<SphereShape>(even));
    EXPECT_EQ(std::get<SphereShape>(even).radius_m, Real{6});
    const ShapeDef tall = scaled(CylinderShape{.radius_m = 1, .height_m = 2}, Vec3{2, 5, 2});
    ASSERT_TRUE(std::holds_alternative<CylinderShape>(tall));
    EXPECT_EQ(std::get<CylinderShape>(tall).radius_m, Real{2});
    EXPECT_EQ(std::get<CylinderShape>(tall).height_m, Real{10});
}

TEST(Scaling, StretchesABallToAnEllipsoid) {
    const ShapeDef egg = scaled(SphereShape{.radius_m = 1}, Vec3{1, 2, 1});
    ASSERT_TRUE(std::holds_alternative<HullShape>(egg));
    Vec3 min;
    Vec3 max;
    bounds_of(egg, min, max);
    EXPECT_TRUE(test::near(max, Vec3{1, 2, 1}, 1e-5));
    EXPECT_TRUE(test::near(min, Vec3{-1, -2, -1}, 1e-5));
}

TEST(Scaling, ShearsTurnedPartsOfACompound) {
    const Real half_turn = radians_from_degrees(90.0_r);
    const CompoundShape rod{.children = {{.shape = BoxShape{.size_m = {4, 1, 1}},
                                          .body_from_child = {.position = {1, 0, 0},
                                                              .orientation = glm::angleAxis(
                                                                  half_turn, Vec3{0, 0, 1})}}}};
    Vec3 min;
    Vec3 max;
    bounds_of(scaled(ShapeDef{rod}, Vec3{2, 3, 1}), min, max);
    // Turned upright it is 1 wide about x = 1 and 4 high; then x doubles and y triples.
    EXPECT_TRUE(test::near(min, Vec3{1, -6, -0.5_r}, 1e-5));
    EXPECT_TRUE(test::near(max, Vec3{3, 6, 0.5_r}, 1e-5));
}

TEST(ShapeFactory, MakesEqualShapesOnce) {
    physics::PhysicsWorld world({});
    ShapeFactory factory(world);
    std::vector<std::string> notes;
    const Result<BuiltShape> first = factory.make(BoxShape{.size_m = {1, 2, 3}}, notes);
    const Result<BuiltShape> same = factory.make(BoxShape{.size_m = {1, 2, 3}}, notes);
    const Result<BuiltShape> other = factory.make(BoxShape{.size_m = {3, 2, 1}}, notes);
    ASSERT_TRUE(first.ok() && same.ok() && other.ok());
    EXPECT_EQ(first->id, same->id);
    EXPECT_NE(first->id, other->id);
    EXPECT_EQ(factory.shape_count(), 2U);
    EXPECT_EQ(first->inner_radius_m, 0.5_r);
}

TEST(ShapeFactory, PassesRefusalsOn) {
    physics::PhysicsWorld world({});
    ShapeFactory factory(world);
    std::vector<std::string> notes;
    EXPECT_FALSE(factory.make(SphereShape{.radius_m = -1}, notes).ok());
}

}  // namespace
}  // namespace plumbline::scene
