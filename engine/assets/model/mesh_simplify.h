// Fewer triangles for the same shape, by meshoptimizer: edges are collapsed in the order of the
// quadric error that it costs (Garland and Heckbert 1997). No GL.
#pragma once

#include "engine/assets/mesh_data.h"

#include <cstdint>
#include <vector>

namespace plumbline::assets {

/// Indices into the same vertices. No surface moves by more than about `error_m`; open borders, seams
/// of texture coordinates and edges between colours stay closed. Colours that change gradually are lost.
std::vector<std::uint32_t> simplified(const std::vector<Vertex>& vertices,
                                      const std::vector<std::uint32_t>& indices,
                                      float error_m);

}  // namespace plumbline::assets
