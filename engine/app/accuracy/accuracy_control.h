// Accuracy in play: the live gauges, the setting that the panel chose, and the ghost beside it.
// Turning a slider changes nothing but accuracy: the world is rebuilt at a step's edge.
#pragma once

#include "engine/app/session.h"
#include "engine/core/lines.h"
#include "engine/core/time/frame_clock.h"
#include "engine/scene/paths/scene_list.h"
#include "engine/scene/state_report.h"
#include "engine/study/ghost/ghost.h"

#include <deque>
#include <memory>
#include <optional>
#include <string>

namespace plumbline::app {

/// What a person asked for in the panel this frame.
struct AccuracyRequest {
    std::optional<study::Setting> setting{};
    std::optional<study::Setting> start_ghost{};
    bool stop_ghost{false};
    bool adopt{false};
};

/// The last second of simulated time, and what needs no reference.
struct AccuracyGauges {
    scene::CostHistory cost{};  ///< of the second's steps
    double ms_per_s{0};         ///< CPU of stepping per simulated second
    int most_substeps{0};
    std::size_t islands{0};
    double energy_J{0};
    double energy_change_J{0};  ///< within the second; what people and motors give included
    double max_penetration_m{0};
    double max_joint_error_m{0};
    double lost_s{0};  ///< of wall time, in all
};

class AccuracyControl {
public:
    /// `recorded`: a recording or a replay runs, which holds no change of accuracy.
    AccuracyControl(Session& session, bool recorded);

    /// Gauges are read only while somebody looks: energy and penetration walk all bodies.
    void watch(bool shown);
    /// After each fixed step.
    void after_step();
    /// Between frames' steps: does what was asked. Returns a line for the person, or nothing.
    std::string apply(const AccuracyRequest& request, FrameClock& clock);
    /// After the session built its simulation anew: the chosen setting stays, the ghost goes.
    void after_rebuild(FrameClock& clock);
    /// After a saved game was loaded, which ran at its own setting; `before`: that of the world before.
    void after_load(const study::Setting& before, FrameClock& clock);
    /// Once a frame.
    void take_answers();
    /// Outlines of the ghost's bodies that are more than a millimetre off the visible ones, as of the
    /// latest time that it has reached.
    void add_ghost_lines(LineList& lines, const Vec3f& eye_world) const;

    /// As the world runs now.
    study::Setting setting() const;
    bool recorded() const { return recorded_; }
    /// Something was turned since the scene began: a recording of it could not be replayed.
    bool changed() const { return chosen_.has_value(); }
    AccuracyGauges gauges(const FrameClock& clock) const;
    const study::Ghost* ghost() const { return ghost_.get(); }

private:
    struct Sample {
        double time_s{0};
        physics::StepCost cost{};
        double energy_J{0};
        double max_penetration_m{0};
        double max_joint_error_m{0};
        int most_substeps{0};
    };

    void use(const study::Setting& setting, FrameClock& clock);

    Session& session_;
    bool recorded_;
    bool watched_{false};
    std::optional<study::Setting> chosen_;
    std::unique_ptr<study::Ghost> ghost_;
    std::deque<Sample> samples_;
};

/// Writes NAME-adopted.toml, a copy of the scene with the setting under [accuracy]: beside the scene,
/// or among the user's, a folder that is made, where the scene is the program's. It is the same text otherwise, comments
/// included, but for names of files that it could not be found by from there. Overwrites nothing:
/// the next free number is taken. Returns where. Nothing is left where the copy would not load.
Result<std::filesystem::path> write_adopted_copy(const std::filesystem::path& scene,
                                                 const study::Setting& setting,
                                                 const scene::SceneFolders& folders);

}  // namespace plumbline::app
