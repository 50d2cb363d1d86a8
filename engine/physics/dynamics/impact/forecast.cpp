#include "engine/physics/dynamics/impact/forecast.h"

#include "engine/physics/bullet/body.h"
#include "engine/physics/bullet/rotations.h"
#include "engine/physics/dynamics/rotation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace plumbline::physics {
namespace {

bool moves(const BodyRecord& record) {
    return !record.frozen && record.kind != BodyKind::Static;
}

/// How fast gyroscopic torque changes the spin.
double gyroscopic_radps2(const BodyRecord& record) {
    const Vec3d spin{unrotated(record.motion->spin_radps, record.motion->at.rotation)};
    const Vec3d momentum = record.traits.inertia_kgm2 * spin;
    return glm::length(Vec3d(record.motion->inverse_moments) * glm::cross(momentum, spin));
}

/// Up to which share of the step a screw motion tells where the body turns: no point of it leaves that by more than a
/// share of its inner radius.
double horizon_of(const BodyRecord& record, const Outlook& outlook) {
    constexpr double kMostError = 0.1;
    if (!outlook.gyroscopic_torque || record.traits.isotropic_inertia || !pushable(record))
        return 1;
    const double error_mps2 =
        gyroscopic_radps2(record) * static_cast<double>(record.traits.radius_m) / 8;
    const double most_m = kMostError * static_cast<double>(record.sweep.inner_radius_m);
    const double left_s = (1 - outlook.now) * outlook.step_s;
    if (!(error_mps2 * left_s * left_s > most_m)) return 1;
    return outlook.now + std::sqrt(most_m / error_mps2) / outlook.step_s;
}

/// The turn over the whole step, at the mean spin up to a share of it.
Vec3d predicted_turn_rad(const BodyRecord& record, const Outlook& outlook, double until) {
    const Vec3d turn{record.motion->spin_radps * static_cast<Real>(outlook.step_s)};
    const double duration_s = (until - outlook.now) * outlook.step_s;
    if (!outlook.gyroscopic_torque || record.traits.isotropic_inertia || !pushable(record) ||
        !(glm::length(turn) * (until - outlook.now) < std::numbers::pi))
        return turn;
    const Transform& from = record.motion->at;
    const FreeTurn end = turned_freely({double_quat_of(from.rotation), turn / outlook.step_s},
                                       record.traits.inertia_kgm2,
                                       duration_s);
    Transform to = from;
    to.rotation = Mat3{glm::mat3_cast(end.orientation)};
    return Vec3d(motion_between(from, to, 1).spin_radps) / (until - outlook.now);
}

/// Parts meet others at seams while they touch: points tell better then.
bool has_parts(const BodyRecord& record) {
    return record.traits.geometry->parts.size() > 1;
}

}  // namespace

bool may_meet(const BodyRecord& record, const BodyRecord& other, const Outlook& outlook) {
    if (!other.joints.empty()) return false;
    if (!pushable(other)) return true;
    return outlook.now == 0 || (other.small.awake && other.small.island == record.small.island);
}

void Forecast::begin(const Outlook& outlook) {
    outlook_ = outlook;
    bodies_.clear();
}

Forecast::Course& Forecast::course_of(const BodyRecord& record) {
    const auto [place, is_new] = bodies_.try_emplace(&record);
    if (is_new) place->second.gain_mps2 = gain_mps2(record);
    return place->second;
}

/// What the body will do from now on if nothing meets it.
BodyPath Forecast::predicted_path(const BodyRecord& record,
                                  const Course& course,
                                  double until) const {
    BodyPath path{.from = record.motion->at, .since = outlook_.now};
    if (!moves(record)) return path;
    const double left_s = (1 - outlook_.now) * outlook_.step_s;
    path.displacement_m =
        (Vec3d(record.motion->velocity_mps) + Vec3d(course.gain_mps2) * (left_s / 2)) *
        outlook_.step_s;
    path.turn_rad = predicted_turn_rad(record, outlook_, until);
    return path;
}

