#include "engine/physics/deformable/point_body.h"

#include "engine/core/io/archive.h"
#include "engine/core/io/pose_archive.h"

#include <algorithm>
#include <numeric>

namespace plumbline::physics {

void PointBody::add_point(const Vec3d& position_m, double mass_kg) {
    positions_m_.push_back(position_m);
    velocities_mps_.emplace_back(0, 0, 0);
    impulses_Ns_.emplace_back(0, 0, 0);
    masses_kg_.push_back(mass_kg);
    inverse_masses_.push_back(1 / mass_kg);
}

double PointBody::mass_kg() const {
    return std::accumulate(masses_kg_.begin(), masses_kg_.end(), 0.0);
}

void PointBody::accelerate(const Vec3d& gravity_mps2) {
    for (std::size_t i = 0; i < masses_kg_.size(); ++i)
        impulses_Ns_[i] = gravity_mps2 * (masses_kg_[i] * substep_s_);
    add_forces();
    for (std::size_t i = 0; i < masses_kg_.size(); ++i)
        velocities_mps_[i] += impulses_Ns_[i] * (inverse_masses_[i] * weight_of(i));
    damp();
}

void PointBody::slow_down(double share) {
    for (Vec3d& velocity : velocities_mps_) velocity *= share;
}

void PointBody::move() {
    for (std::size_t i = 0; i < positions_m_.size(); ++i)
        positions_m_[i] += velocities_mps_[i] * substep_s_;
    after_move();
}

Vec3d PointBody::moment_kgm() const {
    Vec3d sum{0, 0, 0};
    for (std::size_t i = 0; i < masses_kg_.size(); ++i) sum += positions_m_[i] * masses_kg_[i];
    return sum;
}

Vec3d PointBody::momentum_kgmps() const {
    Vec3d sum{0, 0, 0};
    for (std::size_t i = 0; i < masses_kg_.size(); ++i) sum += velocities_mps_[i] * masses_kg_[i];
    return sum;
}

Vec3d PointBody::angular_momentum_kgm2ps() const {
    Vec3d sum{0, 0, 0};
    for (std::size_t i = 0; i < masses_kg_.size(); ++i)
        sum += glm::cross(positions_m_[i], velocities_mps_[i] * masses_kg_[i]);
    return sum;
}

double PointBody::kinetic_J() const {
    double sum = 0;
    for (std::size_t i = 0; i < masses_kg_.size(); ++i)
        sum += 0.5 * masses_kg_[i] * glm::dot(velocities_mps_[i], velocities_mps_[i]);
    return sum;
}

void PointBody::serialize(Archive& archive) {
    archive(positions_m_, velocities_mps_, inverse_masses_);
    serialize_own(archive);
}

}  // namespace plumbline::physics
