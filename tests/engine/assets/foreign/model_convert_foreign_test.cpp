// What assimp reads of Collada and FBX files as materials, bones, keys and metres.
#include "engine/assets/foreign/foreign_import.h"
#include "engine/assets/foreign/model_convert_impl.h"
#include "engine/assets/model/model_pose.h"
#include "tests/engine/assets/foreign/collada.h"
#include "tests/engine/assets/foreign/foreign_scenes.h"

#include <assimp/anim.h>
#include <assimp/material.h>
#include <assimp/metadata.h>

namespace plumbline::assets::test {
namespace {

TEST(ModelConvertForeign, takes_units_up_axis_names_and_materials_from_a_collada_file) {
    const Result<ModelData> model = read_foreign(kCollada, "m.dae");
    ASSERT_TRUE(model.ok()) << model.error().message;
    ASSERT_EQ(model->meshes.size(), 1U);
    EXPECT_EQ(model->meshes[0].vertices.size(), 3U);
    EXPECT_NEAR(model->materials[model->meshes[0].material].base_color.x, 0.5, 1e-6);
    const MeshData mesh = merged_mesh(*model, rest_pose(*model), "m.dae");
    // Centimetres, z up: 1 m wide, 2 m high.
    EXPECT_NEAR(glm::length(mesh.bounds.max - Vec3f(1, 2, 0)), 0, 1e-4)
        << mesh.bounds.max.x << ' ' << mesh.bounds.max.y << ' ' << mesh.bounds.max.z;
}

/// The scene's materials are these; it deletes them.
void wear(aiScene& scene, std::initializer_list<aiMaterial*> materials) {
    scene.mNumMaterials = static_cast<unsigned>(materials.size());
    scene.mMaterials = new aiMaterial*[materials.size()];
    std::copy(materials.begin(), materials.end(), scene.mMaterials);
}

TEST(ModelConvertForeign, reads_factors_of_materials_and_keeps_their_names_apart) {
    const auto scene = foreign_scene({foreign_mesh("a", 0)});
    auto* full = new aiMaterial;
    const aiString name("paint");
    const aiColor4D red(1, -1, 0.5F, 1);
    const float opacity = 0.25F;
    const float shininess = 6.0F;
    const int two_sided = 1;
    full->AddProperty(&name, AI_MATKEY_NAME);
    full->AddProperty(&red, 1, AI_MATKEY_COLOR_DIFFUSE);
    full->AddProperty(&opacity, 1, AI_MATKEY_OPACITY);
    full->AddProperty(&shininess, 1, AI_MATKEY_SHININESS);
    full->AddProperty(&two_sided, 1, AI_MATKEY_TWOSIDED);
    auto* again = new aiMaterial;
    const float none = 0.0F;
    const aiString map("wood.png");
    again->AddProperty(&name, AI_MATKEY_NAME);
    again->AddProperty(&none, 1, AI_MATKEY_OPACITY);
    again->AddProperty(&red, 1, AI_MATKEY_COLOR_DIFFUSE);
    again->AddProperty(&map, AI_MATKEY_TEXTURE(aiTextureType_DIFFUSE, 0));
    wear(*scene, {full, again, new aiMaterial});
    const std::vector<MaterialData> found = convert_foreign_scene(*scene, "m.fbx").materials;
    ASSERT_EQ(found.size(), 3U);
    EXPECT_EQ(found[0].name, "paint");
    EXPECT_EQ(found[0].base_color, Vec3f(1, 0, 0.5F));
    EXPECT_EQ(found[0].alpha, 0.25F);
    EXPECT_EQ(found[0].alpha_mode, AlphaMode::Blend);
    EXPECT_EQ(found[0].roughness, 0.5F) << "the root of 2 / (6 + 2)";
    EXPECT_TRUE(found[0].two_sided);
    EXPECT_EQ(found[1].name, "paint.2");
    EXPECT_EQ(found[1].alpha, 1.0F) << "0 means that nothing is transparent";
    EXPECT_EQ(found[1].alpha_mode, AlphaMode::Opaque);
    EXPECT_EQ(found[1].base_color_map, "wood.png");
    EXPECT_EQ(found[1].base_color, Vec3f(1)) << "the map stands in for it";
    EXPECT_EQ(found[2].name, "material.2");
    EXPECT_EQ(found[2].base_color, Vec3f(0.8F));
    EXPECT_EQ(found[2].roughness, 0.8F);
}

TEST(ModelConvertForeign, keeps_the_four_joints_that_weigh_most) {
    aiMesh* mesh = foreign_mesh("held", 0);
    mesh->mNumBones = 6;
    mesh->mBones = new aiBone*[6];
    constexpr std::array<float, 6> kWeights{0.1F, 0.5F, 0.25F, 0.2F, 0.3F, 0.9F};
    for (unsigned i = 0; i < 6; ++i) {
        mesh->mBones[i] = new aiBone;
        mesh->mBones[i]->mName = i == 5 ? "absent" : "first";
        mesh->mBones[i]->mNumWeights = 2;
        mesh->mBones[i]->mWeights = new aiVertexWeight[2]{{1, kWeights[i]}, {7, 1.0F}};
    }
    const auto scene = foreign_scene({mesh});
    const ModelData model = convert_foreign_scene(*scene, "m.fbx");
    ASSERT_EQ(model.skins.size(), 1U);
    EXPECT_EQ(model.skins[0].joints, std::vector<std::uint32_t>(5, 1)) << "node \"first\"";
    const JointInfluence& held = model.meshes[0].influences.at(1);
    // The bone of 0.1 gave its place to that of 0.3; what stays adds up to 1.25.
    EXPECT_EQ(held.joints, (std::array<std::uint16_t, 4>{4, 1, 2, 3}));
    for (std::size_t k = 0; k < 4; ++k)
        EXPECT_FLOAT_EQ(held.weights[k], (std::array{0.3F, 0.5F, 0.25F, 0.2F}[k]) / 1.25F);
    EXPECT_EQ(model.meshes[0].influences[0].weights, (std::array<float, 4>{}));
    // The mesh hangs on a node of its own below the one that showed it.
    ASSERT_EQ(model.nodes.size(), 4U);
    EXPECT_TRUE(model.nodes[2].meshes.empty());
    EXPECT_EQ(model.nodes[3].parent, 2U);
    EXPECT_EQ(model.nodes[3].skin, 0U);
    EXPECT_EQ(model.nodes[3].meshes, std::vector<std::uint32_t>{0});
}

TEST(ModelConvertForeign, reads_keys_whose_times_rise_in_seconds) {
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
    const ModelData model = convert_foreign_scene(*scene, "m.fbx");
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

TEST(ModelConvertForeign, puts_centimetres_below_a_node_of_a_hundredth) {
    for (const double unit_cm : {1.0, 100.0, 0.0, 1e9}) {
        const auto scene = foreign_scene({foreign_mesh("a", 0)});
        scene->mMetaData = aiMetadata::Alloc(1);
        scene->mMetaData->Set(0, "UnitScaleFactor", unit_cm);
        const ModelData model = convert_foreign_scene(*scene, "m.fbx");
        if (unit_cm != 1.0) {
            EXPECT_EQ(model.nodes.size(), 3U) << unit_cm << ": metres, or no sane unit";
            continue;
        }
        ASSERT_EQ(model.nodes.size(), 4U);
        EXPECT_EQ(model.nodes[0].name, "metres");
        EXPECT_EQ(model.nodes[0].rest.scale, Vec3f(0.01F));
        EXPECT_EQ(model.nodes[1].parent, 0U);
        EXPECT_EQ(model.nodes[3].parent, 1U);
        EXPECT_EQ(model.nodes[3].meshes, std::vector<std::uint32_t>{0});
    }
}

}  // namespace
}  // namespace plumbline::assets::test
