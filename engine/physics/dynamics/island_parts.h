// One island's step in parts: up to each impact of its fast bodies, and wherever points would lag behind.
//
// What moves farther than its own inner radius within a step cannot be solved by the points found when the step begins:
// they are where it was. So the step is cut where the sweep says that such a body meets something. There the points are
// found anew, the impact is solved (restitution and friction, all bodies at the same moment), and the rest of the step
// goes on from it. Nothing of the step is lost. Kinematic bodies go along: at each part's start they are where their
// velocity takes them by then.
#pragma once

#include "engine/physics/collision/pair_reach.h"
#include "engine/physics/dynamics/body_sweep.h"
#include "engine/physics/dynamics/islands.h"

#include <span>
#include <vector>

namespace plumbline::physics {

/// What finds the contact points of an island's bodies: of several islands at once, if nothing that bounds them moves.
class IslandPoints {
public:
    virtual ~IslandPoints() = default;
    /// Finds the points of an island's bodies anew, within the step, for its part `step`. `manifolds` becomes those that
    /// have points, in the order in which the step began.
    virtual void collide_again(std::span<BodyRecord* const> bodies,
                               const CollideStep& step,
                               std::vector<Manifold*>& manifolds) = 0;
    /// Lists the manifolds that have points, likewise.
    virtual void list(std::span<BodyRecord* const> bodies, std::vector<Manifold*>& manifolds) = 0;
};

/// Drops the points of a body that outruns them, where it touches nothing: they are off as soon as it turns, and what
/// it meets is predicted. Whether there were any.
bool drop_points_ahead(const BodyRecord& record, const Outlook& outlook);

class IslandParts {
public:
    IslandParts(IslandPoints& points, IslandSolver& solver) : points_(points), solver_(solver) {}

    void set_step(const CollideStep& step) { step_ = step; }
    IslandResult solve(Island& island, const IslandStep& step);

private:
    /// A time of the step, in shares of it.
    struct Span {
        double from{0};
        double to{1};
    };
    /// A kinematic body that moves near the island, where it was when the step began.
    struct Carrier {
        BodyRecord* record{nullptr};
        Transform start{};
    };
    void list_carriers(const Island& island);
    void carry_to(double share);
    void solve_up_to_impacts(Island& island, IslandStep& step, double& now);
    void solve_span(Island& island, IslandStep& step, const Span& span);
    /// `only_struck`: of pairs whose velocities the impacts left as they were, the points stay.
    void find_points(Island& island, double share, bool only_struck = false);
    void drop_points_ahead(Island& island, const Outlook& outlook);

    IslandPoints& points_;
    IslandSolver& solver_;
    Forecast forecast_;
    CollideStep step_{};
    IslandResult result_{};
    std::vector<Carrier> carriers_;
};

}  // namespace plumbline::physics
