// Triangles of a water's surface, as seen from above.
#pragma once

#include "engine/assets/mesh_data.h"
#include "engine/scene/environment/basin.h"

#include <cstdint>
#include <span>

namespace plumbline::scene {

/// Metres of the surface for a repeat of its texture.
inline constexpr double kWaterTile_m = 1;
/// Along a side of a surface with waves: eight for the shortest wave of draft, four for that of balanced.
inline constexpr std::uint32_t kWaterCells = 64;

/// A grid from corner to corner of the water's box at its level; `cells` along each side.
assets::MeshData water_mesh(const Vec3d& min_m, const Vec3d& max_m, std::uint32_t cells);
/// The same of a basin's water.
assets::MeshData water_mesh(const Basin& basin);

/// Moves the vertices of a grid to so much above the level, row by row along z.
void shape_water_mesh(std::span<const double> heights_m, double level_m, assets::MeshData& mesh);

}  // namespace plumbline::scene
