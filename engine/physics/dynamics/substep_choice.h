// How many sub-steps an island needs. Knows nothing of Bullet.
//
// Contacts are springs whose stiffness grows with the square of the sub-steps, so a load's sag can
// be foretold: sag = load / (reduced mass * omega^2). What else asks for more: how many bodies stand
// on each other (a sweep carries a change one body further) and how fast jointed bodies turn.
#pragma once

#include "engine/core/math.h"

#include <algorithm>
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

inline constexpr int kMostSubsteps = 64;

/// Stacks buckle where their contacts give way by a share of what they are made of: without joints they get up to so many.
constexpr int most_of_stacks(int most) {
    constexpr int kTimes = 4;
    return std::min(kTimes * most, kMostSubsteps);
}

/// Collects what one island shows before its step.
class SubstepChooser {
public:
    /// Bodies are numbered from 0; `step_s` is the whole step.
    void begin(std::size_t bodies, double step_s);
    /// What a body presses down with by itself, and whether it is a plate (is_plate()); without, it is none and weighs nothing.
    void set_body(int body, Real weight_N, bool is_plate);
    /// A negative index is a body that never moves.
    struct Pair {
        int a{-1};
        int b{-1};
        Real load_N{0};            ///< that it presses with
        bool is_load_known{true};  ///< else it carries what stands on it, at least
        Real reduced_mass_kg{0};
        Real size_m{0};  ///< of the smaller body, for what "too far" is
    };
    void add_contact(const Pair& pair) { pairs_.push_back(pair); }
    /// A joint: the faster spin of its two bodies and the error the latest step left, as a share of
    /// the bodies' size.
    void add_joint(Real spin_radps, Real relative_error, int least_substeps = 0);
    /// A force field acts on one of the bodies.
    void add_field(int substeps);
    /// From `least` to `most`, or to most_of_stacks() where tall stacks or loads on plates without joints ask for more.
    SubstepChoice choose(int least, int most);

private:
    struct Sag {
        double deepest{0};
        double deepest_of_plates{0};
        double mean{0};
    };
    Sag foretell_sag();
    void find_levels();
    void foretell_loads();
    int level_of(int body) const { return body < 0 ? 0 : level_[static_cast<std::size_t>(body)]; }
    int upper_of(const Pair& pair) const;
    int levels() const;
    double sag_share(const Pair& pair) const;
    bool has_plate(const Pair& pair) const;

    double step_s_{1.0 / 60.0};
    std::size_t bodies_{0};
    std::vector<Pair> pairs_;
    bool has_joints_{false};
    double fastest_spin_radps_{0};
    double joint_error_{0};
    int by_fields_{0};
    int by_joints_{0};
    std::vector<Real> carried_N_;      ///< by each body, itself included
    std::vector<std::uint8_t> plate_;  ///< 1: bodies that are plates
    std::vector<int> supports_;        ///< of each body: pairs with what lies lower
    std::vector<int> level_;           ///< of each body, 0: not reached
    std::vector<int> first_;           ///< neighbours of body i: neighbour_[first_[i]] on
    std::vector<int> neighbour_;
    std::vector<int> queue_;
};

/// How stiff contacts are: a frequency in shares of 1/h. As much as sweeps hold stable (0.125 would
/// be the bound for one point after the other; the points of a pair are solved together here).
inline constexpr Real kContactFrequency = 0.18_r;

}  // namespace plumbline::physics
