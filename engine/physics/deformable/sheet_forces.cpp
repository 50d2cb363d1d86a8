// What acts within a sheet in a sub-step: threads, shear, bending, their damping, and drag.
#include "engine/physics/sheet.h"

#include <array>
#include <cmath>

namespace plumbline::physics {
namespace {

/// Threads give back a little less than they take, so that what rings falls silent: a mode of frequency w decays at this times w2 h / 2.
constexpr double kInternalFriction = 0.05;

}  // namespace

void Sheet::add_forces() {
    add_stretch();
    if (def_.bend_Nm > 0) add_bending();
    for (std::uint32_t row = 0; row + 1 < rows_; ++row) {
        for (std::uint32_t column = 0; column + 1 < columns_; ++column) add_cell(column, row);
    }
    if (def_.drag > 0) add_drag();
}

void Sheet::add_stretch() {
    const double h = substep_s_;
    for (const ThreadFamily& family : families_) {
        for (const Thread& thread : family.threads) {
            const double opening_m =
                glm::dot(thread.direction, velocities_mps_[thread.b] - velocities_mps_[thread.a]) *
                h;
            const double pull_Ns =
                stiffness_share_ * thread.stiffness_Npm * h *
                (thread.length_m - thread.rest_m + opening_m * kInternalFriction);
            impulses_Ns_[thread.a] += thread.direction * pull_Ns;
            impulses_Ns_[thread.b] -= thread.direction * pull_Ns;
        }
    }
}

/// Shear, by the two diagonals e and f: (e2 - f2) / 4 is the dot product of the cell's mean sides. Twist, by its corners.
void Sheet::add_cell(std::uint32_t column, std::uint32_t row) {
    const double area_m2 = cell_m_[0] * cell_m_[1];
    const std::size_t top = at(column, row);
    const std::size_t below = top + columns_;
    const Vec3d e = positions_m_[below + 1] - positions_m_[top];
    const Vec3d f = positions_m_[below] - positions_m_[top + 1];
    Vec3d by_e{0, 0, 0};
    Vec3d by_f{0, 0, 0};
    if (torn_ == 0 || is_whole(column, row)) {
        const double half_Nspm = stiffness_share_ * def_.shear_Npm * substep_s_ / (8 * area_m2) *
                                 (glm::dot(e, e) - glm::dot(f, f));
        by_e = e * half_Nspm;
        by_f = f * half_Nspm;
    }
    // The corners' second difference is twice what the diagonals' middles lie apart.
    const Vec3d apart =
        positions_m_[top] - positions_m_[top + 1] - positions_m_[below] + positions_m_[below + 1];
    const Vec3d twist = apart * (2 * def_.bend_Nm * bend_share_ * substep_s_ / area_m2);
    impulses_Ns_[top] += by_e - twist;
    impulses_Ns_[below + 1] -= by_e + twist;
    impulses_Ns_[top + 1] -= by_f - twist;
    impulses_Ns_[below] += by_f + twist;
}

void Sheet::add_bending() {
    for (const StripFamily& family : strips_) {
        for (const StripFamily::Strip& strip : family.strips) {
            const double k = strip.stiffness_Npm * bend_share_ * substep_s_;
            for (std::uint32_t i = 0; i + 2 < strip.count; ++i) {
                const std::size_t first = strip.first + std::size_t{i} * strip.stride;
                const std::size_t middle = first + strip.stride;
                const std::size_t last = middle + strip.stride;
                const double held = clamp_factor(
                    inverse_masses_[first], inverse_masses_[middle], inverse_masses_[last]);
                Vec3d bent = positions_m_[first] - 2.0 * positions_m_[middle] + positions_m_[last];
                if (bend_lag_s_ > 0)
                    bent += (velocities_mps_[first] - 2.0 * velocities_mps_[middle] +
                             velocities_mps_[last]) *
                            bend_lag_s_;
                const Vec3d pull = bent * (k * held);
                impulses_Ns_[first] -= pull;
                impulses_Ns_[middle] += 2.0 * pull;
                impulses_Ns_[last] -= pull;
            }
        }
    }
}

/// All cells know what else acts in the sub-step, and none what drags at others.
void Sheet::add_drag() {
    drags_Ns_.clear();
    for (std::uint32_t row = 0; row + 1 < rows_; ++row) {
        for (std::uint32_t column = 0; column + 1 < columns_; ++column)
            drags_Ns_.push_back(drag_Ns(at(column, row)));
    }
    const Vec3d* push_Ns = drags_Ns_.data();
    for (std::uint32_t row = 0; row + 1 < rows_; ++row) {
        for (std::uint32_t column = 0; column + 1 < columns_; ++column, ++push_Ns) {
            for (const std::size_t point : corners_of(at(column, row)))
                impulses_Ns_[point] -= *push_Ns;
        }
    }
}

/// On each corner of a cell, of air, or of water where a corner is under.
Vec3d Sheet::drag_Ns(std::size_t top) const {
    const std::array<std::size_t, 4> corners = corners_of(top);
    const Vec3d area = glm::cross(positions_m_[corners[3]] - positions_m_[corners[0]],
                                  positions_m_[corners[2]] - positions_m_[corners[1]]) /
                       2.0;
    const double area2 = glm::dot(area, area);
    if (!(area2 > 0)) return {0, 0, 0};
    Vec3d passing_mps{0, 0, 0};
    Vec3d changed_mps{0, 0, 0};
    double density_kgpm3 = 0;
    for (const std::size_t i : corners) {
        passing_mps += velocities_mps_[i];
        changed_mps += impulses_Ns_[i] * inverse_masses_[i];
        const bool is_wet = !fluids_.empty() && positions_m_[i].y < fluids_[i].level_m;
        if (!fluids_.empty()) passing_mps -= is_wet ? fluids_[i].flow_mps : fluids_[i].air_mps;
        density_kgpm3 +=
            is_wet ? fluids_[i].density_kgpm3 * fluids_[i].drag : def_.air_density_kgpm3;
    }
    passing_mps /= 4;
    // A quarter of it for each corner, solved over the sub-step with all else that acts in it, so that what is steady is exact.
    const double k_kgps = 0.5 * density_kgpm3 / 4 * def_.drag / 4 *
                          std::sqrt(area2 * glm::dot(passing_mps, passing_mps));
    const double quarter_kg = def_.density_kgpm2 * cell_m_[0] * cell_m_[1] / 4;
    const double slowed_kg = k_kgps * substep_s_ / (1 + k_kgps * substep_s_ / quarter_kg);
    return area * (glm::dot(passing_mps + changed_mps / 4.0, area) * slowed_kg / area2);
}

/// Each line takes exactly what its damping takes in the sub-step, never more than there is; forwards and backwards by half, which
/// keeps all of it together stable, too.
void Sheet::damp() {
    for (ThreadFamily& family : families_) family.measure(positions_m_);
    if (!(def_.damping_s > 0)) return;
    if (is_braced_) {
        for (ThreadFamily& family : families_) family.brace(braces_);
    }
    const double half_s2 = substep_s_ * def_.damping_s / 2;
    const double shear_kgm2 = def_.shear_Npm * cell_m_[0] * cell_m_[1] * half_s2 * stiffness_share_;
    const auto bend = [&](std::size_t axis) {
        if (bend_lag_s_ > 0) return;
        strips_[axis].relax(half_s2 * bend_share_, inverse_masses_, velocities_mps_);
    };
    for (ThreadFamily& family : families_)
        family.factor(half_s2 * stiffness_share_, inverse_masses_);
    const auto stretch = [&](std::size_t axis) {
        families_[axis].relax(inverse_masses_, velocities_mps_, impulses_Ns_);
    };
    for (const std::size_t axis : {0U, 1U}) bend(axis);
    for (const std::size_t axis : {0U, 1U}) stretch(axis);
    find_sheared(shear_kgm2);
    for (const ShearedCell& cell : sheared_) damp_shear(cell);
    for (auto cell = sheared_.rbegin(); cell != sheared_.rend(); ++cell) damp_shear(*cell);
    for (const std::size_t axis : {1U, 0U}) stretch(axis);
    for (const std::size_t axis : {1U, 0U}) bend(axis);
}

/// Of each row every other cell, then those between: one does not wait for the one before.
void Sheet::find_sheared(double stiff_kgm2) {
    sheared_.clear();
    for (std::uint32_t row = 0; row + 1 < rows_; ++row) {
        for (const std::uint32_t first : {0U, 1U}) {
            for (std::uint32_t column = first; column + 1 < columns_; column += 2) {
                if (torn_ == 0 || is_whole(column, row))
                    sheared_.push_back(sheared(at(column, row), stiff_kgm2));
            }
        }
    }
}

Sheet::ShearedCell Sheet::sheared(std::size_t top, double stiff_kgm2) const {
    const double inverse_m2 = 1 / (2 * cell_m_[0] * cell_m_[1]);
    const std::size_t below = top + columns_;
    const Vec3d e = (positions_m_[below + 1] - positions_m_[top]) * inverse_m2;
    const Vec3d f = (positions_m_[below] - positions_m_[top + 1]) * inverse_m2;
    const double weight = 1 / stiff_kgm2 +
                          (inverse_masses_[top] + inverse_masses_[below + 1]) * glm::dot(e, e) +
                          (inverse_masses_[below] + inverse_masses_[top + 1]) * glm::dot(f, f);
    return {.top = top, .e = e, .f = f, .inverse_weight = 1 / weight};
}

void Sheet::damp_shear(const ShearedCell& cell) {
    const std::size_t top = cell.top;
    const std::size_t below = top + columns_;
    const double opening = glm::dot(cell.e, velocities_mps_[below + 1] - velocities_mps_[top]) -
                           glm::dot(cell.f, velocities_mps_[below] - velocities_mps_[top + 1]);
    const double pull = -opening * cell.inverse_weight;
    push_at_once(top, cell.e * -pull);
    push_at_once(below + 1, cell.e * pull);
    push_at_once(below, cell.f * -pull);
    push_at_once(top + 1, cell.f * pull);
}

}  // namespace plumbline::physics
