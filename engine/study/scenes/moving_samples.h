// The dynamic bodies of a scene as runs are compared by them: which they are, and where they are now.
#pragma once

#include "engine/physics/totals.h"
#include "engine/scene/simulation.h"
#include "engine/study/scenes/scene_run.h"

#include <cstdint>
#include <vector>

namespace plumbline::study {

class MovingSamples {
public:
    /// Pieces of ropes count where nothing else moves. `simulation` must outlive it.
    explicit MovingSamples(scene::Simulation& simulation);

    const std::vector<physics::BodyId>& bodies() const { return bodies_; }
    bool has_others() const { return has_others_; }  ///< than pieces of ropes
    /// What an answer says of the scene as it starts.
    void describe(SceneAnswer& answer) const;
    /// Puts every body up to so far elsewhere along each axis, and lets it drift by as many m/s.
    void shift(std::uint64_t seed, double shift_m);
    Moment moment();

private:
    Layout layout() const;

    scene::Simulation& simulation_;
    std::vector<physics::BodyId> bodies_;
    bool has_others_{false};
    std::vector<double> masses_kg_;
    std::vector<BodyPose> poses_;
};

/// Keeps the largest of what the energy turns over, from one sample to the next.
void note_turnover(Trace& trace, const physics::Energy& start, const physics::Energy& now);

}  // namespace plumbline::study
