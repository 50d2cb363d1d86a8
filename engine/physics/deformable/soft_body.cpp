#include "engine/physics/soft_body.h"

#include "engine/core/io/archive.h"
#include "engine/physics/force_field.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace plumbline::physics {
namespace {

/// The square of what a sub-step turns the fastest mode by; symplectic Euler bears 4, and 2 where damping leaves nothing of a speed.
constexpr double kMostSoft_rad2 = 1.8;
/// Of stiffness, what a body has at least: its weight shortens a column of its length by half of this part.
constexpr double kMostBySelf = 0.25;
constexpr double kMostForced = 1000;  ///< sub-steps
/// Conjugate gradients: of what damping does to velocities, the share that may be missing; and iterations, which are as dear as sub-steps.
constexpr double kUndamped = 0.02;
constexpr std::uint32_t kFewestIterations = 4;
constexpr std::uint32_t kMostIterations = 40;
/// Damping that lets what rings fall silent, in sub-steps; counted every fifth: the fastest mode may turn once in four, and would hide.
constexpr double kSoftFriction = 0.02;
constexpr std::uint32_t kRubsEvery = 5;

double sign_of(std::uint32_t point, std::size_t axis) {
    return (point >> axis & 1U) != 0 ? 1.0 : -1.0;
}

/// Columns are the derivatives of the determinant by the columns of `m`.
glm::dmat3 cofactors(const glm::dmat3& m) {
    return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
}

double square_sum(const glm::dmat3& m) {
    return glm::dot(m[0], m[0]) + glm::dot(m[1], m[1]) + glm::dot(m[2], m[2]);
}

}  // namespace

SoftBody::SoftBody(SoftBodyDef def)
    : def_(std::move(def)),
      shear_Pa_(def_.young_Pa / (2 * (1 + def_.poisson))),
      volume_Pa_(def_.young_Pa * def_.poisson / ((1 + def_.poisson) * (1 - 2 * def_.poisson)) +
                 shear_Pa_) {
    std::vector<double> masses_kg(def_.grid.points_m.size(), 0.0);
    for (std::size_t i = 0; i < def_.grid.cells.size(); ++i) {
        cells_.push_back(cell_of(i));
        for (const std::uint32_t point : def_.grid.cells[i])
            masses_kg[point] += def_.density_kgpm3 * cells_.back().volume_m3 / 8;
    }
    for (std::size_t i = 0; i < masses_kg.size(); ++i)
        add_point(def_.grid.points_m[i], masses_kg[i]);
    const auto [low_m, high_m] = bounds_of(def_.grid.points_m);
    const Vec3d size_m = high_m - low_m;
    const double longest_m = std::max({size_m.x, size_m.y, size_m.z});
    least_share_ = std::min(
        1.0,
        def_.density_kgpm3 * kStandardGravity_mps2 * longest_m / (kMostBySelf * def_.young_Pa));
    for (const SoftGrid::Face& face : def_.grid.faces) {
        for (std::size_t i = 0; i < 4; ++i)
            longest_side_m_ = std::max(longest_side_m_,
                                       glm::distance(positions_m_[face.points[i]],
                                                     positions_m_[face.points[(i + 1) % 4]]));
    }
}

