// Bodies that nothing touches and that do not turn.
#pragma once

#include "engine/study/scenarios/world/scenario_world.h"

namespace plumbline::study {

/// Where a body is that left `from_m` at `velocity_mps` a time `t_s` ago and falls.
Vec3d thrown_m(const Vec3d& from_m, const Vec3d& velocity_mps, double t_s);

/// A01: a ball leaves the origin at 3 m/s along and 10 m/s up. Nothing is in its way.
struct ThrownBall {
    explicit ThrownBall(const Setting& setting);

    Vec3d off_m(double t_s) const;  ///< from where it should be by now

    ScenarioWorld world;
    physics::BodyId ball;
};

}  // namespace plumbline::study
