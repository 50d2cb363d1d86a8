// What a valid scene says is what the description holds.
#include "engine/scene/accuracy.h"
#include "tests/engine/scene/scene_file_fixture.h"

namespace plumbline::scene {
namespace {

constexpr Real kSlack{1e-6_r};

void expect_near(const Vec3& value, const Vec3& wanted) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(value[i], wanted[i], kSlack) << "part " << i;
}
void expect_near_f(const Vec3f& value, const Vec3f& wanted) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(value[i], wanted[i], 1e-6F) << "part " << i;
}

TEST_F(SceneFileTest, EmptyFileGivesTheDefaults) {
    const Outcome outcome = load("");
    ASSERT_TRUE(outcome.scene.ok());
    EXPECT_TRUE(outcome.faults.empty());
    const SceneDescription& scene = *outcome.scene;
    expect_near(scene.gravity_mps2, {0, -9.81_r, 0});
    EXPECT_FALSE(scene.kill_below_m);
    EXPECT_EQ(scene.accuracy.preset, "balanced");
    EXPECT_EQ(scene.accuracy.step_hz, 60);
    EXPECT_FALSE(scene.accuracy.substeps);
    EXPECT_FALSE(scene.accuracy.iterations);
    EXPECT_EQ(scene.accuracy.solver, physics::Solver::SmallStep);
    EXPECT_FALSE(scene.player);
    EXPECT_FALSE(scene.has_camera);
    EXPECT_FALSE(scene.sun);
    EXPECT_FALSE(scene.sky);
    EXPECT_FALSE(scene.fog);
    EXPECT_FALSE(scene.flashlight);
    EXPECT_FALSE(scene.post);
    EXPECT_TRUE(scene.entities.empty());
}

TEST_F(SceneFileTest, BomAndCrlfAreAccepted) {
    const Outcome outcome = load("\xEF\xBB\xBF[scene]\r\ntitle = \"Tür\"\r\n");
    ASSERT_TRUE(outcome.scene.ok());
    EXPECT_EQ(outcome.scene->title, "Tür");
}

TEST_F(SceneFileTest, WorldPlayerCameraAndViews) {
    const Outcome outcome = load(R"([scene]
title = "T"
description = "D"
[world]
gravity_mps2 = [1, -2.5, 3]
kill_below_m = -100
[player]
position_m = [1, 2, 3]
yaw_deg = 90
pitch_deg = -30
[camera]
position_m = [4, 5, 6]
target_m = [0, 1, 0]
fov_deg = 60
near_m = 0.1
far_m = 250
clear_color = [0.1, 0.2, 0.3]
[[view]]
name = "gate"
position_m = [1, 1, 1]
target_m = [0, 0, 0]
wait_s = 2.5
flashlight = true
light_scale = 0.25
[[entity]]
primitive = { plane = [9, 9] }
body = { kind = "static" }
)");
    ASSERT_TRUE(outcome.scene.ok()) << outcome.scene.error().message;
    EXPECT_TRUE(outcome.faults.empty());
    const SceneDescription& scene = *outcome.scene;
    EXPECT_EQ(scene.title, "T");
    EXPECT_EQ(scene.description, "D");
    expect_near(scene.gravity_mps2, {1, -2.5_r, 3});
    EXPECT_EQ(scene.kill_below_m, Real{-100});
    ASSERT_TRUE(scene.player);
    expect_near(scene.player->feet_position_m, {1, 2, 3});
    EXPECT_NEAR(scene.player->yaw_rad, kPi / 2, kSlack);
    EXPECT_NEAR(scene.player->pitch_rad, -kPi / 6, kSlack);
    EXPECT_EQ(to_string(scene.player->origin), "scene.toml:7");
    EXPECT_TRUE(scene.has_camera);
    expect_near(scene.camera.position_m, {4, 5, 6});
    expect_near(scene.camera.target_m, {0, 1, 0});
    EXPECT_NEAR(scene.camera.fov_y_rad, kPi / 3, kSlack);
    EXPECT_NEAR(scene.camera.near_m, 0.1_r, kSlack);
    EXPECT_NEAR(scene.camera.far_m, Real{250}, kSlack);
    expect_near_f(scene.clear_color, {0.1F, 0.2F, 0.3F});
    ASSERT_EQ(scene.views.size(), 1U);
    EXPECT_EQ(scene.views[0].name, "gate");
    EXPECT_NEAR(scene.views[0].wait_s, 2.5_r, kSlack);
    EXPECT_TRUE(scene.views[0].flashlight);
    EXPECT_FLOAT_EQ(scene.views[0].light_scale, 0.25F);
}

