#include "engine/render/resources/gpu_materials.h"

#include "engine/render/shader_blocks.h"

#include <glad/gl.h>

#include <cstring>

namespace plumbline::render {
namespace {

// Smoother than this a surface mirrors the sky visibly; rougher ones make do with the sky's
// harmonics, which cost no texture lookup.
constexpr float kMirrorRoughness = 0.3F;
// The share of sunlight that comes through a leaf or petal.
constexpr float kLeafTransmission = 0.55F;

/// Two-sided without being metal: a leaf, a petal, a blade of grass.
bool is_thin(const assets::MaterialData& material) {
    return material.two_sided && material.thin && material.metallic < 0.5F &&
           material.alpha_mode != assets::AlphaMode::Blend;
}

/// What glass mirrors head on (Fresnel).
float head_on_of(float ior) {
    const float share = (ior - 1.0F) / (ior + 1.0F);
    return share * share;
}

bool sees_into(const assets::MaterialData& water) {
    return water.attenuation_m > 0.0F;
}

MaterialBlock block_of(const assets::MaterialData& material) {
    const FeatureSet features = features_of(material);
    const bool is_leaf = (features & mesh_feature::kLeaf) != 0;
    const bool is_water = (features & mesh_feature::kRipples) != 0;
    const bool is_phong = (features & mesh_feature::kPhong) != 0;
    return {.base_color = Vec4f{material.base_color, material.alpha},
            .emissive = Vec4f{material.emissive, material.alpha_cutoff},
            .surface = {is_phong ? material.shininess : material.roughness,
                        is_phong ? material.specular : material.metallic,
                        is_phong   ? (material.white_highlight ? 1.0F : 0.0F)
                        : is_leaf  ? kLeafTransmission
                        : is_water ? material.ripple_slope
                                   : material.variation,
                        is_phong ? material.diffuse : material.occlusion},
            .relief = {material.height_depth,
                       head_on_of(material.ior),
                       sees_into(material) ? 1.0F / material.attenuation_m : 0.0F,
                       material.caustics}};
}

/// Of a material shaded by PBR: how it mirrors, and what is seen through it.
FeatureSet mirror_features_of(const assets::MaterialData& material) {
    FeatureSet features = 0;
    if (material.orm_map.empty() && material.roughness < kMirrorRoughness)
        features |= mesh_feature::kSkyReflection;
    if (material.alpha_mode != assets::AlphaMode::Blend) return features;
    if (material.ripple_slope > 0.0F && material.normal_map.empty()) {
        features |= mesh_feature::kRipples;
        if (sees_into(material)) features |= mesh_feature::kRefraction;
    } else if (material.ior > 0.0F) {
        features |= mesh_feature::kGlass | mesh_feature::kSkyReflection;
    }
    return features;
}

}  // namespace

FeatureSet features_of(const assets::MaterialData& material) {
    FeatureSet features = 0;
    if (material.shading == assets::Shading::BlinnPhong) features |= mesh_feature::kBlinnPhong;
    if (material.shading == assets::Shading::Unlit) features |= mesh_feature::kUnlit;
    features |=
        material.base_color_map.empty() ? mesh_feature::kVertexColor : mesh_feature::kBaseMap;
    if (material.vertex_colors) features |= mesh_feature::kVertexColor;
    if (material.emissive != Vec3f{0.0F}) {
        features |= mesh_feature::kEmissive;
        if (!material.emissive_map.empty()) features |= mesh_feature::kEmissiveMap;
    }
    if (material.alpha_mode == assets::AlphaMode::Mask && !material.base_color_map.empty()) {
        features |= mesh_feature::kAlphaMask;
    }
    if (material.alpha_mode == assets::AlphaMode::Blend) features |= mesh_feature::kBlend;
    if (material.shading == assets::Shading::Unlit) return features;

    if (material.variation > 0.0F && !material.base_color_map.empty() && !is_thin(material)) {
        features |= mesh_feature::kVariation;
    }
    if (material.flat) features |= mesh_feature::kFlat;
    if (!material.normal_map.empty()) features |= mesh_feature::kNormalMap;
    if (material.shading == assets::Shading::BlinnPhong && material.shininess > 0.0F) {
        return features | mesh_feature::kPhong;
    }
    if (!material.orm_map.empty()) features |= mesh_feature::kOrmMap;
    if (material.two_sided) features |= mesh_feature::kTwoSided;
    if (material.metallic > 0.0F) features |= mesh_feature::kMetal;
    if (is_thin(material)) features |= mesh_feature::kLeaf;
    if (material.shading == assets::Shading::Pbr) features |= mirror_features_of(material);
    if (!material.height_map.empty() && material.height_depth > 0.0F &&
        !material.normal_map.empty()) {
        features |= mesh_feature::kParallax;
    }
    return features;
}

std::vector<TextureRequest> textures_of(const assets::MaterialData& material) {
    std::vector<TextureRequest> requests;
    const FeatureSet features = features_of(material);
    if ((features & mesh_feature::kBaseMap) != 0) {
        const bool masked = (features & mesh_feature::kAlphaMask) != 0;
        requests.push_back({.file = material.base_color_map,
                            .content = MipContent::Color,
                            .alpha_cutoff = masked ? material.alpha_cutoff : 0.0F});
    }
    const auto add = [&](FeatureSet feature, TextureRequest request) {
        if ((features & feature) != 0) requests.push_back(std::move(request));
    };
    constexpr MipContent kData = MipContent::Data;
    add(mesh_feature::kNormalMap,
        {.file = material.normal_map, .content = kData, .unit = kNormalUnit});
    add(mesh_feature::kParallax,
        {.file = material.height_map, .content = kData, .unit = kHeightUnit});
    add(mesh_feature::kOrmMap, {.file = material.orm_map, .content = kData, .unit = kOrmUnit});
    add(mesh_feature::kEmissiveMap, {.file = material.emissive_map, .unit = kEmissiveUnit});
    return requests;
}

GpuMaterials::GpuMaterials(const assets::AssetLibrary& library, GpuTextures& textures)
    : library_(library),
      textures_(textures),
      blocks_(gl::BufferUse::Uniforms, gl::BufferLife::Kept) {
    GLint alignment = 256;
    glGetIntegerv(GL_UNIFORM_BUFFER_OFFSET_ALIGNMENT, &alignment);
    const auto step = static_cast<std::size_t>(alignment);
    stride_ = (sizeof(MaterialBlock) + step - 1) / step * step;
}

void GpuMaterials::update(const MaterialUse& use) {
    const std::size_t count = library_.material_count() + 1;
    if (materials_.size() == count && use_ == use) return;
    use_ = use;
    materials_.clear();
    std::vector<std::byte> bytes(count * stride_);
    std::vector<TextureRequest> wanted;
    for (std::uint32_t id = 0; id < count; ++id) {
        assets::MaterialData material =
            id == 0 ? assets::MaterialData{} : library_.material(assets::MaterialId{id});
        if (use.shading) material.shading = *use.shading;
        if (!use.textures) material.base_color_map.clear();
        if (!use.parallax) material.height_map.clear();
        if (!use.refraction) material.attenuation_m = 0.0F;
        if (!use.caustics) material.caustics = 0.0F;
        if (!use.surface_maps) {
            material.normal_map.clear();
            // What is metal where is in there, too.
            if (material.metallic == 0.0F) material.orm_map.clear();
        }
        const MaterialBlock block = block_of(material);
        std::memcpy(bytes.data() + id * stride_, &block, sizeof(block));
        materials_.push_back(
            {.features = features_of(material), .textures = textures_of(material)});
        const std::vector<TextureRequest>& textures = materials_.back().textures;
        wanted.insert(wanted.end(), textures.begin(), textures.end());
    }
    textures_.decode_ahead(wanted);
    blocks_.upload(bytes.data(), bytes.size());
}

void GpuMaterials::bind(assets::MaterialId id) {
    gl::bind_uniforms(kMaterialBinding, blocks_, id.value * stride_, sizeof(MaterialBlock));
    const Entry& material = materials_[id.value];
    for (const TextureRequest& request : material.textures) {
        gl::bind_texture(request.unit, textures_.get(request));
    }
}

void GpuMaterials::clear() {
    materials_.clear();
}

}  // namespace plumbline::render
