#include "engine/physics/self_contacts.h"

#include "engine/core/io/archive.h"
#include "engine/physics/surface_contacts.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace plumbline::physics {
namespace {

constexpr int kSelfSweeps = 2;
/// Of a cell's side: how far beyond the thickness, and what moves there within the time, pairs are listed.
constexpr double kMarginOfSide = 0.25;
/// Of the sine of the angle between edges: those that run along each other touch with their ends.
constexpr double kAlong = 0.05;
constexpr double kMostBin = 1e15;
constexpr std::uint32_t kNoPlace = ~std::uint32_t{0};

/// Shares of a triangle's corners at its place closest to a point (Ericson, Real-Time Collision Detection, 5.1.5).
std::array<double, 3> closest_shares(const Vec3d& p,
                                     const Vec3d& a,
                                     const Vec3d& b,
                                     const Vec3d& c) {
    const Vec3d ab = b - a;
    const Vec3d ac = c - a;
    const double d1 = glm::dot(ab, p - a);
    const double d2 = glm::dot(ac, p - a);
    if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
    const double d3 = glm::dot(ab, p - b);
    const double d4 = glm::dot(ac, p - b);
    if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return {1 - d1 / (d1 - d3), d1 / (d1 - d3), 0};
    const double d5 = glm::dot(ab, p - c);
    const double d6 = glm::dot(ac, p - c);
    if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) return {1 - d2 / (d2 - d6), 0, d2 / (d2 - d6)};
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
        const double share = (d4 - d3) / (d4 - d3 + d5 - d6);
        return {0, 1 - share, share};
    }
    const double sum = va + vb + vc;
    return {va / sum, vb / sum, vc / sum};
}

template <class T>
Vec3d weighted(const T& values,
               const std::array<std::uint32_t, 4>& points,
               const std::array<double, 4>& weights) {
    Vec3d sum{0, 0, 0};
    for (std::size_t i = 0; i < 4; ++i) sum += weights[i] * values[points[i]];
    return sum;
}

/// A ball round some points.
template <std::size_t N>
PlaceBins::Place place_of(const std::array<std::uint32_t, N>& points, std::span<const Vec3d> at_m) {
    PlaceBins::Place place;
    for (const std::uint32_t point : points) place.middle_m += at_m[point] / double{N};
    for (const std::uint32_t point : points)
        place.radius_m = std::max(place.radius_m, glm::distance(at_m[point], place.middle_m));
    return place;
}

/// How far any has moved, less what all have alike.
double most_moved(std::span<const Vec3d> now, std::span<const Vec3d> before) {
    Vec3d mean{0, 0, 0};
    for (std::size_t i = 0; i < now.size(); ++i) mean += now[i] - before[i];
    mean /= static_cast<double>(now.size());
    double most2 = 0;
    for (std::size_t i = 0; i < now.size(); ++i) {
        const Vec3d own = now[i] - before[i] - mean;
        most2 = std::max(most2, glm::dot(own, own));
    }
    return std::sqrt(most2);
}

}  // namespace

void PlaceBins::clear(std::size_t count, double side_m) {
    side_m_ = side_m;
    places_.clear();
    heads_.assign(std::bit_ceil(2 * count + 1), kNoPlace);
}

/// Of the cube that is so many cubes away.
std::size_t PlaceBins::bin_of(const Vec3d& at_m, const std::array<int, 3>& away) const {
    std::size_t hash = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double number =
            std::floor(at_m[axis] / side_m_) + away[static_cast<std::size_t>(axis)];
        // Any odd factor mixes them; numbers that are too large share a bin.
        const double kept = std::clamp(number, -kMostBin, kMostBin);
        hash =
            hash * 0x9E3779B97F4A7C15U + static_cast<std::size_t>(static_cast<std::int64_t>(kept));
    }
    return (hash ^ hash >> 32U) & (heads_.size() - 1);
}

void PlaceBins::add(const Place& place) {
    const std::size_t bin = bin_of(place.middle_m, {0, 0, 0});
    places_.push_back(place);
    places_.back().next = heads_[bin];
    heads_[bin] = static_cast<std::uint32_t>(places_.size() - 1);
}

