// The water that a mesh holds: where its inside lies below the level and no way leads out.
#pragma once

#include "engine/assets/mesh_data.h"
#include "engine/core/math.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace plumbline::scene {

/// A grid of upright lines through the mesh. One is under water where it is free at the level (the surface next above faces
/// downwards, or there is none) and it lies in a region of such lines that does not reach the edge of the grid: the outside of a
/// bowl is as free as its inside.
class Basin {
public:
    /// `corners_m`: of triangles, three by three, world axes.
    Basin(std::span<const Vec3d> corners_m, double level_m);

    bool is_empty() const { return wet_ == 0; }
    /// Whether there is water at that place.
    bool holds(double x, double z) const;
    double volume_m3() const;
    /// Round all of the water: from its deepest place to the level.
    Vec3d min_m() const;
    Vec3d max_m() const;

    /// Corners of a cell of its surface, for drawing: of water and, so that the wall meets it, of its neighbours.
    struct Cell {
        double x0, z0, x1, z1;
    };
    std::vector<Cell> surface() const;

private:
    static constexpr std::size_t kCells = 128;  ///< along each side

    /// What the mesh has of a cell's line next to the level.
    struct Line {
        double ground_m;
        double above_m;
        bool is_solid{false};  ///< what is above faces upwards: the level lies within the mesh
    };
    void cut(const Vec3d& a, const Vec3d& b, const Vec3d& c);
    void flood();
    /// At the lower x and z of a cell.
    glm::dvec2 corner_of(std::size_t column, std::size_t row) const;
    bool touches_water(std::size_t column, std::size_t row) const;

    double level_m_;
    glm::dvec2 low_m_{0, 0};              ///< x and z of the grid's corner
    glm::dvec2 cell_m_{1, 1};             ///< along x and z
    std::vector<Line> lines_;             ///< row * kCells + column; rows along z
    std::vector<std::uint8_t> is_water_;  ///< likewise
    std::size_t wet_{0};                  ///< cells of water
};

}  // namespace plumbline::scene
