// Bodies, shapes, prefabs, arrays and joints of scene files.
#include "tests/engine/scene/sections/scene_file_fixture.h"

namespace plumbline::scene {
namespace {

TEST_F(SceneFileTest, BodyKeepsEveryKey) {
    const Outcome outcome = load(R"([[material]]
name = "red"
[[entity]]
name = "cube"
position_m = [1, 2, 3]
rotation_deg = [0, 90, 0]
scale = [2, 2, 2]
primitive = { box = [1, 2, 3] }
material = "red"
casts_shadow = false
[entity.body]
kind = "dynamic"
shape = { box = [1, 1, 1] }
mass_kg = 10
friction = 0.6
rolling_friction = 0.01
spinning_friction = 0.02
restitution = 0.3
linear_damping_per_s = 0.1
angular_damping_per_s = 0.2
velocity_mps = [1, 0, -1]
angular_velocity_radps = [0, 3, 0]
center_of_mass_m = [0, -0.1, 0]
inertia_kgm2 = [1, 2, 2.5]
can_sleep = false
ccd = "on"
group = "movers"
collides_with = ["default", "movers"]
)");
    ASSERT_TRUE(outcome.scene.ok()) << outcome.scene.error().message;
    EXPECT_TRUE(outcome.faults.empty());
    const EntityDescription& cube = outcome.scene->entities.at(0);
    EXPECT_EQ(cube.name, "cube");
    EXPECT_EQ(to_string(cube.location), "scene.toml:3");
    expect_near(cube.world_from_body.position, {1, 2, 3});
    // A quarter turn about y takes +x to -z.
    expect_near(cube.world_from_body.orientation * Vec3{1, 0, 0}, {0, 0, -1});
    expect_near(cube.scale, {2, 2, 2});
    expect_near(std::get<physics::BoxShape>(std::get<Primitive>(cube.visual)).size_m, {1, 2, 3});
    EXPECT_EQ(cube.material, "red");
    EXPECT_FALSE(cube.casts_shadow);
    ASSERT_TRUE(cube.body);
    const BodyDescription& body = *cube.body;
    EXPECT_EQ(body.kind, physics::BodyKind::Dynamic);
    const auto& shape = std::get<physics::ShapeDef>(body.shape);
    expect_near(std::get<physics::BoxShape>(shape).size_m, {1, 1, 1});
    EXPECT_EQ(body.mass_kg, Real{10});
    EXPECT_FALSE(body.density_kgpm3);
    EXPECT_EQ(body.friction, 0.6_r);
    EXPECT_EQ(body.rolling_friction, 0.01_r);
    EXPECT_EQ(body.spinning_friction, 0.02_r);
    EXPECT_EQ(body.restitution, 0.3_r);
    EXPECT_EQ(body.linear_damping_per_s, 0.1_r);
    EXPECT_EQ(body.angular_damping_per_s, 0.2_r);
    expect_near(body.velocity_mps, {1, 0, -1});
    expect_near(body.angular_velocity_radps, {0, 3, 0});
    expect_near(body.center_of_mass_m.value_or(Vec3{9}), {0, -0.1_r, 0});
    expect_near(body.inertia_kgm2.value_or(Vec3{9}), {1, 2, 2.5_r});
    EXPECT_FALSE(body.can_sleep);
    EXPECT_EQ(body.ccd, physics::ContinuousCollision::On);
    EXPECT_EQ(body.group, "movers");
    EXPECT_EQ(body.collides_with, (std::vector<std::string>{"default", "movers"}));
}

TEST_F(SceneFileTest, OrientationIsNormalised) {
    const Outcome outcome = load("[[entity]]\norientation = [0.7071, 0, 0.7071, 0]\n");
    ASSERT_TRUE(outcome.scene.ok());
    EXPECT_TRUE(outcome.faults.empty());
    const Quat turned = outcome.scene->entities[0].world_from_body.orientation;
    EXPECT_NEAR(glm::length(turned), Real{1}, kSlack);
    expect_near(turned * Vec3{1, 0, 0}, {0, 0, -1});
}

TEST_F(SceneFileTest, EveryPrimitive) {
    const Outcome outcome = load(R"([[entity]]
primitive = { sphere = 0.5 }
[[entity]]
primitive = { cylinder = [0.4, 2] }
[[entity]]
primitive = { capsule = [0.3, 1.5] }
[[entity]]
primitive = { cone = [0.2, 1] }
[[entity]]
primitive = { plane = [10, 20] }
body = { kind = "static" }
)");
    ASSERT_TRUE(outcome.scene.ok()) << outcome.scene.error().message;
    const auto visual = [&](std::size_t i) {
        return std::get<Primitive>(outcome.scene->entities.at(i).visual);
    };
    EXPECT_EQ(std::get<physics::SphereShape>(visual(0)).radius_m, 0.5_r);
    EXPECT_EQ(std::get<physics::CylinderShape>(visual(1)).radius_m, 0.4_r);
    EXPECT_EQ(std::get<physics::CylinderShape>(visual(1)).height_m, Real{2});
    EXPECT_EQ(std::get<physics::CapsuleShape>(visual(2)).height_m, 1.5_r);
    EXPECT_EQ(std::get<physics::ConeShape>(visual(3)).radius_m, 0.2_r);
    EXPECT_EQ(std::get<physics::PlaneShape>(visual(4)).size_m, (Vec2{10, 20}));
    EXPECT_TRUE(std::holds_alternative<FitShape>(outcome.scene->entities[4].body->shape));
}

TEST_F(SceneFileTest, HullsMeshesAndCompounds) {
    write("assets/m.glb", "x");
    const Outcome outcome = load(R"([[entity]]
body = { shape = { hull_m = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]] } }
[[entity]]
[entity.body]
kind = "static"
shape = { mesh_m = [[0, 0, 0], [1, 0, 0], [0, 1, 0]], triangles = [[0, 1, 2], [2, 1, 0]] }
[[entity]]
[entity.body]
shape = { compound = [
    { sphere = 0.5, position_m = [0, 1, 0] },
    { box = [1, 1, 1], rotation_deg = [0, 0, 90] },
    { hull_m = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]] },
] }
[[entity]]
model = "m.glb"
body = { shape = { hull = "model" } }
[[entity]]
model = "m.glb"
body = { kind = "static", shape = { mesh = "model" } }
[[entity]]
model = "m.glb"
body = { shape = "fit" }
)");
    ASSERT_TRUE(outcome.scene.ok()) << outcome.scene.error().message;
    EXPECT_TRUE(outcome.faults.empty());
    const auto& entities = outcome.scene->entities;
    const auto def = [&](std::size_t i) {
        return std::get<physics::ShapeDef>(entities.at(i).body->shape);
    };
    EXPECT_EQ(std::get<physics::HullShape>(def(0)).points_m.size(), 4U);
    const auto mesh = std::get<physics::MeshShape>(def(1));
    EXPECT_EQ(mesh.vertices_m.size(), 3U);
    EXPECT_EQ(mesh.triangles.at(1), (std::array<std::uint32_t, 3>{2, 1, 0}));
    const auto compound = std::get<physics::CompoundShape>(def(2));
    ASSERT_EQ(compound.children.size(), 3U);
    expect_near(compound.children[0].body_from_child.position, {0, 1, 0});
    expect_near(compound.children[1].body_from_child.orientation * Vec3{1, 0, 0}, {0, 1, 0});
    EXPECT_TRUE(std::holds_alternative<ModelHullShape>(entities[3].body->shape));
    EXPECT_EQ(std::get<ModelVisual>(entities[3].visual).file, assets() / "m.glb");
    EXPECT_TRUE(std::holds_alternative<ModelMeshShape>(entities[4].body->shape));
    EXPECT_TRUE(std::holds_alternative<FitShape>(entities[5].body->shape));
}

