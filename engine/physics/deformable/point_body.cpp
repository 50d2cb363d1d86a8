#include "engine/physics/point_body.h"

#include "engine/core/io/archive.h"
#include "engine/core/io/pose_archive.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace plumbline::physics {
namespace {

constexpr double kMostSpeed_mps = 1e4;
constexpr double kMostPlace_m = 1e6;

}  // namespace

void PointBody::add_point(const Vec3d& position_m, double mass_kg) {
    positions_m_.push_back(position_m);
    velocities_mps_.emplace_back(0, 0, 0);
    impulses_Ns_.emplace_back(0, 0, 0);
    braces_.emplace_back(0, 0, 0);
    masses_kg_.push_back(mass_kg);
    inverse_masses_.push_back(1 / mass_kg);
}

double PointBody::mass_kg() const {
    return std::accumulate(masses_kg_.begin(), masses_kg_.end(), 0.0);
}

void PointBody::accelerate(const Vec3d& gravity_mps2) {
    for (std::size_t i = 0; i < masses_kg_.size(); ++i)
        impulses_Ns_[i] = gravity_mps2 * (masses_kg_[i] * substep_s_);
    damp();
    if (std::exchange(is_braced_, false)) std::ranges::fill(braces_, Vec3d{0, 0, 0});
    add_forces();
    for (std::size_t i = 0; i < masses_kg_.size(); ++i)
        velocities_mps_[i] += impulses_Ns_[i] * (inverse_masses_[i] * weight_of(i));
}

std::uint32_t PointBody::take_substeps(double seconds, double wanted, std::uint32_t most) {
    const double allowed = std::max(most, 1U);
    const auto count =
        static_cast<std::uint32_t>(wanted < allowed ? std::max(wanted, 1.0) : allowed);
    substep_s_ = seconds / count;
    stiffness_share_ = 1;
    return count;
}

void PointBody::move(double seconds) {
    for (std::size_t i = 0; i < positions_m_.size(); ++i)
        positions_m_[i] += velocities_mps_[i] * seconds;
    after_move();
}

bool PointBody::is_sound() const {
    // Also false where a number is none.
    const auto is_good = [](const Vec3d& v, double most) { return glm::dot(v, v) < most * most; };
    return std::ranges::all_of(positions_m_,
                               [&](const Vec3d& at) { return is_good(at, kMostPlace_m); }) &&
           std::ranges::all_of(velocities_mps_,
                               [&](const Vec3d& v) { return is_good(v, kMostSpeed_mps); });
}

void PointBody::put_back(std::span<const Vec3d> positions_m) {
    std::ranges::copy(positions_m, positions_m_.begin());
    std::ranges::fill(velocities_mps_, Vec3d{0, 0, 0});
}

PointTotals PointBody::totals() const {
    PointTotals sum{.elastic_J = elastic_J(), .water_J = water_J(), .displaced_m3 = displaced_m3()};
    for (std::size_t i = 0; i < masses_kg_.size(); ++i) {
        const Vec3d momentum_kgmps = velocities_mps_[i] * masses_kg_[i];
        sum.moment_kgm += positions_m_[i] * masses_kg_[i];
        sum.momentum_kgmps += momentum_kgmps;
        sum.angular_momentum_kgm2ps += glm::cross(positions_m_[i], momentum_kgmps);
        sum.kinetic_J += 0.5 * glm::dot(momentum_kgmps, velocities_mps_[i]);
    }
    return sum;
}

void PointBody::serialize(Archive& archive) {
    archive(positions_m_, velocities_mps_, inverse_masses_, braces_, is_braced_);
    const std::size_t count = masses_kg_.size();
    if (archive.expect(positions_m_.size() == count && velocities_mps_.size() == count &&
                           inverse_masses_.size() == count && braces_.size() == count,
                       "a deforming body has other points"))
        serialize_own(archive);
}

PointBounds bounds_of(std::span<const Vec3d> points_m) {
    PointBounds bounds{points_m.front(), points_m.front()};
    for (const Vec3d& at : points_m) {
        bounds.low_m = glm::min(bounds.low_m, at);
        bounds.high_m = glm::max(bounds.high_m, at);
    }
    return bounds;
}

double fastest_mps(std::span<const Vec3d> velocities_mps) {
    double fastest2 = 0;
    for (const Vec3d& v : velocities_mps) fastest2 = std::max(fastest2, glm::dot(v, v));
    return std::sqrt(fastest2);
}

void lead(PointBody& body, std::size_t point, const Vec3d& velocity_mps) {
    body.change_velocity(point, velocity_mps - body.velocities_mps()[point]);
}

void slow_down(PointBody& body, double share) {
    for (std::size_t i = 0; i < body.velocities_mps().size(); ++i)
        lead(body, i, body.velocities_mps()[i] * share);
}

}  // namespace plumbline::physics