TEST_F(SceneFileTest, AccuracyKeysOverrideThePreset) {
    const Outcome outcome = load(R"([accuracy]
preset = "precise"
iterations = 33
solver = "bullet_dantzig"
tolerance = 0.02
)");
    ASSERT_TRUE(outcome.scene.ok());
    const Accuracy& accuracy = outcome.scene->accuracy;
    EXPECT_EQ(accuracy.preset, "precise");
    EXPECT_EQ(accuracy.step_hz, 120);
    EXPECT_FALSE(accuracy.substeps);
    EXPECT_EQ(accuracy.iterations, 33);
    EXPECT_EQ(accuracy.solver, physics::Solver::BulletDantzig);
    EXPECT_NEAR(accuracy.tolerance.value_or(0), 0.02, 1e-6);
}

TEST_F(SceneFileTest, AutoTakesAToleranceOrABudget) {
    const Outcome outcome = load("[accuracy]\npreset = \"auto\"\nbudget_ms = 0.5\nstep_hz = 120\n");
    ASSERT_TRUE(outcome.scene.ok());
    EXPECT_TRUE(outcome.faults.empty());
    const Accuracy& accuracy = outcome.scene->accuracy;
    EXPECT_NEAR(accuracy.budget_ms.value_or(0), 0.5, 1e-6);
    EXPECT_FALSE(accuracy.tolerance);
    EXPECT_TRUE(accuracy.step_hz_given);
    EXPECT_FALSE(accuracy.solver_given);
    EXPECT_FALSE(load("[accuracy]\nbudget_ms = 1\ntolerance = 0.1\n").scene.ok());
    EXPECT_FALSE(load("[accuracy]\nbudget_ms = 0\n").scene.ok());
}

TEST_F(SceneFileTest, PresetsGetFinerFromDraftToReference) {
    double last = 0;
    for (const char* preset : {"draft", "balanced", "precise", "reference"}) {
        const Outcome outcome = load(fmt::format("[accuracy]\npreset = \"{}\"\n", preset));
        ASSERT_TRUE(outcome.scene.ok());
        EXPECT_TRUE(outcome.faults.empty());
        const physics::WorldDef def = world_def(*outcome.scene, {});
        const double work = def.substeps * def.iterations / def.step_s;
        EXPECT_GT(work, last) << preset;
        last = work;
    }
}

TEST_F(SceneFileTest, SolversByName) {
    using physics::Solver;
    for (const auto& [name, solver] : {std::pair{"bullet_si", Solver::BulletSi},
                                       std::pair{"bullet_nncg", Solver::BulletNncg},
                                       std::pair{"bullet_dantzig", Solver::BulletDantzig},
                                       std::pair{"bullet_pgs", Solver::BulletPgs}}) {
        const Outcome outcome = load(fmt::format("[accuracy]\nsolver = \"{}\"\n", name));
        ASSERT_TRUE(outcome.scene.ok());
        EXPECT_EQ(outcome.scene->accuracy.solver, solver) << name;
    }
}

TEST_F(SceneFileTest, NumbersOfTheFileGoBeforeThePresets) {
    const Outcome outcome =
        load("[accuracy]\nstep_hz = 120\nsubsteps = 4\niterations = 1\nsolver = \"small_step\"\n");
    ASSERT_TRUE(outcome.scene.ok());
    EXPECT_EQ(outcome.scene->accuracy.solver, physics::Solver::SmallStep);
    const physics::WorldDef def = world_def(*outcome.scene, {});
    EXPECT_DOUBLE_EQ(def.step_s, 1.0 / 120);
    EXPECT_EQ(def.substeps, 4);
    EXPECT_EQ(def.substeps_max, 4) << "a number alone means exactly so many";
    EXPECT_EQ(def.iterations, 1);
    EXPECT_TRUE(outcome.faults.empty());
}

