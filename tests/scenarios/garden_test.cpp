// The garden keeps its promises: its house is closed, its doors turn, its things stand still.

#include "engine/physics/character.h"
#include "engine/physics/query.h"
#include "engine/physics/totals.h"
#include "engine/scene/simulation/entity_lookup.h"
#include "tests/scenarios/scene_run.h"

#include <gtest/gtest.h>

#include <array>
#include <set>

namespace plumbline {
namespace {

using test::SceneRun;

class Garden : public testing::Test {
protected:
    SceneRun run_{"garden.toml"};

    void SetUp() override { ASSERT_TRUE(run_.simulation); }
    physics::PhysicsWorld& world() { return run_.simulation->physics; }
    physics::BodyId body(const std::string& name) const {
        const ecs::Entity entity = run_.simulation->find(name);
        return run_.simulation->registry.get<scene::BodyRef>(entity).body;
    }
    std::string name_of(physics::BodyId hit) const {
        return run_.simulation->registry.get<scene::Name>(entity_of(*run_.simulation, hit)).text;
    }
    /// How far a hinged leaf has turned about +Y since it was built as drawn in the file.
    Real turned_deg(const std::string& leaf) const {
        const Vec3 along = run_.state(leaf).world_from_body.orientation * Vec3{1, 0, 0};
        return std::atan2(-along.z, along.x) * 180 / kPi;
    }
    /// What a ray from a place meets first, and how far away.
    std::string seen(const Vec3& from, const Vec3& direction, Real& distance_m) {
        const auto hit = cast_ray(world(), from, from + direction * Real{40});
        distance_m = hit ? hit->distance_m : Real{40};
        return hit ? name_of(hit->body) : "nothing";
    }
};

/// Directions spread evenly over the sphere.
Vec3 direction(int i, int count) {
    const Real y = 1 - (2 * static_cast<Real>(i) + 1) / static_cast<Real>(count);
    const Real around = static_cast<Real>(i) * kPi * (3 - std::sqrt(Real{5}));
    const Real level = std::sqrt(1 - y * y);
    return {level * std::cos(around), y, level * std::sin(around)};
}

TEST_F(Garden, TheHouseIsClosed) {
    // Living room, kitchen, hall, bedroom. 9 m is the longest way across the house.
    for (const Vec3& eye : {Vec3{-2.2_r, 1.7_r, -8.2_r},
                            Vec3{-2.2_r, 1.7_r, -4.6_r},
                            Vec3{0.1_r, 1.7_r, -4.8_r},
                            Vec3{1.9_r, 1.7_r, -5.6_r}}) {
        for (int i = 0; i < 1500; ++i) {
            const Vec3 way = direction(i, 1500);
            Real distance_m = 0;
            const std::string met = seen(eye, way, distance_m);
            ASSERT_LT(distance_m, 9) << met << " towards " << way.x << ' ' << way.y << ' ' << way.z;
            ASSERT_NE(met, "lawn");
        }
    }
}

TEST_F(Garden, TheShedIsClosedUnderItsRoof) {
    const Vec3 eye{-12.6_r, 1.4_r, -8.3_r};
    for (int i = 0; i < 1500; ++i) {
        const Vec3 way = direction(i, 1500);
        // Its doorway: 0.6 m left to 1.1 m right of the middle, 1.3 m before it, 2.1 m high.
        if (way.z > 0) {
            const Vec3 at = eye + way * ((-7.3_r - eye.z) / way.z);
            if (at.x > -12.25_r && at.x < -10.45_r && at.y < 2.15_r) continue;
        }
        Real distance_m = 0;
        const std::string met = seen(eye, way, distance_m);
        ASSERT_LT(distance_m, 5) << met << " towards " << way.x << ' ' << way.y << ' ' << way.z;
    }
}

TEST_F(Garden, HasGroundAsFarAsOneSees) {
    for (int ring = 1; ring <= 95; ++ring) {
        for (int i = 0; i < 64; ++i) {
            const Real angle = (static_cast<Real>(i) + 0.3_r) * kPi / 32;
            const Real far_m = Real{4} * static_cast<Real>(ring);
            const Vec3 above{far_m * std::cos(angle), 60, far_m * std::sin(angle)};
            Real distance_m = 0;
            const std::string met = seen(above, {0, -1, 0}, distance_m);
            const auto hit = cast_ray(world(), above, above - Vec3{0, 100, 0});
            ASSERT_TRUE(hit) << "no ground at " << above.x << ' ' << above.z;
            ASSERT_GT(hit->point_world.y, -6);
        }
    }
}

TEST_F(Garden, ThingsStandStillAndFallAsleep) {
    std::vector<Vec3> start;
    const auto& moving = run_.simulation->moving_bodies();
    for (const scene::MovingBody& one : moving) {
        start.push_back(world().state(one.body).world_from_body.position);
    }
    run_.step(60 * 6);
    EXPECT_EQ(awake_count(world()), 1U) << "after 6 s";
    EXPECT_TRUE(run_.state("windmill_rotor").awake) << "a motor turns it";
    run_.step(60 * 4);
    for (std::size_t i = 0; i < moving.size(); ++i) {
        const Vec3 end = world().state(moving[i].body).world_from_body.position;
        const std::string name = name_of(moving[i].body);
        EXPECT_LT(glm::distance(end, start[i]), 0.002_r) << name;
        EXPECT_GT(end.y, -0.001_r) << name << " sank into the ground";
    }
    EXPECT_EQ(run_.simulation->tally().removed, 0U);
    EXPECT_LT(max_penetration_m(world()), 0.002);
    EXPECT_TRUE(run_.simulation->warnings.empty());
}

TEST_F(Garden, EveryThingHasANameThatAPersonReads) {
    for (const scene::MovingBody& one : run_.simulation->moving_bodies()) {
        const auto& name = run_.simulation->registry.get<scene::Name>(one.entity);
        EXPECT_FALSE(name.label.empty()) << name.text;
        EXPECT_EQ(name.label.find_first_of("_0123456789"), std::string::npos) << name.label;
    }
}

TEST_F(Garden, TheFrontDoorOpensToWhoWalksAgainstIt) {
    run_.step(60);
    EXPECT_NEAR(turned_deg("front_door"), 0, 0.1) << "it stands closed";
    physics::Character person(world(), {.feet_position_m = {0.1_r, 0.13_r, -2.6_r}});
    for (int i = 0; i < 60 * 4; ++i) {
        person.update({.direction_world = {0, 0, -1}});
        run_.step(1);
        ASSERT_LT(turned_deg("front_door"), 96) << "its limit is 95 degrees";
    }
    EXPECT_GT(turned_deg("front_door"), 60);
    // Through the door (at z = -3.5) and the hall into the living room, on the house's floor.
    EXPECT_LT(person.state().feet_position_m.z, -6);
    EXPECT_NEAR(person.state().feet_position_m.y, 0.12_r, 0.01);
}

TEST_F(Garden, TheFrontDoorOpensToAThrownCrate) {
    // 30 kg at 6 m/s half a metre from the hinge, flat against a leaf of 28 kg and 0.95 m: all of the crate's side leaves the
    // leaf with a tenth of its speed, so both turn alike. Its centre goes along with the leaf where friction holds it there,
    // and only towards it where none does.
    constexpr Real kLever_m = 0.505_r;
    constexpr Real kAway_m = 0.407_r + 0.025_r;  // of the crate's centre from the leaf's middle
    const Real turning_kgm2 = 28 * 0.948_r * 0.948_r / 3 + 30 * 0.814_r * 0.814_r / 6;
    const auto radps_with = [&](Real lever2) {
        return 1.1_r * 180 * kLever_m / (turning_kgm2 + 30 * lever2);
    };
    const Real least_radps = radps_with(kLever_m * kLever_m + kAway_m * kAway_m);
    const Real most_radps = radps_with(kLever_m * kLever_m);
    world().set_pose(body("crate_1"), {.position = {0.03_r, 1.2_r, -2.6_r}});
    world().set_velocity(body("crate_1"), {0, 0, -6}, {0, 0, 0});
    Real fastest_radps = 0;
    Real widest_deg = 0;
    for (int i = 0; i < 180; ++i) {
        run_.step(1);
        fastest_radps = std::max(fastest_radps, run_.state("front_door").angular_velocity_radps.y);
        widest_deg = std::max(widest_deg, turned_deg("front_door"));
    }
    EXPECT_GT(fastest_radps, 0.98_r * least_radps);
    EXPECT_LT(fastest_radps, 1.02_r * most_radps);
    EXPECT_GT(widest_deg, 80);
    EXPECT_LT(widest_deg, 96) << "its limit is 95 degrees";
}

TEST_F(Garden, AShutterClosesAndStaysInItsLimits) {
    // The right shutter of the window left of the door: its hinge at the window's right side.
    const std::string shutter = "shutter_front_1_right";
    EXPECT_NEAR(turned_deg(shutter), 0, 0.01);
    world().set_velocity(body(shutter), {0, 0, 0}, {0, -4, 0});
    Real closed_deg = 0;
    for (int i = 0; i < 240; ++i) {
        run_.step(1);
        const Real now = turned_deg(shutter);
        closed_deg = std::max(closed_deg, now > 90 ? 360 - now : -now);
    }
    EXPECT_GT(closed_deg, 150);
    EXPECT_LT(closed_deg, 173) << "its limit is 172 degrees";
}

TEST_F(Garden, TheLampSwingsAndComesBack) {
    const Vec3 rest = run_.state("pendant_lamp").world_from_body.position;
    world().apply_impulse(body("pendant_lamp"), {1.2_r, 0, 0});
    Real farthest_m = 0;
    for (int i = 0; i < 60 * 20; ++i) {
        run_.step(1);
        const Vec3 now = run_.state("pendant_lamp").world_from_body.position;
        farthest_m = std::max(farthest_m, glm::distance(now, rest));
        // The cord is 0.6 m long.
        const Vec3 hook = rest + Vec3{0, 0.6_r, 0};
        ASSERT_NEAR(glm::distance(now, hook), 0.6, 0.002);
    }
    EXPECT_GT(farthest_m, 0.1);
    EXPECT_LT(glm::distance(run_.state("pendant_lamp").world_from_body.position, rest), 0.02);
}

}  // namespace
}  // namespace plumbline