const Forecast::Course& Forecast::on_path(const BodyRecord& record, double until) {
    Course& known = course_of(record);
    if (known.until == until) return known;
    Course& course = known.until == 0 ? known : other_;
    course.path = predicted_path(record, known, until);
    // A mesh finds what is near by its own tree.
    if (record.traits.geometry->mesh == nullptr)
        course.swept = swept_bounds(*record.traits.geometry, course.path);
    course.until = until;
    return course;
}

/// Whether the balls round the two can meet in what is left of the step.
bool Forecast::may_come_near(const BodyRecord& a, const BodyRecord& b) {
    const auto left_s = static_cast<Real>((1 - outlook_.now) * outlook_.step_s);
    const Vec3 gain = course_of(a).gain_mps2 - course_of(b).gain_mps2;
    const Real closing_m = glm::distance(a.motion->velocity_mps, b.motion->velocity_mps) * left_s +
                           glm::length(gain) * left_s * left_s / 2;
    const Real apart_m = glm::distance(a.motion->at.position_m, b.motion->at.position_m);
    // With room for the distance at which they touch.
    return apart_m <= closing_m + (a.traits.radius_m + b.traits.radius_m) * 1.1_r;
}

PredictedImpact Forecast::first_impact(const BodyRecord& record) {
    return first_impact(record, 1, false);
}

PredictedImpact Forecast::first_impact(const BodyRecord& record, double latest, bool once_a_pair) {
    const double until = horizon_of(record, outlook_);
    PredictedImpact first{.share = std::min(until, latest)};
    const Course course = on_path(record, until);
    for (const PairLink& link : record.small.pairs) {
        BodyRecord& other = partner(*link.pair, record);
        if (!may_come_near(record, other) || !may_meet(record, other, outlook_)) continue;
        const bool touches = touch(*link.pair);
        if (touches && (has_parts(record) || has_parts(other))) continue;
        const Course& against = on_path(other, until);
        if (once_a_pair && against.is_compared) continue;
        const bool is_mesh = other.traits.geometry->mesh != nullptr;
        if (!is_mesh && !overlap(course.swept, against.swept)) continue;
        const auto impact = time_of_impact(
            {*record.traits.geometry, course.path, crossing_of(record), &course.swept},
            {*other.traits.geometry, against.path, crossing_of(other), &against.swept},
            touches ? Known::Touching : Known::Apart,
            first.share,
            until);
        if (impact) first = {impact->share, &other};
    }
    return first;
}

double Forecast::next_impact(std::span<BodyRecord* const> bodies) {
    double next = 1;
    for (const BodyRecord* record : bodies) {
        if (!outruns_points(*record, outlook_)) continue;
        next = std::min(next, first_impact(*record, next, true).share);
        course_of(*record).is_compared = true;
    }
    return std::max(next, outlook_.now);
}

std::vector<BodyRecord*> reached_after(const BodyRecord& record,
                                       const PredictedImpact& impact,
                                       const Outlook& outlook) {
    std::vector<BodyRecord*> reached;
    const auto until_s = static_cast<Real>((impact.share - outlook.now) * outlook.step_s);
    const auto left_s = static_cast<Real>((1 - impact.share) * outlook.step_s);
    const Real speed_mps = glm::length(record.motion->velocity_mps);
    const std::array<const BodyRecord*, 2> meeting{&record, impact.other};
    for (const BodyRecord* from : meeting) {
        const Vec3 place_m = from->motion->at.position_m + from->motion->velocity_mps * until_s;
        for (const PairLink& link : from->small.pairs) {
            BodyRecord& next = partner(*link.pair, *from);
            if (!pushable(next) || &next == &record || &next == impact.other ||
                !next.joints.empty())
                continue;
            const Vec3 there_m = next.motion->at.position_m + next.motion->velocity_mps * until_s;
            const Real moves_m = (speed_mps + glm::length(next.motion->velocity_mps)) * left_s;
            if (glm::distance(place_m, there_m) >
                from->traits.radius_m + next.traits.radius_m + moves_m)
                continue;
            if (std::ranges::find(reached, &next) == reached.end()) reached.push_back(&next);
        }
    }
    return reached;
}

}  // namespace plumbline::physics
