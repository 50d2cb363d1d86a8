#include "engine/core/limits.h"
#include "tests/engine/physics/test_world.h"

#include <cmath>
#include <limits>

namespace plumbline::physics {
namespace {

MassProperties weigh(TestWorld& test, const ShapeDef& def, Real mass_kg) {
    const BodyId body = test.add(def, {0, 0, 0}, {.kind = BodyKind::Dynamic, .mass_kg = mass_kg});
    const MassProperties mass = test.world.mass_properties(body);
    test.world.destroy_body(body);
    return mass;
}

void expect_near(const Vec3& got, const Vec3d& want, double tolerance) {
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(static_cast<double>(got[axis]), want[axis], tolerance) << "axis " << axis;
    }
}

std::vector<Vec3> corners_of_box(const Vec3& low, const Vec3& high) {
    std::vector<Vec3> corners;
    for (int i = 0; i < 8; ++i) {
        corners.push_back({(i & 1) != 0 ? high.x : low.x,
                           (i & 2) != 0 ? high.y : low.y,
                           (i & 4) != 0 ? high.z : low.z});
    }
    return corners;
}

TEST(ShapeMass, ClosedFormsOfPrimitives) {
    TestWorld test;
    const double tolerance = 50 * kRounding;
    expect_near(
        weigh(test, BoxShape{.size_m = {1, 2, 3}}, 12).inertia_kgm2, {13, 10, 5}, tolerance);
    expect_near(weigh(test, SphereShape{.radius_m = 2}, 5).inertia_kgm2, {8, 8, 8}, tolerance);
    expect_near(weigh(test, CylinderShape{.radius_m = 1, .height_m = 3}, 4).inertia_kgm2,
                {4, 2, 4},
                tolerance);
    const MassProperties cone = weigh(test, ConeShape{.radius_m = 1, .height_m = 2}, 10);
    expect_near(cone.inertia_kgm2, {3, 3, 3}, tolerance);
    expect_near(cone.center_of_mass_m, {0, -0.5, 0}, tolerance);
}

TEST(ShapeMass, CapsuleIsACylinderAndTwoHalfBalls) {
    TestWorld test;
    const double r = 0.5;
    const double h = 2.0;
    const double barrel = kPiD * r * r * h;
    const double half = 2.0 / 3.0 * kPiD * r * r * r;
    const double share = 7.0 / (barrel + 2 * half);
    // A half ball about its own centre: 83/320 m r^2 across, at h/2 + 3r/8.
    const double offset = 0.5 * h + 0.375 * r;
    const double across =
        barrel * (3 * r * r + h * h) / 12 + 2 * half * (83.0 / 320.0 * r * r + offset * offset);
    const double along = 0.5 * barrel * r * r + 2 * half * 0.4 * r * r;
    expect_near(weigh(test, CapsuleShape{.radius_m = 0.5_r, .height_m = 2}, 7).inertia_kgm2,
                {share * across, share * along, share * across},
                50 * kRounding);
}

TEST(ShapeMass, HullOffItsOriginKnowsItsCentreAndInertia) {
    TestWorld test;
    const MassProperties mass = weigh(test, HullShape{corners_of_box({1, 2, 3}, {2, 4, 6})}, 12);
    expect_near(mass.center_of_mass_m, {1.5, 3, 4.5}, 50 * kRounding);
    expect_near(mass.inertia_kgm2, {13, 10, 5}, 200 * kRounding);
}

TEST(ShapeMass, TetrahedronByItsClosedForm) {
    TestWorld test;
    // Corner at the origin, legs 1: centre 1/4 each; about it Ixx = m (3/80 + 3/80), Ixy = m/80.
    const MassProperties mass =
        weigh(test, HullShape{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, 80);
    expect_near(mass.center_of_mass_m, {0.25, 0.25, 0.25}, 50 * kRounding);
    Vec3d moments{mass.inertia_kgm2};
    if (moments.x > moments.y) std::swap(moments.x, moments.y);
    if (moments.y > moments.z) std::swap(moments.y, moments.z);
    if (moments.x > moments.y) std::swap(moments.x, moments.y);
    // 6 on the diagonal, 1 beside it: 5 + 1 * {0, 0, 3}... or 7, 7, 4 when the sign is negative.
    const double sum = moments.x + moments.y + moments.z;
    EXPECT_NEAR(sum, 18.0, 1e-3);
    EXPECT_NEAR(moments.y * moments.z * moments.x, 5.0 * 5.0 * 8.0, 0.01);
}

TEST(ShapeMass, CompoundWeighsByVolumeAndParallelAxes) {
    TestWorld test;
    // Two unit cubes 3 m apart: I = 2 * (1/6) along, 2 * (1/6 + 1.5^2) across, for 2 kg.
    CompoundShape dumbbell;
    dumbbell.children.push_back({.shape = BoxShape{}, .body_from_child = {.position = {-1, 5, 0}}});
    dumbbell.children.push_back({.shape = BoxShape{}, .body_from_child = {.position = {2, 5, 0}}});
    const MassProperties mass = weigh(test, dumbbell, 2);
    expect_near(mass.center_of_mass_m, {0.5, 5, 0}, 50 * kRounding);
    const double across = 2 * (1.0 / 6.0 + 2.25);
    expect_near(mass.inertia_kgm2, {1.0 / 3.0, across, across}, 100 * kRounding);
}

TEST(ShapeMass, OverridesHold) {
    TestWorld test;
    const BodyId body = test.add(BoxShape{},
                                 {1, 2, 3},
                                 {.kind = BodyKind::Dynamic,
                                  .mass_kg = 2,
                                  .inertia_kgm2 = Vec3{1, 2, 3},
                                  .center_of_mass_m = Vec3{0, -0.4_r, 0}});
    const MassProperties mass = test.world.mass_properties(body);
    expect_near(mass.inertia_kgm2, {1, 2, 3}, kRounding);
    expect_near(mass.center_of_mass_m, {0, -0.4, 0}, kRounding);
    expect_near(test.world.state(body).world_from_body.position, {1, 2, 3}, 10 * kRounding);
    Vec3 low;
    Vec3 high;
    test.world.bounds(body, low, high);
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

TEST(ShapeContact, ConeStandsOnItsBaseWithoutGap) {
    TestWorld test;
    test.ground();
    const BodyId cone = test.add(ConeShape{.radius_m = 0.5_r, .height_m = 1}, {0, 0.55_r, 0});
    test.run(3.0);
    EXPECT_NEAR(test.at(cone).y, 0.5, 0.01);
}

TEST(ShapeContact, CompoundTableStandsOnItsLegs) {
    TestWorld test;
    test.ground();
    CompoundShape table;
    table.children.push_back({.shape = BoxShape{.size_m = {1, 0.1_r, 1}}, .body_from_child = {}});
    for (const Real x : {-0.4_r, 0.4_r}) {
        for (const Real z : {-0.4_r, 0.4_r}) {
            table.children.push_back({.shape = BoxShape{.size_m = {0.1_r, 0.8_r, 0.1_r}},
                                      .body_from_child = {.position = {x, -0.45_r, z}}});
        }
    }
    const BodyId body = test.add(table, {0, 0.9_r, 0}, {.kind = BodyKind::Dynamic, .mass_kg = 10});
    test.run(3.0);
    EXPECT_NEAR(test.at(body).y, 0.85, 0.01);
}

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
    test.world.bounds(body, low, high);
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
    const Vec3d moments{test.world.mass_properties(body).inertia_kgm2};
    EXPECT_NEAR(moments.x, 4.0, 0.5) << "a ball of radius 1 has 4 kg m2";
}

std::string refusal(const ShapeDef& def) {
    TestWorld test;
    const auto made = test.world.create_shape(def);
    return made.ok() ? "" : made.error().message;
}

TEST(ShapeRefusals, SayWhatIsWrong) {
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    EXPECT_EQ(refusal(BoxShape{.size_m = {1, 0, 1}}),
              "shape: box: height is 0 m; it must lie between 0.001 and 10000 m");
    EXPECT_EQ(refusal(SphereShape{.radius_m = nan}),
              "shape: sphere: radius is nan m; it must lie between 0.001 and 10000 m");
    EXPECT_EQ(refusal(CylinderShape{.radius_m = 1, .height_m = -2}),
              "shape: cylinder: height is -2 m; it must lie between 0.001 and 10000 m");
    EXPECT_EQ(refusal(HullShape{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}),
              "shape: hull: 3 points; a hull needs at least 4");
    EXPECT_EQ(refusal(HullShape{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, nan}}}),
              "shape: hull: a point is not finite");
    EXPECT_EQ(refusal(CompoundShape{}), "shape: compound: it has no children");
    EXPECT_EQ(refusal(MeshShape{}), "shape: mesh: it has no triangles");
    MeshShape bad = flat_mesh(1, 1);
    bad.triangles[1][2] = 9;
    EXPECT_EQ(refusal(bad), "shape: mesh: triangle 1 names vertex 9 of 4");
    CompoundShape nested;
    nested.children.push_back({.shape = flat_mesh(1, 1), .body_from_child = {}});
    EXPECT_EQ(refusal(nested), "shape: compound: a mesh may not be part of a compound; use hulls");
}

TEST(ShapeRefusals, LimitsThemselvesAreAllowed) {
    EXPECT_EQ(refusal(SphereShape{.radius_m = static_cast<Real>(limits::kSizeMin_m)}), "");
    EXPECT_EQ(refusal(SphereShape{.radius_m = static_cast<Real>(limits::kSizeMax_m)}), "");
    EXPECT_NE(refusal(SphereShape{.radius_m = static_cast<Real>(limits::kSizeMax_m) * 1.01_r}), "");
    EXPECT_NE(refusal(SphereShape{.radius_m = static_cast<Real>(limits::kSizeMin_m) * 0.99_r}), "");
}

TEST(ShapeNotes, TrianglesWithoutAreaAreLeftOut) {
    TestWorld test;
    MeshShape mesh = flat_mesh(2, 1);
    mesh.triangles.push_back({0, 1, 2});
    mesh.triangles.push_back({4, 4, 5});
    std::vector<std::string> notes;
    ASSERT_TRUE(test.world.create_shape(mesh, &notes).ok());
    EXPECT_EQ(notes, std::vector<std::string>{"mesh: 2 triangles without area left out"});
}

}  // namespace
}  // namespace plumbline::physics
