// [entity.body].
#include "tests/engine/scene/sections/scene_file_fixture.h"

namespace plumbline::scene {
namespace {

constexpr const char* kBallWithBody =
    "[[entity]]\nname = \"a\"\nprimitive = { sphere = 1 }\n[entity.body]\n";

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

TEST_F(SceneFileTest, EmptyCollidesWithMeansNothing) {
    const auto filters = [&](const char* key) {
        const Outcome outcome =
            load(fmt::format("[[entity]]\nprimitive = {{ sphere = 1 }}\n[entity.body]\n{}\n", key));
        EXPECT_TRUE(outcome.faults.empty());
        return outcome.scene->entities.at(0).body->collides_with;
    };
    EXPECT_TRUE(filters("").empty());  // everything
    EXPECT_EQ(filters("collides_with = []"), std::vector<std::string>{""});
}

TEST_F(SceneFileTest, MassZeroMakesStatic) {
    const Outcome outcome =
        load("[[entity]]\nprimitive={sphere=1}\nbody={mass_kg=0, velocity_mps=[1,0,0]}");
    ASSERT_TRUE(outcome.scene.ok());
    EXPECT_EQ(outcome.scene->entities[0].body->kind, physics::BodyKind::Static);
    EXPECT_EQ(glm::length(outcome.scene->entities[0].body->velocity_mps), Real{0});
}

TEST_F(SceneFileTest, ImpossibleInertiaIsLeftToTheShape) {
    const Outcome outcome =
        load("[[entity]]\nprimitive={sphere=1}\nbody={inertia_kgm2=[1, 2, 3.1]}");
    ASSERT_TRUE(outcome.scene.ok());
    EXPECT_EQ(outcome.faults.size(), 1U);
    EXPECT_FALSE(outcome.scene->entities[0].body->inertia_kgm2);
    // A thin plate has exactly the sum.
    EXPECT_TRUE(
        load("[[entity]]\nprimitive={sphere=1}\nbody={inertia_kgm2=[1, 2, 3]}").faults.empty());
}

// SOURCES A39.
TEST_F(SceneFileTest, LinearFactorHoldsAlongAxes) {
    const SceneDescription scene = good(std::string(kBallWithBody) + "linear_factor = [1, 1, 0]\n");
    expect_near(scene.entities[0].body->linear_factor, {1, 1, 0});
    expect_only(
        std::string(kBallWithBody) + "linear_factor = [1, 0.5, 1]\n",
        "5:17: error: entity[0].body.linear_factor: expected 1 (free) or 0 (held) for each of "
        "x, y and z, as in [1, 1, 0]");
    expect_only(
        std::string(kBallWithBody) + "kind = \"static\"\nlinear_factor = [0, 1, 1]\n",
        "6:17: warning: entity[0].body.linear_factor: only dynamic bodies are held along axes; "
        "ignored");
}

TEST_F(SceneFileTest, GravityFactorAndCombineRules) {
    const SceneDescription scene = good(std::string(kBallWithBody) +
                                        "gravity_factor = -0.5\nfriction_combine = \"minimum\"\n"
                                        "restitution_combine = \"average\"\n");
    const BodyDescription& body = *scene.entities[0].body;
    EXPECT_EQ(body.gravity_factor, -0.5_r);
    EXPECT_EQ(body.friction_rule, physics::CombineRule::Minimum);
    EXPECT_EQ(body.restitution_rule, physics::CombineRule::Average);
    expect_only(std::string(kBallWithBody) + "gravity_factor = 2000\n",
                "5:18: error: entity[0].body.gravity_factor: 2000; expected a "
                "factor from -1000 to 1000");
}

TEST_F(SceneFileTest, OnlyDynamicBodiesHaveVelocities) {
    const std::string ball(kBallWithBody);
    expect_only(ball + "kind = \"static\"\nvelocity_mps = [0, 1, 0]\n",
                "6:16: warning: entity[0].body.velocity_mps: a static body does not move; ignored");
    expect_only(ball + "kind = \"kinematic\"\nangular_velocity_radps = [0, 1, 0]\n",
                "6:26: warning: entity[0].body.angular_velocity_radps: a kinematic body moves as "
                "its motion says; ignored");
    const Outcome outcome = load(ball + "kind = \"kinematic\"\nvelocity_mps = [0, 1, 0]\n");
    ASSERT_TRUE(outcome.scene.ok());
    expect_near(outcome.scene->entities[0].body->velocity_mps, {0, 0, 0});
}

TEST_F(SceneFileTest, ShapesThatAKindOfBodyCannotHave) {
    const std::string mesh =
        "shape = { mesh_m = [[0, 0, 0], [1, 0, 0], [0, 1, 0]], triangles = [[0, 1, 2]] }\n";
    const std::string bare = "[[entity]]\n[entity.body]\n";
    EXPECT_TRUE(load(bare + "kind = \"kinematic\"\n" + mesh).faults.empty());
    expect_only(bare + mesh,
                "3:9: error: entity[0].body.shape: a mesh has no inside: static and kinematic "
                "bodies only; use hull or compound");
    expect_only(bare + "kind = \"kinematic\"\nshape = { plane = [1, 1] }\n",
                "4:9: error: entity[0].body.shape: planes are for static bodies only; use box");
    expect_only(bare,
                "2:1: error: entity[0].body.shape: missing; expected a shape, or a model or "
                "primitive to fit");
    // A prefab may leave it to those that start from it; one that was refused is not missing too.
    EXPECT_TRUE(load("[[prefab]]\nname = \"p\"\n[prefab.body]\n").faults.empty());
    expect_only(bare + "shape = { box = [1, 1] }\n",
                "3:17: error: entity[0].body.shape.box: an array of 2; expected [x, y, z]");
    expect_only(std::string(kBallWithBody) + "group = \"\"\n",
                "5:9: error: entity[0].body.group: is empty; expected a name");
}

}  // namespace
}  // namespace plumbline::scene
