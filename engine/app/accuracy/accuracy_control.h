// Accuracy in play: the gauges of the last second, and the ghost beside the world.
#pragma once

#include "engine/app/accuracy/picture_study.h"
#include "engine/app/accuracy/study_control.h"
#include "engine/app/session.h"
#include "engine/core/lines.h"
#include "engine/core/time/frame_clock.h"
#include "engine/scene/state_report.h"
#include "engine/study/ghost/ghost.h"

#include <deque>
#include <optional>
#include <string>
#include <vector>

namespace plumbline::app {

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

/// An effect that bodies feel, of those with fidelities, while something calls for it.
struct EffectInPlay {
    std::string name;
    scene::Fidelity fidelity{scene::Fidelity::Balanced};
    std::string price{};  ///< what other fidelities cost and buy; empty: no study has seen it
};

class AccuracyControl {
public:
    explicit AccuracyControl(Session& session) : study(session), session_(session) {}

    /// Gauges are read only while somebody looks: energy and penetration walk all bodies.
    void watch(bool shown);
    /// After each fixed step. The ghost of a world that was built anew since is gone.
    void after_step();
    /// Goes on from the running world's present state. The error is a line for the person.
    Result<Done> start_ghost(const study::Setting& setting);
    void stop_ghost() { ghost_.reset(); }
    /// Once a frame: of the ghost and of the studies.
    void take_answers();
    /// Outlines of the ghost's bodies that are more than a millimetre off the visible ones, as of the
    /// latest time that it has reached.
    void add_ghost_lines(LineList& lines, const Vec3f& eye_world) const;

    /// As the world runs now.
    study::Setting setting() const { return session_.accuracy(); }
    std::vector<EffectInPlay> effects() const;
    AccuracyGauges gauges(const FrameClock& clock) const;
    StudyControl study;
    PictureStudy picture;

    const study::Ghost* ghost() const { return ghost_ ? &*ghost_ : nullptr; }

private:
    struct Sample {
        double time_s{0};
        physics::StepCost cost{};
        double energy_J{0};
        double max_penetration_m{0};
        double max_joint_error_m{0};
        int most_substeps{0};
    };

    void forget_other_world();

    Session& session_;
    bool watched_{false};
    std::optional<study::Ghost> ghost_;
    std::deque<Sample> samples_;
    study::Setting sampled_at_{};
    std::uint64_t generation_{0};  ///< of the world that both belong to
};

}  // namespace plumbline::app