TEST_F(SceneFileTest, EntitiesStartFromTheirPrefabKeyByKey) {
    const Outcome outcome = load(R"([[prefab]]
name = "thing"
label = "light thing"
primitive = { box = [1, 1, 1] }
rotation_deg = [0, 45, 0]
[prefab.body]
mass_kg = 5
friction = 0.9
[[prefab]]
name = "heavy_thing"
label = "heavy thing"
prefab = "thing"
[prefab.body]
mass_kg = 50
[[entity]]
name = "a"
prefab = "heavy_thing"
orientation = [1, 0, 0, 0]
primitive = { sphere = 2 }
[entity.body]
restitution = 0.5
)");
    ASSERT_TRUE(outcome.scene.ok()) << outcome.scene.error().message;
    EXPECT_TRUE(outcome.faults.empty());
    const EntityDescription& a = outcome.scene->entities.at(0);
    // Replaced as a whole, not mixed with the prefab's box.
    EXPECT_EQ(std::get<physics::SphereShape>(std::get<Primitive>(a.visual)).radius_m, Real{2});
    expect_near(a.world_from_body.orientation * Vec3{1, 0, 0}, {1, 0, 0});
    EXPECT_EQ(a.body->mass_kg, Real{50});
    EXPECT_EQ(a.body->friction, 0.9_r);
    EXPECT_EQ(a.body->restitution, 0.5_r);
    EXPECT_EQ(outcome.scene->prefabs.at("thing").body->mass_kg, Real{5});
    EXPECT_EQ(a.label, "heavy thing");
    EXPECT_EQ(outcome.scene->prefabs.at("thing").label, "light thing");
    EXPECT_EQ(outcome.scene->prefabs.size(), 2U);
}

