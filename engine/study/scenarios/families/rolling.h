// Balls that roll: their worlds, and when they do.
#pragma once

#include "engine/study/scenarios/scenario.h"

#include <cmath>

namespace plumbline::study {

/// A solid ball that is sent off without spin slides until it rolls at 5/7 of its speed.
struct SlideToRoll {
    double speed_mps{5};
    double mu{0.2};

    double slowing_mps2() const { return mu * kG_mps2; }
    double rolls_at_s() const { return 2 * speed_mps / (7 * slowing_mps2()); }
    double rolling_mps() const { return 5.0 / 7 * speed_mps; }
    double speed_at_mps(double t_s) const;
    double path_m(double t_s) const;
};

/// A30: that ball, of radius 0.5 m, from above the origin.
struct SlidingBall {
    SlidingBall(const Setting& setting, const SlideToRoll& law, double heading_rad = 0);

    ScenarioWorld world;
    physics::BodyId ball;
};

/// A31: a ball is let go on a slope; `share` is its friction over that at which it just rolls.
struct DownSlopeErrors {
    double path;  ///< in 2 s, relative
    double spin;  ///< after 2 s, relative
};
DownSlopeErrors down_slope(double angle_rad, double share, Stepper& stepper);

/// A32: a ball of radius 0.25 m on a plate that turns at 3 rad/s, started on its circle of 2 m.
struct BallOnTurntable {
    explicit BallOnTurntable(const Setting& setting);

    static constexpr double kPath_m = 2;
    static constexpr double kRadius_m = 0.25;
    static constexpr double kTable_radps = 3;
    static constexpr double kAround_radps = 2.0 / 7 * kTable_radps;  ///< at any radius

    static Vec3d expected_m(double t_s);
    double path_m() const { return std::hypot(world.at(ball).x, world.at(ball).z); }
    /// To be called after every step.
    void follow();

    ScenarioWorld world;
    physics::BodyId ball;
    double gone_round_rad{0};
};

}  // namespace plumbline::study
