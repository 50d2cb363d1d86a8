// Which promise of model_data.h a model breaks.
#include "engine/assets/foreign/model_wire.h"
#include "engine/core/limits.h"
#include "tests/engine/assets/fixture.h"

#include <functional>
#include <limits>

namespace plumbline::assets::test {
namespace {

/// Two nodes, the second with a triangle, one bone, one target and one keyed place.
ModelData whole_model() {
    ModelData model;
    model.nodes = {{.name = "root"}, {.name = "arm", .parent = 0U, .meshes = {0}, .skin = 0U}};
    model.materials = {{.name = "m"}};
    ModelMesh mesh{.name = "triangle", .vertices = std::vector<Vertex>(3), .indices = {0, 1, 2}};
    mesh.influences.resize(3);
    mesh.targets = {{.positions = std::vector<Vec3f>(3), .normals = {}}};
    model.meshes = {mesh};
    model.skins = {{.joints = {0}, .joint_from_mesh = {Mat4f{1.0F}}}};
    model.animations = {
        {.name = "a",
         .duration_s = 1.0F,
         .channels = {{.node = 1, .times_s = {0, 1}, .values = {0, 0, 0, 1, 1, 1}}}}};
    return model;
}

std::string fault_after(const std::function<void(ModelData&)>& spoil) {
    ModelData model = whole_model();
    spoil(model);
    return fault_of(model);
}

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

TEST(ModelCheck, finds_nothing_in_a_model_that_is_whole) {
    EXPECT_EQ(fault_of(whole_model()), "");
    EXPECT_EQ(fault_of(ModelData{}), "");
}

TEST(ModelCheck, looks_at_what_nodes_name) {
    EXPECT_EQ(fault_after([](ModelData& m) { m.nodes[1].parent = 1U; }),
              "node 1 stands before its parent");
    EXPECT_EQ(fault_after([](ModelData& m) { m.nodes[0].parent = 1U; }),
              "node 0 stands before its parent");
    EXPECT_EQ(fault_after([](ModelData& m) { m.nodes[0].meshes = {1}; }), "node 0 names no mesh");
    EXPECT_EQ(fault_after([](ModelData& m) { m.nodes[1].skin = 1U; }), "node 1 names no skin");
    EXPECT_EQ(fault_after([](ModelData& m) { m.nodes[1].parent_from_node[3][0] = kNan; }),
              "node 1 stands nowhere");
    EXPECT_EQ(fault_after([](ModelData& m) { m.nodes.resize(limits::kModelNodes + 1); }),
              "it has too many nodes");
}

TEST(ModelCheck, looks_at_what_meshes_hold) {
    EXPECT_EQ(fault_after([](ModelData& m) { m.meshes[0].material = 1; }),
              "mesh 0 has no material");
    EXPECT_EQ(fault_after([](ModelData& m) { m.meshes[0].indices[2] = 3; }),
              "mesh 0 names vertices that it lacks");
    EXPECT_EQ(fault_after([](ModelData& m) { m.meshes[0].indices.pop_back(); }),
              "mesh 0 names vertices that it lacks");
    EXPECT_EQ(fault_after([](ModelData& m) { m.meshes[0].influences.pop_back(); }),
              "mesh 0 has another number of influences");
    EXPECT_EQ(fault_after([](ModelData& m) { m.meshes[0].targets[0].positions.pop_back(); }),
              "mesh 0 has a target of another size");
    EXPECT_EQ(fault_after([](ModelData& m) { m.meshes[0].targets[0].normals.resize(2); }),
              "mesh 0 has a target of another size");
    EXPECT_EQ(fault_after([](ModelData& m) { m.meshes[0].vertices[1].position_body.y = kNan; }),
              "mesh 0 has numbers that are not finite");
    EXPECT_EQ(fault_after([](ModelData& m) { m.meshes[0].vertices[1].color.z = kNan; }),
              "mesh 0 has numbers that are not finite");
}

TEST(ModelCheck, looks_at_bones_and_keys) {
    const auto channel = [](ModelData& m) -> AnimationChannel& {
        return m.animations[0].channels[0];
    };
    EXPECT_EQ(fault_after([](ModelData& m) { m.skins[0].joints = {2}; }),
              "a skin names nodes that are not there");
    EXPECT_EQ(fault_after([](ModelData& m) { m.skins[0].joint_from_mesh.clear(); }),
              "a skin names nodes that are not there");
    EXPECT_EQ(fault_after([&](ModelData& m) { channel(m).node = 2; }),
              "animation \"a\" names no node or no time");
    EXPECT_EQ(fault_after([&](ModelData& m) { channel(m).times_s.clear(); }),
              "animation \"a\" names no node or no time");
    EXPECT_EQ(fault_after([&](ModelData& m) {
                  channel(m).times_s = {1, 1};
              }),
              "animation \"a\" has times that do not rise");
    EXPECT_EQ(fault_after([&](ModelData& m) { channel(m).values[5] = kNan; }),
              "animation \"a\" has numbers that are not finite");
    const std::string number = "animation \"a\" has another number of values";
    EXPECT_EQ(fault_after([&](ModelData& m) { channel(m).values.pop_back(); }), number);
    EXPECT_EQ(fault_after([&](ModelData& m) { channel(m).path = ChannelPath::Rotation; }), number);
    EXPECT_EQ(fault_after([&](ModelData& m) { channel(m).path = ChannelPath::MorphWeights; }), "");
    EXPECT_EQ(
        fault_after([&](ModelData& m) { channel(m).interpolation = Interpolation::CubicSpline; }),
        number);
    EXPECT_EQ(fault_after([&](ModelData& m) {
                  channel(m).interpolation = Interpolation::CubicSpline;
                  channel(m).values.resize(18);
              }),
              "");
}

}  // namespace
}  // namespace plumbline::assets::test
