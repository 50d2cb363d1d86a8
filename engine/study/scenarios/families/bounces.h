// Bodies that fall on the floor and leave it again: their worlds, and when and how high they bounce.
#pragma once

#include "engine/study/scenarios/scenario.h"

namespace plumbline::study {

/// A20: what falls, from where, on a floor of the same restitution, without friction.
struct Drop {
    enum class Shape {
        Ball,
        Cube,  ///< of 1 m
    };
    double height_m{1};  ///< of its lowest point
    double e{1};         ///< restitution
    Shape shape{Shape::Ball};
    double radius_m{0.1};  ///< of a ball

    /// The instant of the n-th contact; n from 1.
    double contact_s(int n) const;
    /// Height of the n-th apex; n from 1.
    double apex_m(int n) const;
    /// Where its middle is while it touches the floor.
    double to_middle_m() const { return shape == Shape::Cube ? 0.5 : radius_m; }
};

struct DroppedBody {
    DroppedBody(const Setting& setting, const Drop& drop);

    /// Height of its lowest point.
    double height_m() const { return world.at(body).y - drop.to_middle_m(); }
    /// Height that it would reach from where it is, by its energy.
    double reach_m() const;

    Drop drop;
    ScenarioWorld world;
    physics::BodyId body;
};

/// A21: a ball falls 1 m. When it last has 1 mm to go, by the geometric series and in the world.
struct BouncingEnd {
    int flights;        ///< that reach 1 mm
    double expected_s;  ///< the contact that ends the last of them
};
BouncingEnd bouncing_end(double e);
double bouncing_end_found_s(double e, Stepper& stepper);

/// A25: 7 x 7 elastic balls fall 5 m. Error of their energy for 20 s, rms over the steps, as a share of
/// that of the fall.
double elastic_balls_energy_rms(Stepper& stepper);

}  // namespace plumbline::study
