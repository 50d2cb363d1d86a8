// Posed models as one mesh: transforms, normals, bones and targets.
#include "engine/assets/model/model_pose.h"
#include "tests/engine/assets/animation_files.h"

#include <limits>

namespace plumbline::assets::test {
namespace {

TEST(ModelMerge, turns_normals_by_the_inverse_transpose) {
    TriangleFile file;
    file.bytes.replace(36, 36, std::string(36, '\0'));
    std::string normals;
    const float part = std::sqrt(0.5F);
    for (int i = 0; i < 3; ++i) append_bytes<float>(normals, {part, 0, part});
    file.bytes.replace(36, 36, normals);
    file.json["nodes"][0]["scale"] = {2, 1, 1};
    const Import import = import_bytes(file.gltf());
    ASSERT_TRUE(import.ok());
    const Vec3f expected = glm::normalize(Vec3f{0.5F, 0, 1});
    EXPECT_NEAR(glm::length(import.mesh().vertices[0].normal_body - expected), 0, 1e-6);
}

TEST(ModelMerge, keeps_triangles_facing_outwards_when_a_node_mirrors) {
    TriangleFile file;
    file.json["nodes"][0]["scale"] = {-1, 1, 1};
    const Import import = import_bytes(file.gltf());
    ASSERT_TRUE(import.ok());
    const auto& v = import.mesh().vertices;
    const auto& i = import.mesh().indices;
    const Vec3f face = glm::cross(v[i[1]].position_body - v[i[0]].position_body,
                                  v[i[2]].position_body - v[i[0]].position_body);
    EXPECT_EQ(face, Vec3f(0, 0, 1));
    EXPECT_EQ(v[0].normal_body, Vec3f(0, 0, 1));
}

TEST(ModelMerge, merges_every_instance_of_a_mesh) {
    TriangleFile file;
    file.json["nodes"] = {{{"mesh", 0}}, {{"mesh", 0}, {"translation", {0, 0, 5}}}};
    file.json["scenes"][0]["nodes"] = {0, 1};
    const Import import = import_bytes(file.gltf());
    ASSERT_TRUE(import.ok());
    EXPECT_EQ(import.mesh().vertices.size(), 6U);
    EXPECT_EQ(import.mesh().sub_meshes.size(), 1U);
    EXPECT_EQ(import.mesh().sub_meshes[0].index_count, 6U);
    EXPECT_EQ(import.mesh().bounds.max.z, 5.0F);
}

TEST(ModelMerge, gives_flat_normals_to_a_file_without_any) {
    TriangleFile file;
    // Two triangles at a right angle that share an edge: four corners, six vertices when flat.
    std::string corners;
    append_bytes<float>(corners, {0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0});
    std::string indices;
    append_bytes<std::uint16_t>(indices, {0, 1, 2, 0, 3, 1});
    file.primitive()["attributes"] = {{"POSITION", file.add_accessor(corners, 5126, 4, "VEC3")}};
    file.primitive()["indices"] = file.add_accessor(indices, 5123, 6, "SCALAR");
    const Import import = import_bytes(file.gltf());
    ASSERT_TRUE(import.ok()) << import.error();
    ASSERT_EQ(import.mesh().vertices.size(), 6U);
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_EQ(import.mesh().vertices[import.mesh().indices[i]].normal_body,
                  i < 3 ? Vec3f(0, 1, 0) : Vec3f(1, 0, 0));
    }
}

TEST(ModelMerge, mends_single_normals_that_are_zero_or_not_finite) {
    TriangleFile file;
    std::string normals;
    append_bytes<float>(normals, {0, 0, 0, 0, 1, 0, std::numeric_limits<float>::quiet_NaN(), 0, 0});
    file.bytes.replace(36, 36, normals);
    const Import import = import_bytes(file.gltf());
    ASSERT_TRUE(import.ok());
    EXPECT_EQ(import.mesh().vertices[0].normal_body, Vec3f(0, 0, 1));  // the triangle's
    EXPECT_EQ(import.mesh().vertices[1].normal_body, Vec3f(0, 1, 0));  // the file's
    EXPECT_EQ(import.mesh().vertices[2].normal_body, Vec3f(0, 0, 1));
}

TEST(ModelMerge, leaves_out_a_mesh_beyond_the_largest_position) {
    for (const double x : {99'998.0, 100'001.0}) {
        TriangleFile file = two_meshes();
        file.json["nodes"][1]["translation"] = {x, 0, 0};
        const Import import = import_bytes(file.gltf());
        ASSERT_TRUE(import.ok()) << import.error();
        EXPECT_EQ(import.mesh().indices.size(), x < 1e5 ? 6U : 3U);
    }
}

TEST(ModelMerge, drops_faces_without_area_and_counts_them) {
    TriangleFile file;
    std::string indices;
    append_bytes<std::uint16_t>(indices, {0, 1, 2, 0, 0, 1, 1, 2, 2});
    file.primitive()["indices"] = file.add_accessor(indices, 5123, 9, "SCALAR");
    const Import import = import_bytes(file.gltf());
    ASSERT_TRUE(import.ok());
    EXPECT_EQ(import.mesh().indices.size(), 3U);
    EXPECT_TRUE(contains(import.log, "2 faces without area are left out")) << import.log;
}

/// The one part that moves, as the first animation has it at that time.
MeshData deformed_at(const ModelData& model, float time_s) {
    const ModelParts parts = parts_of(model);
    EXPECT_EQ(parts.moving.size(), 1U);
    EXPECT_TRUE(parts.moving.at(0).deforms);
    MeshData mesh = part_mesh(model, parts.moving.at(0), rest_pose(model));
    deform(model, parts.moving.at(0), pose_at(model, model.animations.at(0), time_s), mesh);
    return mesh;
}

TEST(ModelMerge, carries_vertices_by_the_mean_of_their_bones_and_not_by_the_node) {
    const Import import = import_bytes(skinned().gltf());
    ASSERT_TRUE(import.ok()) << import.error();
    // At rest the bones undo their inverse bind matrices: the triangle as it was made.
    EXPECT_EQ(import.mesh().vertices[1].position_body, Vec3f(1, 0, 0));
    const MeshData mesh = deformed_at(import.model.value(), 0.5F);
    expect_near(mesh.vertices[0].position_body, {0, 0, 0});
    expect_near(mesh.vertices[1].position_body, {1, 2, 0});
    expect_near(mesh.vertices[2].position_body, {0, 2, 0});
    expect_near(mesh.bounds.max, {1, 2, 0});
}

TEST(ModelMerge, ignores_joints_that_its_skin_lacks) {
    TriangleFile file = skinned();
    std::string joints;
    append_bytes<std::uint8_t>(joints, {0, 0, 0, 0, 1, 0, 0, 0, 0, 9, 0, 0});
    file.attributes()["JOINTS_0"] = file.add_accessor(joints, 5121, 3, "VEC4");
    const Import import = import_bytes(file.gltf());
    ASSERT_TRUE(import.ok()) << import.error();
    expect_near(import.mesh().vertices[2].position_body, {0, 1, 0});
}

TEST(ModelMerge, adds_targets_by_their_weights) {
    TriangleFile file;
    std::string offsets;
    append_bytes<float>(offsets, {0, 0, 0, 0, 0, 4, 0, 0, 0});
    file.primitive()["targets"] = {{{"POSITION", file.add_accessor(offsets, 5126, 3, "VEC3")}}};
    file.json["meshes"][0]["weights"] = {0.25};
    file.json["animations"] = Json::array({Json::object()});
    add_channel(file, add_sampler(file, {0, 2}, {0, 1}, "SCALAR"), 0, "weights");
    const Import import = import_bytes(file.gltf());
    ASSERT_TRUE(import.ok()) << import.error();
    EXPECT_EQ(import.mesh().vertices[1].position_body, Vec3f(1, 0, 1));
    const MeshData mesh = deformed_at(import.model.value(), 1.5F);
    expect_near(mesh.vertices[1].position_body, {1, 0, 3});
}

}  // namespace
}  // namespace plumbline::assets::test
