// What assimp reads of Collada and FBX files, as our reader of glTF finds it again.
#include "engine/assets/foreign/model_export_impl.h"
#include "engine/assets/model/model_pose.h"
#include "engine/assets/model/model_readers_impl.h"
#include "tests/engine/assets/foreign/collada.h"
#include "tests/engine/assets/foreign/foreign_scenes.h"

#include <assimp/anim.h>
#include <assimp/material.h>
#include <assimp/texture.h>

#include <limits>

namespace plumbline::assets::test {
namespace {

ModelData model_of(const Result<std::string>& glb, const TempFolder& folder = {}) {
    EXPECT_TRUE(glb.ok()) << glb.error().message;
    ModelReferences references(folder.path() / "m.fbx", folder.path());
    references.expect_paths_of_another_machine();
    Result<ModelData> model = read_gltf(*glb, "m.fbx", references);
    EXPECT_TRUE(model.ok()) << model.error().message;
    return model.ok() ? std::move(*model) : ModelData{};
}

TEST(ModelExport, takes_units_up_axis_names_and_materials_from_a_collada_file) {
    const ModelData model = model_of(glb_of_foreign_model(kCollada, "m.dae"));
    ASSERT_EQ(model.meshes.size(), 1U);
    EXPECT_EQ(model.meshes[0].vertices.size(), 3U);
    EXPECT_EQ(model.materials[model.meshes[0].material].name, "red");
    EXPECT_NEAR(model.materials[model.meshes[0].material].base_color.x, 0.5, 1e-6);
    const MeshData mesh = merged_mesh(model, rest_pose(model), "m.dae");
    // Centimetres, z up: 1 m wide, 2 m high.
    EXPECT_NEAR(glm::length(mesh.bounds.max - Vec3f(1, 2, 0)), 0, 1e-4)
        << mesh.bounds.max.x << ' ' << mesh.bounds.max.y << ' ' << mesh.bounds.max.z;
}

TEST(ModelExport, keeps_the_tree_with_places_and_lets_v_run_down) {
    const auto scene = foreign_scene({foreign_mesh("plate", 0)});
    const ModelData model = model_of(glb_of_scene(*scene, "m.fbx"));
    ASSERT_EQ(model.nodes.size(), 3U);
    EXPECT_EQ(model.nodes[0].name, "root");
    EXPECT_EQ(model.nodes[1].name, "first");
    EXPECT_EQ(model.nodes[2].name, "second");
    EXPECT_EQ(model.nodes[2].parent, 0U);
    EXPECT_EQ(model.nodes[2].meshes, std::vector<std::uint32_t>{0});
    EXPECT_EQ(Vec3f{model.nodes[2].parent_from_node[3]}, Vec3f(5, 6, 7));
    EXPECT_EQ(Vec3f{model.nodes[2].parent_from_node[1]}, Vec3f(0, 2, 0));
    ASSERT_EQ(model.meshes.size(), 1U);
    EXPECT_EQ(model.meshes[0].vertices[0].uv, Vec2f(0.25F, 0.75F));
    EXPECT_EQ(model.meshes[0].vertices[1].uv, Vec2f(0, 0)) << "not finite";
    EXPECT_EQ(model.meshes[0].vertices[0].normal_body, Vec3f(0)) << "to be made";
    EXPECT_FALSE(model.materials[0].vertex_colors);
}

TEST(ModelExport, leaves_out_meshes_with_places_that_are_nowhere) {
    aiMesh* nan = foreign_mesh("nan", 0);
    nan->mVertices[1].x = std::numeric_limits<float>::quiet_NaN();
    aiMesh* infinite = foreign_mesh("infinite", 0);
    infinite->mVertices[0].z = std::numeric_limits<float>::infinity();
    const auto scene = foreign_scene({nan, infinite, foreign_mesh("good", 0)});
    ::testing::internal::CaptureStderr();
    const ModelData model = model_of(glb_of_scene(*scene, "m.fbx"));
    const std::string log = ::testing::internal::GetCapturedStderr();
    EXPECT_TRUE(contains(log, "is left out: its vertex 1 is not finite")) << log;
    EXPECT_TRUE(contains(log, "is left out: its vertex 0 is not finite")) << log;
    ASSERT_EQ(model.meshes.size(), 1U);
}

/// The scene's materials are these; it deletes them.
void wear(aiScene& scene, std::initializer_list<aiMaterial*> materials) {
    for (unsigned i = 0; i < scene.mNumMaterials; ++i) delete scene.mMaterials[i];
    delete[] scene.mMaterials;
    scene.mNumMaterials = static_cast<unsigned>(materials.size());
    scene.mMaterials = new aiMaterial*[materials.size()];
    std::copy(materials.begin(), materials.end(), scene.mMaterials);
}

TEST(ModelExport, reads_factors_of_materials_and_keeps_their_names_apart) {
    const auto scene =
        foreign_scene({foreign_mesh("a", 0), foreign_mesh("b", 1), foreign_mesh("c", 2)});
    auto* full = new aiMaterial;
    const aiString name("paint");
    const aiColor4D red(1, -1, 0.5F, 1);
    const float opacity = 0.25F;
    const float shininess = 6.0F;
    const int two_sided = 1;
    full->AddProperty(&name, AI_MATKEY_NAME);
    full->AddProperty(&red, 1, AI_MATKEY_COLOR_DIFFUSE);
    full->AddProperty(&red, 1, AI_MATKEY_COLOR_SPECULAR);
    full->AddProperty(&opacity, 1, AI_MATKEY_OPACITY);
    full->AddProperty(&shininess, 1, AI_MATKEY_SHININESS);
    full->AddProperty(&two_sided, 1, AI_MATKEY_TWOSIDED);
    auto* again = new aiMaterial;
    const float none = 0.0F;
    // As a tool on another machine wrote it; the image lies beside the model.
    const aiString map("C:\\work\\50% w\xc3\xb6od.png");
    again->AddProperty(&name, AI_MATKEY_NAME);
    again->AddProperty(&none, 1, AI_MATKEY_OPACITY);
    again->AddProperty(&red, 1, AI_MATKEY_COLOR_DIFFUSE);
    again->AddProperty(&map, AI_MATKEY_TEXTURE(aiTextureType_DIFFUSE, 0));
    wear(*scene, {full, again, new aiMaterial});
    const TempFolder folder;
    folder.write("textures/50% w\xc3\xb6od.png", "x");
    const std::vector<MaterialData> found =
        model_of(glb_of_scene(*scene, "m.fbx"), folder).materials;
    ASSERT_EQ(found.size(), 3U);
    EXPECT_EQ(found[0].name, "paint");
    EXPECT_EQ(found[0].base_color, Vec3f(1, 0, 0.5F));
    EXPECT_EQ(found[0].alpha, 0.25F);
    EXPECT_EQ(found[0].alpha_mode, AlphaMode::Blend);
    EXPECT_EQ(found[0].roughness, 0.5F) << "the root of 2 / (6 + 2)";
    EXPECT_EQ(found[0].metallic, 0.0F);
    EXPECT_TRUE(found[0].two_sided);
    EXPECT_EQ(found[1].name, "paint.2");
    EXPECT_EQ(found[1].alpha, 1.0F) << "0 means that nothing is transparent";
    EXPECT_EQ(found[1].alpha_mode, AlphaMode::Opaque);
    EXPECT_EQ(found[1].base_color_map, folder.path() / "textures/50% w\xc3\xb6od.png");
    EXPECT_EQ(found[1].base_color, Vec3f(1)) << "the map stands in for it";
    EXPECT_EQ(found[2].name, "material.2");
    EXPECT_EQ(found[2].base_color, Vec3f(0.8F));
    EXPECT_EQ(found[2].roughness, 0.8F);
}

TEST(ModelExport, hands_over_images_that_the_file_holds_and_tells_of_those_that_are_nowhere) {
    const auto scene = foreign_scene({foreign_mesh("a", 0), foreign_mesh("b", 1)});
    auto* texture = new aiTexture;
    texture->mFilename = aiString("wood\xff.png");
    texture->mWidth = 8;
    texture->pcData = new aiTexel[2];
    std::memcpy(texture->pcData, "12345678", 8);
    std::memcpy(texture->achFormatHint, "png", 4);
    scene->mNumTextures = 1;
    scene->mTextures = new aiTexture* [1] { texture };
    auto* inside = new aiMaterial;
    const aiString map("*0");
    inside->AddProperty(&map, AI_MATKEY_TEXTURE(aiTextureType_DIFFUSE, 0));
    auto* absent = new aiMaterial;
    const aiString nowhere("file:///elsewhere/none.png");
    absent->AddProperty(&nowhere, AI_MATKEY_TEXTURE(aiTextureType_DIFFUSE, 0));
    wear(*scene, {inside, absent});
    ::testing::internal::CaptureStderr();
    const ModelData model = model_of(glb_of_scene(*scene, "m.fbx"));
    const std::string log = ::testing::internal::GetCapturedStderr();
    ASSERT_EQ(model.images.size(), 1U);
    EXPECT_EQ(model.images[0].bytes, "12345678");
    EXPECT_EQ(model.materials[0].base_color_map, model.images[0].name);
    EXPECT_TRUE(model.materials[1].base_color_map.empty());
    EXPECT_TRUE(contains(log, "model m.fbx: its image \"none.png\" is not beside it")) << log;
}

void hold(aiMesh& mesh, std::initializer_list<std::pair<const char*, aiMatrix4x4>> bones) {
    mesh.mBones = new aiBone*[bones.size()];
    for (const auto& [name, offset] : bones) {
        auto* bone = new aiBone;
        bone->mName = name;
        bone->mOffsetMatrix = offset;
        bone->mNumWeights = 3;
        const float weight = 1.0F / static_cast<float>(bones.size());
        bone->mWeights = new aiVertexWeight[3]{{0, weight}, {1, weight}, {2, weight}};
        mesh.mBones[mesh.mNumBones++] = bone;
    }
}

// Two meshes made at different places hang on the same bone: both stand where each alone would.
TEST(ModelExport, keeps_each_meshs_place_on_bones_that_it_shares) {
    const auto moved = [](float x, float y) {
        aiMatrix4x4 matrix;
        matrix.a4 = x;
        matrix.b4 = y;
        return matrix;
    };
    aiMesh* near = foreign_mesh("near", 0);
    aiMesh* far = foreign_mesh("far", 0);
    hold(*near, {{"first", moved(0, 0)}, {"second", moved(-5, 0)}});
    hold(*far, {{"second", moved(5, 10)}, {"first", moved(10, 10)}});
    const auto scene = foreign_scene({near, far});
    const ModelData model = model_of(glb_of_scene(*scene, "m.fbx"));
    ASSERT_EQ(model.skins.size(), 1U);
    ASSERT_EQ(model.meshes.size(), 2U);
    const MeshData mesh = merged_mesh(model, rest_pose(model), "m.fbx");
    // "first" stands at the origin; "second" at (5, 6, 7), twice as high: a vertex at (x, y) comes half
    // from (x, y, 0) and half from (x - 5 + 5, 2 y + 6, 7); the far mesh's are moved by (10, 10) before.
    ASSERT_EQ(mesh.vertices.size(), 6U);
    EXPECT_NEAR(glm::distance(mesh.vertices[0].position_body, Vec3f(0, 3, 3.5F)), 0, 1e-5);
    EXPECT_NEAR(glm::distance(mesh.vertices[2].position_body, Vec3f(0, 4.5F, 3.5F)), 0, 1e-5);
    EXPECT_NEAR(glm::distance(mesh.vertices[3].position_body, Vec3f(10, 18, 3.5F)), 0, 1e-5);
}

TEST(ModelExport, reads_keys_whose_times_rise_in_seconds) {
    const auto scene = foreign_scene({foreign_mesh("a", 0)});
    auto* track = new aiNodeAnim;
    track->mNodeName = "second";
    track->mNumPositionKeys = 4;
    track->mPositionKeys =
        new aiVectorKey[4]{{-1, {9, 9, 9}}, {0, {1, 2, 3}}, {0, {9, 9, 9}}, {50, {4, 5, 6}}};
    auto* stray = new aiNodeAnim;
    stray->mNodeName = "absent";
    auto* animation = new aiAnimation;
    animation->mTicksPerSecond = 0;  // unknown: 25
    animation->mNumChannels = 2;
    animation->mChannels = new aiNodeAnim* [2] { track, stray };
    scene->mNumAnimations = 1;
    scene->mAnimations = new aiAnimation* [1] { animation };
    const ModelData model = model_of(glb_of_scene(*scene, "m.fbx"));
    ASSERT_EQ(model.animations.size(), 1U);
    EXPECT_EQ(model.animations[0].name, "animation 1");
    EXPECT_EQ(model.animations[0].duration_s, 2.0F);
    ASSERT_EQ(model.animations[0].channels.size(), 1U);
    const AnimationChannel& channel = model.animations[0].channels[0];
    EXPECT_EQ(channel.node, 2U);
    EXPECT_EQ(channel.path, ChannelPath::Translation);
    EXPECT_EQ(channel.times_s, (std::vector<float>{0, 2}));
    EXPECT_EQ(channel.values, (std::vector<float>{1, 2, 3, 4, 5, 6}));
}

TEST(ModelExport, takes_names_of_any_bytes) {
    const auto scene = foreign_scene({foreign_mesh("m\xff", 0)});
    scene->mRootNode->mChildren[0]->mName = "a\x01\xe4";
    const ModelData model = model_of(glb_of_scene(*scene, "m.fbx"));
    ASSERT_EQ(model.nodes.size(), 3U);
    EXPECT_EQ(model.nodes[1].name, "a\\x01\\xe4");
}

TEST(ModelExport, knows_collada_and_fbx_by_their_content) {
    EXPECT_EQ(foreign_model_fault(kCollada), "");
    EXPECT_EQ(foreign_model_fault("Kaydara FBX Binary  "), "");
    EXPECT_EQ(foreign_model_fault("; FBX 7.4\nFBXHeaderExtension:  {"), "");
    EXPECT_EQ(foreign_model_fault("solid x"), "its content is neither Collada nor FBX");
}

}  // namespace
}  // namespace plumbline::assets::test
