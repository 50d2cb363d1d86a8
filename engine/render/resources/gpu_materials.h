// Materials of the asset library as the shaders read them.
#pragma once

#include "engine/assets/asset_library.h"
#include "engine/render/gl/buffer.h"
#include "engine/render/resources/gpu_textures.h"
#include "engine/render/shaders/mesh_features.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace plumbline::render {

/// The shader code that a material needs.
FeatureSet features_of(const assets::MaterialData& material);
/// The images that it names.
std::vector<TextureRequest> textures_of(const assets::MaterialData& material);

/// What a frame asks of all materials.
struct MaterialUse {
    std::optional<assets::Shading> shading{};  ///< over every material's own
    bool textures{true};                       ///< false: no base colour maps
    /// False leaves normal maps out, and the maps of roughness where nothing is metal.
    bool surface_maps{true};
    bool parallax{true};    ///< false leaves height maps out
    bool refraction{true};  ///< false: water does not show what lies below it
    bool caustics{true};

    friend bool operator==(const MaterialUse&, const MaterialUse&) = default;
};

class GpuMaterials {
public:
    GpuMaterials(const assets::AssetLibrary& library, GpuTextures& textures);

    /// Uploads materials that the library has got since the last call. Once a frame.
    void update(const MaterialUse& use);
    FeatureSet features(assets::MaterialId id) const { return materials_[id.value].features; }
    const std::vector<TextureRequest>& textures(assets::MaterialId id) const {
        return materials_[id.value].textures;
    }
    /// Makes the material's numbers and images what the next draw reads.
    void bind(assets::MaterialId id);
    void clear();

private:
    const assets::AssetLibrary& library_;
    GpuTextures& textures_;
    gl::Buffer blocks_;
    std::size_t stride_{0};
    struct Entry {
        FeatureSet features{0};
        std::vector<TextureRequest> textures;
    };
    MaterialUse use_;
    std::vector<Entry> materials_;  ///< by id; [0]: what draws without a material get
};

}  // namespace plumbline::render