TEST_F(SceneFileTest, DensityOverAPrefabsMass) {
    const Outcome outcome = load(R"([[prefab]]
name = "thing"
primitive = { box = [1, 1, 1] }
body = { mass_kg = 5 }
[[entity]]
prefab = "thing"
body = { density_kgpm3 = 300 }
)");
    ASSERT_TRUE(outcome.scene.ok()) << outcome.scene.error().message;
    EXPECT_FALSE(outcome.scene->entities[0].body->mass_kg);
    EXPECT_EQ(outcome.scene->entities[0].body->density_kgpm3, Real{300});
}

TEST_F(SceneFileTest, ArraysStayArrays) {
    const Outcome outcome = load(R"([[prefab]]
name = "crate"
primitive = { box = [1, 1, 1] }
body = {}
[[array]]
name = "pile"
prefab = "crate"
origin_m = [0, 0.5, 0]
count = [10, 20, 30]
spacing_m = [1.1, 1.2, 1.3]
)");
    ASSERT_TRUE(outcome.scene.ok()) << outcome.scene.error().message;
    ASSERT_EQ(outcome.scene->arrays.size(), 1U);
    const ArrayDescription& pile = outcome.scene->arrays[0];
    EXPECT_EQ(pile.name, "pile");
    EXPECT_EQ(pile.prefab.name, "crate");
    EXPECT_EQ(pile.count, (std::array<int, 3>{10, 20, 30}));
    expect_near(pile.origin_m, {0, 0.5_r, 0});
    expect_near(pile.spacing_m, {1.1_r, 1.2_r, 1.3_r});
    // 6000 things are many, and said to be; they are not refused.
    ASSERT_EQ(outcome.faults.size(), 1U);
}

TEST_F(SceneFileTest, ArraysTurnTheirCopies) {
    const std::string prefab =
        "[[prefab]]\nname = \"plank\"\nprimitive = { box = [2, 1, 1] }\nbody = {}\n"
        "rotation_deg = [0, 0, 90]\n[[array]]\nname = \"a\"\nprefab = \"plank\"\n";
    const Outcome plain = load(prefab);
    ASSERT_TRUE(plain.scene.ok()) << plain.scene.error().message;
    const Quat own = plain.scene->arrays[0].prefab.world_from_body.orientation;
    EXPECT_NEAR(glm::angle(own), glm::half_pi<Real>(), 1e-5) << "the prefab's turn stays";

    const Outcome turned =
        load(prefab + "rotation_deg = [0, 30, 0]\nturn_deg = [10, 20, 30]\ncount = [2, 2, 2]\n");
    ASSERT_TRUE(turned.scene.ok()) << turned.scene.error().message;
    const ArrayDescription& array = turned.scene->arrays[0];
    EXPECT_NEAR(
        glm::angle(array.prefab.world_from_body.orientation), radians_from_degrees(30.0), 1e-5)
        << "the array's own counts over the prefab's";
    expect_near(
        array.turn_rad,
        {radians_from_degrees(10.0_r), radians_from_degrees(20.0_r), radians_from_degrees(30.0_r)});
    const Outcome both = load(prefab + "rotation_deg = [0, 0, 0]\norientation = [1, 0, 0, 0]\n");
    EXPECT_FALSE(both.scene.ok());
}

