// Smaller and smaller copies of an image, made on the CPU.
#pragma once

#include "engine/assets/image_data.h"

#include <memory>
#include <vector>

namespace plumbline::render {

enum class MipContent {
    Color,  ///< sRGB: averaged as light, not as code values
    Data    ///< normals, roughness and so on: averaged as they are
};

/// The image itself, or one of half floats in 8 bits: what is brighter than 1 becomes 1, and colours
/// are no longer multiplied by alpha.
std::shared_ptr<const assets::ImageData> in_bytes(std::shared_ptr<const assets::ImageData> image,
                                                  MipContent content);

/// The levels below the image, from half its size down to 1 x 1. 8-bit formats only: see in_bytes().
/// With `alpha_cutoff` > 0, each level's alpha is scaled so that the same share of it passes the
/// cutoff as in the full image: leaves would vanish with distance otherwise.
std::vector<assets::ImageData> mip_chain(const assets::ImageData& image,
                                         MipContent content,
                                         float alpha_cutoff);

}  // namespace plumbline::render
