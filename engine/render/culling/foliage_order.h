// Foliage near to far. Leaves hide each other many times over, and what is hidden is only spared when
// what hides it was drawn before: so the triangles lie in the index buffer once for each side that a
// crown may be looked at from. Pure arithmetic; no GL.
#pragma once

#include "engine/assets/mesh_data.h"
#include "engine/core/math.h"
#include "engine/render/culling/mesh_lods.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace plumbline::render {

/// About the mesh's y axis, as trees are walked round.
inline constexpr std::size_t kFoliageSides = 8;

/// From which of kFoliageSides a mesh is seen. `to_eye_body`: any length.
std::size_t side_seen_from(const Vec3f& to_eye_body);

/// Appends the foliage of each version to the indices, near to far, once a side, and sets its by_side.
/// `is_foliage` by sub-mesh; parts beyond its end are none. Nothing where there is little foliage.
void add_foliage_order(const std::vector<assets::Vertex>& vertices,
                       const std::vector<bool>& is_foliage,
                       std::vector<std::uint32_t>& indices,
                       std::vector<MeshLod>& lods);

}  // namespace plumbline::render