template <class F>
void PlaceBins::for_near(const Place& place, const F& visit) const {
    std::array<std::size_t, 27> bins{};
    std::size_t count = 0;
    for (int x = -1; x <= 1; ++x) {
        for (int y = -1; y <= 1; ++y) {
            for (int z = -1; z <= 1; ++z) bins[count++] = bin_of(place.middle_m, {x, y, z});
        }
    }
    std::ranges::sort(bins);
    for (std::size_t i = 0; i < bins.size(); ++i) {
        if (i > 0 && bins[i] == bins[i - 1]) continue;  // two cubes in one bin
        for (std::uint32_t at = heads_[bins[i]]; at != kNoPlace; at = places_[at].next) {
            const Vec3d apart_m = places_[at].middle_m - place.middle_m;
            const double near_m = places_[at].radius_m + place.radius_m;
            if (glm::dot(apart_m, apart_m) <= near_m * near_m) visit(places_[at].number);
        }
    }
}

SelfContacts::SelfContacts(const PointBody& body, double thickness_m, double friction)
    : thickness_m_(thickness_m),
      friction_(friction),
      margin_m_(kMarginOfSide * body.longest_side_m()),
      rest_m_(body.positions_m().begin(), body.positions_m().end()) {
    body.list_parts(parts_);
}

void SelfContacts::solve(PointBody& body, double h) {
    if (most_moved(body.positions_m(), listed_m_) > margin_m_) find(body, seconds_);
    contacts_.clear();
    for (Pair& pair : pairs_) add(body, pair, h);
    for (int sweep = 0; sweep < kSelfSweeps; ++sweep) {
        for (const Contact& contact : contacts_) solve_one(contact, body, h);
    }
}

void SelfContacts::find(const PointBody& body, double seconds) {
    seconds_ = seconds;
    listed_m_.assign(body.positions_m().begin(), body.positions_m().end());
    const auto at_m = body.positions_m();
    const std::size_t known = parts_.triangles.size();
    body.list_parts(parts_);
    std::vector<Pair> before;
    std::swap(before, pairs_);
    if (parts_.triangles.size() != known) before.clear();  // torn: other numbers
    bin_parts(at_m);
    const auto list = [&](Pair pair) {
        if (share_points(pair)) return;
        const Contact contact = contact_of(pair, at_m);
        const Vec3d apart_m = weighted(at_m, contact.points, contact.weights);
        const Vec3d opening_mps = weighted(body.velocities_mps(), contact.points, contact.weights);
        const double reach_m = thickness_m_ + margin_m_ + glm::length(opening_mps) * seconds;
        if (!(glm::dot(apart_m, apart_m) <= reach_m * reach_m)) return;
        const auto same = std::lower_bound(before.begin(), before.end(), pair);
        if (same != before.end() && !(pair < *same)) pair.side = same->side;
        pairs_.push_back(pair);
    };
    for (std::uint32_t i = 0; i < parts_.triangles.size(); ++i) {
        const PlaceBins::Place there = place_of(parts_.triangles[i], at_m);
        points_.for_near(there, [&](std::uint32_t point) { list({.first = point, .second = i}); });
    }
    for (std::uint32_t i = 0; i < parts_.edges.size(); ++i) {
        edges_.for_near(place_of(parts_.edges[i], at_m), [&](std::uint32_t other) {
            if (other > i) list({.first = i, .second = other, .are_edges = true});
        });
    }
    std::sort(pairs_.begin(), pairs_.end());
}

void SelfContacts::bin_parts(std::span<const Vec3d> at_m) {
    const double reach_m = thickness_m_ + 2 * margin_m_;
    double largest_m = 0;
    for (const auto& edge : parts_.edges)
        largest_m = std::max(largest_m, place_of(edge, at_m).radius_m);
    // A triangle of a cell lies within a side of its middle.
    points_.clear(at_m.size(), 2 * largest_m + reach_m);
    for (std::uint32_t i = 0; i < at_m.size(); ++i)
        points_.add({.middle_m = at_m[i], .radius_m = reach_m, .number = i});
    edges_.clear(parts_.edges.size(), 2 * largest_m + reach_m);
    for (std::uint32_t i = 0; i < parts_.edges.size(); ++i) {
        PlaceBins::Place place = place_of(parts_.edges[i], at_m);
        place.radius_m += reach_m;
        place.number = i;
        edges_.add(place);
    }
}

