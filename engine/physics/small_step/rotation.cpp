#include "engine/physics/small_step/rotation.h"

namespace plumbline::physics {
namespace {

/// Spins are followed in pieces of at most this turn: a top at 300 rad/s turns 5 rad in a step.
constexpr double kTurnPerPiece_rad = 0.1;
constexpr double kMaxTurnPieces = 128;

template <class SpinAt>
Quatd turned_once(const Quatd& q, double h, const SpinAt& spin_at) {
    const Vec3d k1 = spin_at(q);
    const Quatd q2 = turn_by(k1, 0.5 * h) * q;
    const Vec3d k2 = spin_at(q2);
    const Vec3d k3 = spin_at(turn_by(k2, 0.5 * h) * q);
    const Vec3d k4 = spin_at(turn_by(k3 - 0.5 * k1, h) * q2);
    const Quatd first = turn_by((3.0 * k1 + 2.0 * k2 + 2.0 * k3 - k4) / 12.0, h) * q;
    return glm::normalize(turn_by((-k1 + 2.0 * k2 + 2.0 * k3 + 3.0 * k4) / 12.0, h) * first);
}

}  // namespace

FreeTurn turned_freely(const FreeTurn& start, const Vec3d& inertia_kgm2, double duration_s) {
    Quatd q = start.orientation;
    const Vec3d momentum = q * (inertia_kgm2 * (glm::conjugate(q) * start.spin_radps));
    const auto spin_at = [&](const Quatd& turned_to) {
        return turned_to * ((glm::conjugate(turned_to) * momentum) / inertia_kgm2);
    };
    const double turn_rad = glm::length(start.spin_radps) * duration_s;
    const double pieces = std::clamp(std::ceil(turn_rad / kTurnPerPiece_rad), 1.0, kMaxTurnPieces);
    for (int i = 0; i < static_cast<int>(pieces); ++i) {
        q = turned_once(q, duration_s / pieces, spin_at);
    }
    return {q, spin_at(q)};
}

}  // namespace plumbline::physics
