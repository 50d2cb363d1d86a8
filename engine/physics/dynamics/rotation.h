// Turning by a spin for a while. Knows nothing of Bullet.
#pragma once

#include "engine/core/math.h"

#include <algorithm>
#include <cmath>

namespace plumbline::physics {

/// The rotation that a constant spin makes in `duration_s`: the exponential map.
template <class T>
glm::qua<T> turn_by(const glm::vec<3, T>& spin_radps, T duration_s) {
    const T rate = glm::length(spin_radps);
    const T half = T(0.5) * rate * duration_s;
    // By their series where sin(x)/x would lose digits: most bodies turn that slowly.
    if (half < T(1e-3)) {
        const T scale = T(0.5) * duration_s * (1 - half * half / 6);
        return {
            1 - half * half / 2, spin_radps.x * scale, spin_radps.y * scale, spin_radps.z * scale};
    }
    const T scale = portable_sin(half) / rate;
    return {portable_cos(half), spin_radps.x * scale, spin_radps.y * scale, spin_radps.z * scale};
}

/// Torque-free turning of a rigid body for `duration_s` that keeps the angular momentum: the spin
/// is what the momentum means at the orientation reached. Fourth order: Celledoni, Marthinsen and
/// Owren's commutator-free scheme (2003), whose stages are turns and never leave the unit
/// quaternions. Long or fast turns are followed in pieces; bodies so thin that no piece is short
/// enough by turns about their own axes.
struct FreeTurn {
    Quatd orientation{1, 0, 0, 0};  ///< world from body
    Vec3d spin_radps{0, 0, 0};      ///< world axes
};
FreeTurn turned_freely(const FreeTurn& start, const Vec3d& inertia_kgm2, double duration_s);

}  // namespace plumbline::physics
