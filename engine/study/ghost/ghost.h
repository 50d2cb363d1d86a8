// A second, more accurate world of the running scene, stepped beside it in a process of its own:
// Bullet's packaged build has unguarded static state, and the ghost may be of float64.
#pragma once

#include "engine/core/process/process.h"
#include "engine/scene/simulation.h"
#include "engine/study/ghost/ghost_state.h"

#include <deque>

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
    static Result<Ghost> start(scene::Simulation& simulation, const Setting& setting);

    /// After each step of the visible world. Never waits: a slow ghost falls behind.
    void follow(const scene::Simulation& simulation);
    /// Once a frame: takes what the ghost has answered.
    void take_answers();
    /// Its scene is loaded and stands where it was to start from.
    bool ready() const { return ready_; }

    /// Poses of the bodies listed at the start, as of latest().time_s.
    const GhostState& latest() const { return latest_; }
    /// Bodies in the order of latest().bodies.
    std::span<const physics::BodyId> bodies() const { return bodies_; }
    /// Oldest first, the last 20 s.
    std::span<const GhostDistance> history() const { return history_; }
    const Setting& setting() const { return setting_; }
    double behind_s() const;  ///< simulated time that the ghost has still to make
    /// Why there is no ghost any more; empty: there is.
    const std::string& failure() const { return failure_; }

private:
    /// The visible world at an instant that the ghost has yet to reach.
    struct Observation {
        double time_s{0};
        double cpu_ms{0};  ///< of the steps since the look before
        std::vector<Vec3d> positions_m;
    };

    Ghost(ChildProcess worker, const Setting& setting)
        : setting_(setting), worker_(std::move(worker)) {}
    void ask(const std::string& body);
    void ask_next();
    void take(GhostState state);
    void fail(const std::string& why);

    Setting setting_;
    std::optional<ChildProcess> worker_;
    std::string received_;
    bool waiting_{false};  ///< for an answer
    bool ready_{false};    ///< the first answer came
    std::deque<Observation> observations_;
    double observed_s_{0};
    double cpu_ms_{0};
    double asked_s_{0};  ///< where the ghost is or is on its way to
    GhostState latest_;
    std::vector<physics::BodyId> bodies_;
    std::vector<GhostDistance> history_;
    std::string failure_;
};

}  // namespace plumbline::study