TEST_F(SceneFileTest, NumbersDoNotCarryOverToTheOtherKindOfSolver) {
    const Outcome outcome = load("[accuracy]\nsubsteps = 4\nsubsteps_max = 8\niterations = 1\n");
    ASSERT_TRUE(outcome.scene.ok());
    const physics::WorldDef own = world_def(*outcome.scene, {});
    EXPECT_EQ(own.substeps, 4);
    EXPECT_EQ(own.substeps_max, 8);
    const physics::WorldDef other =
        world_def(*outcome.scene, {.solver = physics::Solver::BulletSi});
    EXPECT_EQ(other.substeps, 1);
    EXPECT_EQ(other.iterations, 10);
}

TEST_F(SceneFileTest, LightAndAir) {
    for (const char* face : {"px", "nx", "py", "ny", "pz", "nz"})
        write(fmt::format("assets/skies/day/{}.png", face), "x");
    const Outcome outcome = load(R"([sun]
direction = [0, -2, 0]
color = [0.5, 0.25, 1]
intensity = 4
rotation_degps = 180
shadow = { cascades = 1, size_px = 1024, distance_m = 40 }
[sky]
skybox = "skies/day"
[ambient]
color = [0.2, 0.3, 0.4]
[fog]
color_srgb = [1, 0.5, 0]
density_per_m = 0.05
[flashlight]
color = [1, 1, 0.5]
intensity = 70
radius_m = 20
inner_deg = 10
outer_deg = 25
on = true
[post]
bloom = 0.1
exposure = 2
[effects.fog]
)");
    ASSERT_TRUE(outcome.scene.ok()) << outcome.scene.error().message;
    EXPECT_TRUE(outcome.faults.empty());
    const SceneDescription& scene = *outcome.scene;
    ASSERT_TRUE(scene.sun && scene.sun->shadow && scene.sky && scene.fog && scene.flashlight);
    expect_near(scene.sun->direction, {0, -1, 0});
    expect_near_f(scene.sun->color, {0.5F, 0.25F, 1.0F});
    EXPECT_FLOAT_EQ(scene.sun->intensity, 4.0F);
    EXPECT_NEAR(scene.sun->rotation_radps, kPi, kSlack);
    EXPECT_EQ(scene.sun->shadow->cascades, 1);
    EXPECT_EQ(scene.sun->shadow->size_px, 1024);
    EXPECT_NEAR(scene.sun->shadow->distance_m, Real{40}, kSlack);
    EXPECT_EQ(scene.sky->folder, assets() / "skies/day");
    EXPECT_EQ(to_string(scene.sky->origin), "scene.toml:7");
    expect_near_f(scene.ambient, {0.2F, 0.3F, 0.4F});
    // sRGB 0.5 is 0.21404 linear.
    EXPECT_NEAR(scene.fog->color.y, 0.21404F, 1e-5F);
    EXPECT_FLOAT_EQ(scene.fog->color.x, 1.0F);
    EXPECT_FLOAT_EQ(scene.fog->density_per_m, 0.05F);
    EXPECT_FLOAT_EQ(scene.flashlight->intensity, 70.0F);
    EXPECT_FLOAT_EQ(scene.flashlight->radius_m, 20.0F);
    EXPECT_FLOAT_EQ(scene.flashlight->inner_deg, 10.0F);
    EXPECT_FLOAT_EQ(scene.flashlight->outer_deg, 25.0F);
    EXPECT_TRUE(scene.flashlight->on);
    ASSERT_TRUE(scene.post);
    EXPECT_FLOAT_EQ(scene.post->bloom, 0.1F);
    EXPECT_FLOAT_EQ(scene.post->exposure, 2.0F);
    ASSERT_TRUE(scene.effect_settings.contains("fog"));
    EXPECT_EQ(scene.effect_settings.at("fog").line, 24);
}

TEST_F(SceneFileTest, SunShadowByYesAndNo) {
    EXPECT_TRUE(load("sun = { shadow = true }").scene->sun->shadow);
    EXPECT_FALSE(load("sun = { shadow = false }").scene->sun->shadow);
    EXPECT_FALSE(load("sun = {}").scene->sun->shadow);
}

