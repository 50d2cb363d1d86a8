#include "engine/study/scenes/scene_errors.h"

#include "engine/study/angle_between.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumbline::study {
namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();
/// An explosion is further away than any inaccuracy takes a body.
constexpr double kExplodedLengths = 10.0;
constexpr double kExplodedTurnovers = 100.0;

struct PoseDifference {
    double position_m{0};
    double angle_rad{0};
};

/// Root mean square over bodies.
PoseDifference pose_difference(const Moment& a, const Moment& b) {
    PoseDifference sum;
    if (a.bodies.size() != b.bodies.size() || a.bodies.empty()) return {kNoNumber, kNoNumber};
    for (std::size_t i = 0; i < a.bodies.size(); ++i) {
        const double away_m = glm::distance(a.bodies[i].position_m, b.bodies[i].position_m);
        const double angle_rad =
            angle_between_rad(a.bodies[i].orientation, b.bodies[i].orientation);
        sum.position_m += away_m * away_m;
        sum.angle_rad += angle_rad * angle_rad;
    }
    const auto count = static_cast<double>(a.bodies.size());
    return {std::sqrt(sum.position_m / count), std::sqrt(sum.angle_rad / count)};
}

/// Quantile with linear interpolation between neighbours.
double quantile(std::vector<double> values, double share) {
    if (values.empty()) return kNoNumber;
    std::ranges::sort(values);
    const double place = share * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, values.size() - 1);
    return values[below] + (place - static_cast<double>(below)) * (values[above] - values[below]);
}

/// One statistic of one moment of one copy, and what 1 means for it.
struct Statistic {
    std::size_t metric;
    double scale;
    double (*of)(const Trace& copy, const Moment& moment);
    bool one_sided{false};  ///< only more than the reference counts
};

std::vector<Statistic> statistics_of(const Scales& scales) {
    const double length_m = scales.length_m;
    const double body_m = scales.body_size_m;
    std::vector<Statistic> all{
        {0, length_m, [](const Trace&, const Moment& at) { return at.layout.center_m.x; }},
        {0, length_m, [](const Trace&, const Moment& at) { return at.layout.center_m.y; }},
        {0, length_m, [](const Trace&, const Moment& at) { return at.layout.center_m.z; }},
        {1, length_m, [](const Trace&, const Moment& at) { return at.layout.top_m; }},
        {2, length_m, [](const Trace&, const Moment& at) { return at.layout.spread_m; }},
        {3, length_m, [](const Trace&, const Moment& at) { return at.layout.reach_m; }},
        {4, scales.energy_J, [](const Trace&, const Moment& at) { return at.energy_J; }},
        {5, body_m, [](const Trace& copy, const Moment&) { return copy.penetration_m; }, true},
        {6, body_m, [](const Trace& copy, const Moment&) { return copy.joint_error_m; }, true}};
    if (!scales.has_joints) all.pop_back();
    return all;
}

/// False where a copy stopped early: then there is nothing to compare.
bool complete(std::span<const Trace> copies, std::size_t moments) {
    return !copies.empty() && std::ranges::all_of(copies, [&](const Trace& copy) {
        return copy.status == RunStatus::Done && copy.moments.size() == moments;
    });
}

std::vector<double> values_of(std::span<const Trace> copies,
                              const Statistic& statistic,
                              std::size_t moment) {
    std::vector<double> values;
    for (const Trace& copy : copies) values.push_back(statistic.of(copy, copy.moments[moment]));
    return values;
}

/// Per metric the largest of `measure` over its statistics and the moments after the start.
template <class Measure>
std::vector<double> largest(const Scales& scales,
                            std::size_t moments,
                            std::size_t metrics,
                            Measure measure) {
    std::vector<double> errors(metrics, 0.0);
    for (const Statistic& statistic : statistics_of(scales)) {
        for (std::size_t i = 1; i < moments; ++i) {
            const double error = measure(statistic, i) / statistic.scale;
            double& worst = errors[statistic.metric];
            if (!(error <= worst)) worst = error;  // keeps what is not a number
        }
    }
    return errors;
}

std::string length_text(const Scales& scales) {
    return fmt::format("the scene's size, {:.3g} m", scales.length_m);
}
std::string energy_text(const Scales& scales) {
    return fmt::format("the largest turnover, {:.3g} J", scales.energy_J);
}
std::string body_text(const Scales& scales) {
    return fmt::format("a body's size, {:.3g} m", scales.body_size_m);
}

}  // namespace

Scales scales_of(const SceneAnswer& reference) {
    Scales scales{.body_size_m = std::max(reference.body_size_m, 1e-6),
                  .has_joints = reference.joints > 0};
    Vec3d least{std::numeric_limits<double>::max()};
    Vec3d most{std::numeric_limits<double>::lowest()};
    double turnover_J = 0;
    for (const Trace& trace : reference.traces) {
        turnover_J = std::max(turnover_J, trace.energy_turnover_J);
        for (const Moment& moment : trace.moments) {
            for (const BodyPose& body : moment.bodies) {
                least = glm::min(least, body.position_m);
                most = glm::max(most, body.position_m);
            }
        }
    }
    scales.length_m = std::max(glm::distance(least, most), scales.body_size_m);
    const double lift_J = 0.01 * reference.mass_kg * reference.gravity_mps2 * scales.length_m;
    scales.energy_J = std::max({turnover_J, lift_J, 1e-12});
    return scales;
}

