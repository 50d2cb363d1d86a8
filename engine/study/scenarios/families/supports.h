// What holds what up: worlds, and the statics of rigid bodies.
#pragma once

#include "engine/study/scenarios/integrate.h"
#include "engine/study/scenarios/scenario.h"

namespace plumbline::study {

/// A35: three balls touch on the floor, a fourth lies on them. They stand from these frictions on.
double four_balls_mu();        ///< between balls, sqrt 3 - sqrt 2
double four_balls_floor_mu();  ///< a quarter of it
struct FourBalls {
    double between;  ///< coefficients of friction
    double on_floor;
};
/// For 5 s.
bool four_balls_stand(const FourBalls& mu, Stepper& stepper);

/// A36: blocks of 1 x 0.2 x 0.5 m, each as far out over the next as the share `reach` of
/// (1 m / 2) / k, which is what is possible.
struct Overhang {
    Overhang(const Setting& setting, int blocks, double reach);

    double moved_m() const;   ///< the block that has moved most
    double fallen_m() const;  ///< of the topmost block

    ScenarioWorld world;
    std::vector<Vec3d> starts_m;  ///< of world.movers
};

/// Impulse of the latest step between two bodies that have contact events.
double impulse_between_Ns(const ScenarioWorld& world, physics::BodyId a, physics::BodyId b);

/// A39: how loads come down, read for a second after two.
struct PressErrors {
    double mean;  ///< of that second, the worst of all faces, relative
    double rms;   ///< of its steps, the worst of all faces, relative
};
/// Ten cubes of 3 kg stand on each other: each face bears the weight above.
PressErrors tower_presses(Stepper& stepper);
/// A beam of 12 kg on two fixed balls: the lever rule.
PressErrors beam_presses(Stepper& stepper);

}  // namespace plumbline::study
