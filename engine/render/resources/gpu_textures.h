// Images that materials name, uploaded on first use with all their mip levels.
#pragma once

#include "engine/assets/asset_library.h"
#include "engine/render/gl/texture.h"
#include "engine/render/resources/mip_chain.h"
#include "engine/render/shader_blocks.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace plumbline::render {

struct TextureRequest {
    std::filesystem::path file;
    MipContent content{MipContent::Color};
    float alpha_cutoff{0.0F};  ///< 0: alpha is not cut
    TextureUnit unit{kBaseColorUnit};
};

class GpuTextures {
public:
    /// Images larger than `largest_px` on a side are halved until they fit.
    GpuTextures(assets::AssetLibrary& library, std::uint32_t largest_px)
        : library_(library), largest_px_(largest_px) {}

    /// Uploads at the first call; the reference is good until clear().
    const gl::Texture& get(const TextureRequest& request);
    /// Starts decoding the images that are not there yet.
    void decode_ahead(const std::vector<TextureRequest>& requests);
    /// Uploads all that are not there yet, halving them on worker threads meanwhile; `on_each`: after
    /// every request.
    void load(const std::vector<TextureRequest>& requests, const std::function<void()>& on_each);
    void clear();
    std::size_t bytes() const { return bytes_; }

private:
    /// The same file can be wanted as colour by one material and as data by another.
    using Key = std::pair<std::filesystem::path, MipContent>;

    const gl::Texture& add(const TextureRequest& request,
                           const assets::ImageData& image,
                           const std::vector<assets::ImageData>& smaller);

    assets::AssetLibrary& library_;
    std::uint32_t largest_px_;
    std::map<Key, gl::Texture> textures_;
    std::size_t bytes_{0};
};

}  // namespace plumbline::render
