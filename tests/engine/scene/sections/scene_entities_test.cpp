// Bodies, shapes, prefabs, arrays and joints of scene files.
#include "tests/engine/scene/sections/scene_file_fixture.h"

namespace plumbline::scene {
namespace {

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

// SOURCES A35.
TEST_F(SceneFileTest, ContactMaterialIsAMaterialOfABody) {
    const std::string materials = "[[material]]\nname = \"red\"\n[[material]]\nname = \"blue\"\n";
    const SceneDescription scene =
        good(materials +
             "[[entity]]\nprimitive = { sphere = 1 }\nmaterial = \"red\"\n"
             "contact_material = \"blue\"\nbody = {}\n");
    EXPECT_EQ(scene.entities[0].contact_material, "blue");
    expect_only(
        materials +
            "[[entity]]\nprimitive = { sphere = 1 }\ncontact_material = \"bleu\"\nbody = {}\n",
        "7:20: error: entity[0].contact_material: no material is called \"bleu\"; did you mean "
        "\"blue\"?");
    expect_only(
        materials + "[[entity]]\nprimitive = { sphere = 1 }\ncontact_material = \"blue\"\n",
        "7:20: error: entity[0].contact_material: nothing touches an entity without a body");
}

// SOURCES A36.
TEST_F(SceneFileTest, ATriggerIsAVolumeWithoutABody) {
    const std::string prefab =
        "[[prefab]]\nname = \"green_box\"\nprimitive = { box = [4, 4, 4] }\nbody = {}\n";
    const std::string volume = "[[entity]]\nname = \"t\"\nprimitive = { box = [2, 0.5, 2] }\n";
    const SceneDescription scene =
        good(prefab + volume +
             "trigger = { spawn = \"green_box\", at_m = [5, 10, 0], of = [\"t\"], times = 3 }\n");
    const TriggerDescription& trigger = *scene.entities[0].trigger;
    EXPECT_EQ(trigger.spawn, "green_box");
    expect_near(trigger.at_m, {5, 10, 0});
    EXPECT_EQ(trigger.of, std::vector<std::string>{"t"});
    EXPECT_EQ(trigger.times, 3);
    expect_only(
        prefab + volume + "trigger = { spawn = \"green_bx\", at_m = [0, 0, 0] }\n",
        "8:21: error: entity[0].trigger.spawn: no prefab is called \"green_bx\"; did you mean "
        "\"green_box\"?");
    expect_only(
        prefab + volume +
            "trigger = { spawn = \"green_box\", at_m = [0, 0, 0], of = [\"tt\", \"t#1\"] }\n",
        "6:8: warning: entity[0].trigger.of: no entity is called \"tt\"; did you mean \"t\"?");
    expect_only(
        prefab + volume + "trigger = { at_m = [0, 0, 0] }\n",
        "8:11: error: entity[0].trigger: does nothing; expected one or more of spawn, remove, "
        "impulse_Ns, gravity_mps2, explode, light, message, "
        "sound, count");
    expect_only(prefab + volume + "trigger = { light = \"t\", remove = true }\n",
                "6:8: warning: entity[0].trigger.light: no entity with a light is called \"t\"");
    expect_only(prefab + volume + "trigger = { explode = \"charge\" }\n",
                "6:8: warning: entity[0].trigger.explode: no explosion is called \"charge\"");
    expect_only(prefab + volume + "trigger = { spawn = \"green_box\" }\n",
                "8:11: error: entity[0].trigger.at_m: missing; expected where it appears");
    expect_only(
        prefab + volume + "trigger = { spawn = \"green_box\", at_m = [0, 0, 0] }\nbody = {}\n",
        "8:11: error: entity[0].trigger: is passed through: the entity has no body");
    expect_only(
        prefab +
            "[[entity]]\nname = \"t\"\ntrigger = { spawn = \"green_box\", at_m = [0, 0, 0] }\n",
        "7:11: error: entity[0].trigger: is the volume of a primitive other than a plane; "
        "there is none");
}

TEST_F(SceneFileTest, NamesAndLabelsAreShortTexts) {
    const std::string long_name(65, 'x');
    EXPECT_EQ(good("[[entity]]\nname = \"" + long_name.substr(1) + "\"\n").entities[0].name,
              long_name.substr(1));
    EXPECT_FALSE(load("[[entity]]\nname = \"" + long_name + "\"\n").scene.ok());
    expect_only("[[entity]]\nname = \"\"\n",
                "2:8: error: entity[0].name: \"\"; expected 1 to 64 letters");
    EXPECT_FALSE(load("[[entity]]\nlabel = \"a\\tb\"\n").scene.ok());
    EXPECT_EQ(good("[[entity]]\n").entities[0].name, "entity[0]");
}

TEST_F(SceneFileTest, CountsOfCopies) {
    const std::string array =
        "[[prefab]]\nname = \"p\"\n[[array]]\nname = \"n\"\nprefab = \"p\"\ncount = ";
    EXPECT_EQ(good(array + "[1, 2, 3]\n").arrays[0].count, (std::array<int, 3>{1, 2, 3}));
    for (const char* part : {"0", "50001", "1.0"}) {
        expect_only(array + "[1, " + part + ", 1]\n",
                    fmt::format("6:13: error: array[0].count[1]: {}; expected three whole numbers "
                                "from 1 to 50000",
                                part));
    }
    expect_only(array + "7\n",
                "6:9: error: array[0].count: 7; expected three whole numbers from 1 to 50000");
}

TEST_F(SceneFileTest, OnlyKinematicBodiesFollowPaths) {
    const std::string ball = "[[entity]]\nprimitive = { sphere = 1 }\n";
    const std::string path = "motion = { points_m = [[0, 0, 0], [1, 0, 0]] }\n";
    EXPECT_TRUE(load(ball + path + "body = { kind = \"kinematic\" }\n").faults.empty());
    expect_only(ball + path,
                "3:10: error: entity[0].motion: only kinematic bodies follow a path; set body.kind "
                "= \"kinematic\"");
    expect_only(ball + "scale = [1, 20000, 1]\n",
                "3:13: error: entity[0].scale[1]: 20000; expected a factor from 0.001 to 10000");
    expect_only(
        ball + "scale = [1, 10000, 1]\n" + "material = \"rde\"\n",
        "4:12: error: entity[0].material: no material is called \"rde\"; none is known here");
}

}  // namespace
}  // namespace plumbline::scene
