// Whoever is woken wakes what fell asleep with it.
#include "engine/physics/totals.h"
#include "tests/engine/physics/world/asleep.h"

#include <utility>

namespace plumbline::physics {
namespace {

TEST(Waking, WakesAllThatFellAsleepTogether) {
    Asleep asleep;
    asleep.test.world.wake(asleep.tower[2]);
    EXPECT_EQ(awake_count(asleep.test.world), 3U);
    for (const BodyId id : asleep.tower) EXPECT_TRUE(asleep.test.world.state(id).awake);
}

TEST(Waking, ByForceImpulseVelocityPoseAndFreezing) {
    const std::vector<std::pair<const char*, void (*)(PhysicsWorld&, BodyId)>> calls{
        {"force",
         [](PhysicsWorld& world, BodyId id) {
             world.apply_force(id, {0, 1, 0});
         }},
        {"torque",
         [](PhysicsWorld& world, BodyId id) {
             world.apply_torque(id, {0, 1, 0});
         }},
        {"impulse",
         [](PhysicsWorld& world, BodyId id) {
             world.apply_impulse(id, {0, 1, 0});
         }},
        {"velocity",
         [](PhysicsWorld& world, BodyId id) {
             world.set_velocity(id, {0, 1, 0}, {0, 0, 0});
         }},
        {"pose",
         [](PhysicsWorld& world, BodyId id) {
             world.set_pose(id, {.position = {9, 9, 9}});
         }},
        {"freezing", [](PhysicsWorld& world, BodyId id) { world.set_frozen(id, true); }},
        {"destruction", [](PhysicsWorld& world, BodyId id) { world.destroy_body(id); }}};
    for (const auto& [name, call] : calls) {
        SCOPED_TRACE(name);
        Asleep asleep;
        call(asleep.test.world, asleep.tower[1]);
        asleep.test.world.step();
        EXPECT_TRUE(asleep.test.world.state(asleep.tower[0]).awake);
        EXPECT_TRUE(asleep.test.world.state(asleep.tower[2]).awake);
    }
}

TEST(Waking, ByTheLossOfTheGround) {
    Asleep asleep;
    asleep.test.world.destroy_body(asleep.ground);
    asleep.test.world.step();
    EXPECT_EQ(awake_count(asleep.test.world), 3U);
    // g t^2 / 2 from the first step on: nobody hung in the air.
    const double start = asleep.test.at(asleep.tower[2]).y;
    asleep.test.run(1.0);
    EXPECT_NEAR(
        asleep.test.at(asleep.tower[2]).y, start - 0.5 * kG * (61.0 * 61.0 - 1) / 3600, 0.02);
}

}  // namespace
}  // namespace plumbline::physics
