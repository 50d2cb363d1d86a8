#include "engine/assets/foreign/confined_io_impl.h"
#include "engine/assets/foreign/model_export_impl.h"
#include "engine/assets/model/model_readers_impl.h"
#include "engine/core/math.h"
#include "engine/core/text/printable.h"

#include <assimp/Exporter.hpp>
#include <assimp/GltfMaterial.h>
#include <assimp/Importer.hpp>
#include <assimp/anim.h>
#include <assimp/config.h>
#include <assimp/material.h>
#include <assimp/mesh.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <map>
#include <memory>
#include <new>
#include <span>
#include <utility>

namespace plumbline::assets {
namespace {

constexpr double kUsualTicksPer_s = 25.0;

enum class ForeignKind { None, Collada, Fbx };

/// By content, not by name.
ForeignKind kind_of(std::string_view bytes) {
    if (bytes.starts_with("Kaydara FBX Binary")) return ForeignKind::Fbx;
    std::string head(bytes.substr(0, 4'096));
    std::erase(head, '\0');  // UTF-16
    if (head.find("<COLLADA") != std::string::npos) return ForeignKind::Collada;
    return head.find("FBXHeaderExtension") != std::string::npos ? ForeignKind::Fbx
                                                                : ForeignKind::None;
}

/// Without blanks at the beginning of an element, where assimp 5.2 expects a number at once.
std::string tightened(std::string_view xml) {
    std::string text;
    text.reserve(xml.size());
    bool begins = false;
    for (const char letter : xml) {
        const bool is_blank = letter == ' ' || letter == '\t' || letter == '\r' || letter == '\n';
        if (begins && is_blank) continue;
        begins = letter == '>';
        text += letter;
    }
    return text;
}

/// As an image's URI: everything but plain letters, digits and what separates folders is escaped.
aiString uri_of(std::string_view path) {
    std::string uri;
    for (const char letter : path) {
        const bool is_plain = (letter >= 'a' && letter <= 'z') ||
                              (letter >= 'A' && letter <= 'Z') ||
                              (letter >= '0' && letter <= '9') ||
                              std::string_view("-._~/").find(letter) != std::string_view::npos;
        if (is_plain)
            uri += letter;
        else
            uri += fmt::format("%{:02X}", static_cast<unsigned char>(letter));
    }
    return aiString(uri);
}

/// The image of a texture slot as the exporter looks for it; empty without one.
aiString map_of(const aiScene& scene,
                const aiMaterial& source,
                std::initializer_list<aiTextureType> types) {
    for (const aiTextureType type : types) {
        aiString path;
        if (source.GetTexture(type, 0, &path) != aiReturn_SUCCESS || path.length == 0) continue;
        const auto [texture, number] = scene.GetEmbeddedTextureAndIndex(path.C_Str());
        if (texture == nullptr) return uri_of(path.C_Str());
        // Raw texels are not read: no exporter of ours to be seen writes them.
        if (texture->mHeight == 0) return aiString(fmt::format("*{}", number));
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

/// Leaves what our materials know, under the names that the exporter takes from a material.
void prepare_material(const aiScene& scene, unsigned number) {
    aiMaterial& material = *scene.mMaterials[number];
    aiString name;
    material.Get(AI_MATKEY_NAME, name);
    name = aiString(name.length > 0 ? printable(name.C_Str()) : fmt::format("material.{}", number));
    const aiString base_map =
        map_of(scene, material, {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE});
    const aiString normal_map = map_of(scene, material, {aiTextureType_NORMALS});
    const aiString emissive_map = map_of(scene, material, {aiTextureType_EMISSIVE});
    Vec3f base = color_of(material, AI_MATKEY_COLOR_DIFFUSE, Vec3f{0.8F});
    base = color_of(material, AI_MATKEY_BASE_COLOR, base);
    Vec3f emissive = color_of(material, AI_MATKEY_COLOR_EMISSIVE, Vec3f{0.0F});
    // A map stands in for the colour; tools leave any grey behind it.
    if (base_map.length > 0) base = Vec3f{1.0F};
    if (emissive_map.length > 0) emissive = Vec3f{1.0F};
    float alpha = std::clamp(number_of(material, AI_MATKEY_OPACITY, 1.0F), 0.0F, 1.0F);
    // Exporters write 0 where they mean that nothing is transparent.
    if (alpha <= 0.0F) alpha = 1.0F;
    const float shininess = number_of(material, AI_MATKEY_SHININESS, 0.0F);
    float rough = shininess > 0.0F ? std::sqrt(2.0F / (shininess + 2.0F)) : 0.8F;
    rough = std::clamp(number_of(material, AI_MATKEY_ROUGHNESS_FACTOR, rough), 0.05F, 1.0F);
    const float metallic =
        std::clamp(number_of(material, AI_MATKEY_METALLIC_FACTOR, 0.0F), 0.0F, 1.0F);
    int two_sided = 0;
    material.Get(AI_MATKEY_TWOSIDED, two_sided);

    material.Clear();
    const aiColor4D base_color(base.x, base.y, base.z, alpha);
    const aiColor4D emissive_color(emissive.x, emissive.y, emissive.z, 1.0F);
    material.AddProperty(&name, AI_MATKEY_NAME);
    material.AddProperty(&base_color, 1, AI_MATKEY_BASE_COLOR);
    material.AddProperty(&emissive_color, 1, AI_MATKEY_COLOR_EMISSIVE);
    material.AddProperty(&rough, 1, AI_MATKEY_ROUGHNESS_FACTOR);
    material.AddProperty(&metallic, 1, AI_MATKEY_METALLIC_FACTOR);
    material.AddProperty(&two_sided, 1, AI_MATKEY_TWOSIDED);
    const aiString mode(alpha < 1.0F ? "BLEND" : "OPAQUE");
    material.AddProperty(&mode, AI_MATKEY_GLTF_ALPHAMODE);
    const auto add_map = [&](const aiString& map, aiTextureType type) {
        if (map.length > 0) material.AddProperty(&map, AI_MATKEY_TEXTURE(type, 0));
    };
    add_map(base_map, aiTextureType_BASE_COLOR);
    add_map(normal_map, aiTextureType_NORMALS);
    add_map(emissive_map, aiTextureType_EMISSIVE);
}

void make_valid(aiString& name) {
    name = aiString(printable(name.C_Str()));
}

void prepare_mesh(aiMesh& mesh) {
    make_valid(mesh.mName);
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
        // JSON has no infinities; a mesh with a NaN our reader leaves out.
        aiVector3D& place = mesh.mVertices[i];
        if (!is_finite(Vec3f{place.x, place.y, place.z})) place = aiVector3D(NAN, NAN, NAN);
        for (unsigned set = 0; set < mesh.GetNumUVChannels(); ++set) {
            aiVector3D& uv = mesh.mTextureCoords[set][i];
            if (!std::isfinite(uv.x) || !std::isfinite(uv.y)) uv = aiVector3D(0, 1, 0);
        }
    }
    for (unsigned i = 0; i < mesh.mNumBones; ++i) make_valid(mesh.mBones[i]->mName);
}

void prepare_node(aiNode& top) {
    std::vector<aiNode*> open{&top};
    while (!open.empty()) {
        aiNode& node = *open.back();
        open.pop_back();
        make_valid(node.mName);
        delete std::exchange(node.mMetaData, nullptr);
        open.insert(open.end(), node.mChildren, node.mChildren + node.mNumChildren);
    }
}

/// The exporter has one skin for all meshes, in which a bone has one offset, from the first mesh that it
/// moves. Other meshes are put into that one's frame.
void prepare_skins(aiScene& scene) {
    std::map<std::string, aiMatrix4x4> offsets;
    for (unsigned i = 0; i < scene.mNumMeshes; ++i) {
        aiMesh& mesh = *scene.mMeshes[i];
        const std::span bones(mesh.mBones, mesh.mNumBones);
        const auto known = std::ranges::find_if(
            bones, [&](const aiBone* bone) { return offsets.contains(bone->mName.C_Str()); });
        if (known != bones.end()) {
            aiMatrix4x4 bone_from_first = offsets.at((*known)->mName.C_Str());
            const aiMatrix4x4 frame = bone_from_first.Inverse() * (*known)->mOffsetMatrix;
            aiMatrix4x4 back = frame;
            back.Inverse();
            const aiMatrix3x3 turn = aiMatrix3x3(back).Transpose();
            for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
                mesh.mVertices[v] *= frame;
                if (mesh.HasNormals()) mesh.mNormals[v] = (turn * mesh.mNormals[v]).NormalizeSafe();
            }
            for (aiBone* bone : bones) bone->mOffsetMatrix = bone->mOffsetMatrix * back;
        }
        for (const aiBone* bone : bones) offsets.emplace(bone->mName.C_Str(), bone->mOffsetMatrix);
    }
}

/// Leaves keys whose times rise from 0 on; others are repeats.
template <class Key>
void prepare_keys(Key* keys, unsigned& count) {
    unsigned kept = 0;
    for (unsigned i = 0; i < count; ++i) {
        const double time = keys[i].mTime;
        const bool rises = kept == 0 || time > keys[kept - 1].mTime;
        if (std::isfinite(time) && time >= 0.0 && rises) keys[kept++] = keys[i];
    }
    count = kept;
}

void prepare_animation(const aiScene& scene, unsigned number) {
    aiAnimation& animation = *scene.mAnimations[number];
    make_valid(animation.mName);
    if (animation.mName.length == 0)
        animation.mName = aiString(fmt::format("animation {}", number + 1));
    if (!(animation.mTicksPerSecond > 0.0)) animation.mTicksPerSecond = kUsualTicksPer_s;
    unsigned kept = 0;
    for (unsigned i = 0; i < animation.mNumChannels; ++i) {
        std::unique_ptr<aiNodeAnim> channel(animation.mChannels[i]);
        make_valid(channel->mNodeName);
        prepare_keys(channel->mPositionKeys, channel->mNumPositionKeys);
        prepare_keys(channel->mRotationKeys, channel->mNumRotationKeys);
        prepare_keys(channel->mScalingKeys, channel->mNumScalingKeys);
        if (scene.mRootNode->FindNode(channel->mNodeName) != nullptr)
            animation.mChannels[kept++] = channel.release();
    }
    animation.mNumChannels = kept;
}

/// Makes of it what the glTF exporter and our reader of glTF expect.
void prepare(aiScene& scene) {
    for (unsigned i = 0; i < scene.mNumMaterials; ++i) prepare_material(scene, i);
    for (unsigned i = 0; i < scene.mNumTextures; ++i) make_valid(scene.mTextures[i]->mFilename);
    for (unsigned i = 0; i < scene.mNumMeshes; ++i) prepare_mesh(*scene.mMeshes[i]);
    prepare_skins(scene);
    prepare_node(*scene.mRootNode);
    for (unsigned i = 0; i < scene.mNumAnimations; ++i) prepare_animation(scene, i);
    delete std::exchange(scene.mMetaData, nullptr);
}

}  // namespace

Result<std::string> glb_of_scene(aiScene& scene, const std::string& name) {
    prepare(scene);
    Assimp::Exporter exporter;
    const aiExportDataBlob* blob = exporter.ExportToBlob(&scene, "glb2");
    if (blob == nullptr) {
        const std::string_view why = exporter.GetErrorString();
        if (why == "std::bad_alloc") throw std::bad_alloc();
        return model_error(name, why);
    }
    return std::string(static_cast<const char*>(blob->data), blob->size);
}

std::string foreign_model_fault(std::string_view bytes) {
    return kind_of(bytes) == ForeignKind::None ? "its content is neither Collada nor FBX" : "";
}

Result<std::string> glb_of_foreign_model(std::string_view bytes, const std::string& name) {
    const bool is_fbx = kind_of(bytes) == ForeignKind::Fbx;
    const std::string plain_name = is_fbx ? "model.fbx" : "model.dae";
    const std::string content = is_fbx ? std::string(bytes) : tightened(bytes);
    try {
        Assimp::Importer importer;
        keep_importers(importer, {"Collada Importer", "Autodesk FBX Importer"});
        importer.SetIOHandler(
            std::make_unique<ConfinedIo>(plain_name, content).release());  // it takes over
        importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, false);
        importer.SetPropertyBool(AI_CONFIG_FBX_USE_SKELETON_BONE_CONTAINER, false);
        importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                                    aiPrimitiveType_POINT | aiPrimitiveType_LINE);
        // FBX counts in units of so many centimetres, which GlobalScale applies; of Collada it is done.
        const aiScene* read = importer.ReadFile(
            plain_name.c_str(),
            aiProcess_Triangulate | aiProcess_SortByPType | aiProcess_JoinIdenticalVertices |
                aiProcess_LimitBoneWeights | (is_fbx ? unsigned{aiProcess_GlobalScale} : 0U));
        if (read == nullptr) {
            const std::string_view why = importer.GetErrorString();
            if (why == "std::bad_alloc") throw std::bad_alloc();  // it caught that itself
            return model_error(name, why);
        }
        const std::unique_ptr<aiScene> scene(importer.GetOrphanedScene());
        return glb_of_scene(*scene, name);
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& fault) {
        return model_error(name, fault.what());
    }
}

}  // namespace plumbline::assets
