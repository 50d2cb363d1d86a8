#include "engine/physics/deformable/part_contacts.h"

#include "engine/core/io/archive.h"
#include "engine/physics/collision/mesh/triangle_distance.h"

#include <algorithm>
#include <cmath>

namespace plumbline::physics {
namespace {

constexpr int kPartSweeps = 2;
/// Of a cell's side: how far beyond the thickness, and what moves there within the time, pairs are listed.
constexpr double kMarginOfSide = 0.25;
/// Of the sine of the angle between edges: those that run along each other touch with their ends.
constexpr double kAlong = 0.05;
/// Least cosine between a contact's normal and those of the surfaces.
constexpr double kFacing = 0.5;
constexpr double kStraight = 0.9;
/// How much faster than at the start points may become in a step.
constexpr double kFaster = 1.5;
constexpr double kFaster_mps = 0.2;
/// How far points move, at most, and how many sub-steps they take between two looks at what touches.
constexpr double kLookOfThickness = 0.25;
constexpr double kMostLooked = 8;
/// Looked at beyond what moves there meanwhile.
constexpr double kLookAhead_m = 5e-4;

template <class T>
Vec3d weighted(const T& values,
               const std::array<std::uint32_t, 4>& points,
               const std::array<double, 4>& weights) {
    Vec3d sum{0, 0, 0};
    for (std::size_t i = 0; i < 4; ++i) sum += weights[i] * values[points[i]];
    return sum;
}

/// A ball round some points.
template <class T, std::size_t N>
PlaceBins::Place place_of(const std::array<std::uint32_t, N>& points, const T& at_m) {
    PlaceBins::Place place;
    for (const std::uint32_t point : points) place.middle_m += at_m[point] / double{N};
    for (const std::uint32_t point : points)
        place.radius_m = std::max(place.radius_m, glm::distance(at_m[point], place.middle_m));
    return place;
}

}  // namespace

PartContacts::PartContacts(PointBody& body, const SurfaceTraits& traits)
    : first_(&body),
      second_from_(static_cast<std::uint32_t>(body.positions_m().size())),
      traits_(traits),
      margin_m_(kMarginOfSide * body.longest_side_m()),
      rest_m_(body.positions_m().begin(), body.positions_m().end()) {
    list_parts();
}

PartContacts::PartContacts(PointBody& first, PointBody& second, const SurfaceTraits& traits)
    : first_(&first),
      second_(&second),
      second_from_(static_cast<std::uint32_t>(first.positions_m().size())),
      traits_(traits),
      margin_m_(kMarginOfSide * std::min(first.longest_side_m(), second.longest_side_m())) {
    list_parts();
}

PartContacts::Values PartContacts::positions_m() const {
    return {first_->positions_m(),
            second_ != nullptr ? second_->positions_m() : std::span<const Vec3d>{}};
}

PartContacts::Values PartContacts::velocities_mps() const {
    return {first_->velocities_mps(),
            second_ != nullptr ? second_->velocities_mps() : std::span<const Vec3d>{}};
}

double PartContacts::inverse_mass(std::size_t point) const {
    return point < second_from_ ? first_->inverse_mass(point)
                                : second_->inverse_mass(point - second_from_);
}

void PartContacts::change_velocity(std::size_t point, const Vec3d& by_mps) {
    if (point < second_from_) return first_->change_velocity(point, by_mps);
    second_->change_velocity(point - second_from_, by_mps);
}

bool PartContacts::list_parts() {
    const std::array<const PointBody*, 2> bodies{first_, second_};
    bool are_others = false;
    for (std::size_t i = 0; i < 2; ++i) {
        if (bodies[i] == nullptr) continue;
        const std::size_t torn = own_parts_[i].torn;
        const bool are_new = own_parts_[i].triangles.empty();
        bodies[i]->list_parts(own_parts_[i]);
        are_others = are_others || are_new || own_parts_[i].torn != torn;
    }
    if (!are_others) return false;
    parts_ = own_parts_[0];
    for (const auto& [a, b, c] : own_parts_[1].triangles)
        parts_.triangles.push_back({a + second_from_, b + second_from_, c + second_from_});
    for (const auto& [a, b] : own_parts_[1].edges)
        parts_.edges.push_back({a + second_from_, b + second_from_});
    return true;
}

/// For a few sub-steps: while nothing moves by much of the thickness.
void PartContacts::look(double h) {
    // Most of what moves slowly needs no new list.
    if (fastest_mps_ * seconds_ > margin_m_ / 2 && has_moved()) find(seconds_);
    const double before_s = looked_for_s_;
    looked_for_s_ =
        std::clamp(kLookOfThickness * traits_.thickness_m / fastest_mps_, h, kMostLooked * h);
    look_in_s_ = looked_for_s_;
    contacts_.clear();
    for (Pair& pair : pairs_) {
        pair.idle_s -= before_s;
        if (pair.idle_s < looked_for_s_) add(pair, looked_for_s_);
    }
}

void PartContacts::solve(double h) {
    if (look_in_s_ < h / 2) look(h);
    look_in_s_ -= h;
    for (Contact& contact : contacts_) {
        contact.pressed_Ns = 0;
        contact.rubbed_Ns = {0, 0, 0};
    }
    for (int sweep = 0; sweep < kPartSweeps; ++sweep) {
        for (Contact& contact : contacts_) solve_one(contact, h);
    }
}

void PartContacts::follow(double h) {
    for (Contact& contact : contacts_)
        contact.gap_m += h * glm::dot(contact.normal,
                                      weighted(velocities_mps(), contact.points, contact.weights));
}

void PartContacts::find_fastest() {
    const Values velocities = velocities_mps();
    double most2 = 0;
    for (std::size_t i = 0; i < velocities.size(); ++i)
        most2 = std::max(most2, glm::dot(velocities[i], velocities[i]));
    fastest_mps_ = kFaster * std::sqrt(most2) + kFaster_mps;
}

/// Farther than half of the margin, less what all have alike.
bool PartContacts::has_moved() const {
    const Values now = positions_m();
    if (listed_m_.size() != now.size()) return true;
    Vec3d mean{0, 0, 0};
    for (std::size_t i = 0; i < now.size(); ++i) mean += now[i] - listed_m_[i];
    mean /= static_cast<double>(now.size());
    double most2 = 0;
    for (std::size_t i = 0; i < now.size(); ++i) {
        const Vec3d own = now[i] - listed_m_[i] - mean;
        most2 = std::max(most2, glm::dot(own, own));
    }
    return std::sqrt(most2) > margin_m_ / 2;
}

/// Where the boxes round two bodies meet.
PartContacts::Within PartContacts::meeting_place() const {
    Within meeting;
    if (second_ == nullptr) return meeting;
    for (const PointBody* body : {first_, second_}) {
        const auto [low, high] = bounds_of(body->positions_m());
        meeting.low_m = glm::max(meeting.low_m, low);
        meeting.high_m = glm::min(meeting.high_m, high);
    }
    const double reach_m = traits_.thickness_m + 2 * margin_m_;
    meeting.low_m -= reach_m;
    meeting.high_m += reach_m;
    return meeting;
}

void PartContacts::find(double seconds) {
    seconds_ = seconds;
    looked_for_s_ = 0;
    look_in_s_ = 0;
    find_fastest();
    const Values at_m = positions_m();
    listed_m_.clear();
    for (std::size_t i = 0; i < at_m.size(); ++i) listed_m_.push_back(at_m[i]);
    std::vector<Pair> before;
    std::swap(before, pairs_);
    if (list_parts()) before.clear();  // torn: other numbers
    const Within within = meeting_place();
    if (within.is_empty()) return;
    find_normals();
    bin_parts(within);
    for (std::uint32_t i = 0; i < parts_.triangles.size(); ++i) {
        if (!within.has(at_m[parts_.triangles[i][0]], longest_m_)) continue;
        points_.for_near(place_of(parts_.triangles[i], at_m), [&](std::uint32_t point) {
            list({.first = point, .second = i}, before, seconds);
        });
    }
    for (std::uint32_t i = 0; i < parts_.edges.size(); ++i) {
        if (!within.has(at_m[parts_.edges[i][0]], longest_m_)) continue;
        edges_.for_near(place_of(parts_.edges[i], at_m), [&](std::uint32_t other) {
            if (other > i) list({.first = i, .second = other, .are_edges = true}, before, seconds);
        });
    }
    std::sort(pairs_.begin(), pairs_.end());
}

void PartContacts::bin_parts(const Within& within) {
    const Values at_m = positions_m();
    const double reach_m = traits_.thickness_m + 2 * margin_m_;
    longest_m_ = 0;
    for (const auto& [a, b] : parts_.edges)
        longest_m_ = std::max(longest_m_, glm::distance(at_m[a], at_m[b]));
    // A triangle of a cell lies within a side of its middle.
    points_.clear(at_m.size(), longest_m_ + reach_m);
    for (std::uint32_t i = 0; i < at_m.size(); ++i) {
        if (within.has(at_m[i], reach_m))
            points_.add({.middle_m = at_m[i], .radius_m = reach_m, .number = i});
    }
    edges_.clear(parts_.edges.size(), longest_m_ + reach_m);
    for (std::uint32_t i = 0; i < parts_.edges.size(); ++i) {
        if (!within.has(at_m[parts_.edges[i][0]], longest_m_ + reach_m)) continue;
        PlaceBins::Place place = place_of(parts_.edges[i], at_m);
        place.radius_m += reach_m;
        place.number = i;
        edges_.add(place);
    }
    longest_m_ *= 1.5;  // with a triangle's diagonal
}

/// Not what shares a point; of two bodies not what is of one.
bool PartContacts::may_touch(const Pair& pair) const {
    if (!pair.are_edges) {
        const auto& corners = parts_.triangles[pair.second];
        if (second_ != nullptr) return is_of_second(pair.first) != is_of_second(corners[0]);
        return std::ranges::find(corners, pair.first) == corners.end();
    }
    const auto& [a, b] = parts_.edges[pair.first];
    const auto& [c, d] = parts_.edges[pair.second];
    if (second_ != nullptr) return is_of_second(a) != is_of_second(c);
    return a != c && a != d && b != c && b != d;
}

void PartContacts::list(Pair pair, std::span<const Pair> before, double seconds) {
    if (!may_touch(pair)) return;
    const Contact contact = contact_of(pair);
    const Vec3d apart_m = weighted(positions_m(), contact.points, contact.weights);
    const Vec3d opening_mps = weighted(velocities_mps(), contact.points, contact.weights);
    const double reach_m = traits_.thickness_m + margin_m_ + glm::length(opening_mps) * seconds;
    if (!(glm::dot(apart_m, apart_m) <= reach_m * reach_m)) return;
    const auto same = std::lower_bound(before.begin(), before.end(), pair);
    if (same != before.end() && !(pair < *same)) pair.side = same->side;
    pairs_.push_back(pair);
}

PartContacts::Contact PartContacts::contact_of(const Pair& pair) const {
    return pair.are_edges ? edge_contact(pair) : point_contact(pair);
}

PartContacts::Contact PartContacts::point_contact(const Pair& pair) const {
    const Values at_m = positions_m();
    const auto& [i, j, k] = parts_.triangles[pair.second];
    const Vec3d& p = at_m[pair.first];
    const Vec3d& a = at_m[i];
    const auto shares = nearest_shares(p, {a, at_m[j], at_m[k]});
    Contact contact{.points = {pair.first, i, j, k},
                    .weights = {1, -shares[0], -shares[1], -shares[2]}};
    if (std::ranges::min(shares) > 0)
        contact.side = glm::dot(glm::cross(at_m[j] - a, at_m[k] - a), p - a) < 0 ? -1 : 1;
    return contact;
}

/// Where an end is closer, or they run along each other, the ends are what touches: there is no side.
PartContacts::Contact PartContacts::edge_contact(const Pair& pair) const {
    const Values at_m = positions_m();
    const auto& [a, b] = parts_.edges[pair.first];
    const auto& [c, d] = parts_.edges[pair.second];
    const Vec3d u = at_m[b] - at_m[a];
    const Vec3d v = at_m[d] - at_m[c];
    const Vec3d w = at_m[a] - at_m[c];
    const double uu = glm::dot(u, u);
    const double uv = glm::dot(u, v);
    const double vv = glm::dot(v, v);
    const double across = std::max(uu * vv - uv * uv, kAlong * kAlong * uu * vv);
    const double s = std::clamp((uv * glm::dot(v, w) - vv * glm::dot(u, w)) / across, 0.0, 1.0);
    const double t = std::clamp((uu * glm::dot(v, w) - uv * glm::dot(u, w)) / across, 0.0, 1.0);
    Contact contact{.points = {a, b, c, d}, .weights = {1 - s, s, t - 1, -t}};
    contact.run_along = uu * vv - uv * uv <= kAlong * kAlong * uu * vv;
    if (!contact.run_along && s > 0 && s < 1 && t > 0 && t < 1)
        contact.side = glm::dot(glm::cross(u, v), w) < 0 ? -1 : 1;
    return contact;
}

/// Points' normals, of what encloses something; of the rest 0.
void PartContacts::find_normals() {
    const Values at_m = positions_m();
    normals_.assign(at_m.size(), Vec3d{0, 0, 0});
    if (!own_parts_[0].encloses && !own_parts_[1].encloses) return;
    for (const auto& [a, b, c] : parts_.triangles) {
        if (!own_parts_[is_of_second(a) ? 1 : 0].encloses) continue;
        const Vec3d normal = glm::cross(at_m[b] - at_m[a], at_m[c] - at_m[a]);
        for (const std::uint32_t point : {a, b, c}) normals_[point] += normal;
    }
    for (Vec3d& normal : normals_) normal = normalize_or(normal, Vec3d{0, 0, 0});
}

/// Out of the second, and into the first, as far as they enclose something.
Vec3d PartContacts::facing_of(const Contact& contact, bool are_edges) const {
    const auto& [a, b, c, d] = contact.points;
    if (are_edges) return normals_[c] + normals_[d] - normals_[a] - normals_[b];
    return normals_[b] + normals_[c] + normals_[d] - normals_[a];
}

/// Turns the normal to the side where the first should be; false: they do not face each other.
bool PartContacts::turn(const Pair& pair, Contact& contact, double& distance_m) const {
    const Vec3d facing = facing_of(contact, pair.are_edges);
    const bool is_known = facing != Vec3d{0, 0, 0};
    const double cosine = is_known ? glm::dot(contact.normal, glm::normalize(facing)) : 1;
    const bool has_passed = is_known ? cosine < 0 : contact.side != 0 && contact.side == -pair.side;
    if (!has_passed) return cosine > kFacing;
    contact.normal = -contact.normal;
    distance_m = -distance_m;
    // Beyond its edge another triangle is nearer.
    return !is_known || -cosine > (contact.side == 0 ? kStraight : kFacing);
}

void PartContacts::add(Pair& pair, double seconds) {
    Contact contact = contact_of(pair);
    const Vec3d apart_m = weighted(positions_m(), contact.points, contact.weights);
    double distance_m = glm::length(apart_m);
    pair.idle_s = (distance_m - traits_.thickness_m) / (2 * fastest_mps_);
    if (pair.are_edges && contact.side == 0) {
        if (contact.run_along) pair.side = 0;  // it may be another when they cross again
        return;                                // an end is closer: its point
    }
    if (!(distance_m > 0)) return;
    contact.normal = apart_m / distance_m;
    if (!turn(pair, contact, distance_m)) return;
    const double opening =
        glm::dot(contact.normal, weighted(velocities_mps(), contact.points, contact.weights));
    if (distance_m + std::min(opening, 0.0) * seconds > traits_.thickness_m + kLookAhead_m) {
        pair.side = 0;
        return;
    }
    pair.idle_s = 0;
    if (pair.side == 0) pair.side = contact.side;
    contact.gap_m = distance_m - traits_.thickness_m;
    if (second_ == nullptr) {
        // Neighbours are closer than a coarse thread is thick.
        const double rest_m = glm::length(weighted(rest_m_, contact.points, contact.weights));
        contact.gap_m = distance_m - std::min(traits_.thickness_m, rest_m / 2);
    }
    for (std::size_t i = 0; i < 4; ++i)
        contact.inverse_mass +=
            contact.weights[i] * contact.weights[i] * inverse_mass(contact.points[i]);
    if (contact.inverse_mass > 0) contacts_.push_back(contact);
}

void PartContacts::solve_one(Contact& contact, double h) {
    const Vec3d relative = weighted(velocities_mps(), contact.points, contact.weights);
    const double opening = glm::dot(contact.normal, relative);
    const double wanted = wanted_opening_mps(contact.gap_m, h);
    if (opening >= wanted && contact.pressed_Ns == 0) return;
    const double pressed_Ns =
        std::max(contact.pressed_Ns + (wanted - opening) / contact.inverse_mass, 0.0);
    Vec3d rubbed_Ns =
        contact.rubbed_Ns - (relative - contact.normal * opening) / contact.inverse_mass;
    const double most_Ns = traits_.friction * pressed_Ns;
    const double size_Ns = glm::length(rubbed_Ns);
    if (size_Ns > most_Ns) rubbed_Ns *= most_Ns / size_Ns;
    const Vec3d impulse_Ns =
        contact.normal * (pressed_Ns - contact.pressed_Ns) + rubbed_Ns - contact.rubbed_Ns;
    contact.pressed_Ns = pressed_Ns;
    contact.rubbed_Ns = rubbed_Ns;
    for (std::size_t i = 0; i < 4; ++i)
        change_velocity(contact.points[i],
                        impulse_Ns * (contact.weights[i] * inverse_mass(contact.points[i])));
}

void PartContacts::Pair::serialize(Archive& archive) {
    archive(first, second, are_edges, side);
}

void PartContacts::serialize(Archive& archive) {
    archive(pairs_);
}

}  // namespace plumbline::physics
