#include "engine/assets/foreign/model_convert_impl.h"
#include "engine/core/log.h"

#include <assimp/anim.h>
#include <assimp/material.h>
#include <assimp/mesh.h>
#include <assimp/metadata.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace plumbline::assets {
namespace {

constexpr double kUsualTicksPer_s = 25.0;

/// What materials call the image of a texture slot: "image N" for those that the file holds.
std::filesystem::path map_of(const aiScene& scene,
                             const aiMaterial& source,
                             std::initializer_list<aiTextureType> types) {
    for (const aiTextureType type : types) {
        aiString path;
        if (source.GetTexture(type, 0, &path) != aiReturn_SUCCESS || path.length == 0) continue;
        const auto [texture, number] = scene.GetEmbeddedTextureAndIndex(path.C_Str());
        if (texture == nullptr) return path.C_Str();
        // Raw texels are not read: no exporter of ours to be seen writes them.
        if (texture->mHeight == 0) return fmt::format("image {}", number);
    }
    return {};
}

Vec3f color_of(const aiMaterial& source,
               const char* key,
               unsigned type,
               unsigned index,
               const Vec3f& fallback) {
    aiColor4D color;
    if (source.Get(key, type, index, color) != aiReturn_SUCCESS) return fallback;
    const Vec3f rgb{color.r, color.g, color.b};
    return is_finite(rgb) ? glm::max(rgb, Vec3f{0.0F}) : fallback;
}

float number_of(
    const aiMaterial& source, const char* key, unsigned type, unsigned index, float fallback) {
    float value = fallback;
    if (source.Get(key, type, index, value) != aiReturn_SUCCESS) return fallback;
    return std::isfinite(value) ? value : fallback;
}

MaterialData material_of(const aiScene& scene, const aiMaterial& source, unsigned number) {
    aiString name;
    source.Get(AI_MATKEY_NAME, name);
    MaterialData material{.name =
                              name.length > 0 ? name.C_Str() : fmt::format("material.{}", number)};
    material.base_color = color_of(source, AI_MATKEY_COLOR_DIFFUSE, Vec3f{0.8F});
    material.base_color = color_of(source, AI_MATKEY_BASE_COLOR, material.base_color);
    material.emissive = color_of(source, AI_MATKEY_COLOR_EMISSIVE, Vec3f{0.0F});
    material.base_color_map =
        map_of(scene, source, {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE});
    // A map stands in for the colour; tools leave any grey behind it.
    if (!material.base_color_map.empty()) material.base_color = Vec3f{1.0F};
    material.normal_map = map_of(scene, source, {aiTextureType_NORMALS});
    material.emissive_map = map_of(scene, source, {aiTextureType_EMISSIVE});
    if (!material.emissive_map.empty()) material.emissive = Vec3f{1.0F};
    material.alpha = std::clamp(number_of(source, AI_MATKEY_OPACITY, 1.0F), 0.0F, 1.0F);
    // Exporters write 0 where they mean that nothing is transparent.
    if (material.alpha <= 0.0F) material.alpha = 1.0F;
    if (material.alpha < 1.0F) material.alpha_mode = AlphaMode::Blend;
    const float shininess = number_of(source, AI_MATKEY_SHININESS, 0.0F);
    const float rough = shininess > 0.0F ? std::sqrt(2.0F / (shininess + 2.0F)) : 0.8F;
    material.roughness =
        std::clamp(number_of(source, AI_MATKEY_ROUGHNESS_FACTOR, rough), 0.05F, 1.0F);
    material.metallic = std::clamp(number_of(source, AI_MATKEY_METALLIC_FACTOR, 0.0F), 0.0F, 1.0F);
    int two_sided = 0;
    source.Get(AI_MATKEY_TWOSIDED, two_sided);
    material.two_sided = two_sided != 0;
    return material;
}

std::vector<MaterialData> materials_of(const aiScene& scene) {
    std::vector<MaterialData> materials;
    std::set<std::string> names;
    for (unsigned i = 0; i < scene.mNumMaterials; ++i) {
        MaterialData material = material_of(scene, *scene.mMaterials[i], i);
        const std::string plain = material.name;
        for (int suffix = 2; !names.insert(material.name).second; ++suffix) {
            material.name = fmt::format("{}.{}", plain, suffix);
        }
        materials.push_back(std::move(material));
    }
    return materials;
}

void read_images(const aiScene& scene, ModelData& model) {
    for (unsigned i = 0; i < scene.mNumTextures; ++i) {
        const aiTexture& texture = *scene.mTextures[i];
        if (texture.mHeight != 0 || texture.pcData == nullptr) continue;
        const char* bytes = static_cast<const char*>(static_cast<const void*>(texture.pcData));
        model.images.push_back(
            {.name = fmt::format("image {}", i), .bytes = std::string(bytes, texture.mWidth)});
    }
}

/// The node that a bone or channel names.
std::optional<std::uint32_t> node_named(const ConvertedScene& converted,
                                        const aiScene& scene,
                                        const aiString& name) {
    const aiNode* node = scene.mRootNode->FindNode(name);
    const auto place = converted.places.find(node);
    if (place == converted.places.end()) return std::nullopt;
    return place->second;
}

/// Keeps the four joints that weigh most.
void add_influence(JointInfluence& influence, std::uint16_t joint, float weight) {
    const auto least = std::min_element(influence.weights.begin(), influence.weights.end());
    if (!(weight > *least)) return;
    influence.joints[static_cast<std::size_t>(least - influence.weights.begin())] = joint;
    *least = weight;
}

/// Bones of one mesh as a skin; the mesh moves to a node of its own, since a node has one skin.
void read_bones(const aiScene& scene,
                const aiMesh& source,
                std::uint32_t number,
                ConvertedScene& converted) {
    ModelData& model = converted.model;
    ModelMesh& mesh = model.meshes[number];
    ModelSkin skin;
    std::vector<JointInfluence> influences(mesh.vertices.size());
    for (unsigned b = 0; b < source.mNumBones && b < 65'535; ++b) {
        const aiBone& bone = *source.mBones[b];
        const std::optional<std::uint32_t> node = node_named(converted, scene, bone.mName);
        if (!node) continue;
        const auto joint = static_cast<std::uint16_t>(skin.joints.size());
        skin.joints.push_back(*node);
        skin.joint_from_mesh.push_back(matrix_of(bone.mOffsetMatrix));
        for (unsigned w = 0; w < bone.mNumWeights; ++w) {
            const aiVertexWeight& weight = bone.mWeights[w];
            if (weight.mVertexId >= influences.size() || !std::isfinite(weight.mWeight)) continue;
            add_influence(influences[weight.mVertexId], joint, weight.mWeight);
        }
    }
    if (skin.joints.empty()) return;
    for (JointInfluence& influence : influences) {
        float sum = 0.0F;
        for (const float weight : influence.weights) sum += weight;
        for (float& weight : influence.weights) weight = sum > 0.0F ? weight / sum : 0.0F;
    }
    mesh.influences = std::move(influences);
    const auto skin_number = static_cast<std::uint32_t>(model.skins.size());
    model.skins.push_back(std::move(skin));
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        auto& shown = model.nodes[i].meshes;
        const auto place = std::find(shown.begin(), shown.end(), number);
        if (place == shown.end()) continue;
        shown.erase(place);
        ModelNode node{.name = mesh.name,
                       .parent = static_cast<std::uint32_t>(i),
                       .meshes = {number},
                       .skin = skin_number};
        model.nodes.push_back(std::move(node));
        return;
    }
}