TEST_F(SceneFileTest, JointsOfEveryKind) {
    const Outcome outcome = load(R"([[prefab]]
name = "link"
primitive = { box = [1, 1, 1] }
body = {}
[[array]]
name = "chain"
prefab = "link"
origin_m = [0, 10, 0]
count = [1, 1, 3]
spacing_m = [1, 1, 2]
[[joint]]
name = "hang"
kind = "ball_and_socket"
a = "chain.0.0.0"
b = "world"
anchor_m = [0, 11, 0]
collide = true
break_N = 500
[[joint]]
kind = "hinge"
a = "chain.0.0.1"
b = "chain.0.0.0"
anchor_m = [0, 10, 1]
axis = [0, 2, 0]
limits = [-90, 180]
motor = { target = 3.0, max = 20 }
[[joint]]
kind = "slider"
a = "chain.0.0.1"
b = "world"
axis = [1, 0, 0]
limits = [-1, 2]
[[joint]]
kind = "fixed"
a = "chain.0.0.2"
b = "world"
[[joint]]
kind = "cone"
a = "chain.0.0.2"
b = "world"
anchor_m = [0, 0, 0]
axis = [0, 0, 1]
limits = [0, 45]
twist = [-10, 30]
[[joint]]
kind = "distance"
a = "chain.0.0.1"
b = "chain.0.0.2"
[[joint]]
kind = "spring"
a = "chain.0.0.1"
b = "world"
anchor_a_m = [0, 10, 2]
anchor_b_m = [0, 20, 2]
stiffness_Npm = 100
damping_Nspm = 2
rest_length_m = 1.5
)");
    ASSERT_TRUE(outcome.scene.ok()) << outcome.scene.error().message;
    const auto& joints = outcome.scene->joints;
    ASSERT_EQ(joints.size(), 7U);
    EXPECT_EQ(joints[0].name, "hang");
    EXPECT_EQ(joints[0].b, "world");
    EXPECT_TRUE(joints[0].collide);
    EXPECT_EQ(joints[0].break_N, Real{500});
    expect_near(joints[0].anchor_b_m, {0, 11, 0});
    EXPECT_EQ(joints[1].kind, JointKind::Hinge);
    expect_near(joints[1].axis, {0, 1, 0});
    EXPECT_NEAR((*joints[1].limits)[0], -kPi / 2, kSlack);
    EXPECT_NEAR((*joints[1].limits)[1], kPi, kSlack);
    EXPECT_EQ(joints[1].motor->target, Real{3});
    EXPECT_EQ(joints[1].motor->max, Real{20});
    EXPECT_EQ((*joints[2].limits)[1], Real{2});  // metres stay metres
    EXPECT_EQ(joints[4].kind, JointKind::Cone);
    EXPECT_NEAR((*joints[4].limits)[1], kPi / 4, kSlack);
    EXPECT_NEAR((*joints[4].twist)[0], -kPi / 18, kSlack);
    EXPECT_NEAR((*joints[4].twist)[1], kPi / 6, kSlack);
    expect_near(joints[5].anchor_a_m, {0, 10, 2});  // where the copies start
    expect_near(joints[5].anchor_b_m, {0, 10, 4});
    EXPECT_EQ(joints[6].stiffness_Npm, Real{100});
    EXPECT_EQ(joints[6].damping_Nspm, Real{2});
    EXPECT_EQ(joints[6].rest_length_m, 1.5_r);
    EXPECT_TRUE(outcome.faults.empty());
}

}  // namespace
}  // namespace plumbline::scene
