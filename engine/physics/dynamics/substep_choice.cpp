#include "engine/physics/dynamics/substep_choice.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace plumbline::physics {
namespace {

/// Sag of the most loaded contact, and of all on average, as shares of the bodies' size.
constexpr double kDeepestShare = 3e-3;
constexpr double kMeanShare = 1.5e-3;
/// Smaller bodies may sink in by the shares of this size, as nobody sees six hundredths of a millimetre, but thin ones by
/// no more than a fiftieth of their thickness.
constexpr double kSmallest_m = 0.02;
constexpr double kThinShare = 0.02;
constexpr double kSubstepsPerLevel = 0.34;
constexpr double kTurn_rad = 0.4;  ///< of jointed bodies in one sub-step
/// At least, where contacts press on jointed bodies: position correction of joints and soft contacts else set each other
/// trembling.
constexpr double kSubstepsOfJoints = 4;
constexpr double kJointError = 1e-3;  ///< share of the bodies' size
constexpr std::array<int, 14> kSizes{1, 2, 3, 4, 5, 6, 7, 8, 12, 16, 24, 32, 48, 64};

}  // namespace

std::string_view reason_name(SubstepReason reason) {
    constexpr std::array<std::string_view, 9> kNames{
        "least", "fixed", "load", "height", "turning", "field", "joint", "error", "held"};
    return kNames[static_cast<std::size_t>(reason)];
}

void SubstepChooser::begin(std::size_t bodies, double step_s) {
    bodies_ = bodies;
    step_s_ = step_s;
    pairs_.clear();
    deepest_share_ = sum_of_shares_ = 0;
    fastest_spin_radps_ = joint_error_ = 0;
    has_joints_ = false;
    by_fields_ = by_joints_ = 0;
}

void SubstepChooser::add_contact(int a, int b, Real load_N, Real reduced_mass_kg, Real size_m) {
    pairs_.push_back({a, b});
    const bool bounded = a < 0 || b < 0;
    const double omega =
        2 * static_cast<double>(kPi * kContactFrequency) * (bounded ? 2 : 1) / step_s_;
    const double sag =
        static_cast<double>(load_N) / (static_cast<double>(reduced_mass_kg) * omega * omega);
    const auto thickness_m = static_cast<double>(size_m);
    const double share =
        sag /
        std::max(thickness_m, std::min(kSmallest_m, thickness_m * kThinShare / kDeepestShare));
    deepest_share_ = std::max(deepest_share_, share);
    sum_of_shares_ += share;
}

void SubstepChooser::add_joint(Real spin_radps, Real relative_error, int least_substeps) {
    by_joints_ = std::max(by_joints_, least_substeps);
    has_joints_ = true;
    fastest_spin_radps_ = std::max(fastest_spin_radps_, static_cast<double>(spin_radps));
    joint_error_ = std::max(joint_error_, static_cast<double>(relative_error));
}

void SubstepChooser::add_field(int substeps) {
    by_fields_ = std::max(by_fields_, substeps);
}

/// Bodies on top of each other: how far down to what never moves it is for all but a twentieth.
int SubstepChooser::levels() {
    level_.assign(bodies_, 0);
    first_.assign(bodies_ + 1, 0);
    queue_.clear();
    for (const Pair& pair : pairs_) {
        if (pair.a >= 0 && pair.b >= 0) {
            ++first_[static_cast<std::size_t>(pair.a)];
            ++first_[static_cast<std::size_t>(pair.b)];
            continue;
        }
        const int stands = std::max(pair.a, pair.b);
        if (stands < 0 || level_[static_cast<std::size_t>(stands)] != 0) continue;
        level_[static_cast<std::size_t>(stands)] = 1;
        queue_.push_back(stands);
    }
    int total = 0;
    for (int& first : first_) total = first += total;
    neighbour_.resize(static_cast<std::size_t>(total));
    for (const Pair& pair : pairs_) {
        if (pair.a < 0 || pair.b < 0) continue;
        neighbour_[static_cast<std::size_t>(--first_[static_cast<std::size_t>(pair.a)])] = pair.b;
        neighbour_[static_cast<std::size_t>(--first_[static_cast<std::size_t>(pair.b)])] = pair.a;
    }
    for (std::size_t at = 0; at < queue_.size(); ++at) {
        const auto body = static_cast<std::size_t>(queue_[at]);
        for (int i = first_[body]; i < first_[body + 1]; ++i) {
            const int other = neighbour_[static_cast<std::size_t>(i)];
            int& level = level_[static_cast<std::size_t>(other)];
            if (level != 0) continue;
            level = level_[body] + 1;
            queue_.push_back(other);
        }
    }
    if (queue_.empty()) return 0;
    return level_[static_cast<std::size_t>(queue_[(queue_.size() - 1) * 19 / 20])];
}

SubstepChoice SubstepChooser::choose(int least, int most) {
    if (most <= least) return {least, SubstepReason::Fixed};
    double needed = 0;
    SubstepReason reason = SubstepReason::Least;
    const auto ask = [&](double substeps, SubstepReason why) {
        if (substeps <= needed) return;
        needed = substeps;
        if (needed > least) reason = why;
    };
    if (!pairs_.empty()) {
        const double mean = sum_of_shares_ / static_cast<double>(pairs_.size());
        ask(std::sqrt(std::max(deepest_share_ / kDeepestShare, mean / kMeanShare)),
            SubstepReason::Load);
        if (bodies_ > static_cast<std::size_t>(least)) {
            ask(kSubstepsPerLevel * levels(), SubstepReason::Height);
        }
        if (has_joints_) ask(kSubstepsOfJoints, SubstepReason::Load);
    }
    ask(fastest_spin_radps_ * step_s_ / kTurn_rad, SubstepReason::Turning);
    ask(by_fields_, SubstepReason::Field);
    ask(by_joints_, SubstepReason::Joint);
    // The error of second-order joints falls with the square of the sub-steps.
    ask(least * std::sqrt(joint_error_ / kJointError), SubstepReason::Error);
    const double asked = std::max(needed, static_cast<double>(least));
    const int wanted = static_cast<int>(std::min(std::ceil(asked - 1e-6), 64.0));
    const int* size = std::lower_bound(kSizes.data(), kSizes.data() + kSizes.size(), wanted);
    return {std::clamp(*size, least, most), reason, needed};
}

}  // namespace plumbline::physics
