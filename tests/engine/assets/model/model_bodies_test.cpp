// Where nodes stand, and which of them move together.
#include "engine/assets/model/model_bodies.h"

#include "engine/assets/model/model_pose.h"
#include "engine/assets/primitives.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::assets {
namespace {

ModelNode node_at(const Vec3f& at,
                  std::optional<std::uint32_t> parent = {},
                  const Vec3f& scale = Vec3f{1}) {
    ModelNode node{.parent = parent, .rest = {.translation = at, .scale = scale}};
    node.parent_from_node = matrix_of(node.rest);
    return node;
}

TEST(ModelBodies, StandWhereTheirChainOfNodesSays) {
    ModelData model;
    model.nodes = {node_at({1, 2, 3}, {}, {2, 1, 1}), node_at({1, 0, 0}, 0)};
    model.nodes[1].rest.rotation =
        Quatf{std::sqrt(0.5F), 0, 0, std::sqrt(0.5F)};  // a quarter turn about z
    model.nodes[1].parent_from_node = matrix_of(model.nodes[1].rest);
    const std::vector<NodePlace> places = node_places(model);
    EXPECT_EQ(places[0].stretch[0][0], 2.0);
    EXPECT_EQ(places[1].position_m, Vec3d(3, 2, 3)) << "twice as far along x";
    // Its own y lies along the stretched x.
    EXPECT_NEAR(places[1].stretch[1][1], 2.0, 1e-6);
    EXPECT_NEAR(places[1].stretch[0][0], 1.0, 1e-6);
    const Vec3d y = places[1].turn * (places[1].stretch * Vec3d{0, 1, 0});
    EXPECT_NEAR(y.x, -2.0, 1e-6);
}

TEST(ModelBodies, AreExactWhereNothingIsScaled) {
    ModelData model;
    model.nodes = {node_at({0.1F, 0.2F, 0.3F}), node_at({0.7F, 0, 0}, 0)};
    model.nodes[0].rest.rotation = glm::normalize(Quatf{0.9F, 0.1F, 0.3F, 0.2F});
    model.nodes[0].parent_from_node = matrix_of(model.nodes[0].rest);
    for (const NodePlace& place : node_places(model)) EXPECT_EQ(place.stretch, glm::dmat3{1.0});
    EXPECT_EQ(node_places(model)[0].position_m, Vec3d(Vec3f(0.1F, 0.2F, 0.3F)));
}

TEST(ModelBodies, HaveAllBelowThemButOtherBodies) {
    ModelData model;
    // 0 scenery; 1 a body with a child 2 and another body 3, which has a child 4.
    model.nodes = {node_at({0, 0, 0}),
                   node_at({5, 0, 0}),
                   node_at({1, 0, 0}, 1),
                   node_at({0, 5, 0}, 1),
                   node_at({0, 1, 0}, 3)};
    model.physics.motions = {{.node = 1}, {.node = 3}};
    EXPECT_EQ(bodies_of_nodes(model), (std::vector<std::size_t>{2, 0, 0, 1, 1}));
    const MeshData cube = box_mesh({1, 1, 1});
    model.meshes = {{.vertices = cube.vertices, .indices = cube.indices}};
    model.materials.resize(1);
    for (ModelNode& node : model.nodes) node.meshes = {0};
    const std::vector<MeshData> meshes = body_meshes(model, "m");
    ASSERT_EQ(meshes.size(), 3U);
    EXPECT_EQ(meshes[0].bounds.max, Vec3f(1.5F, 0.5F, 0.5F)) << "in the frame of node 1";
    EXPECT_EQ(meshes[1].bounds.max, Vec3f(0.5F, 1.5F, 0.5F));
    EXPECT_EQ(meshes[2].bounds.max, Vec3f(0.5F, 0.5F, 0.5F));
}

}  // namespace
}  // namespace plumbline::assets
