// Contacts follow their bodies through the step: arms, rims, rolling normals; what rocks, falls over and rolls keeps its energy.
#include "engine/physics/dynamics/contact/contact_constraint.h"
#include "tests/engine/physics/test_world.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::physics {
namespace {

/// One point of a body of 1 kg over the ground, half a metre below its centre.
struct OnePoint {
    SolverBody ground;
    SolverBody body;
    ContactConstraint contact;

    OnePoint() {
        body.inverse_mass = 1;
        body.inverse_inertia = {.xx = 1, .yy = 1, .zz = 1};
        contact.a = 1;
        contact.count = 1;
        contact.friction = 0.5_r;
        contact.tangent[0] = {1, 0, 0};
        contact.tangent[1] = {0, 0, 1};
        contact.start_separation_m[0] = 0;
        set_lane(contact.offset_a, 0, {0, -0.5_r, 0});
    }
    void turn(const Vec3& about, Real angle_rad) {
        prepare(contact, body, ground, {}, 1);
        body.delta_rotation = glm::angleAxis(angle_rad, about);
        body.turned.total_rad = angle_rad;
        follow(contact, body, ground);
    }
};

void expect_place_near(const Vec3& is, const Vec3& wanted) {
    EXPECT_NEAR(static_cast<double>(glm::distance(is, wanted)), 0, 1e-5);
}

TEST(ContactFollow, APointTurnsWithItsBody) {
    OnePoint on;
    on.turn({0, 0, 1}, 0.2_r);
    const Real sine = std::sin(0.2_r);
    const Real cosine = std::cos(0.2_r);
    const Vec3 arm{0.5_r * sine, -0.5_r * cosine, 0};
    expect_place_near(lane(on.contact.angular_a, 0), glm::cross(arm, Vec3{0, 1, 0}));
    expect_place_near(on.contact.center_a, arm);
    EXPECT_NEAR(static_cast<double>(on.contact.separation_m[0]), 0.5 * (1 - std::cos(0.2)), 1e-6);
}

// Beyond that it touches with other points than were found.
TEST(ContactFollow, APointStaysWhereTheBodyTurnsFar) {
    OnePoint on;
    on.turn({0, 0, 1}, 1);
    expect_place_near(on.contact.center_a, {0, -0.5_r, 0});
}

// A disc of 0.5 m that stands on its rim: the lowest point stays lowest as it rolls, and goes along as it turns about the vertical.
TEST(ContactFollow, ARimStaysWhereItIsAsItRolls) {
    OnePoint rolling;
    rolling.contact.axis_a = {0, 0, 1};
    rolling.contact.rolls = true;
    rolling.turn({0, 0, 1}, 0.3_r);
    expect_place_near(rolling.contact.center_a, {0, -0.5_r, 0});
    EXPECT_NEAR(static_cast<double>(rolling.contact.separation_m[0]), 0, 1e-6);

    OnePoint leaning;
    const Real lean = 0.7_r;
    leaning.contact.axis_a = {0, std::sin(lean), std::cos(lean)};
    leaning.contact.rolls = true;
    set_lane(leaning.contact.offset_a, 0, {0, -0.5_r * std::cos(lean), 0.5_r * std::sin(lean)});
    leaning.turn({0, 1, 0}, 0.3_r);
    expect_place_near(leaning.contact.center_a,
                      {0.5_r * std::sin(lean) * std::sin(0.3_r),
                       -0.5_r * std::cos(lean),
                       0.5_r * std::sin(lean) * std::cos(0.3_r)});
}

// A plate turns on a fixed roller of 0.4 m: it touches farther out by radius times angle, and its normal goes along.
TEST(ContactFollow, AFaceTakesTheNormalAlong) {
    OnePoint on;
    on.contact.radius_b = 0.4_r;
    on.contact.face_turns = true;
    set_lane(on.contact.offset_a, 0, {0, 0, 0});  // thin
    on.turn({0, 0, 1}, 0.1_r);
    expect_place_near(on.contact.normal, {-std::sin(0.1_r), std::cos(0.1_r), 0});
    const Vec3 across{std::cos(0.1_r), std::sin(0.1_r), 0};
    EXPECT_NEAR(
        static_cast<double>(glm::dot(on.contact.center_a, across)), -0.4 * std::sin(0.1), 1e-5);
    EXPECT_NEAR(static_cast<double>(on.contact.separation_m[0]), 0.4 * (std::cos(0.1) - 1), 1e-5);
}

TEST(ContactFollow, MassesAreWeighedForTheArmsThereAre) {
    OnePoint on;
    on.turn({0, 0, 1}, 0.3_r);
    const auto response = [&] { return static_cast<double>(on.contact.response[0][0]); };
    EXPECT_NEAR(response(), 1, 1e-6);
    weigh_anew(on.contact, on.body, on.ground);
    EXPECT_NEAR(response(), 1 + std::pow(0.5 * std::sin(0.3), 2), 1e-6);
}

const WorldDef kDefault{
    .substeps = 2, .substeps_max = 16, .iterations = 1, .solver = Solver::SmallStep};
constexpr Real kRough = 1;

BodyDef moving(Real mass_kg, const Quat& turned = kNoRotation) {
    BodyDef body{
        .kind = BodyKind::Dynamic, .mass_kg = mass_kg, .friction = kRough, .can_sleep = false};
    body.world_from_body.orientation = turned;
    return body;
}

// A plank that rocks on a roller: w^2 = g (R - h) / (l^2 / 12 + 4 h^2 / 3), h half its thickness.
TEST(RollingContact, APlankRocksOnARollerAndKeepsItsWidth) {
    TestWorld test(kDefault);
    test.add(CylinderShape{0.5_r, 1},
             {0, 0, 0},
             {.world_from_body = {{0, 0, 0}, glm::angleAxis(kPi / 2, Vec3{1, 0, 0})},
              .friction = kRough});
    const BodyId plank = test.add(BoxShape{{2, 0.04_r, 0.3_r}}, {0, 0.52_r, 0}, moving(2));
    test.world.set_velocity(plank, {0, 0, 0}, {0, 0, 0.1_r});
    double first = 0;
    double last = 0;
    int turns = 0;
    double before = 0.1;
    for (int i = 0; i < 1200; ++i) {
        test.world.step();
        const double spin = static_cast<double>(test.world.state(plank).angular_velocity_radps.z);
        if (i < 200) first = std::max(first, spin);
        if (i >= 1000) last = std::max(last, spin);
        turns += spin * before < 0 ? 1 : 0;
        before = spin;
    }
    EXPECT_NEAR(last, first, 0.01 * first);
    const double h = 0.02;
    const double w = std::sqrt(kG * (0.5 - h) / (4.0 / 12 + 4 * h * h / 3));
    EXPECT_NEAR(turns, 20 * w / kPiD, 1);
}

// A beam that falls over on its edge: w^2 = 2 m g r (cos from - cos to) / I.
TEST(RollingContact, ABeamFallsOverAsItsEnergySays) {
    TestWorld test(kDefault);
    test.ground(3);
    const double lean = 10 * kPiD / 180;
    const double half = 0.025;
    const BodyId beam =
        test.add(BoxShape{{0.05_r, 1, 0.5_r}},
                 {static_cast<Real>(std::sin(lean) / 2 - half * std::cos(lean)),
                  static_cast<Real>(std::cos(lean) / 2 + half * std::sin(lean)),
                  0},
                 moving(2, glm::angleAxis(static_cast<Real>(-lean), Vec3{0, 0, 1})));
    double angle = lean;
    while (angle < 60 * kPiD / 180) {
        test.world.step();
        const Quat& q = test.world.state(beam).world_from_body.orientation;
        angle = -2 * std::atan2(static_cast<double>(q.z), static_cast<double>(q.w));
    }
    const double edge = std::atan2(2 * half, 1.0);
    const double r = std::hypot(0.5, half);
    const double inertia = (1 + 4 * half * half) / 3;
    const double wanted =
        std::sqrt(2 * kG * r * (std::cos(lean - edge) - std::cos(angle - edge)) / inertia);
    EXPECT_NEAR(-static_cast<double>(test.world.state(beam).angular_velocity_radps.z),
                wanted,
                0.012 * wanted);
}

// A disc that goes round on its rim, its centre at rest (Euler's disk): W^2 sin(tilt) = 4 g / R.
TEST(RollingContact, ADiscGoesRoundOnItsRim) {
    TestWorld test(kDefault);
    test.ground(kRough);
    const double radius = 0.3;
    const double tilt = 60 * kPiD / 180;
    const double spin = std::sqrt(4 * kG * std::sin(tilt) / radius);
    const double height = radius * std::sin(tilt) + 0.01 * std::cos(tilt);
    const BodyId disc = test.add(CylinderShape{0.3_r, 0.02_r},
                                 {0, static_cast<Real>(height), 0},
                                 moving(1, glm::angleAxis(static_cast<Real>(tilt), Vec3{0, 0, 1})));
    test.world.set_velocity(
        disc,
        {0, 0, 0},
        {static_cast<Real>(spin * std::cos(tilt)), static_cast<Real>(spin * std::sin(tilt)), 0});
    for (int i = 0; i < 240; ++i) test.world.step();
    const BodyState state = test.world.state(disc);
    const Vec3d axis{state.world_from_body.orientation * Vec3{0, 1, 0}};
    const Vec3d turning = test.spin(disc);
    const double along = glm::dot(turning, axis);
    const double across2 = glm::dot(turning, turning) - along * along;
    const double moved2 = glm::dot(test.velocity(disc), test.velocity(disc));
    const double energy_J =
        kG * test.at(disc).y + moved2 / 2 + radius * radius * (along * along / 4 + across2 / 8);
    const double start_J = kG * height + radius * radius * spin * spin / 8;
    EXPECT_NEAR(energy_J, start_J, 0.015 * start_J);
    EXPECT_NEAR(std::acos(axis.y) * 180 / kPiD, 60, 8);
}

}  // namespace
}  // namespace plumbline::physics
