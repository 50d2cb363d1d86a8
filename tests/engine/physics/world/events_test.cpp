// Contact events: one line per touching pair.
#include "engine/physics/query.h"
#include "engine/physics/totals.h"
#include "tests/engine/physics/world/asleep.h"

#include <cmath>

namespace plumbline::physics {
namespace {

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
        for (const ContactEvent& event : test.world.report().contacts) {
            EXPECT_EQ(event.a, floor);
            EXPECT_EQ(event.b, box);
            EXPECT_EQ(event.user_b, 7U);
            EXPECT_NEAR(static_cast<double>(event.normal_world.y), -1.0, 1e-3) << "from b to a";
            if (event.began) {
                ++begun;
                struck_at_mps = static_cast<double>(event.closing_speed_mps);
            }
        }
        EXPECT_LE(test.world.report().contacts.size(), 1U);
        EXPECT_EQ(test.world.report().use.events, test.world.report().contacts.size());
    }
    EXPECT_EQ(begun, 1);
    EXPECT_NEAR(struck_at_mps, std::sqrt(2 * kG * 1.0), kG / 60) << "a fall of 1 m, to a step";
    ASSERT_EQ(test.world.report().contacts.size(), 1U);
    EXPECT_NEAR(static_cast<double>(test.world.report().contacts[0].impulse_Ns),
                3 * kG / 60,
                0.02 * 3 * kG / 60)
        << "at rest the impulse carries the weight";
    EXPECT_EQ(all_contacts(test.world).size(), 2U);
}

TEST(Events, SubstepsAddUp) {
    TestWorld test(at_hz(60, 4));
    test.ground();
    test.add(BoxShape{},
             {0, 0.5_r, 0},
             {.kind = BodyKind::Dynamic, .mass_kg = 3, .contact_events = true});
    test.run(1.0);
    ASSERT_EQ(test.world.report().contacts.size(), 1U);
    EXPECT_NEAR(static_cast<double>(test.world.report().contacts[0].impulse_Ns),
                3 * kG / 60,
                0.02 * 3 * kG / 60);
}

TEST(Events, NobodyAskedMeansNone) {
    TestWorld test;
    test.ground();
    const BodyId box = test.add(BoxShape{}, {0, 0.5_r, 0});
    test.run(0.5);
    EXPECT_TRUE(test.world.report().contacts.empty());
    EXPECT_EQ(test.world.report().use.events_ms, 0.0);
    test.world.set_contact_events(box, true);
    test.world.step();
    EXPECT_EQ(test.world.report().contacts.size(), 1U);
    test.world.set_features({.contact_events = false});
    test.world.step();
    EXPECT_TRUE(test.world.report().contacts.empty());
}

TEST(SleepingContacts, StayListedAndDoNotBeginAnew) {
    Asleep asleep(2, {.kind = BodyKind::Dynamic, .mass_kg = 3, .contact_events = true});
    PhysicsWorld& world = asleep.test.world;
    ASSERT_EQ(world.report().contacts.size(), 2U);
    const double weight_Ns = 3 * kG / 60;
    for (const ContactEvent& event : world.report().contacts) {
        EXPECT_FALSE(event.began);
        EXPECT_EQ(event.closing_speed_mps, Real{0});
    }
    EXPECT_NEAR(static_cast<double>(world.report().contacts[0].impulse_Ns),
                2 * weight_Ns,
                0.05 * weight_Ns);
    EXPECT_NEAR(
        static_cast<double>(world.report().contacts[1].impulse_Ns), weight_Ns, 0.05 * weight_Ns);
    world.wake(asleep.tower[0]);
    world.step();
    ASSERT_EQ(world.report().contacts.size(), 2U);
    for (const ContactEvent& event : world.report().contacts) EXPECT_FALSE(event.began);
    EXPECT_EQ(all_contacts(world).size(), 2U);
}

TEST(SleepingContacts, EndWhenNoBodyAsksForThemOrOneIsGone) {
    Asleep asleep(1, {.kind = BodyKind::Dynamic, .contact_events = true});
    ASSERT_EQ(asleep.test.world.report().contacts.size(), 1U);
    asleep.test.world.set_contact_events(asleep.tower[0], false);
    asleep.test.world.step();
    EXPECT_TRUE(asleep.test.world.report().contacts.empty());

    Asleep other(1, {.kind = BodyKind::Dynamic, .contact_events = true});
    other.test.world.destroy_body(other.ground);
    other.test.world.step();
    EXPECT_TRUE(other.test.world.report().contacts.empty());
}

TEST(ContactPoints, CarryTheWeightAsleepToo) {
    TestWorld test;
    const BodyId floor = test.ground();
    const BodyId box =
        test.add(BoxShape{}, {0, 0.5_r, 0}, {.kind = BodyKind::Dynamic, .mass_kg = 3, .user = 7});
    std::vector<ContactPoint> points{{}, {}};
    contact_points(test.world, points);
    EXPECT_TRUE(points.empty());
    for (const double time_s : {1.0, 5.0}) {
        test.run(time_s);
        contact_points(test.world, points);
        ASSERT_EQ(points.size(), 4U);
        double impulse_Ns = 0;
        for (const ContactPoint& point : points) {
            EXPECT_EQ(point.a, floor);
            EXPECT_EQ(point.b, box);
            EXPECT_EQ(point.user_b, 7U);
            EXPECT_NEAR(static_cast<double>(point.normal_world.y), -1, 1e-3);
            EXPECT_NEAR(static_cast<double>(point.point_a_world.y), 0, 1e-3);
            EXPECT_NEAR(std::abs(static_cast<double>(point.point_b_world.x)), 0.5, 1e-3);
            EXPECT_GT(point.age_steps, 0);
            impulse_Ns += static_cast<double>(point.impulse_Ns);
        }
        EXPECT_NEAR(impulse_Ns, 3 * kG / 60, 1e-3);
    }
    EXPECT_FALSE(test.world.state(box).awake);
}

}  // namespace
}  // namespace plumbline::physics
