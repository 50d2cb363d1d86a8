// Boxes that slide: their worlds, and Coulomb's law of friction.
#pragma once

#include "engine/study/scenarios/scenario.h"

namespace plumbline::study {

/// A28: a box of 1 m x height_m x 1 m is sent off at 5 m/s over a floor, friction 0.3.
struct SlidingBox {
    double height_m{0.25};
    double heading_rad{0};  ///< from +x towards -z
    double turned_rad{0};   ///< of its faces
};
double sliding_way_m();  ///< v0^2 / (2 mu g)
/// Where it has come to rest, after 2.5 s; it starts above the origin.
Vec3d sliding_stop_m(const SlidingBox& box, Stepper& stepper);

/// A plane through the origin that goes down along +x.
struct Slope {
    Quatd turn;
    Vec3d down;
    Vec3d out;

    explicit Slope(double angle_rad);
    void add_to(ScenarioWorld& world, double friction) const;
};

/// A29: a cube of 1 m on a slope of that angle.
struct BoxOnSlope {
    BoxOnSlope(const Setting& setting, double angle_rad, double mu);

    double gain_mps2() const;  ///< g (sin a - mu cos a): below 0, it stays
    double down_m() const;     ///< along the slope from its start
    double down_mps() const;
    double moved_m() const;  ///< along the slope, whichever way

    double angle_rad;
    double mu;
    Slope slope;
    ScenarioWorld world;
    physics::BodyId box;
    Vec3d start_m;
};

/// A34: a cube of 1 m spins at 10 rad/s on its face, friction 0.3.
struct SpinningBox {
    SpinningBox(const Setting& setting, double turned_rad);

    double spin_radps() const { return world.spin(box).y; }

    ScenarioWorld world;
    physics::BodyId box;
};
/// How fast it slows down where it presses on its four corners, and where it presses evenly.
double four_corners_radps2();
double even_pressure_radps2();

}  // namespace plumbline::study
