// KHR_physics_rigid_bodies as plain data: what each key becomes, and which faults are found.
#include "tests/engine/assets/fixture.h"

namespace plumbline::assets::test {
namespace {

/// The triangle, with physics put into the document and its node.
TriangleFile with_physics(const Json& lists, const Json& node, const Json& shapes = Json::array()) {
    TriangleFile file;
    file.json["extensions"]["KHR_physics_rigid_bodies"] = lists;
    file.json["extensions"]["KHR_implicit_shapes"] = {{"shapes", shapes}};
    file.json["nodes"][0]["extensions"]["KHR_physics_rigid_bodies"] = node;
    return file;
}

TEST(GltfPhysics, takes_motions_and_materials_as_they_are) {
    const Json lists{{"physicsMaterials",
                      {{{"staticFriction", 0.6},
                        {"dynamicFriction", 0.5},
                        {"restitution", 0.1},
                        {"frictionCombine", "maximum"}}}}};
    const Json node{
        {"motion",
         {{"mass", 2.5}, {"centerOfMass", {0, 0.1, 0}}, {"inertiaOrientation", {0, 0, 0, 2}}}},
        {"collider", {{"geometry", {{"shape", 0}}}, {"physicsMaterial", 0}}}};
    const Import import = import_bytes(
        with_physics(lists, node, {{{"type", "sphere"}, {"sphere", {{"radius", 0.25}}}}}).gltf());
    ASSERT_TRUE(import.ok()) << import.error();
    EXPECT_EQ(import.log, "") << "the extensions are read";
    const ModelPhysics& physics = import.model->physics;
    ASSERT_EQ(physics.motions.size(), 1U);
    EXPECT_EQ(physics.motions[0].mass_kg, 2.5);
    EXPECT_EQ(physics.motions[0].center_of_mass_m, Vec3d(0, 0.1, 0)) << "at full precision";
    EXPECT_EQ(physics.motions[0].node_from_inertia, Quatd(1, 0, 0, 0)) << "made unit";
    EXPECT_EQ(physics.materials[0].friction_combine, CombineMode::Maximum);
    EXPECT_EQ(physics.materials[0].restitution_combine, CombineMode::Average)
        << "when it is not said";
    ASSERT_EQ(physics.colliders.size(), 1U);
    EXPECT_EQ(std::get<ModelSphere>(physics.colliders[0].shape).radius_m, 0.25);
}

TEST(GltfPhysics, leaves_out_what_is_in_no_scene) {
    TriangleFile file = with_physics(Json::object(), {{"motion", {{"mass", 1}}}});
    file.json["nodes"].push_back(file.json["nodes"][0]);
    const Import import = import_bytes(file.gltf());
    ASSERT_TRUE(import.ok()) << import.error();
    EXPECT_EQ(import.model->physics.motions.size(), 1U);
}

TEST(GltfPhysics, of_filters_with_and_without_lists) {
    const Json lists{{"collisionFilters",
                      {{{"collisionSystems", {"a"}}},
                       {{"collisionSystems", {"b"}}, {"collideWithSystems", {"a"}}},
                       {{"notCollideWithSystems", {"a"}}}}}};
    const Import import = import_bytes(with_physics(lists, Json::object()).gltf());
    ASSERT_TRUE(import.ok()) << import.error();
    const auto& filters = import.model->physics.filters;
    ASSERT_EQ(filters.size(), 3U);
    EXPECT_TRUE(filters[0].accepts({"b"}));
    EXPECT_TRUE(filters[1].accepts({"a"}));
    EXPECT_FALSE(filters[1].accepts({"b"}));
    EXPECT_FALSE(filters[1].accepts({})) << "what is in no system";
    EXPECT_FALSE(filters[2].accepts({"a", "b"}));
    EXPECT_TRUE(filters[2].accepts({}));
}

TEST(GltfPhysics, of_a_joint_to_a_node_outside_the_scene) {
    TriangleFile file = with_physics({{"physicsJoints", {{{"limits", Json::array()}}}}},
                                     {{"joint", {{"connectedNode", 1}, {"joint", 0}}}});
    file.json["nodes"].push_back(Json::object());
    const Import import = import_bytes(file.gltf());
    ASSERT_TRUE(import.ok()) << import.error();
    EXPECT_TRUE(import.model->physics.joints.empty());
    EXPECT_TRUE(contains(import.log, "its connected node is not in the scene")) << import.log;
}

TEST(GltfPhysics, refuses_what_the_text_forbids) {
    const auto joint = [](Json description) {
        return with_physics({{"physicsJoints", {std::move(description)}}},
                            {{"joint", {{"connectedNode", 0}, {"joint", 0}}}});
    };
    expect_refused(joint({{"limits", {{{"linearAxes", {3}}}}}}), "expected 0, 1 or 2");
    expect_refused(joint({{"limits", {{{"linearAxes", {0}}, {"min", 1}, {"max", 0}}}}}),
                   "min is above max");
    expect_refused(joint({{"drives", {{{"type", "angular"}}}}}), "axis is missing");
    expect_refused(
        with_physics({{"physicsMaterials", {{{"dynamicFriction", -1}}}}}, Json::object()),
        "has a coefficient below 0");
    expect_refused(
        with_physics({{"physicsMaterials", {{{"frictionCombine", "least"}}}}}, Json::object()),
        "expected average, minimum, maximum or multiply");
    expect_refused(with_physics(Json::object(), {{"motion", {{"inertiaDiagonal", {1, -1, 1}}}}}),
                   "has a moment below 0");
    expect_refused(
        with_physics(Json::object(), {{"motion", {{"inertiaOrientation", {0, 0, 0, 0}}}}}),
        "inertiaOrientation is zero");
    expect_refused(
        with_physics(
            Json::object(), Json::object(), {{{"type", "box"}, {"box", {{"size", {1, 0, 1}}}}}}),
        "size must be three lengths above 0");
    expect_refused(
        with_physics(Json::object(),
                     Json::object(),
                     {{{"type", "capsule"},
                       {"capsule", {{"height", 1}, {"radiusTop", 0}, {"radiusBottom", 0}}}}}),
        "must have radii of 0 or more");
    expect_refused(
        with_physics(Json::object(),
                     {{"collider", {{"collisionFilter", 0}, {"geometry", {{"node", 0}}}}}}),
        "names number 0 of 0");
}

// Each node of a chain names the one before it, with all below: far more than the file has bytes.
TEST(GltfPhysics, refuses_colliders_that_add_up_to_too_much) {
    TriangleFile file = with_physics(Json::object(), Json::object());
    Json nodes = Json::array();
    for (int i = 0; i < 6000; ++i) {
        Json node{{"mesh", 0}};
        node["extensions"]["KHR_physics_rigid_bodies"]["collider"] = {{"geometry", {{"node", 0}}}};
        nodes.push_back(node);
    }
    for (int i = 1; i < 6000; ++i) nodes[0]["children"].push_back(i);
    file.json["nodes"] = nodes;
    expect_refused(file, "its colliders have more than");
}

}  // namespace
}  // namespace plumbline::assets::test
