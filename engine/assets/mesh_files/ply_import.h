// PLY, ASCII or binary, taken to the letter: what the JSON scenes of the viewer are made of. As a
// model by itself a PLY goes through import_model.
#pragma once

#include "engine/assets/mesh_data.h"
#include "engine/core/result.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::assets {

struct ExactPly {
    /// In the file's frame; v runs down the image. White where the file has no colours, the normal
    /// zero where it has none.
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;
    bool has_normals{false};
    bool has_uvs{false};
};

/// Colours of whole numbers are powers of 2.2, floats are light as they stand, also above 1.
/// Refused, with the number of the vertex or face: what is not finite, a face that names a vertex
/// that is not there or has fewer than three corners, a file that breaks off. `name` is for messages.
Result<ExactPly> read_exact_ply(std::string_view bytes, const std::string& name);

}  // namespace plumbline::assets