TEST_F(SceneFileTest, Materials) {
    for (const char* map : {"b.jpg", "n.png", "o.jpg", "h.jpg"})
        write(fmt::format("assets/textures/{}", map), "x");
    const Outcome outcome = load(R"([[material]]
name = "leaf"
shading = "blinn_phong"
base_color = [0.1, 0.2, 0.3]
alpha = 0.5
emissive = [0, 2, 0]
base_color_map = "textures/b.jpg"
normal_map = "textures/n.png"
orm_map = "textures/o.jpg"
height_map = "textures/h.jpg"
roughness = 0.3
metallic = 0.7
alpha_mode = "mask"
alpha_cutoff = 0.4
two_sided = true
surface = "soft"
)");
    ASSERT_TRUE(outcome.scene.ok()) << outcome.scene.error().message;
    EXPECT_TRUE(outcome.faults.empty());
    const assets::MaterialData& leaf = outcome.scene->materials.at("leaf");
    EXPECT_EQ(leaf.name, "leaf");
    EXPECT_EQ(leaf.shading, assets::Shading::BlinnPhong);
    expect_near_f(leaf.base_color, {0.1F, 0.2F, 0.3F});
    EXPECT_FLOAT_EQ(leaf.alpha, 0.5F);
    expect_near_f(leaf.emissive, {0.0F, 2.0F, 0.0F});
    EXPECT_EQ(leaf.base_color_map, assets() / "textures/b.jpg");
    EXPECT_EQ(leaf.normal_map, assets() / "textures/n.png");
    EXPECT_EQ(leaf.orm_map, assets() / "textures/o.jpg");
    EXPECT_EQ(leaf.height_map, assets() / "textures/h.jpg");
    EXPECT_FLOAT_EQ(leaf.roughness, 0.3F);
    EXPECT_FLOAT_EQ(leaf.metallic, 0.7F);
    EXPECT_EQ(leaf.alpha_mode, assets::AlphaMode::Mask);
    EXPECT_FLOAT_EQ(leaf.alpha_cutoff, 0.4F);
    EXPECT_TRUE(leaf.two_sided);
    EXPECT_EQ(leaf.surface, "soft");
}

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
    EXPECT_EQ(to_string(cube.origin), "scene.toml:3");
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