SoftBody::Cell SoftBody::cell_of(std::size_t number) const {
    Cell cell;
    std::array<Vec3d, 8> at{};
    for (std::uint32_t i = 0; i < 8; ++i) at[i] = def_.grid.points_m[def_.grid.cells[number][i]];
    glm::dmat3 jacobian{0.0};  // columns: half of the cell's mean sides
    for (std::uint32_t i = 0; i < 8; ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            jacobian[static_cast<int>(axis)] += at[i] * (sign_of(i, axis) / 8);
    }
    cell.volume_m3 = 8 * glm::determinant(jacobian);
    const glm::dmat3 inverse = glm::transpose(glm::inverse(jacobian));
    std::array<double, 3> side_m{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Vec3d half = jacobian[static_cast<int>(axis)];
        side_m[axis] = 2 * glm::length(half);
        cell.axes[axis] = glm::normalize(half);
    }
    for (std::uint32_t i = 0; i < 8; ++i)
        cell.gradients_pm[i] = inverse * (Vec3d{sign_of(i, 0), sign_of(i, 1), sign_of(i, 2)} / 8.0);
    // Four points to each side of every plane: the gradient of the fastest wave (Flanagan and Belytschko 1984).
    for (const Vec3d& gradient : cell.gradients_pm)
        cell.steepest_pm2 += 8 * glm::dot(gradient, gradient);
    // Plane stress: what bends contracts across itself, as it likes along the way in which strain grows.
    const double plate_N = 4.0 / 3 * def_.young_Pa / (1 - def_.poisson * def_.poisson);
    for (std::size_t axis = 0; axis < 3; ++axis)
        cell.contraction_Npm[axis] = def_.poisson * plate_N * cell.volume_m3 /
                                     (side_m[(axis + 1) % 3] * side_m[(axis + 2) % 3]);
    for (std::size_t mode = 0; mode < 4; ++mode) {
        const auto is_in = [mode](std::size_t axis) { return mode == 3 || axis != mode; };
        std::array<double, 8> shape{};
        Vec3d uniform{0, 0, 0};
        for (std::uint32_t i = 0; i < 8; ++i) {
            shape[i] = 1;
            for (std::size_t axis = 0; axis < 3; ++axis)
                shape[i] *= is_in(axis) ? sign_of(i, axis) : 1;
            uniform += at[i] * shape[i];
        }
        for (std::uint32_t i = 0; i < 8; ++i)
            cell.modes[mode][i] = (shape[i] - glm::dot(uniform, cell.gradients_pm[i])) / 8;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double side2 = side_m[axis] * side_m[axis];
            double& stiffness = cell.mode_Npm[mode][axis];
            if (mode == 3) {
                stiffness = 4.0 / 9 * def_.young_Pa * cell.volume_m3 / side2;
            } else if (axis != mode) {  // bends: strain along the axis grows across it
                stiffness = plate_N * cell.volume_m3 / side2;
            } else {  // twists
                const double j = side_m[(axis + 1) % 3];
                const double k = side_m[(axis + 2) % 3];
                stiffness = 2.0 / 3 * shear_Pa_ * cell.volume_m3 * (1 / (j * j) + 1 / (k * k));
            }
        }
    }
    return cell;
}

SoftBody::Modes SoftBody::pulls_of(const Cell& cell, const Modes& bent_m) const {
    Modes pulls_N{};
    for (std::size_t mode = 0; mode < 4; ++mode) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            pulls_N[mode][axis] = cell.mode_Npm[mode][axis] * bent_m[mode][axis];
    }
    for (std::size_t across = 0; across < 3; ++across) {
        const std::size_t i = (across + 1) % 3;
        const std::size_t j = (across + 2) % 3;
        pulls_N[j][i] += cell.contraction_Npm[across] * bent_m[i][j];
        pulls_N[i][j] += cell.contraction_Npm[across] * bent_m[j][i];
    }
    return pulls_N;
}

SoftBody::Strain SoftBody::strain_of(std::size_t number, const std::vector<Vec3d>& of) const {
    const Cell& cell = cells_[number];
    Strain strain{.gradient = glm::dmat3{0.0}, .modes_m = {}};
    strain.modes_m.fill(Vec3d{0, 0, 0});
    for (std::size_t i = 0; i < 8; ++i) {
        const Vec3d& at = of[def_.grid.cells[number][i]];
        for (int axis = 0; axis < 3; ++axis)
            strain.gradient[axis] += at * cell.gradients_pm[i][axis];
        for (std::size_t mode = 0; mode < 4; ++mode)
            strain.modes_m[mode] += at * cell.modes[mode][i];
    }
    return strain;
}

