// A spring and damper as numbers of a velocity constraint.
#pragma once

#include "engine/core/math.h"

namespace plumbline::physics {

/// How a row gives way. A soft row's impulse changes by
///     -mass * (mass_share * relative_velocity + mass_share * bias_per_s * error) - decay * impulse
/// which is implicit Euler for a spring-damper between the two bodies (Catto, Soft Constraints,
/// GDC 2011; docs/PHYSICS.md). Rigid: bias 1/h, share 1, decay 0.
struct Softness {
    Real bias_per_s{0};
    Real mass_share{1};
    Real decay{0};
};

/// `frequency_hz` and `damping_ratio` of the spring; `h` the sub-step in seconds.
inline Softness softness_of(Real frequency_hz, Real damping_ratio, Real h) {
    const Real omega = 2 * kPi * frequency_hz;
    const Real a1 = 2 * damping_ratio + h * omega;
    const Real a2 = h * omega * a1;
    return {.bias_per_s = omega / a1, .mass_share = a2 / (1 + a2), .decay = 1 / (1 + a2)};
}

}  // namespace plumbline::physics