TEST_F(SceneFileTest, LightSoundAndMotion) {
    write("assets/sounds/f.ogg", "x");
    const Outcome outcome = load(R"([[entity]]
light = { kind = "spot", color = [1, 0.5, 0], intensity = 30, radius_m = 9, direction = [0, 0, -3], inner_deg = 15, outer_deg = 35 }
sound = { file = "sounds/f.ogg", loop = false, gain = 0.6, radius_m = 7 }
primitive = { box = [1, 1, 1] }
motion = { points_m = [[0, 0, 0], [3, 0, 0]], period_s = 6, spin_degps = [0, 90, 0] }
body = { kind = "kinematic" }
)");
    ASSERT_TRUE(outcome.scene.ok()) << outcome.scene.error().message;
    EXPECT_TRUE(outcome.faults.empty());
    const EntityDescription& entity = outcome.scene->entities.at(0);
    ASSERT_TRUE(entity.light && entity.sound && entity.motion);
    EXPECT_TRUE(entity.light->is_spot);
    expect_near_f(entity.light->color, {1.0F, 0.5F, 0.0F});
    expect_near_f(entity.light->direction, {0.0F, 0.0F, -1.0F});
    EXPECT_FLOAT_EQ(entity.light->inner_deg, 15.0F);
    EXPECT_FLOAT_EQ(entity.light->outer_deg, 35.0F);
    EXPECT_FALSE(entity.sound->loop);
    EXPECT_FLOAT_EQ(entity.sound->gain, 0.6F);
    EXPECT_EQ(entity.sound->file, assets() / "sounds/f.ogg");
    ASSERT_EQ(entity.motion->points_m.size(), 2U);
    EXPECT_NEAR(entity.motion->spin_radps.y, kPi / 2, kSlack);
    EXPECT_EQ(entity.motion->period_s, Real{6});
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

TEST_F(SceneFileTest, ShippedFilesAreIncludedByTheirBareNames) {
    write("assets/scenes/materials.toml", "[[material]]\nname = \"oak\"\n");
    const Outcome bare = load("[scene]\ninclude = [\"materials.toml\"]\n");
    ASSERT_TRUE(bare.scene.ok()) << bare.scene.error().message;
    EXPECT_TRUE(bare.scene->materials.contains("oak"));
    write("materials.toml", "[[material]]\nname = \"elm\"\n");
    const Outcome beside = load("[scene]\ninclude = [\"materials.toml\"]\n");
    ASSERT_TRUE(beside.scene.ok()) << beside.scene.error().message;
    EXPECT_TRUE(beside.scene->materials.contains("elm")) << "one's own comes first";
    const Outcome neither = load("[scene]\ninclude = [\"material.toml\"]\n");
    ASSERT_EQ(neither.faults.size(), 1U);
    EXPECT_EQ(neither.faults[0],
              "scene.toml:2:12: error: scene.include[0]: \"material.toml\" does not exist beside "
              "this file, in assets or in assets/scenes");
}

TEST_F(SceneFileTest, AKeyWithoutItsUnitIsNamed) {
    const Outcome outcome =
        load("[[entity]]\nprimitive = { box = [1, 1, 1] }\n[entity.body]\nmass = 3\n");
    ASSERT_EQ(outcome.faults.size(), 1U);
    EXPECT_EQ(outcome.faults[0],
              "scene.toml:4:1: error: entity[0].body.mass: unknown key; did you mean \"mass_kg\"?");
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
kind = "ball"
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

TEST_F(SceneFileTest, IncludesBringMaterialsAndPrefabs) {
    write("assets/scenes/colours.toml", "[[material]]\nname = \"red\"\nroughness = 0.1\n");
    write("assets/scenes/things.toml",
          "[scene]\ninclude = [\"colours.toml\"]\n[[prefab]]\nname = \"ball\"\nmaterial = \"red\"\n"
          "primitive = { sphere = 0.2 }\n");
    write("assets/scenes/sub/main.toml",
          "[scene]\ninclude = [\"../colours.toml\", \"../things.toml\"]\n"
          "[[entity]]\nprefab = \"ball\"\n"
          "[[material]]\nname = \"red\"\nroughness = 0.9\n");
    const Outcome outcome = load_file("assets/scenes/sub/main.toml");
    ASSERT_TRUE(outcome.scene.ok()) << outcome.scene.error().message;
    EXPECT_TRUE(outcome.faults.empty());
    EXPECT_EQ(outcome.scene->entities.at(0).material, "red");
    // The scene's own word counts over an included file's.
    EXPECT_FLOAT_EQ(outcome.scene->materials.at("red").roughness, 0.9F);
}

TEST_F(SceneFileTest, FilesBesideTheSceneComeFirst) {
    write("assets/t.png", "x");
    write("mine/t.png", "x");
    write("mine/scene.toml", "[[material]]\nname = \"m\"\nbase_color_map = \"t.png\"\n");
    EXPECT_EQ(load_file("mine/scene.toml").scene->materials.at("m").base_color_map,
              folder() / "mine/t.png");
    std::filesystem::remove(folder() / "mine/t.png");
    EXPECT_EQ(load_file("mine/scene.toml").scene->materials.at("m").base_color_map,
              assets() / "t.png");
}

TEST_F(SceneFileTest, ContentHashCoversIncludes) {
    write("part.toml", "[[material]]\nname = \"a\"\n");
    const std::string main = "[scene]\ninclude = [\"part.toml\"]\n";
    const std::uint64_t first = load(main).scene->content_hash;
    EXPECT_EQ(load(main).scene->content_hash, first);
    write("part.toml", "[[material]]\nname = \"b\"\n");
    EXPECT_NE(load(main).scene->content_hash, first);
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

TEST_F(SceneFileTest, AModelIsAScene) {
    write("assets/models/m.glb", "x");
    const Outcome outcome = load_file("assets/models/m.glb");
    ASSERT_TRUE(outcome.scene.ok()) << outcome.scene.error().message;
    EXPECT_FALSE(outcome.scene->has_camera);
    ASSERT_TRUE(outcome.scene->sun && outcome.scene->sun->shadow);
    ASSERT_EQ(outcome.scene->entities.size(), 2U);
    const EntityDescription& model = outcome.scene->entities[1];
    EXPECT_EQ(model.name, "model");
    EXPECT_EQ(std::get<ModelVisual>(model.visual).root, assets());
    EXPECT_EQ(model.body->kind, physics::BodyKind::Static);
}

}  // namespace
}  // namespace plumbline::scene