/// Keys whose times rise; others are repeats.
template <class Key, class Put>
AnimationChannel channel_of(const Key* keys,
                            unsigned count,
                            double ticks_per_s,
                            std::uint32_t node,
                            ChannelPath path,
                            Put put) {
    AnimationChannel channel{.node = node, .path = path};
    for (unsigned i = 0; i < count; ++i) {
        const auto time_s = static_cast<float>(keys[i].mTime / ticks_per_s);
        const bool rises = channel.times_s.empty() || time_s > channel.times_s.back();
        if (!std::isfinite(time_s) || time_s < 0.0F || !rises) continue;
        channel.times_s.push_back(time_s);
        put(keys[i].mValue, channel.values);
    }
    return channel;
}

ModelAnimation animation_of(const aiScene& scene,
                            const aiAnimation& source,
                            unsigned number,
                            const ConvertedScene& converted) {
    ModelAnimation animation{.name = source.mName.C_Str()};
    if (animation.name.empty()) animation.name = fmt::format("animation {}", number + 1);
    const double ticks = source.mTicksPerSecond > 0.0 ? source.mTicksPerSecond : kUsualTicksPer_s;
    const auto put_vector = [](const aiVector3D& v, std::vector<float>& values) {
        values.insert(values.end(), {v.x, v.y, v.z});
    };
    const auto put_turn = [](const aiQuaternion& q, std::vector<float>& values) {
        values.insert(values.end(), {q.x, q.y, q.z, q.w});
    };
    const auto add = [&](AnimationChannel channel) {
        if (channel.times_s.empty()) return;
        animation.duration_s = std::max(animation.duration_s, channel.times_s.back());
        animation.channels.push_back(std::move(channel));
    };
    for (unsigned i = 0; i < source.mNumChannels; ++i) {
        const aiNodeAnim& track = *source.mChannels[i];
        const std::optional<std::uint32_t> node = node_named(converted, scene, track.mNodeName);
        if (!node) continue;
        add(channel_of(track.mPositionKeys,
                       track.mNumPositionKeys,
                       ticks,
                       *node,
                       ChannelPath::Translation,
                       put_vector));
        add(channel_of(track.mRotationKeys,
                       track.mNumRotationKeys,
                       ticks,
                       *node,
                       ChannelPath::Rotation,
                       put_turn));
        add(channel_of(track.mScalingKeys,
                       track.mNumScalingKeys,
                       ticks,
                       *node,
                       ChannelPath::Scale,
                       put_vector));
    }
    return animation;
}

