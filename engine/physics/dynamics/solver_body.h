// A body as the small-step solver sees it during one step. Knows nothing of Bullet.
#pragma once

#include "engine/core/math.h"

#include <cstdint>
#include <span>

namespace plumbline::physics {

/// A symmetric 3x3 matrix by its six numbers.
struct SymmetricMat3 {
    Real xx{0}, xy{0}, xz{0}, yy{0}, yz{0}, zz{0};

    [[gnu::always_inline]] Vec3 operator*(const Vec3& v) const {
        return {xx * v.x + xy * v.y + xz * v.z,
                xy * v.x + yy * v.y + yz * v.z,
                xz * v.x + yz * v.y + zz * v.z};
    }
};

inline constexpr Real kLeastTurn_rad = 1e-4_r;
inline constexpr Real kMostTurn_rad = 0.4_r;

/// How far a body turned since the step's start, to and fro.
struct BodyTurn {
    Real total_rad{0};
    Real weighed_rad{0};  ///< when the masses of its contacts were those of its pose
    bool is_far{false};   ///< in this sub-step: they are others now
};

/// 256 bytes (float32), of which a contact sweep reads the first 52 (velocities and masses) and, for
/// where points have moved to, the change of pose behind them. Velocities are of the centre of mass,
/// world axes. Positions are changes since the step's start, so that float32 keeps its digits far
/// from the origin; the pose at the start is in double precision.
struct alignas(64) SolverBody {
    Vec3 velocity_mps{0, 0, 0};
    Real inverse_mass{0};  ///< 1/kg; 0: static or kinematic
    Vec3 spin_radps{0, 0, 0};
    SymmetricMat3 inverse_inertia{};  ///< world axes, 1/(kg m2)

    Vec3 delta_position_m{0, 0, 0};  ///< centre of mass, since the step's start
    Quat delta_rotation{
        kNoRotation};  ///< since the step's start: world_from_body = delta_rotation * start
    Vec3 acceleration_mps2{0, 0, 0};            ///< gravity and the callers' forces
    Vec3 angular_acceleration_radps2{0, 0, 0};  ///< the callers' torques

    /// What gravity, callers' forces and the impulses of the sub-step before (warm start) change in
    /// this sub-step: forces that act all along it, so that positions take half of their effect.
    Vec3 velocity_increment_mps{0, 0, 0};
    Vec3 spin_increment_radps{0, 0, 0};
    Real linear_damping_factor{1};  ///< share of speed that damping leaves after a sub-step
    Real angular_damping_factor{1};

    /// The pose at the step's start and what the inertia is made from, in double precision.
    Vec3d start_position_m{0, 0, 0};
    Quatd start_orientation{1, 0, 0, 0};
    Vec3d inertia_kgm2{0, 0, 0};  ///< principal, body axes; 0: immovable
    bool depenetrated{false};     ///< deep penetration pushed it in this step
    Real start_speed_mps{0};
    bool isotropic_inertia{true};  ///< all three moments equal: inverse_inertia never changes
    bool jointed{false};           ///< movable, and a joint holds it
    BodyTurn turned{};

    /// Whether so far that its arms point elsewhere, and not so far that it touches with other points than were found.
    bool has_turned() const {
        return turned.total_rad > kLeastTurn_rad && turned.total_rad < kMostTurn_rad;
    }
    bool movable() const { return inverse_mass > 0; }
    double mass_kg() const { return 1 / static_cast<double>(inverse_mass); }  ///< of a movable one
    [[gnu::always_inline]] Vec3 velocity_at(const Vec3& arm) const {
        return velocity_mps + glm::cross(spin_radps, arm);
    }
    /// By how much a unit impulse at `arm` along `direction` changes the velocity there along it, 1/kg.
    Real inverse_mass_along(const Vec3& arm, const Vec3& direction) const {
        const Vec3 turn = glm::cross(arm, direction);
        return inverse_mass + glm::dot(turn, inverse_inertia * turn);
    }
    /// `arm` from the centre of mass, world axes.
    void push(const Vec3& impulse_Ns, const Vec3& arm) {
        velocity_mps += impulse_Ns * inverse_mass;
        spin_radps += inverse_inertia * glm::cross(arm, impulse_Ns);
    }
};

/// Of the movable ones, relative to a centre that moves so fast.
inline double kinetic_J(std::span<const SolverBody> bodies, const Vec3d& center_mps) {
    double sum = 0;
    for (const SolverBody& body : bodies) {
        if (!body.movable()) continue;
        const Vec3d v = Vec3d(body.velocity_mps) - center_mps;
        const Vec3d spin = glm::conjugate(Quatd(body.delta_rotation) * body.start_orientation) *
                           Vec3d(body.spin_radps);
        sum += 0.5 * (body.mass_kg() * glm::dot(v, v) + glm::dot(body.inertia_kgm2 * spin, spin));
    }
    return sum;
}

/// Index of the body that stands for the static world in every island's array: never moves.
inline constexpr std::uint32_t kWorldBody = 0;

}  // namespace plumbline::physics
