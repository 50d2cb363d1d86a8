#include "engine/physics/dynamics/body_sweep.h"

#include "engine/physics/bullet/body.h"
#include "engine/physics/bullet/cast.h"
#include "engine/physics/bullet/rotations.h"
#include "engine/physics/collision/pair_reach.h"
#include "engine/physics/dynamics/rotation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace plumbline::physics {
namespace {

/// Of a step's displacement: below it a body was at the impact when the step began.
constexpr Real kStuckShare = 0.02_r;

/// Where the body's path to where it is now begins.
const Transform& start_of(const BodyRecord& record) {
    return record.sweep.since > 0 ? record.sweep.from : record.before.at;
}

/// What the body did since then.
BodyPath path_of(const BodyRecord& record) {
    const auto since = static_cast<double>(record.sweep.since);
    const auto until = static_cast<double>(record.sweep.until);
    if (stands_still(record) || !(until > since)) return {.from = record.motion->at};
    const Transform& from = start_of(record);
    const SteadyMotion motion = motion_between(from, record.motion->at, 1);
    return {.from = from,
            .displacement_m = Vec3d(motion.velocity_mps) / (until - since),
            .turn_rad = Vec3d(motion.spin_radps) / (until - since),
            .since = since,
            .until = until};
}

/// The pair of two bodies; null: none.
Pair* pair_of(const BodyRecord& a, const BodyRecord& b) {
    const auto& pairs = a.small.pairs;
    const auto place =
        std::lower_bound(pairs.begin(), pairs.end(), b.id, [](const PairLink& link, BodyId id) {
            return link.other < id;
        });
    return place != pairs.end() && place->other == b.id ? place->pair : nullptr;
}

/// Whether the step found contact points between the two before it moved them.
bool are_in_contact(const BodyRecord& a, const BodyRecord& b) {
    const Pair* pair = pair_of(a, b);
    return pair != nullptr && pair->touches;
}

double turned_share(const BodyRecord& record, double angle_rad) {
    const bool is_ball = record.traits.primitive.kind == ConvexShape::Kind::Sphere;
    return is_ball ? 0 : std::min(angle_rad, 2.0) * static_cast<double>(record.traits.radius_m);
}

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

Vec3 gain_mps2(const BodyRecord& record) {
    if (!pushable(record) || !record.small.awake || !flies(record)) return {0, 0, 0};
    return record.applied.force_N * record.motion->inverse_mass;
}

double crossing_of(const BodyRecord& record) {
    constexpr double kCrossingShare = 0.5;
    const auto radius_m = static_cast<double>(record.sweep.inner_radius_m);
    return radius_m > 0 ? kCrossingShare * radius_m : std::numeric_limits<double>::infinity();
}

bool moves_past_itself(const BodyRecord& record) {
    if (record.sweep.inner_radius_m <= 0 || record.sweep.ccd == ContinuousCollision::Off)
        return false;
    if (record.sweep.ccd == ContinuousCollision::On) return true;
    const Transform& from = start_of(record);
    const Transform& to = record.motion->at;
    Real farthest_m = glm::distance(from.position_m, to.position_m);
    if (record.traits.primitive.kind != ConvexShape::Kind::Sphere) {
        Real traces = 0;
        for (int axis = 0; axis < 3; ++axis)
            traces += glm::dot(from.rotation[axis], to.rotation[axis]);
        farthest_m += std::sqrt(std::max(3 - traces, Real{0})) * record.traits.radius_m;
    }
    return farthest_m > record.sweep.inner_radius_m;
}

Impact first_impact(const StepWorld& world, const BodyRecord& record, std::uint32_t unseen_group) {
    const BodyPath path = path_of(record);
    const MovingBody moving{
        *record.traits.geometry, path, crossing_of(record), nullptr, record.filter};
    Impact first;
    const auto near = bodies_near(world,
                                  swept_bounds(moving.geometry, path),
                                  {.group = record.filter.group,
                                   .collides_with = record.filter.collides_with,
                                   .ignored = &record,
                                   .unseen_group = unseen_group});
    for (const BodyRecord* other : near) {
        const BodyPath other_path = path_of(*other);
        const auto impact = time_of_impact(
            moving,
            {*other->traits.geometry, other_path, crossing_of(*other), nullptr, other->filter},
            are_in_contact(record, *other) ? Known::Held : Known::Nothing,
            first.share);
        if (impact) first = *impact;
    }
    return first;
}

bool outruns_points(const BodyRecord& record, const Outlook& outlook) {
    if (record.sweep.inner_radius_m <= 0 || record.sweep.ccd == ContinuousCollision::Off)
        return false;
    const double left_s = (1 - outlook.now) * outlook.step_s;
    const double moves_m =
        static_cast<double>(glm::length(record.motion->velocity_mps)) * left_s +
        static_cast<double>(glm::length(gain_mps2(record))) * (left_s * left_s / 2) +
        turned_share(record, static_cast<double>(glm::length(record.motion->spin_radps)) * left_s);
    return moves_m > static_cast<double>(ahead_m(record));
}

double touching_m(const BodyRecord& a, const BodyRecord& b) {
    constexpr double kTouchingShare = 0.04;
    return kTouchingShare * std::min(crossing_of(a), crossing_of(b));
}

bool touch(const Pair& pair) {
    const auto is_touching = [limit_m = touching_m(*pair.a, *pair.b)](const ManifoldPoint& point) {
        return static_cast<double>(point.distance_m) <= limit_m;
    };
    return pair.touches && std::ranges::any_of(pair.manifolds, [&](const Manifold& manifold) {
               return std::ranges::any_of(manifold.points, is_touching);
           });
}

bool flies(const BodyRecord& record) {
    return std::ranges::none_of(record.small.pairs,
                                [](const PairLink& link) { return touch(*link.pair); });
}

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
        const auto impact = time_of_impact({*record.traits.geometry,
                                            course.path,
                                            crossing_of(record),
                                            &course.swept,
                                            record.filter},
                                           {*other.traits.geometry,
                                            against.path,
                                            crossing_of(other),
                                            &against.swept,
                                            other.filter},
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

bool stop_at_hit(const StepWorld& world, BodyRecord& record, Real duration_s) {
    const Impact impact = first_impact(world, record, 0);
    if (impact.share >= 1) return false;
    const auto share = static_cast<Real>(impact.share);
    stop_at_share(record, share);
    // Less the speed of the fall that it did not make.
    record.motion->velocity_mps -=
        record.traits.weight_N * record.motion->inverse_mass * (duration_s * (1 - share));
    // What stands at the impact already and still heads for it would gain that speed in every step.
    const Vec3 normal{impact.normal};
    const Real into = glm::dot(record.motion->velocity_mps, normal);
    if (share - record.sweep.since < kStuckShare && into < 0)
        record.motion->velocity_mps -= normal * into;
    return true;
}

void stop_at_share(BodyRecord& record, Real share) {
    if (share >= record.sweep.until || record.sweep.since >= record.sweep.until) return;
    const Real since = record.sweep.since;
    const Real part = (share - since) / (record.sweep.until - since);
    const Transform from = start_of(record);
    const Transform to = record.motion->at;
    record.motion->ballistic.going = false;
    Transform stopped = from;
    stopped.position_m += (to.position_m - from.position_m) * part;
    stopped.rotation = turned_part_way(from.rotation, to.rotation, part);
    record.motion->at = stopped;
    record.sweep.until = share;
    write_rigid_pose(record);
}

}  // namespace plumbline::physics