bool SelfContacts::share_points(const Pair& pair) const {
    if (!pair.are_edges) {
        const auto& corners = parts_.triangles[pair.second];
        return std::ranges::find(corners, pair.first) != corners.end();
    }
    const auto& [a, b] = parts_.edges[pair.first];
    const auto& [c, d] = parts_.edges[pair.second];
    return a == c || a == d || b == c || b == d;
}

SelfContacts::Contact SelfContacts::contact_of(const Pair& pair,
                                               std::span<const Vec3d> at_m) const {
    return pair.are_edges ? edge_contact(pair, at_m) : point_contact(pair, at_m);
}

SelfContacts::Contact SelfContacts::point_contact(const Pair& pair,
                                                  std::span<const Vec3d> at_m) const {
    const auto& [i, j, k] = parts_.triangles[pair.second];
    const Vec3d& p = at_m[pair.first];
    const Vec3d& a = at_m[i];
    const auto shares = closest_shares(p, a, at_m[j], at_m[k]);
    Contact contact{.points = {pair.first, i, j, k},
                    .weights = {1, -shares[0], -shares[1], -shares[2]}};
    if (std::ranges::min(shares) > 0)
        contact.side = glm::dot(glm::cross(at_m[j] - a, at_m[k] - a), p - a) < 0 ? -1 : 1;
    return contact;
}

/// Where an end is closer, or they run along each other, the ends are what touches: weights of first points, far apart.
SelfContacts::Contact SelfContacts::edge_contact(const Pair& pair,
                                                 std::span<const Vec3d> at_m) const {
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
    if (s > 0 && s < 1 && t > 0 && t < 1) contact.side = glm::dot(glm::cross(u, v), w) < 0 ? -1 : 1;
    return contact;
}

void SelfContacts::add(const PointBody& body, Pair& pair, double h) {
    Contact contact = contact_of(pair, body.positions_m());
    if (pair.are_edges && contact.side == 0) return;  // an end is closer: its point
    const Vec3d apart_m = weighted(body.positions_m(), contact.points, contact.weights);
    double distance_m = glm::length(apart_m);
    if (!(distance_m > 0)) return;
    contact.normal = apart_m / distance_m;
    if (contact.side != 0 && contact.side == -pair.side) {
        contact.normal = -contact.normal;
        distance_m = -distance_m;
    }
    const double opening =
        glm::dot(contact.normal, weighted(body.velocities_mps(), contact.points, contact.weights));
    if (distance_m + std::min(opening, 0.0) * h > thickness_m_) {
        pair.side = 0;
        return;
    }
    if (pair.side == 0) pair.side = contact.side;
    // Neighbours are closer than a coarse thread is thick.
    const double rest_m = glm::length(weighted(rest_m_, contact.points, contact.weights));
    contact.gap_m = distance_m - std::min(thickness_m_, rest_m / 2);
    for (std::size_t i = 0; i < 4; ++i)
        contact.inverse_mass +=
            contact.weights[i] * contact.weights[i] * body.inverse_mass(contact.points[i]);
    if (contact.inverse_mass > 0) contacts_.push_back(contact);
}

void SelfContacts::solve_one(const Contact& contact, PointBody& body, double h) const {
    const Vec3d relative = weighted(body.velocities_mps(), contact.points, contact.weights);
    const double opening = glm::dot(contact.normal, relative);
    const double wanted = wanted_opening_mps(contact.gap_m, h);
    if (opening >= wanted) return;
    const Vec3d sliding = relative - contact.normal * opening;
    const double speed = glm::length(sliding);
    const double pressed_mps = wanted - opening;
    Vec3d change_mps = contact.normal * pressed_mps;
    if (speed > 0) change_mps -= sliding * std::min(friction_ * pressed_mps / speed, 1.0);
    for (std::size_t i = 0; i < 4; ++i)
        body.change_velocity(
            contact.points[i],
            change_mps *
                (contact.weights[i] * body.inverse_mass(contact.points[i]) / contact.inverse_mass));
}

void SelfContacts::Pair::serialize(Archive& archive) {
    archive(first, second, are_edges, side);
}

void SelfContacts::serialize(Archive& archive) {
    archive(pairs_);
}

}  // namespace plumbline::physics
