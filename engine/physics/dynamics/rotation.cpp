#include "engine/physics/dynamics/rotation.h"

namespace plumbline::physics {
namespace {

// Turning is a quarter of a light step: [[gnu::flatten]] inlines the products of quaternions, which the
// compiler leaves as calls where a source has many of them.

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

/// Faster than this in a piece, by the smallest moment, the scheme above is not stable.
constexpr double kStiffTurn_rad = 0.5;

/// A top in its own axes.
struct Top {
    Quatd orientation;
    Vec3d momentum_body;

    /// The turn about a body axis that the energy c L_axis^2 / 2 makes; exact.
    void turn_about(int axis, double per_moment, double duration_s) {
        Vec3d spin{0, 0, 0};
        spin[axis] = per_moment * momentum_body[axis];
        const Quatd turn = turn_by(spin, duration_s);
        orientation = orientation * turn;
        momentum_body = glm::conjugate(turn) * momentum_body;
    }
    /// That of the energy L^2 c / 2: about the momentum.
    void turn_about_momentum(double per_moment, double duration_s) {
        orientation = turn_by(orientation * (momentum_body * per_moment), duration_s) * orientation;
    }
};

/// By turns about the body's axes (McLachlan and Quispel, Splitting methods, 2002): exact for a top
/// with two equal moments however thin it is; second order in how far they differ.
[[gnu::flatten]] FreeTurn turned_by_splitting(const FreeTurn& start,
                                              const Vec3d& inertia_kgm2,
                                              double duration_s) {
    const Vec3d inverse = 1.0 / inertia_kgm2;
    int own = 0;  // the axis that differs most
    for (int k = 1; k < 3; ++k) {
        const auto apart = [&](int i) {
            return std::abs(2 * inverse[i] - inverse[(i + 1) % 3] - inverse[(i + 2) % 3]);
        };
        if (apart(k) > apart(own)) own = k;
    }
    const int b = (own + 1) % 3;
    const int c = (own + 2) % 3;
    const double across = 0.5 * (inverse[b] + inverse[c]);
    const double uneven = 0.5 * (inverse[b] - inverse[c]);
    Top top{start.orientation,
            inertia_kgm2 * (glm::conjugate(start.orientation) * start.spin_radps)};
    const double uneven_rad = std::abs(uneven) * glm::length(top.momentum_body) * duration_s;
    const double pieces =
        std::clamp(std::ceil(uneven_rad / kTurnPerPiece_rad), 1.0, kMaxTurnPieces);
    const double h = duration_s / pieces;
    const auto half_of_uneven = [&] {
        top.turn_about(b, uneven, h / 4);
        top.turn_about(c, -uneven, h / 2);
        top.turn_about(b, uneven, h / 4);
    };
    for (int i = 0; i < static_cast<int>(pieces); ++i) {
        half_of_uneven();
        top.turn_about(own, inverse[own] - across, h);
        top.turn_about_momentum(across, h);
        half_of_uneven();
    }
    const Quatd q = glm::normalize(top.orientation);
    return {q, q * (top.momentum_body * inverse)};
}

}  // namespace

[[gnu::flatten]] FreeTurn turned_freely(const FreeTurn& start,
                                        const Vec3d& inertia_kgm2,
                                        double duration_s) {
    Quatd q = start.orientation;
    const Vec3d momentum = q * (inertia_kgm2 * (glm::conjugate(q) * start.spin_radps));
    const auto spin_at = [&](const Quatd& turned_to) {
        return turned_to * ((glm::conjugate(turned_to) * momentum) / inertia_kgm2);
    };
    const double turn_rad = glm::length(start.spin_radps) * duration_s;
    const double pieces = std::clamp(std::ceil(turn_rad / kTurnPerPiece_rad), 1.0, kMaxTurnPieces);
    const double least = std::min({inertia_kgm2.x, inertia_kgm2.y, inertia_kgm2.z});
    if (glm::length(momentum) * duration_s > kStiffTurn_rad * least * pieces)
        return turned_by_splitting(start, inertia_kgm2, duration_s);
    for (int i = 0; i < static_cast<int>(pieces); ++i) {
        q = turned_once(q, duration_s / pieces, spin_at);
    }
    return {q, spin_at(q)};
}

}  // namespace plumbline::physics
