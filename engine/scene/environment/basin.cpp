#include "engine/scene/environment/basin.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumbline::scene {
namespace {

/// Of its size: the grid is wider than the mesh, so that its outermost cells lie outside.
constexpr double kMargin = 0.02;
/// Of an area: triangles that stand upright have no height of their own.
constexpr double kFlat_m2 = 1e-14;
constexpr double kFar_m = std::numeric_limits<double>::infinity();

}  // namespace

Basin::Basin(std::span<const Vec3d> corners_m, double level_m)
    : level_m_(level_m),
      lines_(kCells * kCells, {.ground_m = -kFar_m, .above_m = kFar_m}),
      is_water_(kCells * kCells, 1) {
    glm::dvec2 high_m(-kFar_m);
    low_m_ = -high_m;
    for (const Vec3d& corner : corners_m) {
        low_m_ = glm::min(low_m_, {corner.x, corner.z});
        high_m = glm::max(high_m, {corner.x, corner.z});
    }
    const glm::dvec2 margin_m = kMargin * (high_m - low_m_) + 1e-6;
    low_m_ -= margin_m;
    cell_m_ = (high_m + margin_m - low_m_) / static_cast<double>(kCells);
    for (std::size_t i = 0; i + 2 < corners_m.size(); i += 3)
        cut(corners_m[i], corners_m[i + 1], corners_m[i + 2]);
    flood();
}

/// The lines through a triangle.
void Basin::cut(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    const auto across = [](const glm::dvec2& u, const glm::dvec2& v) {
        return u.x * v.y - u.y * v.x;
    };
    const auto in_cells = [this](const Vec3d& corner) {
        return (glm::dvec2{corner.x, corner.z} - low_m_) / cell_m_ - 0.5;
    };
    const glm::dvec2 p = in_cells(a);
    const glm::dvec2 q = in_cells(b);
    const glm::dvec2 r = in_cells(c);
    const double area = across(q - p, r - p);
    if (std::abs(area) < kFlat_m2) return;
    const auto first = [](double from) {
        return static_cast<std::size_t>(std::max(std::ceil(from), 0.0));
    };
    const auto end = [](double to) {
        return static_cast<std::size_t>(std::clamp(std::floor(to) + 1, 0.0, double{kCells}));
    };
    for (std::size_t row = first(std::min({p.y, q.y, r.y})); row < end(std::max({p.y, q.y, r.y}));
         ++row) {
        for (std::size_t column = first(std::min({p.x, q.x, r.x}));
             column < end(std::max({p.x, q.x, r.x}));
             ++column) {
            const glm::dvec2 at(static_cast<double>(column), static_cast<double>(row));
            const double of_a = across(q - at, r - at) / area;
            const double of_b = across(r - at, p - at) / area;
            const double of_c = 1 - of_a - of_b;
            if (std::min({of_a, of_b, of_c}) < 0) continue;
            Line& line = lines_[row * kCells + column];
            const double height_m = of_a * a.y + of_b * b.y + of_c * c.y;
            if (height_m < level_m_) {
                line.ground_m = std::max(line.ground_m, height_m);
            } else if (height_m < line.above_m) {
                line.above_m = height_m;
                line.is_solid = area < 0;  // counter-clockwise from above
            }
        }
    }
}

/// What the edge of the grid is joined with by free lines runs dry.
void Basin::flood() {
    std::vector<std::size_t> dry;
    const auto drain = [&](std::size_t cell) {
        if (is_water_[cell] == 0 || lines_[cell].is_solid) return;
        is_water_[cell] = 0;
        dry.push_back(cell);
    };
    for (std::size_t i = 0; i < kCells; ++i) {
        for (const std::size_t cell :
             {i, (kCells - 1) * kCells + i, i * kCells, i * kCells + kCells - 1})
            drain(cell);
    }
    while (!dry.empty()) {
        const std::size_t cell = dry.back();
        dry.pop_back();
        const std::size_t column = cell % kCells;
        if (column > 0) drain(cell - 1);
        if (column + 1 < kCells) drain(cell + 1);
        if (cell >= kCells) drain(cell - kCells);
        if (cell + kCells < is_water_.size()) drain(cell + kCells);
    }
    for (std::size_t cell = 0; cell < is_water_.size(); ++cell) {
        if (lines_[cell].is_solid || lines_[cell].ground_m == -kFar_m) is_water_[cell] = 0;
        wet_ += is_water_[cell];
    }
}

bool Basin::holds(double x, double z) const {
    const glm::dvec2 at = (glm::dvec2{x, z} - low_m_) / cell_m_;
    constexpr double kEnd{kCells};
    if (!(at.x >= 0 && at.y >= 0 && at.x < kEnd && at.y < kEnd)) return false;
    return is_water_[static_cast<std::size_t>(at.y) * kCells + static_cast<std::size_t>(at.x)] != 0;
}

double Basin::volume_m3() const {
    double depth_m = 0;
    for (std::size_t cell = 0; cell < is_water_.size(); ++cell)
        depth_m += is_water_[cell] != 0 ? level_m_ - lines_[cell].ground_m : 0;
    return depth_m * cell_m_.x * cell_m_.y;
}

Vec3d Basin::min_m() const {
    Vec3d low{kFar_m, level_m_, kFar_m};
    for (std::size_t cell = 0; cell < is_water_.size(); ++cell) {
        if (is_water_[cell] == 0) continue;
        const glm::dvec2 corner = corner_of(cell % kCells, cell / kCells);
        low = glm::min(low, {corner.x, lines_[cell].ground_m, corner.y});
    }
    return low;
}

Vec3d Basin::max_m() const {
    Vec3d high{-kFar_m, level_m_, -kFar_m};
    for (std::size_t cell = 0; cell < is_water_.size(); ++cell) {
        if (is_water_[cell] == 0) continue;
        const glm::dvec2 corner = corner_of(cell % kCells + 1, cell / kCells + 1);
        high = glm::max(high, {corner.x, level_m_, corner.y});
    }
    return high;
}

glm::dvec2 Basin::corner_of(std::size_t column, std::size_t row) const {
    return low_m_ + cell_m_ * glm::dvec2(static_cast<double>(column), static_cast<double>(row));
}

bool Basin::touches_water(std::size_t column, std::size_t row) const {
    for (std::size_t z = row > 0 ? row - 1 : 0; z <= std::min(row + 1, kCells - 1); ++z) {
        for (std::size_t x = column > 0 ? column - 1 : 0; x <= std::min(column + 1, kCells - 1);
             ++x) {
            if (is_water_[z * kCells + x] != 0) return true;
        }
    }
    return false;
}

std::vector<Basin::Cell> Basin::surface() const {
    std::vector<Cell> cells;
    for (std::size_t row = 0; row < kCells; ++row) {
        for (std::size_t column = 0; column < kCells; ++column) {
            if (!touches_water(column, row)) continue;
            const glm::dvec2 low = corner_of(column, row);
            const glm::dvec2 high = corner_of(column + 1, row + 1);
            cells.push_back({low.x, low.y, high.x, high.y});
        }
    }
    return cells;
}

}  // namespace plumbline::scene
