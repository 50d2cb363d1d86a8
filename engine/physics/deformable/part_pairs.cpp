#include "engine/physics/deformable/part_pairs.h"

#include "engine/core/io/archive.h"
#include "engine/core/io/pose_archive.h"
#include "engine/physics/collision/mesh/triangle_distance.h"
#include "engine/physics/deformable/place_bins.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace plumbline::physics {
namespace {

/// Of a cell's side: how far beyond the thickness, and what moves there within the time, pairs are listed.
constexpr double kMarginOfSide = 0.25;
/// Of the longest side, with a triangle's diagonal.
constexpr double kDiagonal = 1.5;
/// Of the sine of the angle between edges: those that run along each other touch with their ends.
constexpr double kAlong = 0.05;

/// A ball round some points.
template <class T, std::size_t N>
PlaceBins::Place ball_round(const std::array<std::uint32_t, N>& points, const T& at_m) {
    PlaceBins::Place place;
    for (const std::uint32_t point : points) place.middle_m += at_m[point] / double{N};
    for (const std::uint32_t point : points)
        place.radius_m = std::max(place.radius_m, glm::distance(at_m[point], place.middle_m));
    return place;
}

}  // namespace

PartPairs::PartPairs(const PointBody& first, const PointBody* second, double thickness_m)
    : first_(&first),
      second_(second),
      second_from_(static_cast<std::uint32_t>(first.positions_m().size())),
      thickness_m_(thickness_m),
      margin_m_(kMarginOfSide * (second != nullptr
                                     ? std::min(first.longest_side_m(), second->longest_side_m())
                                     : first.longest_side_m())),
      reach_m_(thickness_m + 2 * margin_m_) {
    list_parts();
}

PointValues PartPairs::positions_m() const {
    return {first_->positions_m(),
            second_ != nullptr ? second_->positions_m() : std::span<const Vec3d>{}};
}

PointValues PartPairs::velocities_mps() const {
    return {first_->velocities_mps(),
            second_ != nullptr ? second_->velocities_mps() : std::span<const Vec3d>{}};
}

