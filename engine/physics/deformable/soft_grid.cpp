#include "engine/physics/soft_grid.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace plumbline::physics {
namespace {

using Counts = std::array<std::uint32_t, 3>;

/// Corners of a cell's faces, counter-clockwise from outside: low and high along x, y, z.
constexpr std::array<std::array<std::uint32_t, 4>, 6> kFaces{
    {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};

/// Builds a grid cell by cell.
class GridMaker {
public:
    explicit GridMaker(const std::function<Vec3d(const Counts&)>& place) : place_(place) {}

    void add(const Counts& at) {
        std::array<std::uint32_t, 8>& cell = grid_.cells.emplace_back();
        for (std::uint32_t i = 0; i < 8; ++i)
            cell[i] = point({at[0] + (i & 1U), at[1] + (i >> 1U & 1U), at[2] + (i >> 2U)});
        for (std::uint32_t side = 0; side < 6; ++side) {
            SoftGrid::Face face{.points = {}, .side = side};
            for (std::size_t i = 0; i < 4; ++i) face.points[i] = cell[kFaces[side][i]];
            std::array<std::uint32_t, 4> key = face.points;
            std::ranges::sort(key);
            // A face that two cells share is not an outer one.
            if (open_.erase(key) == 0) open_.emplace(key, face);
        }
    }
    SoftGrid finish() {
        for (const auto& [key, face] : open_) grid_.faces.push_back(face);
        return std::move(grid_);
    }

private:
    std::uint32_t point(const Counts& at) {
        const auto [found, is_new] =
            numbers_.try_emplace(at, static_cast<std::uint32_t>(grid_.points_m.size()));
        if (is_new) grid_.points_m.push_back(place_(at));
        return found->second;
    }

    const std::function<Vec3d(const Counts&)>& place_;
    SoftGrid grid_;
    std::map<Counts, std::uint32_t> numbers_;
    std::map<std::array<std::uint32_t, 4>, SoftGrid::Face> open_;  // by sorted points
};

/// Cells of a grid that are wanted, and the points that they need, in the order of the grid.
SoftGrid grid_of(const Counts& counts,
                 const std::function<bool(const Counts&)>& is_wanted,
                 const std::function<Vec3d(const Counts&)>& place) {
    GridMaker maker(place);
    for (std::uint32_t z = 0; z < counts[2]; ++z) {
        for (std::uint32_t y = 0; y < counts[1]; ++y) {
            for (std::uint32_t x = 0; x < counts[0]; ++x) {
                if (is_wanted({x, y, z})) maker.add({x, y, z});
            }
        }
    }
    return maker.finish();
}

constexpr auto kAll = [](const Counts&) { return true; };

}  // namespace

SoftGrid box_grid(const Vec3d& size_m, const Counts& cells) {
    return grid_of(cells, kAll, [&](const Counts& at) {
        Vec3d place{0, 0, 0};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto i = static_cast<int>(axis);
            place[i] = size_m[i] * (static_cast<double>(at[axis]) / cells[axis] - 0.5);
        }
        return place;
    });
}

SoftGrid ellipsoid_grid(const Vec3d& half_axes_m, const Counts& cells) {
    SoftGrid grid = grid_of(cells, kAll, [&](const Counts& at) {
        const Vec3d cube =
            2.0 * Vec3d(at[0], at[1], at[2]) / Vec3d(cells[0], cells[1], cells[2]) - 1.0;
        const double length = glm::length(cube);
        const double shell = std::max({std::abs(cube.x), std::abs(cube.y), std::abs(cube.z)});
        return length > 0 ? half_axes_m * cube * (shell / length) : Vec3d{0, 0, 0};
    });
    for (SoftGrid::Face& face : grid.faces) face.side = 0;
    const SoftBody within({.grid = grid});
    const double whole_m3 =
        4.0 / 3 * glm::pi<double>() * half_axes_m.x * half_axes_m.y * half_axes_m.z;
    // Its cube root, by Newton's method.
    double scale = 1;
    for (int i = 0; i < 30; ++i)
        scale -= (scale - whole_m3 / within.rest_volume_m3() / (scale * scale)) / 3;
    for (Vec3d& point : grid.points_m) point *= scale;
    return grid;
}

SoftGrid voxel_grid(const Vec3d& low_m,
                    const Vec3d& high_m,
                    double cell_m,
                    const std::function<bool(const Vec3d&)>& is_inside) {
    Counts counts{};
    Vec3d start{0, 0, 0};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<int>(axis);
        const double size_m = high_m[i] - low_m[i];
        counts[axis] = static_cast<std::uint32_t>(std::max(1.0, std::ceil(size_m / cell_m - 0.01)));
        start[i] = (low_m[i] + high_m[i] - counts[axis] * cell_m) / 2;
    }
    const auto corner = [&](const Counts& at) {
        return start + Vec3d(at[0], at[1], at[2]) * cell_m;
    };
    return grid_of(
        counts, [&](const Counts& at) { return is_inside(corner(at) + cell_m / 2); }, corner);
}

}  // namespace plumbline::physics
