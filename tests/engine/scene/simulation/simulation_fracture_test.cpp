// What is left of a body that breaks: its parts, and what held it.
#include "engine/scene/build/fragments.h"
#include "tests/support/scene_in_code.h"

#include <numeric>

namespace plumbline::scene {
namespace {

/// 2 m along x, in 10 pieces, of 2000 kg/m3.
EntityDescription fragile_bar() {
    EntityDescription bar = test::box("bar", {1, 5, 2}, {2, 0.2_r, 0.2_r});
    bar.body->density_kgpm3 = 2000;
    bar.body->fracture = FractureDescription{.pieces = 10};
    return bar;
}

/// Pieces left and right of its middle.
std::vector<std::vector<std::uint32_t>> halves_of(const FragileWhole& whole) {
    std::vector<std::vector<std::uint32_t>> halves(2);
    for (std::uint32_t i = 0; i < whole.pattern.pieces.size(); ++i)
        halves[whole.pattern.pieces[i].center_m.x < 0 ? 0 : 1].push_back(i);
    return halves;
}

void break_bar(test::Running& run) {
    run->break_up(run->find("bar"), halves_of(*run->wholes().front()), {});
    run->destroy_marked();
}

TEST(SimulationFracture, PartsStandWhereTheyWereInTheWhole) {
    EntityDescription bar = fragile_bar();
    bar.world_from_body.orientation = portable_angle_axis(0.5_r, Vec3{0, 1, 0});
    bar.body->velocity_mps = {0, 0, 3};
    bar.body->angular_velocity_radps = {0, 2, 0};
    test::Running run(test::scene_of({bar}));
    break_bar(run);
    EXPECT_FALSE(run->find("bar"));
    ASSERT_EQ(run->moving_bodies().size(), 2U);
    double mass_kg = 0;
    for (const char* name : {"bar/0", "bar/1"}) {
        const physics::BodyState part = run.state(name);
        mass_kg += static_cast<double>(part.mass.mass_kg);
        const Vec3d arm_m = Vec3d(part.world_from_body.position) - Vec3d{1, 5, 2};
        EXPECT_NEAR(glm::length(arm_m), 0.5, 0.1);
        EXPECT_LT(glm::distance(Vec3d(part.velocity_mps),
                                Vec3d{0, 0, 3} + glm::cross(Vec3d{0, 2, 0}, arm_m)),
                  1e-5);
        EXPECT_LT(glm::length(Vec3d(part.mass.center_of_mass_m)), 1e-5) << "its origin";
    }
    EXPECT_NEAR(mass_kg, 160, 1e-3);
    EXPECT_GT(run.state("bar/1").world_from_body.position.x, 1);
}

TEST(SimulationFracture, NeitherMovesApartBeforeItIsPushed) {
    SceneDescription scene = test::scene_of({fragile_bar()});
    scene.gravity_mps2 = {0, 0, 0};
    test::Running run(scene);
    break_bar(run);
    run.step(60);
    for (const char* name : {"bar/0", "bar/1"})
        EXPECT_LT(glm::length(run.state(name).velocity_mps), 1e-4_r) << name;
}

TEST(SimulationFracture, RopesAndJointsHoldTheNearestPart) {
    SceneDescription scene = test::scene_of({fragile_bar(), test::cube("weight", {1.9_r, 3, 2})});
    scene.joints = {{.name = "pin",
                     .kind = JointKind::BallAndSocket,
                     .a = "bar",
                     .b = "world",
                     .anchor_a_m = {0.1_r, 5, 2},
                     .anchor_b_m = {0.1_r, 5, 2}}};
    RopeDescription rope{.name = "line", .a = "bar", .b = "weight"};
    rope.anchor_a_m = {1.9_r, 4.9_r, 2};
    rope.anchor_b_m = {1.9_r, 3.5_r, 2};
    rope.length_m = 1.4;
    scene.forces.ropes = {rope};
    test::Running run(scene);
    break_bar(run);
    EXPECT_EQ(run->joints()[0].a, run.body("bar/0"));
    EXPECT_EQ(run->physics.joint(run->joints()[0].joint).def.a, run.body("bar/0"));
    EXPECT_EQ(run->ropes()[0].ends[0], run.body("bar/1"));
    const Vec3d end_m(run->points_of(run->ropes()[0]).front());
    EXPECT_LT(glm::distance(end_m, Vec3d{1.9, 4.9, 2}), 1e-5);
    run.step(60);
    EXPECT_LT(run->physics.joint(run->joints()[0].joint).state.error_m, 1e-3_r);
    EXPECT_LT(run.state("bar/1").world_from_body.position.y, 4) << "it falls with its weight";
}

TEST(SimulationFracture, PartsOfWhatWasDroppedAreDropped) {
    test::Running run(test::scene_of({fragile_bar()}));
    run->registry.add<Dropped>(run->find("bar"), Dropped{.serial = 7});
    break_bar(run);
    for (const char* name : {"bar/0", "bar/1"})
        EXPECT_EQ(run->registry.get<Dropped>(run->find(name)).serial, 7U);
}

TEST(SimulationFracture, SaysWhatDoesNotBreakOrInFewerPieces) {
    EntityDescription dumbbell = fragile_bar();
    dumbbell.body->shape = physics::ShapeDef{physics::CompoundShape{
        {{.shape = physics::SphereShape{}}, {.shape = physics::BoxShape{}}}}};
    EntityDescription crumb = test::box("crumb", {5, 5, 5}, {0.01_r, 0.01_r, 0.01_r});
    crumb.body->fracture = FractureDescription{.pieces = 100};
    test::Running run(test::scene_of({dumbbell, crumb}));
    ASSERT_EQ(run->warnings.size(), 2U);
    EXPECT_EQ(
        run->warnings[0],
        "test.toml:10: entity bar: it is no single convex solid of some size and does not break");
    EXPECT_EQ(run->warnings[1],
              "test.toml:10: entity crumb: it is too small for 100 pieces: cut into 15");
    EXPECT_FALSE(run->registry.has<Fragile>(run->find("bar")));
    EXPECT_EQ(run->registry.get<Fragile>(run->find("crumb")).pieces.size(), 15U);
}

}  // namespace
}  // namespace plumbline::scene
