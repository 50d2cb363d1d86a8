// Bodies that hit each other or the floor: what their runs end with, against the laws of impact.
#pragma once

#include "engine/study/scenarios/scenario.h"

namespace plumbline::study {

/// A22: a ball at 2 m/s meets one of 1 kg at rest; restitution 0.7, no friction, afloat.
struct BallsMeet {
    double mass_ratio;  ///< of the one that comes
    double aside{0};    ///< of its path from the other's centre, in radii
};
struct BallsMeetErrors {
    double velocity;  ///< the worse of the two, as a share of 2 m/s
    double momentum;  ///< relative
};
BallsMeetErrors balls_meet(const BallsMeet& how, Stepper& stepper);

struct SpinningBall {
    Vec3d velocity_mps;
    Vec3d spin_radps;
};
/// A solid ball as it leaves the floor, y = 0, by rigid Coulomb friction.
SpinningBall after_floor(const SpinningBall& before, double radius_m, double mu, double e);

/// A23: a ball comes down at 5 m/s with six mixtures of speed and spin, in 24 directions each.
struct SpinningBallErrors {
    double worst;   ///< of velocity and spin, as a share of the speed after
    double spread;  ///< of that speed over the directions, as a share of it
};
SpinningBallErrors spinning_ball_bounces(double mu, Stepper& stepper);

/// A24: of five balls in a row the first ones come at 2 m/s; restitution 1, afloat.
struct Cradle {
    double gap_m;
    int coming{1};
};
/// As shares of 2 m/s.
struct CradleErrors {
    double leaving;  ///< as many as came, at their speed: worst error
    double staying;  ///< fastest of the others
};
CradleErrors cradle_swings(const Cradle& cradle, Stepper& stepper);

}  // namespace plumbline::study
