#include "tests/engine/physics/test_world.h"

#include <cmath>

namespace plumbline::physics {
namespace {

TEST(Friction, CombinesAsGeometricMeanAndStopsASlideWhereCoulombSays) {
    // sqrt(0.9 * 0.1) = 0.3: v^2 / (2 mu g) = 4.2473667 m from 5 m/s.
    TestWorld test(at_hz(240));
    test.ground(0.9_r);
    const BodyId box =
        test.add(BoxShape{.size_m = {1, 0.2_r, 1}},
                 {0, 0.1_r, 0},
                 {.kind = BodyKind::Dynamic, .velocity_mps = {5, 0, 0}, .friction = 0.1_r});
    test.run(3.0);
    // Bullet's friction rows use last step's normal force: 1 % covers that and the first contact.
    EXPECT_NEAR(test.at(box).x, 4.2473667, 0.01 * 4.2473667);
    EXPECT_NEAR(test.velocity(box).x, 0.0, 1e-3);
}

TEST(Friction, NoneOnOneSideMeansNone) {
    TestWorld test;
    test.ground(1);
    const BodyId box =
        test.add(BoxShape{.size_m = {1, 0.2_r, 1}},
                 {0, 0.1_r, 0},
                 {.kind = BodyKind::Dynamic, .velocity_mps = {5, 0, 0}, .friction = 0});
    test.run(2.0);
    EXPECT_NEAR(test.velocity(box).x, 5.0, 1e-4);
}

/// Highest point of a ball dropped from 1 m, after its first impact.
double apex_after_bounce(Real ground_restitution, Real ball_restitution) {
    TestWorld test(at_hz(240));
    test.ground(0.5_r, ground_restitution);
    const BodyId ball = test.add(SphereShape{.radius_m = 0.1_r},
                                 {0, 1.1_r, 0},
                                 {.kind = BodyKind::Dynamic, .restitution = ball_restitution});
    test.run(std::sqrt(2.0 / kG) + 0.02);
    double apex = 0;
    for (int i = 0; i < 240; ++i) {
        test.world.step();
        apex = std::max(apex, test.at(ball).y - 0.1);
    }
    return apex;
}

TEST(Restitution, CombinesAsMaximum) {
    const double both = apex_after_bounce(0.5_r, 0.5_r);
    EXPECT_EQ(apex_after_bounce(0, 0.5_r), both);
    EXPECT_EQ(apex_after_bounce(0.5_r, 0), both);
    // e^2 H = 0.25 m. Stock Bullet adds a fifth of the overlap per step to the rebound, so that its
    // bounces come out too high by a share that depends on where in the step the impact falls.
    EXPECT_GT(both, 0.24);
    EXPECT_LT(both, 0.45);
    EXPECT_LT(apex_after_bounce(0, 0), 0.05);
}

TEST(Restitution, RollingFrictionStopsABallAndNoneLetsItRoll) {
    TestWorld test;
    test.ground(1);
    const auto roll = [&test](Real z, Real rolling_friction) {
        return test.add(SphereShape{.radius_m = 0.2_r},
                        {0, 0.2_r, z},
                        {.kind = BodyKind::Dynamic,
                         .velocity_mps = {2, 0, 0},
                         .angular_velocity_radps = {0, 0, -10},
                         .friction = 1,
                         .rolling_friction = rolling_friction});
    };
    const BodyId free = roll(0, 0);
    const BodyId held = roll(5, 0.02_r);
    test.run(4.0);
    EXPECT_NEAR(test.velocity(free).x, 2.0, 0.02);
    EXPECT_NEAR(test.velocity(held).x, 0.0, 0.01);
}

TEST(SmallThings, OneCentimetreCubeRestsOnTheGround) {
    TestWorld test(at_hz(120));
    test.ground();
    const BodyId die = test.add(BoxShape{.size_m = {0.01_r, 0.01_r, 0.01_r}},
                                {0, 0.02_r, 0},
                                {.kind = BodyKind::Dynamic, .mass_kg = 0.002_r});
    test.run(3.0);
    EXPECT_NEAR(test.at(die).y, 0.005, 0.0002) << "gap or overlap below 0.2 mm";
    EXPECT_LT(glm::length(test.velocity(die)), 0.002);
}

TEST(SmallThings, OneCentimetreHullRestsOnABox) {
    TestWorld test(at_hz(120));
    test.add(BoxShape{.size_m = {1, 0.1_r, 1}}, {0, -0.05_r, 0}, {.kind = BodyKind::Static});
    HullShape hull;
    for (const Real x : {-0.005_r, 0.005_r}) {
        for (const Real y : {-0.005_r, 0.005_r}) {
            for (const Real z : {-0.005_r, 0.005_r}) hull.points_m.push_back({x, y, z});
        }
    }
    const BodyId die =
        test.add(hull, {0, 0.02_r, 0}, {.kind = BodyKind::Dynamic, .mass_kg = 0.002_r});
    test.run(3.0);
    EXPECT_NEAR(test.at(die).y, 0.005, 0.0002);
}

struct SlideCase {
    const char* name;
    ShapeDef shape;
    Real height_m;
    Real yaw_rad;
};

class MeshSlide : public testing::TestWithParam<int> {};

TEST_P(MeshSlide, KeepsSpeedHeadingAndStaysDown) {
    const std::vector<SlideCase> cases{
        {"box", BoxShape{}, 0.5_r, 0},
        {"box, turned", BoxShape{}, 0.5_r, radians_from_degrees(30.0_r)},
        {"ball", SphereShape{}, 0.5_r, 0},
        {"ball, turned", SphereShape{}, 0.5_r, radians_from_degrees(30.0_r)}};
    const SlideCase& slide = cases[static_cast<std::size_t>(GetParam())];
    SCOPED_TRACE(slide.name);
    TestWorld test;
    test.add(flat_mesh(64, 1), {0, 0, 0}, {.kind = BodyKind::Static, .friction = 0});
    const Vec3 heading{std::cos(slide.yaw_rad), 0, std::sin(slide.yaw_rad)};
    const Vec3 start = Vec3{0, slide.height_m, 0} - 15.0_r * heading;
    const BodyId body =
        test.add(slide.shape,
                 start,
                 {.kind = BodyKind::Dynamic, .velocity_mps = 10.0_r * heading, .friction = 0});
    double fastest_up = 0;
    for (int i = 0; i < 180; ++i) {
        test.world.step();
        fastest_up = std::max(fastest_up, test.velocity(body).y);
    }
    const Vec3d v = test.velocity(body);
    EXPECT_LT(fastest_up, 0.02);
    EXPECT_NEAR(std::hypot(v.x, v.z), 10.0, 0.01);
    const Vec3d h{heading};
    EXPECT_LT(std::abs(v.x * h.z - v.z * h.x) / 10.0, 0.0017) << "heading off by 0.1 degree";
}

INSTANTIATE_TEST_SUITE_P(Things, MeshSlide, testing::Range(0, 4));

TEST(MeshContact, HoldsOnMeshesThatAreMovedAndTurned) {
    // A hillside made of a flat mesh, far from the origin: Bullet 3.24 alone lets
    // things fall through such a mesh.
    for (const Real degrees : {0.0_r, 20.0_r, 180.0_r}) {
        TestWorld test;
        const Quat turned = glm::angleAxis(radians_from_degrees(degrees), Vec3{1, 0, 0});
        test.world.create_body(
            {.shape = test.shape(flat_mesh(24, 1)),
             .world_from_body = {.position = {40, -30, 10}, .orientation = turned},
             .friction = 4});
        const Vec3 normal = turned * Vec3{0, degrees > 90 ? -1.0_r : 1.0_r, 0};
        const std::vector<ShapeDef> shapes{BoxShape{.size_m = {0.4_r, 0.4_r, 0.4_r}},
                                           SphereShape{.radius_m = 0.2_r},
                                           CapsuleShape{.radius_m = 0.2_r, .height_m = 0.5_r},
                                           CylinderShape{.radius_m = 0.2_r, .height_m = 0.5_r},
                                           ConeShape{.radius_m = 0.2_r, .height_m = 0.5_r}};
        std::vector<BodyId> things;
        for (const ShapeDef& shape : shapes) {
            const Vec3 along = turned * Vec3{static_cast<Real>(things.size()) - 2, 0, 0.3_r};
            things.push_back(test.add(shape, Vec3{40, -30, 10} + along + 0.7_r * normal));
        }
        test.run(1.0);
        for (std::size_t i = 0; i < things.size(); ++i) {
            const Vec3 above =
                test.world.state(things[i]).world_from_body.position - Vec3{40, -30, 10};
            EXPECT_GT(glm::dot(above, normal), 0.05_r) << degrees << " degrees, thing " << i;
        }
    }
}

/// Floor and walls of one mesh: each face keeps its own contact points.
TEST(MeshContact, BoxInACornerOfARoomRests) {
    MeshShape room = flat_mesh(4, 1);
    const auto wall = [&room](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
        const auto first = static_cast<std::uint32_t>(room.vertices_m.size());
        for (const Vec3& corner : {a, b, c, d}) room.vertices_m.push_back(corner);
        room.triangles.push_back({first, first + 1, first + 2});
        room.triangles.push_back({first, first + 2, first + 3});
    };
    wall({2, 0, -2}, {2, 0, 2}, {2, 3, 2}, {2, 3, -2});
    wall({-2, 0, 2}, {-2, 3, 2}, {2, 3, 2}, {2, 0, 2});
    TestWorld test;
    test.add(room, {0, 0, 0}, {.kind = BodyKind::Static});
    const BodyId box = test.add(BoxShape{}, {1.4_r, 0.6_r, 1.4_r});
    for (int i = 0; i < 240; ++i) {
        test.world.apply_force(box, {6, 0, 6});
        test.world.step();
    }
    EXPECT_NEAR(test.at(box).x, 1.5, 0.01);
    EXPECT_NEAR(test.at(box).z, 1.5, 0.01);
    EXPECT_NEAR(test.at(box).y, 0.5, 0.01);
    // Pressed against two walls for good, Gauss-Seidel leaves a tremble that moves nothing.
    EXPECT_LT(glm::length(test.velocity(box)), 0.01);
    EXPECT_LT(glm::length(test.spin(box)), 0.01);
}

TEST(Events, OneLinePerPairWithImpulseAndSpeed) {
    TestWorld test;
    const BodyId floor = test.ground();
    const BodyId box =
        test.add(BoxShape{},
                 {0, 1.5_r, 0},
                 {.kind = BodyKind::Dynamic, .mass_kg = 3, .contact_events = true, .user = 7});
    test.add(BoxShape{}, {5, 0.6_r, 0});
    int begun = 0;
    double struck_at_mps = 0;
    for (int i = 0; i < 180; ++i) {
        test.world.step();
        for (const ContactEvent& event : test.world.contacts()) {
            EXPECT_EQ(event.a, floor);
            EXPECT_EQ(event.b, box);
            EXPECT_EQ(event.user_b, 7U);
            EXPECT_NEAR(static_cast<double>(event.normal_world.y), -1.0, 1e-3) << "from b to a";
            if (event.began) {
                ++begun;
                struck_at_mps = static_cast<double>(event.closing_speed_mps);
            }
        }
        EXPECT_LE(test.world.contacts().size(), 1U);
        EXPECT_EQ(test.world.feature_use().events, test.world.contacts().size());
    }
    EXPECT_EQ(begun, 1);
    EXPECT_NEAR(struck_at_mps, std::sqrt(2 * kG * 1.0), kG / 60) << "a fall of 1 m, to a step";
    ASSERT_EQ(test.world.contacts().size(), 1U);
    EXPECT_NEAR(
        static_cast<double>(test.world.contacts()[0].impulse_Ns), 3 * kG / 60, 0.02 * 3 * kG / 60)
        << "at rest the impulse carries the weight";
    EXPECT_EQ(test.world.all_contacts().size(), 2U);
}

TEST(Events, SubstepsAddUp) {
    TestWorld test(at_hz(60, 4));
    test.ground();
    test.add(BoxShape{},
             {0, 0.5_r, 0},
             {.kind = BodyKind::Dynamic, .mass_kg = 3, .contact_events = true});
    test.run(1.0);
    ASSERT_EQ(test.world.contacts().size(), 1U);
    EXPECT_NEAR(
        static_cast<double>(test.world.contacts()[0].impulse_Ns), 3 * kG / 60, 0.02 * 3 * kG / 60);
}

TEST(Events, NobodyAskedMeansNone) {
    TestWorld test;
    test.ground();
    const BodyId box = test.add(BoxShape{}, {0, 0.5_r, 0});
    test.run(0.5);
    EXPECT_TRUE(test.world.contacts().empty());
    EXPECT_EQ(test.world.feature_use().events_ms, 0.0);
    test.world.set_contact_events(box, true);
    test.world.step();
    EXPECT_EQ(test.world.contacts().size(), 1U);
    test.world.set_features({.contact_events = false});
    test.world.step();
    EXPECT_TRUE(test.world.contacts().empty());
}

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

class EverySolver : public testing::TestWithParam<Solver> {};

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
    EXPECT_GE(test.world.cost().contacts, 12U);
    EXPECT_GE(test.world.cost().row_solves, 2U * test.world.cost().contacts);
    EXPECT_LT(test.world.max_penetration_m(), 0.02);
    EXPECT_EQ(solver_from_name(solver_name(GetParam())), GetParam());
}

INSTANTIATE_TEST_SUITE_P(
    Solvers,
    EverySolver,
    testing::Values(Solver::BulletSi, Solver::BulletNncg, Solver::BulletDantzig, Solver::BulletPgs),
    [](const auto& param_info) { return std::string(solver_name(param_info.param)); });

TEST(SolverNames, UnknownIsNone) {
    EXPECT_EQ(solver_from_name("bullet_lemke"), std::nullopt);
}

}  // namespace
}  // namespace plumbline::physics