/// FBX counts in units of so many centimetres, which assimp 5.2 leaves to its callers; Collada's units
/// it applies itself.
float metres_per_unit(const aiScene& scene) {
    double centimetres = 0.0;
    if (scene.mMetaData == nullptr) return 1.0F;
    float single = 0.0F;
    if (scene.mMetaData->Get("UnitScaleFactor", single)) centimetres = static_cast<double>(single);
    scene.mMetaData->Get("UnitScaleFactor", centimetres);
    const bool sane = std::isfinite(centimetres) && centimetres > 1e-6 && centimetres < 1e6;
    return sane ? static_cast<float>(centimetres / 100.0) : 1.0F;
}

/// Puts a node of its own above everything, so that animations of the root keep their meaning.
void scale_whole(ModelData& model, float factor) {
    if (factor == 1.0F) return;
    ModelNode top{.name = "metres", .parent_from_node = glm::scale(Mat4f{1.0F}, Vec3f{factor})};
    top.rest.scale = Vec3f{factor};
    for (ModelNode& node : model.nodes) node.parent = node.parent ? *node.parent + 1 : 0U;
    for (ModelSkin& skin : model.skins) {
        for (std::uint32_t& joint : skin.joints) ++joint;
    }
    for (ModelAnimation& animation : model.animations) {
        for (AnimationChannel& channel : animation.channels) ++channel.node;
    }
    model.nodes.insert(model.nodes.begin(), std::move(top));
}

}  // namespace

ModelData convert_foreign_scene(const aiScene& scene, const std::string& name) {
    ConvertedScene converted = convert_tree(scene, materials_of(scene), name);
    ModelData& model = converted.model;
    read_images(scene, model);
    for (unsigned i = 0; i < scene.mNumMeshes; ++i) {
        const std::optional<std::uint32_t> number = converted.meshes[i];
        if (number && scene.mMeshes[i]->HasBones()) {
            read_bones(scene, *scene.mMeshes[i], *number, converted);
        }
    }
    for (unsigned i = 0; i < scene.mNumAnimations; ++i) {
        ModelAnimation animation = animation_of(scene, *scene.mAnimations[i], i, converted);
        if (!animation.channels.empty()) model.animations.push_back(std::move(animation));
    }
    scale_whole(model, metres_per_unit(scene));
    return model;
}

}  // namespace plumbline::assets
