// Primitives of glTF meshes: attributes, modes, weights, and primitives that are left out.
#include "tests/engine/assets/fixture.h"

#include <limits>

namespace plumbline::assets::test {
namespace {

TEST(GltfMeshes, lays_texture_coordinates_as_the_base_map_asks) {
    TriangleFile file;
    std::string second;
    append_bytes<float>(second, {0, 0, 1, 0, 0, 1});
    file.attributes()["TEXCOORD_1"] = file.add_accessor(second, 5126, 3, "VEC2");
    file.json["extensionsRequired"] = {"KHR_texture_transform"};
    file.json["images"] = {{{"uri", "a.png"}}};
    file.json["textures"] = {{{"source", 0}}};
    const Json transform = {{"offset", {0.5, 0.25}}, {"scale", {2, 4}}};
    const Json slot = {
        {"index", 0}, {"texCoord", 1}, {"extensions", {{"KHR_texture_transform", transform}}}};
    file.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", slot}}}}};
    file.primitive()["material"] = 0;
    const Import import = import_bytes(file.gltf());
    ASSERT_TRUE(import.ok()) << import.error();
    EXPECT_EQ(import.mesh().vertices[0].uv, Vec2f(0.5F, 0.25F));
    EXPECT_EQ(import.mesh().vertices[1].uv, Vec2f(2.5F, 0.25F));
    EXPECT_EQ(import.mesh().vertices[2].uv, Vec2f(0.5F, 4.25F));
}

TEST(GltfMeshes, reads_byte_texture_coordinates) {
    TriangleFile file;
    std::string uv;
    append_bytes<std::uint8_t>(uv, {0, 255, 0, 0, 51, 102, 0, 0, 255, 0, 0, 0});
    const std::size_t accessor = file.add_accessor(uv, 5121, 3, "VEC2");
    file.json["accessors"][accessor]["normalized"] = true;
    file.json["bufferViews"].back()["byteStride"] = 4;
    file.attributes()["TEXCOORD_0"] = accessor;
    const Import import = import_bytes(file.gltf());
    ASSERT_TRUE(import.ok()) << import.error();
    EXPECT_NEAR(glm::length(import.mesh().vertices[1].uv - Vec2f(0.2F, 0.4F)), 0, 1e-6);
    EXPECT_NEAR(glm::length(import.mesh().vertices[2].uv - Vec2f(1, 0)), 0, 1e-6);
}

TEST(GltfMeshes, reads_strips_and_fans) {
    for (const int mode : {5, 6}) {
        TriangleFile file;
        std::string corners;
        append_bytes<float>(corners, {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0});
        file.primitive()["mode"] = mode;
        file.primitive().erase("indices");
        file.primitive()["attributes"] = {
            {"POSITION", file.add_accessor(corners, 5126, 4, "VEC3")}};
        const Import import = import_bytes(file.gltf());
        ASSERT_TRUE(import.ok()) << import.error();
        EXPECT_EQ(import.mesh().indices.size(), 6U) << "mode " << mode;
    }
}

TEST(GltfMeshes, leaves_out_a_mesh_whose_indices_pass_its_vertices) {
    TriangleFile file = two_meshes();
    std::string indices;
    append_bytes<std::uint16_t>(indices, {0, 1, 3});
    file.primitive(1)["indices"] = file.add_accessor(indices, 5123, 3, "SCALAR");
    const Import import = import_bytes(file.gltf());
    ASSERT_TRUE(import.ok()) << import.error();
    EXPECT_EQ(import.mesh().indices.size(), 3U);
    EXPECT_TRUE(
        contains(import.log, "meshes[1].primitives[0] is left out: index 2 names vertex 3 of 3"))
        << import.log;
}

TEST(GltfMeshes, leaves_out_a_mesh_with_vertices_that_are_not_finite) {
    for (const float bad :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        TriangleFile file = two_meshes();
        std::string corners;
        append_bytes<float>(corners, {0, 0, 0, 1, bad, 0, 0, 1, 0});
        file.primitive(1)["attributes"] = {
            {"POSITION", file.add_accessor(corners, 5126, 3, "VEC3")}};
        const Import import = import_bytes(file.gltf());
        ASSERT_TRUE(import.ok()) << import.error();
        EXPECT_EQ(import.mesh().indices.size(), 3U);
        EXPECT_TRUE(
            contains(import.log, "meshes[1].primitives[0] is left out: its vertex 1 is not finite"))
            << import.log;
    }
}

// FAULTS 29: an ordinary .glb opened white.
TEST(GltfMeshes, shows_colours_of_vertices_whatever_the_material_is_called) {
    for (const bool as_bytes : {true, false}) {
        TriangleFile file;
        std::string colors;
        for (int i = 0; i < 3; ++i) {
            if (as_bytes) append_bytes<std::uint8_t>(colors, {51, 102, 255, 255});
            if (!as_bytes) append_bytes<float>(colors, {0.2F, 0.4F, 1, 1});
        }
        file.attributes()["COLOR_0"] = file.add_accessor(colors, as_bytes ? 5121 : 5126, 3, "VEC4");
        if (as_bytes) file.json["accessors"].back()["normalized"] = true;
        file.json["materials"] = {{{"name", "bark"}}};
        file.primitive()["material"] = 0;
        const Import import = import_bytes(file.gltf());
        ASSERT_TRUE(import.ok()) << import.error();
        EXPECT_NEAR(glm::length(import.mesh().vertices[2].color - Vec3f(0.2F, 0.4F, 1)), 0, 1e-6);
        EXPECT_TRUE(import.materials()[0].vertex_colors);
    }
}

TEST(GltfMeshes, reads_wind_weights_from_an_attribute_of_their_own) {
    TriangleFile file;
    std::string winds;
    append_bytes<float>(winds, {0, 0, 0, 1, 1, 0.5F, 0.2F, 1, 7, -3, NAN, 1});
    file.attributes()["_WIND"] = file.add_accessor(winds, 5126, 3, "VEC4");
    const Import import = import_bytes(file.gltf());
    ASSERT_TRUE(import.ok()) << import.error();
    const std::vector<Vertex>& vertices = import.mesh().vertices;
    EXPECT_EQ(vertices[0].wind, WindWeights{});
    EXPECT_EQ(vertices[1].wind, (WindWeights{.sway = 255, .phase = 128, .flutter = 51}));
    EXPECT_EQ(vertices[2].wind, (WindWeights{.sway = 255})) << "clamped";
    EXPECT_EQ(vertices[1].color, Vec3f(1)) << "they are no colours";
    EXPECT_TRUE(sways(import.mesh()));
}

TEST(GltfMeshes, wind_strips_alike_and_drop_what_is_left_over) {
    const std::vector<std::pair<int, std::vector<std::uint32_t>>> modes{
        {4, {0, 1, 2}},  // two corners of a second triangle
        {5, {0, 1, 2, 2, 1, 3, 2, 3, 4}},
        {6, {0, 1, 2, 0, 2, 3, 0, 3, 4}}};
    for (const auto& [mode, expected] : modes) {
        TriangleFile file;
        std::string corners;
        append_bytes<float>(corners, {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0});
        file.primitive()["mode"] = mode;
        file.primitive().erase("indices");
        file.primitive()["attributes"] = {
            {"POSITION", file.add_accessor(corners, 5126, 5, "VEC3")}};
        const Import import = import_bytes(file.gltf());
        ASSERT_TRUE(import.ok()) << import.error();
        EXPECT_EQ(import.model.value().meshes[0].indices, expected) << "mode " << mode;
    }
}

TEST(GltfMeshes, leave_out_points_lines_and_what_has_no_positions) {
    const auto log_of = [](const auto& spoil) {
        TriangleFile file = two_meshes();
        spoil(file, file.primitive(1));
        const Import import = import_bytes(file.gltf());
        EXPECT_TRUE(import.ok()) << import.error();
        return import.ok() && import.model.value().meshes.size() == 1 ? import.log : "all is shown";
    };
    const std::string left_out = "meshes[1].primitives[0] is left out: ";
    for (const int mode : {0, 1, 2, 3}) {
        const std::string log = log_of([&](auto&, Json& part) { part["mode"] = mode; });
        EXPECT_TRUE(contains(log, left_out + "it holds points or lines")) << log;
    }
    std::string log = log_of([](auto&, Json& part) { part["attributes"].erase("POSITION"); });
    EXPECT_TRUE(contains(log, left_out + "it has no positions")) << log;
    log = log_of([](auto&, Json& part) { part["indices"] = 0; });
    EXPECT_TRUE(contains(log, left_out + "its indices are not whole numbers")) << log;
    log = log_of([](TriangleFile& file, Json& part) {
        file.json["accessors"].push_back(file.json["accessors"][0]);
        file.json["accessors"].back()["type"] = "VEC2";
        part["attributes"]["POSITION"] = file.json["accessors"].size() - 1;
    });
    EXPECT_TRUE(contains(log, "primitives[0].POSITION is left out: VEC2 of component type 5126"))
        << log;
}

TEST(GltfMeshes, refuse_primitives_without_attributes_and_too_many_targets) {
    TriangleFile bare;
    bare.primitive().erase("attributes");
    expect_refused(bare, "meshes[0].primitives[0] has no attributes");
    for (const std::size_t count : {256U, 257U}) {
        TriangleFile file;
        file.primitive()["targets"] = std::vector<Json>(count, Json::object());
        const Import import = import_bytes(file.gltf());
        ASSERT_EQ(import.ok(), count == 256) << import.error();
        if (import.ok()) {
            EXPECT_EQ(import.model.value().meshes[0].targets.size(), count);
            EXPECT_EQ(import.model.value().meshes[0].targets[0].positions.size(), 3U) << "zeros";
        } else {
            expect_refused(import, "primitives[0] has 257 targets; at most 256 are read");
        }
    }
}

TEST(GltfMeshes, make_weights_of_joints_add_up_to_one) {
    TriangleFile file;
    std::string joints;
    std::string weights;
    append_bytes<std::uint8_t>(joints, {1, 2, 0, 0, 1, 2, 0, 0, 1, 2, 0, 0});
    append_bytes<float>(weights, {0.5F, 0.25F, 0, 0.25F, 3, 1, NAN, -1, 0, 0, 0, 0});
    file.attributes()["JOINTS_0"] = file.add_accessor(joints, 5121, 3, "VEC4");
    file.attributes()["WEIGHTS_0"] = file.add_accessor(weights, 5126, 3, "VEC4");
    const Import import = import_bytes(file.gltf());
    ASSERT_TRUE(import.ok()) << import.error();
    const std::vector<JointInfluence>& held = import.model.value().meshes[0].influences;
    ASSERT_EQ(held.size(), 3U);
    EXPECT_EQ(held[0].joints, (std::array<std::uint16_t, 4>{1, 2, 0, 0}));
    EXPECT_EQ(held[0].weights, (std::array<float, 4>{0.5F, 0.25F, 0, 0.25F}));
    EXPECT_EQ(held[1].weights, (std::array<float, 4>{0.5F, 0.5F, 0, 0})) << "clamped to 1 before";
    EXPECT_EQ(held[2].weights, (std::array<float, 4>{}));
}

}  // namespace
}  // namespace plumbline::assets::test
