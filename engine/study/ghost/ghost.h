// A second, more accurate world of the running scene, stepped beside it in a process of its own:
// Bullet's packaged build has unguarded static state, and the ghost may be of float64.
#pragma once

#include "engine/scene/simulation.h"
#include "engine/study/ghost/ghost_state.h"

#include <memory>

namespace plumbline::study {

/// The distance between the visible world and its ghost at one instant that both have reached.
struct GhostDistance {
    double time_s{0};
    double largest_m{0};  ///< of all bodies, between their origins
    double mean_m{0};
    double visible_ms_per_s{0};  ///< CPU of stepping per simulated second, over the last answer
    double ghost_ms_per_s{0};
};

class Ghost {
public:
    /// Goes on from the simulation's present state at `setting`. Returns before the ghost's scene is
    /// loaded. Refused: the program is not beside this one.
    static Result<std::unique_ptr<Ghost>> start(scene::Simulation& simulation,
                                                const Setting& setting);
    ~Ghost();

    /// After each step of the visible world. Never waits: a slow ghost falls behind.
    void follow(const scene::Simulation& simulation);
    /// Once a frame: takes what the ghost has answered.
    void take_answers();
    /// Its scene is loaded and stands where it was to start from.
    bool ready() const;

    /// Poses of the bodies listed at the start, as of latest().time_s.
    const GhostState& latest() const;
    /// Bodies in the order of latest().bodies.
    std::span<const physics::BodyId> bodies() const;
    std::span<const GhostDistance> history() const;  ///< oldest first, the last 20 s
    const Setting& setting() const;
    double behind_s() const;             ///< simulated time that the ghost has still to make
    const std::string& failure() const;  ///< why there is no ghost any more; empty: there is

private:
    Ghost();
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace plumbline::study
