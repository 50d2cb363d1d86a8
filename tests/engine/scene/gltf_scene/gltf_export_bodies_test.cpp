// Bodies written as glTF and read back move as they did.
#include "tests/engine/scene/gltf_scene/gltf_round_trip.h"

#include <cmath>

namespace plumbline::scene::gltf {
namespace {

using physics::BodyKind;
using test::ball;
using test::box;
using test::cube;
using test::ground;
using test::Running;
using test::scene_of;

EntityDescription shaped(const char* name, const Vec3& at_m, physics::ShapeDef shape) {
    EntityDescription entity = box(name, at_m, {0.5_r, 0.5_r, 0.5_r});
    entity.body->shape = std::move(shape);
    entity.world_from_body.orientation = glm::normalize(Quat{0.9_r, 0.1_r, 0.3_r, 0.2_r});
    return entity;
}

TEST(GltfExportBodies, KeepsEveryShapeForTwoSeconds) {
    using namespace physics;
    HullShape hull;
    for (const Vec3& p :
         {Vec3{0, 0.5_r, 0}, {0.4_r, -0.2_r, 0}, {-0.2_r, -0.2_r, 0.4_r}, {-0.2_r, -0.2_r, -0.4_r}})
        hull.points_m.push_back(p);
    CompoundShape dumbbell;
    dumbbell.children.push_back({SphereShape{.radius_m = 0.3_r}, {.position = {-0.5_r, 0, 0}}});
    dumbbell.children.push_back(
        {BoxShape{.size_m = {0.4_r, 0.4_r, 0.4_r}}, {.position = {0.5_r, 0.1_r, 0}}});
    SceneDescription scene =
        scene_of({shaped("box", {0, 3, 0}, BoxShape{.size_m = {1, 0.5_r, 0.7_r}}),
                  shaped("sphere", {3, 3, 0}, SphereShape{.radius_m = 0.4_r}),
                  shaped("cylinder", {6, 3, 0}, CylinderShape{}),
                  shaped("capsule", {9, 3, 0}, CapsuleShape{}),
                  shaped("cone", {12, 3, 0}, ConeShape{}),
                  shaped("hull", {15, 3, 0}, hull),
                  shaped("dumbbell", {18, 3, 0}, dumbbell)});
    EntityDescription plane = box("plane", {0, 0, 0}, {1, 1, 1}, BodyKind::Static);
    plane.body->shape = physics::ShapeDef{PlaneShape{}};
    scene.entities.push_back(plane);
    RoundTrip trip(scene);
    ASSERT_NE(trip.after, nullptr);
    EXPECT_LT(trip.apart_m(30), 1e-6) << "as they fall";
    EXPECT_LT(trip.apart_m(90), 2e-3) << "and after they struck the ground";
    EXPECT_TRUE(trip.exported.notes.empty());
}

// Nothing that JSON rounds, nothing that turns: to the bit.
TEST(GltfExportBodies, KeepsTheStateOfWhatStandsStraightToTheBit) {
    SceneDescription scene =
        scene_of({ball("a", {0, 4, 0}, 0.5_r), ball("b", {3, 6, 0}, 0.25_r), ground()});
    scene.entities[0].body->restitution = 0.5_r;
    scene.entities[0].body->friction = 0.25_r;
    scene.entities[0].body->mass_kg = 2;
    scene.entities[1].body->mass_kg = 3;
    scene.entities[1].body->velocity_mps = {0.5_r, 0, 0};
    scene.entities[1].body->linear_damping_per_s = 0.125_r;
    RoundTrip trip(scene);
    ASSERT_NE(trip.after, nullptr);
    trip.before.step(120);
    trip.after->step(120);
    EXPECT_EQ(trip.before->state_hash(), (*trip.after)->state_hash());
}

TEST(GltfExportBodies, KeepsFactorsRulesAndFilters) {
    SceneDescription scene =
        scene_of({ball("a", {0, 5, 0}, 0.5_r), ball("b", {3, 5, 0}, 0.5_r), ground()});
    BodyDescription& a = *scene.entities[0].body;
    a.gravity_factor = 0.5_r;
    a.friction_rule = physics::CombineRule::Minimum;
    a.restitution_rule = physics::CombineRule::Average;
    a.rolling_friction = 0.01_r;
    a.can_sleep = false;
    BodyDescription& b = *scene.entities[1].body;
    b.group = "ghost";
    b.collides_with = {"ghost"};
    RoundTrip trip(scene);
    ASSERT_NE(trip.after, nullptr);
    const SceneDescription& read = *trip.description;
    const BodyDescription& twin = *read.entities[0].body;
    EXPECT_EQ(twin.gravity_factor, 0.5_r);
    EXPECT_EQ(twin.friction_rule, physics::CombineRule::Minimum);
    EXPECT_EQ(twin.restitution_rule, physics::CombineRule::Average);
    EXPECT_EQ(twin.rolling_friction, 0.01_r);
    const BodyDescription& other = *read.entities[1].body;
    EXPECT_EQ(other.friction_rule, physics::CombineRule::Usual) << "though glTF has no such rule";
    EXPECT_EQ(other.friction, (*trip.before).surfaces().get(0).friction);
    EXPECT_FALSE(twin.can_sleep);
    EXPECT_EQ(read.entities[1].body->group, "ghost");
    EXPECT_LT(trip.apart_m(120), 1e-4);
    EXPECT_LT((*trip.after)
                  ->physics.state((*trip.after)->moving_bodies()[1].body)
                  .world_from_body.position.y,
              Real{-5})
        << "it fell through the ground";
}

TEST(GltfExportBodies, KeepsMaterialsAndFiltersOfParts) {
    EntityDescription body = box("body", {0, 2, 0}, {1, 1, 1});
    const physics::BoxShape cube{.size_m = {0.5_r, 0.5_r, 0.5_r}};
    body.body->shape = physics::ShapeDef{physics::CompoundShape{
        .children = {{.shape = cube, .body_from_child = {.position = {0, -1, 0}}},
                     {.shape = cube, .body_from_child = {.position = {0, 1, 0}}}}}};
    body.body->parts.push_back({.friction = 0.25_r, .group = "ghost", .collides_with = {"ghost"}});
    body.body->parts.push_back({.restitution = 0.75_r,
                                .restitution_rule = physics::CombineRule::Minimum,
                                .group = "solid"});
    RoundTrip trip(scene_of({body, ground()}));
    ASSERT_NE(trip.after, nullptr);
    const std::vector<BodyDescription>& parts = trip.description->entities[0].body->parts;
    ASSERT_EQ(parts.size(), 2U);
    EXPECT_EQ(parts[0].friction, 0.25_r);
    EXPECT_EQ(parts[1].restitution, 0.75_r);
    EXPECT_EQ(parts[1].restitution_rule, physics::CombineRule::Minimum);
    EXPECT_LT(trip.apart_m(120), 1e-4);
    EXPECT_LT((*trip.after)
                  ->physics.state((*trip.after)->moving_bodies()[0].body)
                  .world_from_body.position.y,
              Real{0})
        << "only its upper part is held by the ground";
}

// A level is made by freezing things where they are: they stand in the file.
TEST(GltfExportBodies, WritesWhatIsFrozenAsStanding) {
    Running run(scene_of({ball("a", {0, 5, 0}, 0.5_r), ball("b", {3, 5, 0}, 0.5_r)}));
    run.step(30);
    run->physics.set_frozen(run->moving_bodies()[0].body, true);
    const Vec3 where = run->physics.state(run->moving_bodies()[0].body).world_from_body.position;
    const test::TemporaryFolder folder;
    Diagnostics faults;
    const auto read = read_description(folder.write("m.glb", gltf_of(*run, "{}").glb), {}, faults);
    ASSERT_TRUE(read.ok()) << read.error().message;
    const auto a = std::ranges::find(read->entities, "a", &EntityDescription::name);
    ASSERT_NE(a, read->entities.end());
    EXPECT_EQ(a->body->kind, BodyKind::Static);
    EXPECT_EQ(a->world_from_body.position, where);
    const auto b = std::ranges::find(read->entities, "b", &EntityDescription::name);
    EXPECT_EQ(b->body->kind, BodyKind::Dynamic);
    EXPECT_NEAR(static_cast<double>(b->body->velocity_mps.y), -9.81 / 2, 0.01) << "it was falling";
}

}  // namespace
}  // namespace plumbline::scene::gltf
