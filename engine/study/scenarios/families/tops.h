// Bodies that turn freely: their worlds, and where they are by Euler's equations.
#pragma once

#include "engine/study/scenarios/integrate.h"
#include "engine/study/scenarios/scenario.h"

#include <cmath>
#include <optional>

namespace plumbline::study {

/// A turning body without torque: w x y z of its turn, then its spin about its own axes.
struct EulersEquations {
    Vec3d inertia_kgm2;

    State<7> operator()(double t_s, const State<7>& state) const;
};

struct TurningBody {
    Quatd turn{1, 0, 0, 0};
    Vec3d own_spin_radps{0, 0, 0};  ///< about its own axes
};
/// Where it is after `seconds`, by two integrators.
TurningBody turned_for(const TurningBody& start, const Vec3d& inertia_kgm2, double seconds);

TurningBody turning_body(const ScenarioWorld& world, physics::BodyId body);

/// A body that nothing pushes is moved by itself, one in an island by the solver.
enum class Company {
    None,
    Tied,  ///< to a body beside it, by a spring without strength
};

/// Shape, mass and spin of a body; the rest does not count afloat.
struct FreeBodyDef {
    physics::ShapeDef shape;
    Vec3d spin_radps{0, 0, 0};
    double mass_kg{1};
    std::optional<Vec3d> inertia_kgm2{};  ///< none: the shape's
};
/// A05: a box of 1 x 2 x 3 m that spins at 5 rad/s about its middle axis, and turns over.
FreeBodyDef box_of_three_lengths();
/// A06: a disc of radius 0.5 m, 0.1 m thick, that spins at 30 rad/s, 20 degrees off its axis.
FreeBodyDef wobbling_disc();
/// The handle of assets/scenes/bench/peers/dzhani.toml: 56 kg that spin at 5 rad/s about the middle axis.
FreeBodyDef t_handle();

/// One body afloat at the origin.
struct FreeBody {
    FreeBody(const Setting& setting, const FreeBodyDef& def, Company company = Company::None);

    TurningBody now() const { return turning_body(world, body); }
    Vec3d axis() const { return world.turn(body) * Vec3d{0, 1, 0}; }  ///< its own y

    ScenarioWorld world;
    physics::BodyId body;
};

/// The axis of a round body goes round its angular momentum on a cone.
struct Precession {
    Vec3d momentum_kgm2ps;
    Vec3d start;        ///< the body's axis then
    double rate_radps;  ///< |L| / I across the axis

    Vec3d about() const { return glm::normalize(momentum_kgm2ps); }
    double cone_rad() const { return std::acos(glm::dot(start, about())); }
    Vec3d axis_at(double t_s) const;
};
/// Of wobbling_disc().
Precession disc_precession();

/// What a free body keeps: largest errors over a run, relative to the start.
struct ConservedErrors {
    double energy{0};
    double momentum{0};  ///< direction included
};
ConservedErrors conserved_errors(ScenarioWorld& world, double seconds, Stepper& stepper);

}  // namespace plumbline::study
