// When two bodies that move and turn touch within a step.
#pragma once

#include "engine/physics/collision/body_geometry.h"

#include <optional>

namespace plumbline::physics {

/// A body's motion within a step: from a place on, at a constant velocity and spin. Shares of the step run from 0
/// to 1.
struct BodyPath {
    Transform from{};               ///< mass frame
    Vec3d displacement_m{0, 0, 0};  ///< over the whole step
    Vec3d turn_rad{0, 0, 0};        ///< likewise: an axis times an angle
    double since{0};                ///< a share: when it is at `from`
    double until{1};                ///< likewise: from then on it stands
};

/// What moves along a path, and the overlap from which on something crosses it: a share of its least inner radius.
struct MovingBody {
    const BodyGeometry& geometry;
    const BodyPath& path;
    double crossing_m{0};          ///< infinite: the other body's counts
    const Bounds* swept{nullptr};  ///< all of its places; null: not known yet
    CollisionFilter filter{};      ///< of parts without one
};

struct Impact {
    double share{1};        ///< up to which the bodies only touch
    Vec3d normal{0, 1, 0};  ///< unit, from b to a
};

/// What the step knows of two bodies' contact.
enum class Known {
    Nothing,
    Apart,     ///< no points hold them: what only grazes the other is an impact too
    Touching,  ///< they touch when their paths begin, and may meet elsewhere
    Held,      ///< contact points hold them on their whole paths
};

/// The first impact of two bodies within the step, before `latest` and after both paths, which tell as far as `end`, began. Bodies that touch at its start, or are held by
/// contact points, are up to their contacts: they have one only where they come to cross each other, that is to overlap
/// by more than the smaller `crossing_m`, and are stopped at a share of that, or where they are if that is deeper; those
/// that are apart have one from three hundredths of that overlap on. Those that overlap by more at its start are not stopped.
///
/// Conservative advancement along the screw motions of both (Mirtich 1996, "Impulse-based Dynamic Simulation", 2.3):
/// within the time in which no point can have closed the gap along its normal nothing touches. The bound is of second
/// order in that time, so that bodies which turn about the point where they touch are followed in few steps.
std::optional<Impact> time_of_impact(
    const MovingBody& a, const MovingBody& b, Known known, double latest, double end = 1);

/// A box round all places of the geometry along its path.
Bounds swept_bounds(const BodyGeometry& geometry, const BodyPath& path);

}  // namespace plumbline::physics
