// What a scene of the gallery says of itself: its rules, its known reds, what is done to it.
#pragma once

#include "engine/core/math.h"
#include "engine/core/text/source_location.h"

#include <optional>
#include <string>
#include <vector>

namespace plumbline::scene {

/// `[[hard_case.pass]]`: one number that is watched while the scene runs.
struct HardCaseRule {
    std::string measure;          ///< a name in engine/study/gallery/measures.cpp
    std::vector<std::string> of;  ///< bodies or joints, "cube.*" is all that begin so; none: all
    std::string relative_to;      ///< a body, or empty
    double from_s{0};
    std::optional<double> to_s{};  ///< none: to the end
    // One of the three.
    std::optional<double> below{};
    std::optional<double> above{};
    std::optional<double> near{};  ///< not further from it than `within`
    double within{0};
    SourceLocation location{};
};

enum class CaseEventKind {
    Teleport,   ///< `value` m
    Velocity,   ///< `value` m/s, and `angular_velocity_radps`; kinematic bodies keep it
    Force,      ///< `value` N
    Impulse,    ///< `value` N s
    Gravity,    ///< `value` m/s2
    Remove,     ///< the body goes
    MotorOff,   ///< of a joint
    NotFinite,  ///< gives the body a velocity that is no number
};

/// `[[hard_case.event]]`: what is done to a scene while it runs, by engine/study/gallery.
struct HardCaseEvent {
    CaseEventKind kind{CaseEventKind::Teleport};
    std::string of;        ///< a body; MotorOff: a joint; Gravity: nothing
    double at_s{0};        ///< before the step that begins then
    double duration_s{0};  ///< Force: so long, and one step at least
    Vec3 value{0, 0, 0};
    Vec3 angular_velocity_radps{0, 0, 0};
    Vec3 point_m{0, 0, 0};  ///< Force, Impulse: where, from the body's origin along world axes
};

/// `[[hard_case.known_red]]`: a rule that small_step breaks at 60 Hz.
struct HardCaseRed {
    std::string rule;   ///< its text, as the table shows it
    double reached{0};  ///< the worst value that is accepted
    bool gone{false};   ///< instead: a body of it is gone
    std::string why;
    SourceLocation location{};
};

/// `[hard_case]`: a scene that is hard to keep stable, and what passes (docs/GALLERY.md).
struct HardCase {
    std::string id;             ///< "H05"
    std::string shows;          ///< one or two sentences
    std::string known_to_fail;  ///< who, with the source
    double seconds{10};
    bool nightly{false};         ///< tier = "nightly": too long for every change
    double settled_s{0};         ///< from then on `penetration_m` holds
    std::string unsettled;       ///< why not before
    double penetration_m{0.02};  ///< 2 % of the smallest edge, unless the case says otherwise
    double energy_gain{0.01};    ///< above the start's and what events did, as a share of its scale
    double energy_scale_J{0};    ///< 0: the start's own size
    std::string energy_from;     ///< what feeds energy in: the energy is not judged then
    int non_finite{0};           ///< bodies that may be taken out for not being finite
    int removed{0};              ///< bodies that may fall below kill_below_m
    std::vector<HardCaseRed> known_red;  ///< what small_step fails; no others
    std::vector<HardCaseRule> rules;
    std::vector<HardCaseEvent> events;  ///< by time
    SourceLocation location{};
};

}  // namespace plumbline::scene
