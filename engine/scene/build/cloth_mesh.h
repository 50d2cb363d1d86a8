// Triangles of a sheet of cloth: both of its faces, half of its thickness apart from its points.
#pragma once

#include "engine/assets/mesh_data.h"
#include "engine/physics/sheet.h"

#include <span>

namespace plumbline::scene {

/// The front looks along the sheet's z at the start. Texture coordinates run over the whole of it.
assets::MeshData cloth_mesh(const physics::Sheet& sheet);

/// Moves the vertices to `points_m`, row by row from the top as the sheet has them, and leaves out torn cells.
void shape_cloth_mesh(const physics::Sheet& sheet,
                      std::span<const Vec3d> points_m,
                      float thickness_m,
                      assets::MeshData& mesh);

}  // namespace plumbline::scene