bool PartPairs::list_parts() {
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

void PartPairs::begin_step(double seconds) {
    seconds_ = seconds;
    if (list_parts()) {  // torn: other numbers
        pairs_.clear();
        listed_m_.clear();
    }
    moved_m_ = moved_since_listed_m();
    if (moved_m_ > margin_m_ / 2) return find();
    for (PartPair& pair : pairs_) pair.idle_s = 0;
}

bool PartPairs::keep_up(double most_m) {
    if (moved_m_ + most_m <= margin_m_ / 2 || moved_since_listed_m() <= margin_m_ / 2) return false;
    find();
    return true;
}

/// Less what all have alike; infinite where nothing is listed.
double PartPairs::moved_since_listed_m() const {
    const PointValues now = positions_m();
    if (listed_m_.size() != now.size()) return std::numeric_limits<double>::infinity();
    Vec3d mean{0, 0, 0};
    for (std::size_t i = 0; i < now.size(); ++i) mean += now[i] - listed_m_[i];
    mean /= static_cast<double>(now.size());
    double most2 = 0;
    for (std::size_t i = 0; i < now.size(); ++i) {
        const Vec3d own = now[i] - listed_m_[i] - mean;
        most2 = std::max(most2, glm::dot(own, own));
    }
    return std::sqrt(most2);
}

/// Where the boxes round two bodies meet.
PartPairs::Within PartPairs::meeting_place() const {
    Within meeting;
    if (second_ == nullptr) return meeting;
    for (const PointBody* body : {first_, second_}) {
        const auto [low, high] = bounds_of(body->positions_m());
        meeting.low_m = glm::max(meeting.low_m, low);
        meeting.high_m = glm::min(meeting.high_m, high);
    }
    meeting.low_m -= reach_m_;
    meeting.high_m += reach_m_;
    return meeting;
}

void PartPairs::find() {
    const PointValues at_m = positions_m();
    listed_m_.clear();
    for (std::size_t i = 0; i < at_m.size(); ++i) listed_m_.push_back(at_m[i]);
    moved_m_ = 0;
    std::vector<PartPair> before;
    std::swap(before, pairs_);
    const Within within = meeting_place();
    if (within.is_empty()) return;
    const auto number = [](std::size_t count) { return static_cast<std::uint32_t>(count); };
    const Numbers points{0, number(at_m.size())};
    const Numbers triangles{0, number(parts_.triangles.size())};
    const Numbers edges{0, number(parts_.edges.size())};
    double longest_m = 0;
    for (const auto& [a, b] : parts_.edges)
        longest_m = std::max(longest_m, glm::distance(at_m[a], at_m[b]));
    const Search search{within, longest_m, before};
    if (second_ == nullptr) {
        list_points(points, triangles, search);
        list_edges(edges, edges, search);
    } else {
        const std::uint32_t second_triangle = number(own_parts_[0].triangles.size());
        const std::uint32_t second_edge = number(own_parts_[0].edges.size());
        list_points({0, second_from_}, {second_triangle, triangles.end}, search);
        list_points({second_from_, points.end}, {0, second_triangle}, search);
        list_edges({0, second_edge}, {second_edge, edges.end}, search);
    }
    std::sort(pairs_.begin(), pairs_.end());
}

/// Points against triangles.
void PartPairs::list_points(Numbers points, Numbers triangles, const Search& search) {
    const PointValues at_m = positions_m();
    std::vector<PlaceBins::Place> places;
    for (std::uint32_t i = points.begin; i < points.end; ++i) {
        if (search.within.has(at_m[i], reach_m_))
            places.push_back({.middle_m = at_m[i], .radius_m = reach_m_, .number = i});
    }
    // A triangle of a cell lies within a side of its middle, and its longest side is a diagonal.
    const PlaceBins bins(std::move(places), search.longest_m + reach_m_);
    for (std::uint32_t i = triangles.begin; i < triangles.end; ++i) {
        if (!search.within.has(at_m[parts_.triangles[i][0]], kDiagonal * search.longest_m))
            continue;
        bins.for_near(ball_round(parts_.triangles[i], at_m), [&](std::uint32_t point) {
            list({.first = point, .second = i}, search.before);
        });
    }
}

void PartPairs::list_edges(Numbers firsts, Numbers seconds, const Search& search) {
    const PointValues at_m = positions_m();
    std::vector<PlaceBins::Place> places;
    for (std::uint32_t i = firsts.begin; i < firsts.end; ++i) {
        if (!search.within.has(at_m[parts_.edges[i][0]], search.longest_m + reach_m_)) continue;
        PlaceBins::Place place = ball_round(parts_.edges[i], at_m);
        place.radius_m += reach_m_;
        place.number = i;
        places.push_back(place);
    }
    const PlaceBins bins(std::move(places), search.longest_m + reach_m_);
    for (std::uint32_t i = seconds.begin; i < seconds.end; ++i) {
        if (!search.within.has(at_m[parts_.edges[i][0]], kDiagonal * search.longest_m)) continue;
        bins.for_near(ball_round(parts_.edges[i], at_m), [&](std::uint32_t other) {
            if (other < i) list({.first = other, .second = i, .are_edges = true}, search.before);
        });
    }
}

/// What shares a point does not.
bool PartPairs::may_touch(const PartPair& pair) const {
    if (!pair.are_edges) {
        const auto& corners = parts_.triangles[pair.second];
        return std::ranges::find(corners, pair.first) == corners.end();
    }
    const auto& [a, b] = parts_.edges[pair.first];
    const auto& [c, d] = parts_.edges[pair.second];
    return a != c && a != d && b != c && b != d;
}

void PartPairs::list(PartPair pair, std::span<const PartPair> before) {
    if (!may_touch(pair)) return;
    const PartPlace place = place_of(pair);
    const Vec3d apart_m = place.difference(positions_m());
    const Vec3d opening_mps = place.difference(velocities_mps());
    const double reach_m = thickness_m_ + margin_m_ + glm::length(opening_mps) * seconds_;
    if (!(glm::dot(apart_m, apart_m) <= reach_m * reach_m)) return;
    const auto same = std::lower_bound(before.begin(), before.end(), pair);
    if (same != before.end() && !(pair < *same)) pair.side = same->side;
    pairs_.push_back(pair);
}

PartPlace PartPairs::place_of(const PartPair& pair) const {
    return pair.are_edges ? place_between_edges(pair) : place_at_triangle(pair);
}

PartPlace PartPairs::place_at_triangle(const PartPair& pair) const {
    const PointValues at_m = positions_m();
    const auto& [i, j, k] = parts_.triangles[pair.second];
    const Vec3d& p = at_m[pair.first];
    const Vec3d& a = at_m[i];
    const auto shares = nearest_shares(p, {a, at_m[j], at_m[k]});
    PartPlace place{.points = {pair.first, i, j, k},
                    .weights = {1, -shares[0], -shares[1], -shares[2]}};
    if (std::ranges::min(shares) > 0)
        place.side = glm::dot(glm::cross(at_m[j] - a, at_m[k] - a), p - a) < 0 ? -1 : 1;
    return place;
}

/// Where an end is closer, or they run along each other, the ends are what touches: there is no side.
PartPlace PartPairs::place_between_edges(const PartPair& pair) const {
    const PointValues at_m = positions_m();
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
    PartPlace place{.points = {a, b, c, d}, .weights = {1 - s, s, t - 1, -t}};
    place.run_along = uu * vv - uv * uv <= kAlong * kAlong * uu * vv;
    if (!place.run_along && s > 0 && s < 1 && t > 0 && t < 1)
        place.side = glm::dot(glm::cross(u, v), w) < 0 ? -1 : 1;
    return place;
}

void PartPair::serialize(Archive& archive) {
    archive(first, second, are_edges, side);
}

void PartPairs::serialize(Archive& archive) {
    archive(pairs_, listed_m_);
    if (!archive.reads()) return;
    const auto is_there = [this](const PartPair& pair) {
        return pair.are_edges
                   ? pair.first < parts_.edges.size() && pair.second < parts_.edges.size()
                   : pair.first < positions_m().size() && pair.second < parts_.triangles.size();
    };
    list_parts();
    if (!archive.expect(std::ranges::all_of(pairs_, is_there), "what touches is not there"))
        pairs_.clear();
}

}  // namespace plumbline::physics
