// Cells for soft bodies: of boxes, ellipsoids and closed meshes.
#pragma once

#include "engine/physics/soft_body.h"

#include <array>
#include <cstdint>
#include <functional>
#include <span>

namespace plumbline::physics {

/// Round the origin, `cells` along each axis; its six faces are sides of their own.
SoftGrid box_grid(const Vec3d& size_m, const std::array<std::uint32_t, 3>& cells);
/// Shells from the middle outwards; as large as the ellipsoid.
SoftGrid ellipsoid_grid(const Vec3d& half_axes_m, const std::array<std::uint32_t, 3>& cells);
/// The cells of a grid over the box whose middles are inside.
SoftGrid voxel_grid(const Vec3d& low_m,
                    const Vec3d& high_m,
                    double cell_m,
                    const std::function<bool(const Vec3d&)>& is_inside);

}  // namespace plumbline::physics
