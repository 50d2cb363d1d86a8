// Bodies of glTF files move as the extension says.
#include "tests/engine/scene/gltf_scene/gltf_fixture.h"

#include <cmath>

namespace plumbline::scene::gltf {
namespace {

using physics::BodyKind;
using physics::CombineRule;
using test::Running;

TEST(GltfBodies, FallRiseAndFlyAsTheirMotionsSay) {
    PhysicsFile file;
    file.add_ball("falls", {0, 50, 0}, {{"mass", 2}});
    file.add_ball("rises", {5, 50, 0}, {{"mass", 2}, {"gravityFactor", -0.5}});
    file.add_ball("flies", {10, 50, 0}, {{"gravityFactor", 0}, {"linearVelocity", {0, 0, 3}}});
    // In the node's own frame: a quarter turn about y takes z to x.
    file.json["nodes"][2]["rotation"] = {0, std::sqrt(0.5), 0, std::sqrt(0.5)};
    const ReadGltf read = file.read();
    ASSERT_TRUE(read.scene.ok()) << read.said();
    EXPECT_FALSE(read.entity("falls").body->density_kgpm3);
    Running run(unseen(*read));
    const double drop_m = 9.81 / 2;
    EXPECT_NEAR(num(state_after(run, "falls", 1).world_from_body.position.y), 50 - drop_m, 1e-3);
    EXPECT_NEAR(
        num(state_after(run, "rises", 0).world_from_body.position.y), 50 + drop_m / 2, 1e-3);
    const Vec3 flown = state_after(run, "flies", 0).world_from_body.position;
    EXPECT_NEAR(num(flown.x), 13, 1e-4);
    EXPECT_NEAR(num(flown.z), 0, 1e-4);
    EXPECT_EQ(num(state_after(run, "falls", 0).mass.mass_kg), 2);
}

TEST(GltfBodies, KeepTheirMassFrame) {
    PhysicsFile file;
    file.add_ball("toy",
                  {0, 0, 0},
                  {{"mass", 3},
                   {"centerOfMass", {0, -0.25, 0}},
                   {"inertiaDiagonal", {1, 2, 2.5}},
                   {"inertiaOrientation", {0, std::sqrt(0.5), 0, std::sqrt(0.5)}}});
    const ReadGltf read = file.read();
    ASSERT_TRUE(read.scene.ok()) << read.said();
    Running run(unseen(*read));
    const physics::BodyState toy = state_after(run, "toy", 0);
    EXPECT_EQ(toy.mass.inertia_kgm2, Vec3(1, 2, 2.5_r));
    EXPECT_EQ(toy.mass.center_of_mass_m, Vec3(0, -0.25_r, 0));
    // A torque about the body's z is about the first principal axis, which a quarter turn puts there.
    run->physics.apply_torque(run->registry.get<BodyRef>(run->find("toy")).body, {0, 0, 1});
    run.step(1);
    EXPECT_NEAR(
        num(state_after(run, "toy", 0).angular_velocity_radps.z) / run->step_s(), 1.0, 0.01);
}

// Samples of the extension: a wheel of infinite mass turns where it is, a box of infinite inertia falls without turning.
TEST(GltfBodies, TakeZeroMassAndInertiaAsInfinite) {
    PhysicsFile file;
    file.add_ball("wheel",
                  {0, 5, 0},
                  {{"mass", 0}, {"inertiaDiagonal", {0, 1, 0}}, {"angularVelocity", {0, 2, 0}}});
    const std::size_t box = file.add_box(1, 1, 1);
    file.add_body(
        "floor", {0, -0.5, 0}, {{"collider", PhysicsFile::collider(file.add_box(50, 1, 50))}});
    file.add_body("box",
                  {5, 2, 0},
                  {{"motion", {{"mass", 1}, {"inertiaDiagonal", {0, 0, 0}}}},
                   {"collider", PhysicsFile::collider(box)}});
    file.json["nodes"][2]["rotation"] = {0, 0, std::sin(0.2), std::cos(0.2)};  // lands on an edge
    file.add_ball("both", {10, 5, 0}, {{"mass", 0}, {"linearVelocity", {0, 1, 0}}});
    const ReadGltf read = file.read();
    ASSERT_TRUE(read.scene.ok()) << read.said();
    EXPECT_EQ(read.body("both").kind, BodyKind::Kinematic) << "nothing can move it";
    Running run(unseen(*read));
    const physics::BodyState wheel = state_after(run, "wheel", 2);
    EXPECT_EQ(wheel.world_from_body.position, Vec3(0, 5, 0));
    EXPECT_NEAR(num(wheel.angular_velocity_radps.y), 2, 1e-3);
    const physics::BodyState fallen = state_after(run, "box", 0);
    EXPECT_NEAR(num(fallen.world_from_body.orientation.z), std::sin(0.2), 1e-4);
    EXPECT_NEAR(num(fallen.world_from_body.position.y), (std::cos(0.4) + std::sin(0.4)) / 2, 0.01);
    EXPECT_NEAR(num(state_after(run, "both", 0).world_from_body.position.y), 7, 1e-3);
}

TEST(GltfBodies, AreOneWithAllBelowThemThatHasNoMotion) {
    PhysicsFile file;
    const std::size_t shape = file.add_box(1, 1, 1);
    const Json collider = {{"collider", PhysicsFile::collider(shape)}};
    const std::size_t body = file.add_body("body", {0, 10, 0}, {{"motion", {{"mass", 2}}}});
    file.add_child(body, file.add_body("left", {-1, 0, 0}, collider));
    file.add_child(body, file.add_body("right", {1, 0, 0}, collider));
    file.add_child(
        body,
        file.add_body("own",
                      {0, 5, 0},
                      {{"motion", {{"mass", 1}}}, {"collider", PhysicsFile::collider(shape)}}));
    const ReadGltf read = file.read();
    ASSERT_TRUE(read.scene.ok()) << read.said();
    const auto whole = read.shape<physics::CompoundShape>("body");
    ASSERT_EQ(whole.children.size(), 2U);
    EXPECT_EQ(whole.children[0].body_from_child.position, Vec3(-1, 0, 0));
    EXPECT_EQ(read.entity("own").world_from_body.position, Vec3(0, 15, 0));
}

TEST(GltfBodies, CombineTheirMaterialsByTheTextsRules) {
    PhysicsFile file;
    const std::size_t shape = file.add_box(1, 1, 1);
    const auto wearing = [&](const char* name, Json material) {
        Json collider = PhysicsFile::collider(shape);
        collider["physicsMaterial"] = file.add("physicsMaterials", std::move(material));
        file.add_body(name, {0, 0, 0}, {{"collider", collider}});
    };
    wearing("average", {{"dynamicFriction", 0.4}, {"staticFriction", 0.4}, {"restitution", 0.5}});
    wearing("product", {{"dynamicFriction", 0.5}, {"frictionCombine", "multiply"}});
    wearing("most", {{"restitution", 1.5}, {"restitutionCombine", "maximum"}});
    wearing("least",
            {{"dynamicFriction", 0.3}, {"staticFriction", 0.9}, {"frictionCombine", "minimum"}});
    const ReadGltf read = file.read();
    ASSERT_TRUE(read.scene.ok()) << read.said();
    EXPECT_EQ(read.body("average").friction_rule, CombineRule::Average);
    EXPECT_EQ(read.body("average").restitution_rule, CombineRule::Average);
    EXPECT_NEAR(num(*read.body("average").friction), 0.4, 1e-6);
    EXPECT_EQ(read.body("product").friction_rule, CombineRule::Multiply);
    EXPECT_NEAR(num(*read.body("product").friction), 0.5, 1e-6);
    EXPECT_EQ(read.body("most").restitution_rule, CombineRule::Maximum);
    EXPECT_EQ(read.body("most").restitution, Real{1});
    EXPECT_EQ(read.body("least").friction_rule, CombineRule::Minimum);
    EXPECT_NE(read.said().find("a restitution of 1.5 makes energy"), std::string::npos);
    EXPECT_NE(read.said().find("least: static friction 0.9 differs"), std::string::npos)
        << read.said();
}

// The rule is not the same both ways: where one side declines, they do not touch.
TEST(GltfBodies, TouchWhereBothFiltersAgree) {
    PhysicsFile file;
    const auto filtered = [&](const char* name, double x, double y, bool moves, Json filter) {
        Json collider = PhysicsFile::collider(file.add_box(1, 1, 1));
        if (!filter.is_null()) collider["collisionFilter"] = file.add("collisionFilters", filter);
        Json physics{{"collider", collider}};
        if (moves) physics["motion"] = Json::object();
        file.add_body(name, {x, y, 0}, physics);
    };
    const Json ghost{{"collisionSystems", {"ghost"}}, {"collideWithSystems", {"ghost"}}};
    filtered("table", 0, 0, false, {{"collisionSystems", {"table"}}});
    filtered("ghost", 0, 3, true, ghost);
    filtered("plain table", 5, 0, false, nullptr);
    filtered(
        "shy", 5, 3, true, {{"collisionSystems", {"shy"}}, {"notCollideWithSystems", {"table"}}});
    const ReadGltf read = file.read();
    ASSERT_TRUE(read.scene.ok()) << read.said();
    EXPECT_EQ(read.body("ghost").collides_with, std::vector<std::string>{"ghost"});
    Running run(unseen(*read));
    EXPECT_LT(num(state_after(run, "ghost", 2).world_from_body.position.y), -5)
        << "it fell through";
    EXPECT_NEAR(num(state_after(run, "shy", 0).world_from_body.position.y), 1, 0.01);
}

TEST(GltfBodies, TellWhatComesIntoATrigger) {
    PhysicsFile file;
    file.add_body("gate", {0, 2, 0}, {{"trigger", PhysicsFile::collider(file.add_box(3, 1, 3))}});
    file.add_ball("ball", {0, 5, 0}, {{"mass", 1}});
    const ReadGltf read = file.read();
    ASSERT_TRUE(read.scene.ok()) << read.said();
    const EntityDescription& gate = read.entity("gate");
    EXPECT_FALSE(gate.body) << "things pass through it";
    ASSERT_TRUE(gate.trigger);
    EXPECT_EQ(gate.trigger->message, "something came into gate");
    EXPECT_EQ(std::get<physics::BoxShape>(std::get<Primitive>(gate.visual)).size_m, Vec3(3, 1, 3));
}

TEST(GltfBodies, SayWhatCannotBe) {
    PhysicsFile file;
    file.add_body("bare", {0, 0, 0}, {{"motion", {{"mass", 1}}}});
    file.add_ball("heavy", {0, 5, 0}, {{"mass", 1e9}});
    file.add_ball("fast", {0, 9, 0}, {{"linearVelocity", {5e3, 0, 0}}});
    const ReadGltf read = file.read();
    ASSERT_TRUE(read.scene.ok()) << read.said();
    EXPECT_FALSE(read.entity("bare").body);
    for (const char* said : {"bare: it has motion and no collider",
                             "heavy: a mass of 1000000000 kg; 10000000 kg is used",
                             "fast: a velocity of 5000; 1000 is used"})
        EXPECT_NE(read.said().find(said), std::string::npos) << said << "\n" << read.said();
}

TEST(GltfBodies, HaveNamesOfTheirOwn) {
    PhysicsFile file;
    for (int i = 0; i < 3; ++i) file.add_ball(i == 2 ? "" : "ball", {3 * i, 0, 0}, Json::object());
    const ReadGltf read = file.read();
    ASSERT_TRUE(read.scene.ok()) << read.said();
    EXPECT_EQ(read.entity("ball (2)").world_from_body.position.x, Real{3});
    EXPECT_EQ(read.entity("node 2").world_from_body.position.x, Real{6});
}

}  // namespace
}  // namespace plumbline::scene::gltf
