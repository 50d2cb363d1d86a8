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
/// A tower of n blocks on springs at their corners falls by its own weight from a sag of 1.96 / n^2 of their size in its lowest joint on:
/// n^3 = 7.84 c / (m g a) (Greenhill 1881), c = k a^2 / 4 each joint's stiffness against leaning. This is 0.85 of it.
constexpr double kBuckling = 1.67;
constexpr int kTower = 10;         ///< levels: fewer do not buckle before they sag
constexpr double kTurn_rad = 0.4;  ///< of jointed bodies in one sub-step
/// At least, where contacts press on jointed bodies: position correction of joints and soft contacts else set each other
/// trembling.
constexpr double kSubstepsOfJoints = 4;
constexpr double kJointError = 1e-3;  ///< share of the bodies' size
constexpr std::array<int, 14> kSizes{1, 2, 3, 4, 5, 6, 7, 8, 12, 16, 24, 32, 48, kMostSubsteps};

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
    carried_N_.assign(bodies, 0);
    plate_.assign(bodies, 0);
    fastest_spin_radps_ = joint_error_ = 0;
    has_joints_ = false;
    by_fields_ = by_joints_ = 0;
}

void SubstepChooser::set_body(int body, Real weight_N, bool is_plate) {
    carried_N_[static_cast<std::size_t>(body)] = weight_N;
    plate_[static_cast<std::size_t>(body)] = is_plate ? 1 : 0;
}

bool SubstepChooser::has_plate(const Pair& pair) const {
    const auto is_plate = [this](int body) {
        return body >= 0 && plate_[static_cast<std::size_t>(body)] != 0;
    };
    return is_plate(pair.a) || is_plate(pair.b);
}

/// Sag of one sub-step over the body's size.
double SubstepChooser::sag_share(const Pair& pair) const {
    const bool bounded = pair.a < 0 || pair.b < 0;
    const double omega =
        2 * static_cast<double>(kPi * kContactFrequency) * (bounded ? 2 : 1) / step_s_;
    const double sag_m = static_cast<double>(pair.load_N) /
                         (static_cast<double>(pair.reduced_mass_kg) * omega * omega);
    const auto thickness_m = static_cast<double>(pair.size_m);
    return sag_m /
           std::max(thickness_m, std::min(kSmallest_m, thickness_m * kThinShare / kDeepestShare));
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

/// How many bodies it is from each down to what never moves.
void SubstepChooser::find_levels() {
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
}

/// Of all but a twentieth of the bodies.
int SubstepChooser::levels() const {
    return queue_.empty() ? 0 : level_of(queue_[(queue_.size() - 1) * 19 / 20]);
}

/// The body of the pair that stands on the other, by their levels; -1: none.
int SubstepChooser::upper_of(const Pair& pair) const {
    const int level_a = level_of(pair.a);
    const int level_b = level_of(pair.b);
    if (level_a == level_b) return -1;
    return level_a > level_b ? pair.a : pair.b;
}

/// A new contact carries the heavier body or, where bodies stand on what never moves, its share of all above it: from the top down each
/// hands what it carries on to what lies lower, in equal shares.
void SubstepChooser::foretell_loads() {
    for (Pair& pair : pairs_) {
        if (pair.is_load_known) continue;
        for (const int body : {pair.a, pair.b}) {
            if (body >= 0)
                pair.load_N = std::max(pair.load_N, carried_N_[static_cast<std::size_t>(body)]);
        }
    }
    supports_.assign(bodies_, 0);
    for (const Pair& pair : pairs_) {
        const int upper = upper_of(pair);
        if (upper >= 0) ++supports_[static_cast<std::size_t>(upper)];
    }
    const auto share_of = [this](std::size_t body) {
        return carried_N_[body] / static_cast<Real>(supports_[body]);
    };
    for (auto at = queue_.rbegin(); at != queue_.rend(); ++at) {
        const auto body = static_cast<std::size_t>(*at);
        for (int i = first_[body]; i < first_[body + 1]; ++i) {
            const auto other = static_cast<std::size_t>(neighbour_[static_cast<std::size_t>(i)]);
            if (level_[other] < level_[body]) carried_N_[other] += share_of(body);
        }
    }
    for (Pair& pair : pairs_) {
        if (pair.is_load_known) continue;
        const int upper = upper_of(pair);
        if (upper >= 0)
            pair.load_N = std::max(pair.load_N, share_of(static_cast<std::size_t>(upper)));
    }
}

/// As shares of the bodies' size: the largest, that of the thin ones, and all on average.
SubstepChooser::Sag SubstepChooser::foretell_sag() {
    find_levels();
    const auto is_new = [](const Pair& pair) { return !pair.is_load_known; };
    if (std::ranges::any_of(pairs_, is_new)) foretell_loads();
    Sag sag;
    for (const Pair& pair : pairs_) {
        const double share = sag_share(pair);
        sag.deepest = std::max(sag.deepest, share);
        if (has_plate(pair)) sag.deepest_of_plates = std::max(sag.deepest_of_plates, share);
        sag.mean += share;
    }
    sag.mean /= static_cast<double>(pairs_.size());
    return sag;
}

SubstepChoice SubstepChooser::choose(int least, int most) {
    if (most <= least) return {least, SubstepReason::Fixed};
    double needed = 0;
    double deepest_plate_share = 0;
    double by_buckling = 0;
    SubstepReason reason = SubstepReason::Least;
    const auto ask = [&](double substeps, SubstepReason why) {
        if (substeps <= needed) return;
        needed = substeps;
        if (needed > least) reason = why;
    };
    if (!pairs_.empty()) {
        const Sag sag = foretell_sag();
        if (!has_joints_) deepest_plate_share = sag.deepest_of_plates;
        if (!has_joints_ && sag.deepest_of_plates == 0 && levels() >= kTower)
            by_buckling = levels() * std::sqrt(sag.deepest / kBuckling);
        const double wished = std::max(sag.deepest / kDeepestShare, sag.mean / kMeanShare);
        ask(std::sqrt(wished), SubstepReason::Load);
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
    needed = std::min(needed, static_cast<double>(most));
    ask(std::sqrt(deepest_plate_share / kDeepestShare), SubstepReason::Load);
    ask(by_buckling, SubstepReason::Height);
    const double asked = std::max(needed, static_cast<double>(least));
    const int wanted = static_cast<int>(std::min(std::ceil(asked - 1e-6), double{kMostSubsteps}));
    const int* size = std::lower_bound(kSizes.data(), kSizes.data() + kSizes.size(), wanted);
    return {std::clamp(*size, least, wanted > most ? most_of_stacks(most) : most), reason, needed};
}

}  // namespace plumbline::physics
