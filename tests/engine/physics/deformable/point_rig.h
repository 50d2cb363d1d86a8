// Steps and displacements of a body made of points, for tests.
#pragma once

#include "engine/physics/point_body.h"

#include <cstddef>
#include <cstdint>

namespace plumbline::physics {

inline constexpr double kPointStep_s = 1.0 / 60;

/// Of each step's motion `kept` is left.
inline void run_points(PointBody& body,
                       int steps,
                       const Vec3d& gravity_mps2,
                       std::uint32_t most = 1000,
                       double kept = 1) {
    for (int i = 0; i < steps; ++i) {
        const std::uint32_t count = body.plan(kPointStep_s, most);
        for (std::uint32_t k = 0; k < count; ++k) {
            body.accelerate(gravity_mps2);
            body.move(body.substep_s());
        }
        if (kept != 1) slow_down(body, kept);
    }
}

/// At rest, by what `by_m` says of each point's place.
template <class F>
void displace_points(PointBody& body, const F& by_m) {
    constexpr double kAtOnce_s = 1e-6;
    body.plan(kAtOnce_s, 1);
    for (std::size_t i = 0; i < body.positions_m().size(); ++i)
        body.change_velocity(i, by_m(body.positions_m()[i]) / kAtOnce_s);
    body.move(body.substep_s());
    slow_down(body, 0);
}

}  // namespace plumbline::physics