std::vector<Metric> trajectory_metrics(const Scales& scales) {
    std::vector<Metric> metrics{{"position", length_text(scales)},
                                {"orientation", "half a turn"},
                                {"energy", energy_text(scales)},
                                {"penetration", body_text(scales)}};
    if (scales.has_joints) metrics.push_back({"joint error", body_text(scales)});
    return metrics;
}

std::vector<double> trajectory_errors(const Trace& run,
                                      const Trace& reference,
                                      const Scales& scales) {
    std::vector<double> errors(trajectory_metrics(scales).size(), 0.0);
    if (run.moments.size() != reference.moments.size()) {
        std::ranges::fill(errors, kNoNumber);
        return errors;
    }
    const auto keep = [&](std::size_t metric, double error) {
        if (!(error <= errors[metric])) errors[metric] = error;  // keeps what is not a number
    };
    for (std::size_t i = 1; i < run.moments.size(); ++i) {
        const PoseDifference off = pose_difference(run.moments[i], reference.moments[i]);
        keep(0, off.position_m / scales.length_m);
        keep(1, off.angle_rad / static_cast<double>(kPi));
        keep(2,
             std::abs(run.moments[i].energy_J - reference.moments[i].energy_J) / scales.energy_J);
    }
    keep(3, std::max(0.0, run.penetration_m - reference.penetration_m) / scales.body_size_m);
    if (scales.has_joints)
        keep(4, std::max(0.0, run.joint_error_m - reference.joint_error_m) / scales.body_size_m);
    return errors;
}

std::vector<Metric> ensemble_metrics(const Scales& scales) {
    std::vector<Metric> metrics{{"centre of mass", length_text(scales)},
                                {"height", length_text(scales)},
                                {"spread", length_text(scales)},
                                {"reach", length_text(scales)},
                                {"energy", energy_text(scales)},
                                {"penetration", body_text(scales)}};
    if (scales.has_joints) metrics.push_back({"joint error", body_text(scales)});
    return metrics;
}

std::vector<double> ensemble_errors(std::span<const Trace> copies,
                                    std::span<const Trace> reference,
                                    const Scales& scales) {
    const std::size_t metrics = ensemble_metrics(scales).size();
    const std::size_t moments = reference.empty() ? 0 : reference.front().moments.size();
    if (!complete(copies, moments) || !complete(reference, moments))
        return std::vector<double>(metrics, kNoNumber);
    return largest(scales, moments, metrics, [&](const Statistic& statistic, std::size_t i) {
        const double off = quantile(values_of(copies, statistic, i), 0.5) -
                           quantile(values_of(reference, statistic, i), 0.5);
        return statistic.one_sided ? std::max(0.0, off) : std::abs(off);
    });
}

std::vector<double> ensemble_spread(std::span<const Trace> copies, const Scales& scales) {
    const std::size_t metrics = ensemble_metrics(scales).size();
    const std::size_t moments = copies.empty() ? 0 : copies.front().moments.size();
    if (!complete(copies, moments)) return std::vector<double>(metrics, kNoNumber);
    return largest(scales, moments, metrics, [&](const Statistic& statistic, std::size_t i) {
        const std::vector<double> values = values_of(copies, statistic, i);
        return 0.5 * (quantile(values, 0.95) - quantile(values, 0.05));
    });
}

std::vector<double> ensemble_chance(std::span<const Trace> copies, const Scales& scales) {
    // Of a normal distribution: half the 5-95 % way is 1.645 sigma, and the median of n draws has
    // a standard error of 1.2533 sigma / sqrt(n).
    constexpr double kPerHalfWay = 1.2533 / 1.645;
    std::vector<double> chance = ensemble_spread(copies, scales);
    for (double& each : chance) {
        each *=
            kPerHalfWay / std::sqrt(static_cast<double>(std::max<std::size_t>(1, copies.size())));
    }
    return chance;
}

std::string explosion_in(const Trace& run, const Trace& reference, const Scales& scales) {
    for (std::size_t i = 1; i < std::min(run.moments.size(), reference.moments.size()); ++i) {
        const Moment& here = run.moments[i];
        const Moment& there = reference.moments[i];
        const double away_m = pose_difference(here, there).position_m;
        if (away_m > kExplodedLengths * scales.length_m)
            return fmt::format(
                "bodies {:.3g} m from where they belong at {:.2f} s", away_m, here.time_s);
        const double off_J = std::abs(here.energy_J - there.energy_J);
        if (off_J > kExplodedTurnovers * scales.energy_J)
            return fmt::format("off by {:.3g} J at {:.2f} s, the scene turns over {:.3g} J",
                               off_J,
                               here.time_s,
                               scales.energy_J);
    }
    return {};
}

}  // namespace plumbline::study
