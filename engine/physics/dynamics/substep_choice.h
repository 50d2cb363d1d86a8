// How many sub-steps an island needs. Knows nothing of Bullet.
//
// Contacts are springs whose stiffness grows with the square of the sub-steps, so a load's sag can
// be foretold: sag = load / (reduced mass * omega^2). What else asks for more: how many bodies stand
// on each other (a sweep carries a change one body further) and how fast jointed bodies turn.
#pragma once

#include "engine/core/math.h"

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace plumbline::physics {

/// What decided the number of sub-steps.
enum class SubstepReason : std::uint8_t {
    Least,    ///< nothing asked for more than the least
    Fixed,    ///< the settings leave no choice
    Load,     ///< the heaviest load would sink in too far, or jointed bodies press on something
    Height,   ///< many bodies on top of each other
    Turning,  ///< jointed bodies turn fast
    Field,    ///< a force field asked for them
    Joint,    ///< an elastic joint did
    Error,    ///< joints were further apart than they may be
    Held,     ///< a step shortly before needed as many
};
std::string_view reason_name(SubstepReason reason);  ///< "load"

struct SubstepChoice {
    int substeps{1};
    SubstepReason reason{SubstepReason::Least};
    double needed{0};  ///< before rounding up to a number that is used
};

/// Collects what one island shows before its step.
class SubstepChooser {
public:
    /// Bodies are numbered from 0; `step_s` is the whole step.
    void begin(std::size_t bodies, double step_s);
    /// A pair that presses with `load_N`. `size_m`: of the smaller body, for what "too far" is.
    /// A negative index is a body that never moves.
    void add_contact(int a, int b, Real load_N, Real reduced_mass_kg, Real size_m);
    /// A joint: the faster spin of its two bodies and the error the latest step left, as a share of
    /// the bodies' size.
    void add_joint(Real spin_radps, Real relative_error, int least_substeps = 0);
    /// A force field acts on one of the bodies.
    void add_field(int substeps);
    SubstepChoice choose(int least, int most);

private:
    int levels();

    struct Pair {
        int a{-1};
        int b{-1};
    };
    double step_s_{1.0 / 60.0};
    std::size_t bodies_{0};
    std::vector<Pair> pairs_;
    double deepest_share_{0};  ///< sag of one sub-step over the body's size: the largest ...
    double sum_of_shares_{0};  ///< ... and all together
    bool has_joints_{false};
    double fastest_spin_radps_{0};
    double joint_error_{0};
    int by_fields_{0};
    int by_joints_{0};
    std::vector<int> level_;  ///< of each body, 0: not reached
    std::vector<int> first_;  ///< neighbours of body i: neighbour_[first_[i]] on
    std::vector<int> neighbour_;
    std::vector<int> queue_;
};

/// How stiff contacts are: a frequency in shares of 1/h. As much as sweeps hold stable (0.125 would
/// be the bound for one point after the other; the points of a pair are solved together here).
inline constexpr Real kContactFrequency = 0.18_r;

}  // namespace plumbline::physics