std::uint32_t SoftBody::plan(double seconds, std::uint32_t most) {
    // Of the second derivative of the energy by the volume's part, over lambda.
    double squeezed = 1;
    const double rest = 1 + shear_Pa_ / volume_Pa_;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
        const glm::dmat3 f = strain_of(i, positions_m_).gradient;
        const glm::dmat3 by_volume = cofactors(f);
        const double away = std::abs(glm::dot(f[0], by_volume[0]) - rest);
        const double bound = square_sum(by_volume) / 3 +
                             std::max(0.0, away * std::sqrt(square_sum(f) / 3) - (rest - 1));
        squeezed = std::max(squeezed, bound);
    }
    const double wave_m2ps2 =
        ((volume_Pa_ - shear_Pa_) * squeezed + 2 * shear_Pa_ + def_.young_Pa / 3) /
        def_.density_kgpm3;
    const double steepest_pm2 =
        std::ranges::max_element(cells_, {}, &Cell::steepest_pm2)->steepest_pm2;
    const double wanted =
        std::ceil(seconds * std::sqrt(wave_m2ps2 * steepest_pm2 / kMostSoft_rad2));
    // What could not carry itself would turn inside out.
    const double fewest = std::min(std::ceil(wanted * std::sqrt(least_share_)), kMostForced);
    const std::uint32_t count =
        take_substeps(seconds, wanted, std::max(most, static_cast<std::uint32_t>(fewest)));
    damping_ = wave_m2ps2 * steepest_pm2 * substep_s_ * def_.damping_s;
    iterations_ = std::clamp(most / count, kFewestIterations, kMostIterations);
    const double bearable_pm2 = kMostSoft_rad2 / (wave_m2ps2 * substep_s_ * substep_s_);
    double borne_m3 = 0;
    double all_m3 = 0;
    for (Cell& cell : cells_) {
        cell.share = count < wanted ? std::min(1.0, bearable_pm2 / cell.steepest_pm2) : 1;
        borne_m3 += cell.share * cell.volume_m3;
        all_m3 += cell.volume_m3;
    }
    stiffness_share_ = borne_m3 / all_m3;
    return count;
}

/// Velocities become (1 + h d W K)^-1 times what they are, K the stiffness of the cells as they are deformed now, by conjugate
/// gradients in the product of momenta. Whichever iteration they end with, momentum and angular momentum are kept.
void SoftBody::damp() {
    strains_.resize(cells_.size());
    for (std::size_t i = 0; i < cells_.size(); ++i) strains_[i] = strain_of(i, positions_m_);
    if (!(def_.damping_s > 0)) return;
    const std::size_t count = positions_m_.size();
    const auto product = [&](const std::vector<Vec3d>& a, const std::vector<Vec3d>& b) {
        double sum = 0;
        for (std::size_t i = 0; i < count; ++i) sum += masses_kg_[i] * glm::dot(a[i], b[i]);
        return sum;
    };
    damp_against(velocities_mps_);
    residual_mps_.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        residual_mps_[i] = -yielded_mps(i);
        impulses_Ns_[i] -= held_Ns(i);
    }
    search_mps_ = residual_mps_;
    double left = product(residual_mps_, residual_mps_);
    const double enough = kUndamped * kUndamped * left;
    for (std::uint32_t k = 0; k < iterations_ && left > enough; ++k) {
        damp_against(search_mps_);
        image_mps_.resize(count);
        for (std::size_t i = 0; i < count; ++i) image_mps_[i] = search_mps_[i] + yielded_mps(i);
        const double length = left / product(search_mps_, image_mps_);
        for (std::size_t i = 0; i < count; ++i) {
            velocities_mps_[i] += search_mps_[i] * length;
            residual_mps_[i] -= image_mps_[i] * length;
            impulses_Ns_[i] -= held_Ns(i) * length;
        }
        const double before = std::exchange(left, product(residual_mps_, residual_mps_));
        for (std::size_t i = 0; i < count; ++i)
            search_mps_[i] = residual_mps_[i] + search_mps_[i] * (left / before);
    }
}

/// Sets damped_Ns_ to what damping takes in a sub-step from points that move so.
void SoftBody::damp_against(const std::vector<Vec3d>& velocities_mps) {
    damped_Ns_.assign(velocities_mps.size(), Vec3d{0});
    for (std::size_t number = 0; number < cells_.size(); ++number) {
        Load load{.stress_Nm = glm::dmat3{0.0}, .pulls_N = {}};
        load.pulls_N.fill(Vec3d{0});
        add_damping(cells_[number],
                    strains_[number],
                    strain_of(number, velocities_mps),
                    def_.damping_s,
                    load);
        spread(number, load, substep_s_, damped_Ns_);
    }
}

void SoftBody::spread(std::size_t number,
                      const Load& load,
                      double seconds,
                      std::vector<Vec3d>& impulses_Ns) const {
    const Cell& cell = cells_[number];
    const std::array<std::uint32_t, 8>& points = def_.grid.cells[number];
    for (std::size_t i = 0; i < 8; ++i) {
        Vec3d force = load.stress_Nm * cell.gradients_pm[i];
        for (std::size_t mode = 0; mode < 4; ++mode)
            force += load.pulls_N[mode] * cell.modes[mode][i];
        impulses_Ns[points[i]] += force * seconds;
    }
}

