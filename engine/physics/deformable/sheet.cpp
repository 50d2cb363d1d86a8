#include "engine/physics/sheet.h"

#include "engine/core/io/archive.h"

#include <algorithm>
#include <cmath>

namespace plumbline::physics {
namespace {

/// Symplectic Euler is stable while the square of what a sub-step turns the fastest mode by is below 4.
constexpr double kMost_rad2 = 2.8;
/// Where damping leaves nothing of a mode's speed, below 2.
constexpr double kMostDamped_rad2 = 1.8;
/// Of it, what bending and tension across the threads have where not all of it can be had.
constexpr double kMostBending_rad2 = 0.8;
constexpr double kMostAcross_rad2 = 0.5;
/// Of damping that forces bear: the share of its speed that the fastest bending mode loses in a sub-step.
constexpr double kMostLag = 0.2;

/// Where a point at `x_m` of the flat sheet begins: its folds are a triangle wave as long as the sheet is wide.
Vec3d in_folds(const SheetDef& def, double x_m) {
    if (def.folds == 0) return {x_m, 0, 0};
    const double phase = (x_m / def.size_m[0] + 0.5) * def.folds;
    const double from_crease = std::abs(2 * (phase - std::floor(phase)) - 1) - 0.5;
    const double depth_m =
        def.size_m[0] / (2 * def.folds) * std::sqrt(std::max(0.0, 1 - def.gather * def.gather));
    return {x_m * def.gather, 0, depth_m * from_crease};
}

}  // namespace

Sheet::Sheet(const SheetDef& def)
    : columns_(def.cells[0] + 1),
      rows_(def.cells[1] + 1),
      cell_m_{def.size_m[0] / def.cells[0], def.size_m[1] / def.cells[1]},
      def_(def) {
    for (std::uint32_t row = 0; row < rows_; ++row) {
        for (std::uint32_t column = 0; column < columns_; ++column) {
            const Vec3d place = in_folds(def, cell_m_[0] * column - def.size_m[0] / 2) +
                                Vec3d{0, def.size_m[1] / 2 - cell_m_[1] * row, 0};
            const double share =
                (column % (columns_ - 1) == 0 ? 0.5 : 1.0) * (row % (rows_ - 1) == 0 ? 0.5 : 1.0);
            add_point(def.position_m + def.orientation * place,
                      def.density_kgpm2 * cell_m_[0] * cell_m_[1] * share);
        }
    }
    add_threads();
}

void Sheet::add_threads() {
    const auto add_line = [this](std::size_t axis,
                                 std::uint32_t first,
                                 std::uint32_t stride,
                                 std::uint32_t count,
                                 bool border) {
        const double width_m = cell_m_[1 - axis] * (border ? 0.5 : 1.0);
        const double length_m = cell_m_[axis];
        ThreadFamily& family = families_[axis];
        for (std::uint32_t i = 0; i + 1 < count; ++i)
            family.threads.push_back({.a = first + i * stride,
                                      .b = first + (i + 1) * stride,
                                      .rest_m = length_m,
                                      .stiffness_Npm = def_.stretch_Npm * width_m / length_m,
                                      .width_m = width_m});
        family.per_line = count - 1;
        const double bend_Npm = def_.bend_Nm * width_m / (length_m * length_m * length_m);
        strips_[axis].strips.push_back(
            {.first = first, .stride = stride, .count = count, .stiffness_Npm = bend_Npm});
    };
    for (std::uint32_t row = 0; row < rows_; ++row)
        add_line(0, row * columns_, 1, columns_, row == 0 || row + 1 == rows_);
    for (std::uint32_t column = 0; column < columns_; ++column)
        add_line(1, column, columns_, rows_, column == 0 || column + 1 == columns_);
}

/// Gershgorin: twice the sum of what crosses a point's threads, over its mass, bounds the square of its frequency.
void Sheet::find_across() {
    across_radps2_.assign(positions_m_.size(), 0.0);
    for (const ThreadFamily& family : families_) {
        for (const Thread& thread : family.threads) {
            if (!(thread.length_m > thread.rest_m)) continue;
            const double each =
                2 * thread.stiffness_Npm * (thread.length_m - thread.rest_m) / thread.length_m;
            across_radps2_[thread.a] += each * inverse_masses_[thread.a];
            across_radps2_[thread.b] += each * inverse_masses_[thread.b];
        }
    }
}

/// Of all threads that meet at a corner: the largest cosine of the angle between two of different families.
double Sheet::most_aligned() const {
    const std::vector<Thread>& along = families_[0].threads;
    const std::vector<Thread>& down = families_[1].threads;
    double most = 0;
    for (std::size_t row = 0; row + 1 < rows_; ++row) {
        for (std::size_t column = 0; column + 1 < columns_; ++column) {
            const Thread* top = &along[row * (columns_ - 1) + column];
            const Thread* left = &down[column * (rows_ - 1) + row];
            for (const Thread* x : {top, top + (columns_ - 1)}) {
                for (const Thread* y : {left, left + (rows_ - 1)})
                    most = std::max(most, std::abs(glm::dot(x->direction, y->direction)));
            }
        }
    }
    return std::min(most, 1.0);
}

std::uint32_t Sheet::plan(double seconds, std::uint32_t most) {
    for (ThreadFamily& family : families_) family.measure(positions_m_);
    const double x2 = 1 / (cell_m_[0] * cell_m_[0]);
    const double y2 = 1 / (cell_m_[1] * cell_m_[1]);
    const double rho = def_.density_kgpm2;
    // Threads that cross at right angles do not stiffen each other.
    const double aligned =
        (def_.damping_s > 0 ? 1 : most_aligned()) * 2 / (cell_m_[0] * cell_m_[1]);
    const double along = (x2 + y2 + std::sqrt((x2 - y2) * (x2 - y2) + aligned * aligned)) / 2;
    const double stretching =
        4 * (def_.stretch_Npm * along + def_.shear_Npm * std::max(x2, y2)) / rho;
    const double bending = 16 * def_.bend_Nm * (x2 + y2) * (x2 + y2) / rho;
    find_across();
    const double tension = *std::ranges::max_element(across_radps2_);
    const double most_rad2 = def_.damping_s > 0 ? kMostDamped_rad2 : kMost_rad2;
    const double wanted =
        std::ceil(seconds * std::sqrt((stretching + bending + tension) / most_rad2));
    const std::uint32_t count = take_substeps(seconds, wanted, most);
    bend_share_ = 1;
    weights_.clear();
    damping_ = stretching * substep_s_ * def_.damping_s;
    bend_lag_s_ = bending * substep_s_ * def_.damping_s < kMostLag ? def_.damping_s : 0;
    if (count >= wanted) return count;
    const double h2 = substep_s_ * substep_s_;
    bend_share_ = std::min(1.0, kMostBending_rad2 / std::max(bending * h2, 1e-12));
    const double left_rad2 = most_rad2 - bend_share_ * bending * h2;
    const auto share_of = [&](double rad2) {
        return std::min(1.0, rad2 / std::max(stretching * h2, 1e-12));
    };
    // What is softer pulls less across.
    const double across_s2 = share_of(left_rad2) * h2;
    stiffness_share_ = share_of(left_rad2 - std::min(tension * across_s2, kMostAcross_rad2));
    if (tension * across_s2 <= kMostAcross_rad2) return count;
    for (const double radps2 : across_radps2_)
        weights_.push_back(std::min(1.0, kMostAcross_rad2 / std::max(radps2 * across_s2, 1e-12)));
    return count;
}

std::vector<SurfacePlace> Sheet::places(std::uint32_t along) const {
    std::vector<SurfacePlace> places;
    for (std::uint32_t row = 0; row <= (rows_ - 1) * along; ++row) {
        for (std::uint32_t column = 0; column <= (columns_ - 1) * along; ++column) {
            const std::uint32_t left = std::min(column / along, columns_ - 2);
            const std::uint32_t top = std::min(row / along, rows_ - 2);
            const double x = static_cast<double>(column - left * along) / along;
            const double y = static_cast<double>(row - top * along) / along;
            const std::uint32_t corner = top * columns_ + left;
            places.push_back(
                {.points = {corner, corner + 1, corner + columns_, corner + columns_ + 1},
                 .weights = {(1 - x) * (1 - y), x * (1 - y), (1 - x) * y, x * y}});
        }
    }
    return places;
}

template <class F>
void Sheet::for_triangles(const F& visit) const {
    for (std::uint32_t row = 0; row + 1 < rows_; ++row) {
        for (std::uint32_t column = 0; column + 1 < columns_; ++column) {
            const std::size_t top = at(column, row);
            const std::size_t below = top + columns_;
            const bool falls = (row + column) % 2 == 0;
            visit(top, below, falls ? below + 1 : top + 1);
            visit(falls ? top : below, below + 1, top + 1);
        }
    }
}

void Sheet::list_parts(SurfaceParts& parts) const {
    if (!parts.triangles.empty() && parts.torn == torn_) return;
    parts = {.torn = torn_};
    const auto number = [](std::size_t point) { return static_cast<std::uint32_t>(point); };
    for_triangles([&](std::size_t a, std::size_t b, std::size_t c) {
        const std::size_t top = std::min({a, b, c});  // of the cell, whichever half of it this is
        const std::size_t column = std::min({a % columns_, b % columns_, c % columns_});
        if (torn_ > 0 && !is_whole(number(column), number(top / columns_))) return;
        parts.triangles.push_back({number(a), number(b), number(c)});
    });
    for (const ThreadFamily& family : families_) {
        for (const Thread& thread : family.threads) {
            if (thread.stiffness_Npm > 0) parts.edges.push_back({thread.a, thread.b});
        }
    }
}

void Sheet::after_move() {
    if (!(def_.tear_Npm > 0)) return;
    for (const std::size_t axis : {0U, 1U}) {
        for (Thread& thread : families_[axis].threads) {
            if (!(thread.stiffness_Npm > 0)) continue;
            const double length_m = glm::distance(positions_m_[thread.a], positions_m_[thread.b]);
            const double tension_N =
                stiffness_share_ * thread.stiffness_Npm * (length_m - thread.rest_m);
            if (tension_N <= def_.tear_Npm * thread.width_m) continue;
            thread.stiffness_Npm = 0;
            ++torn_;
        }
    }
}

bool Sheet::is_whole(std::uint32_t column, std::uint32_t row) const {
    const std::uint32_t along_x = columns_ - 1;
    const std::uint32_t along_y = rows_ - 1;
    const auto holds = [&](std::size_t axis, std::uint32_t thread) {
        return families_[axis].threads[thread].stiffness_Npm > 0;
    };
    return holds(0, row * along_x + column) && holds(0, (row + 1) * along_x + column) &&
           holds(1, column * along_y + row) && holds(1, (column + 1) * along_y + row);
}

double Sheet::area_m2() const {
    double twice_m2 = 0;
    for (std::uint32_t row = 0; row + 1 < rows_; ++row) {
        for (std::uint32_t column = 0; column + 1 < columns_; ++column) {
            const std::size_t top = at(column, row);
            const std::size_t below = top + columns_;
            twice_m2 += glm::length(glm::cross(positions_m_[below + 1] - positions_m_[top],
                                               positions_m_[below] - positions_m_[top + 1]));
        }
    }
    return twice_m2 / 2;
}

double Sheet::elastic_J() const {
    double sum = 0;
    for (const std::size_t axis : {0U, 1U}) {
        for (const Thread& thread : families_[axis].threads) {
            const double drawn_m =
                glm::distance(positions_m_[thread.a], positions_m_[thread.b]) - thread.rest_m;
            sum += 0.5 * stiffness_share_ * thread.stiffness_Npm * drawn_m * drawn_m;
        }
        for (const StripFamily::Strip& strip : strips_[axis].strips) {
            for (std::uint32_t i = 0; i + 2 < strip.count; ++i) {
                const std::size_t first = strip.first + std::size_t{i} * strip.stride;
                const Vec3d bent = positions_m_[first] - 2.0 * positions_m_[first + strip.stride] +
                                   positions_m_[first + 2 * std::size_t{strip.stride}];
                const double held =
                    clamp_factor(inverse_masses_[first],
                                 inverse_masses_[first + strip.stride],
                                 inverse_masses_[first + 2 * std::size_t{strip.stride}]);
                sum += 0.5 * held * bend_share_ * strip.stiffness_Npm * glm::dot(bent, bent);
            }
        }
    }
    const double area_m2 = cell_m_[0] * cell_m_[1];
    for (std::uint32_t row = 0; row + 1 < rows_; ++row) {
        for (std::uint32_t column = 0; column + 1 < columns_; ++column) {
            const std::size_t top = at(column, row);
            const std::size_t below = top + columns_;
            const Vec3d e = positions_m_[below + 1] - positions_m_[top];
            const Vec3d f = positions_m_[below] - positions_m_[top + 1];
            const double angle = (glm::dot(e, e) - glm::dot(f, f)) / (4 * area_m2);
            const Vec3d twist = positions_m_[top] - positions_m_[top + 1] - positions_m_[below] +
                                positions_m_[below + 1];
            sum += glm::dot(twist, twist) * bend_share_ * def_.bend_Nm / area_m2;
            if (torn_ == 0 || is_whole(column, row))
                sum += 0.5 * stiffness_share_ * def_.shear_Npm * area_m2 * angle * angle;
        }
    }
    return sum;
}

void Sheet::serialize_own(Archive& archive) {
    torn_ = 0;
    for (const std::size_t axis : {0U, 1U}) {
        for (Thread& thread : families_[axis].threads) {
            archive(thread.stiffness_Npm);
            torn_ += thread.stiffness_Npm == 0 ? 1U : 0U;
        }
    }
}

}  // namespace plumbline::physics