void SoftBody::add_forces() {
    // What rings loses a little, now and then.
    const bool rubs = ++substep_ % kRubsEvery == 0;
    for (std::size_t number = 0; number < cells_.size(); ++number) {
        const Cell& cell = cells_[number];
        const Strain& strain = strains_[number];
        Load load = elastic_load(cell, strain);
        if (rubs)
            add_damping(cell,
                        strain,
                        strain_of(number, velocities_mps_),
                        kRubsEvery * kSoftFriction * substep_s_,
                        load);
        spread(number, load, -substep_s_ * cell.share, impulses_Ns_);
    }
    if (!fluids_.empty()) add_water();
}

/// The first Piola-Kirchhoff stress, times the volume, and what the modes add.
SoftBody::Load SoftBody::elastic_load(const Cell& cell, const Strain& strain) const {
    const glm::dmat3& f = strain.gradient;
    const glm::dmat3 by_volume = cofactors(f);
    const double grown = glm::dot(f[0], by_volume[0]) - 1 - shear_Pa_ / volume_Pa_;
    Load load{.stress_Nm = f * (shear_Pa_ * cell.volume_m3) +
                           by_volume * (volume_Pa_ * grown * cell.volume_m3),
              .pulls_N = {}};
    Modes bent_m{};
    for (std::size_t mode = 0; mode < 4; ++mode) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            bent_m[mode][axis] = glm::dot(f * cell.axes[axis], strain.modes_m[mode]);
    }
    add_modes(cell, strain, pulls_of(cell, bent_m), load);
    return load;
}

/// As large as the elastic forces that the rates of strain and of bending would make in `lost_s`.
void SoftBody::add_damping(
    const Cell& cell, const Strain& strain, const Strain& rate, double lost_s, Load& load) const {
    const glm::dmat3& f = strain.gradient;
    const glm::dmat3 opening = glm::transpose(f) * rate.gradient;
    const glm::dmat3 green_ps = (opening + glm::transpose(opening)) * 0.5;
    const double trace_ps = green_ps[0][0] + green_ps[1][1] + green_ps[2][2];
    const double lame_Pa = volume_Pa_ - shear_Pa_;
    load.stress_Nm += f * (green_ps * (2 * shear_Pa_) + glm::dmat3(lame_Pa * trace_ps)) *
                      (lost_s * cell.volume_m3);
    Modes bent_m{};
    for (std::size_t mode = 0; mode < 4; ++mode) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            bent_m[mode][axis] =
                lost_s * (glm::dot(f * cell.axes[axis], rate.modes_m[mode]) +
                          glm::dot(rate.gradient * cell.axes[axis], strain.modes_m[mode]));
    }
    add_modes(cell, strain, pulls_of(cell, bent_m), load);
}

/// The modes turn with the cell's axes, which pulls at these, too.
void SoftBody::add_modes(const Cell& cell, const Strain& strain, const Modes& pulls_N, Load& load) {
    for (std::size_t mode = 0; mode < 4; ++mode) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            load.pulls_N[mode] += strain.gradient * cell.axes[axis] * pulls_N[mode][axis];
            load.stress_Nm +=
                glm::outerProduct(strain.modes_m[mode] * pulls_N[mode][axis], cell.axes[axis]);
        }
    }
}

void SoftBody::serialize_own(Archive& archive) {
    archive(substep_);
}

double SoftBody::elastic_J() const {
    const double rest = 1 + shear_Pa_ / volume_Pa_;
    const double at_rest = volume_Pa_ / 2 * (1 - rest) * (1 - rest);
    double sum = 0;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
        const auto [f, modes_m] = strain_of(i, positions_m_);
        const double volume = glm::determinant(f);
        double cell_J =
            cells_[i].volume_m3 * (shear_Pa_ / 2 * (square_sum(f) - 3) +
                                   volume_Pa_ / 2 * (volume - rest) * (volume - rest) - at_rest);
        Modes bent_m{};
        for (std::size_t mode = 0; mode < 4; ++mode) {
            for (std::size_t axis = 0; axis < 3; ++axis)
                bent_m[mode][axis] = glm::dot(f * cells_[i].axes[axis], modes_m[mode]);
        }
        const Modes pulls_N = pulls_of(cells_[i], bent_m);
        for (std::size_t mode = 0; mode < 4; ++mode) {
            for (std::size_t axis = 0; axis < 3; ++axis)
                cell_J += pulls_N[mode][axis] * bent_m[mode][axis] / 2;
        }
        sum += cells_[i].share * cell_J;
    }
    return sum;
}

}  // namespace plumbline::physics
