#include "engine/physics/collision/narrow_phase/point_choice.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumbline::physics {
namespace {

using Flat = glm::dvec2;

/// A point is chosen before an earlier one where it is better by this share: more than what a body at rest
/// moves, so that it keeps its points.
constexpr double kBetter = 1e-3;
/// What sticks out by less, as a share of the chosen points' span, hardly carries.
constexpr double kSticksOut = 0.05;
/// Of the points' extent round their middle: what is no less deep than that counts as near. Of a body at rest all do, as
/// contacts give way by as much (substep_choice.cpp), so its places alone decide and the choice stays while loads change.
constexpr double kAsNear = 0.003;
/// ... and what is deeper than this share of the deepest: heavy loads press contacts in by more.
constexpr double kAsDeepShare = 0.5;
constexpr double kAll_m = std::numeric_limits<double>::max();

PointChoice all_of(std::size_t count) {
    PointChoice choice{.count = count};
    for (std::size_t i = 0; i < count; ++i) choice.kept[i] = i;
    return choice;
}

double square(const Flat& a) {
    return glm::dot(a, a);
}

class SpanChooser {
public:
    SpanChooser(std::span<const FlatPoint> points, double level_m)
        : points_(points), level_m_(level_m) {
        for (const FlatPoint& point : points) {
            deepest_m_ = std::min(deepest_m_, point.distance_m);
            middle_ += point.place / static_cast<double>(points.size());
        }
        double most2 = 0;
        for (const FlatPoint& point : points)
            most2 = std::max(most2, square(point.place - middle_));
        near_m_ = deepest_m_ +
                  std::max({level_m, kAsNear * std::sqrt(most2), -kAsDeepShare * deepest_m_});
    }

    /// Those that span most: of all points or, where that takes some that hardly touch, of the deep ones, if they span an area.
    void keep_corners() {
        if (span(kAll_m) && are_near()) return keep_beyond_corners();
        choice.count = 0;
        if (span(near_m_)) return keep_beyond_corners();
        choice.count = 0;
        if (span(kAll_m)) keep_beyond_corners();
    }

    /// What is deeper than all that is kept, as the line of a ridge is: two points of it, or one in place of the last where
    /// there is no room.
    void keep_deepest() {
        double kept_m = std::numeric_limits<double>::max();
        for (const std::size_t i : choice.points())
            kept_m = std::min(kept_m, points_[i].distance_m);
        const auto is_deeper = [&](const FlatPoint& point) {
            return point.distance_m < kept_m - level_m_;
        };
        if (!std::ranges::any_of(points_, is_deeper)) return;
        choice.count = std::min(choice.count, PointChoice::kMost - 1);
        keep_best(
            [&](const FlatPoint& point) {
                return point.distance_m <= deepest_m_ + level_m_ ? square(point.place - middle_)
                                                                 : -1;
            },
            -0.5);
        if (choice.count == PointChoice::kMost) return;
        const Flat one = place(choice.count - 1);
        keep_best([&](const FlatPoint& point) {
            return is_deeper(point) ? square(point.place - one) : 0.0;
        });
    }

    PointChoice choice;

private:
    /// Replaces the choice by up to four points no farther than `most_m`. Returns whether they span an area.
    bool span(double most_m) {
        const auto away2 = [&](const FlatPoint& point, const Flat& from) {
            return point.distance_m <= most_m ? square(point.place - from) : 0.0;
        };
        keep_best(
            [&](const FlatPoint& point) {
                return point.distance_m <= near_m_ ? square(point.place - middle_) : -1;
            },
            -0.5);
        const Flat first = place(0);
        if (!keep_best([&](const FlatPoint& point) { return away2(point, first); })) return false;
        const Flat second = place(1);
        const Flat left{first.y - second.y, second.x - first.x};
        const auto to_left = [&](const FlatPoint& point) {
            return point.distance_m <= most_m ? glm::dot(point.place - first, left) : 0.0;
        };
        span_m_ = glm::distance(first, second);
        const double least = kSticksOut * span_m_ * span_m_;
        const bool has_left = keep_best(to_left, least);
        const bool has_right =
            keep_best([&](const FlatPoint& point) { return -to_left(point); }, least);
        // Counter-clockwise.
        corners_[0] = first;
        corner_count_ = 1;
        if (has_right) corners_[corner_count_++] = place(choice.count - 1);
        corners_[corner_count_++] = second;
        if (has_left) corners_[corner_count_++] = place(2);
        return has_left || has_right;
    }
    bool are_near() const {
        return std::ranges::all_of(choice.points(),
                                   [&](std::size_t i) { return is_near(points_[i]); });
    }
    void keep_beyond_corners() {
        for (std::size_t i = 0; i < corner_count_; ++i)
            keep_beyond(corners_[i], corners_[(i + 1) % corner_count_]);
    }
    /// Keeps the point with the highest score above `least`. Returns whether there is one.
    template <typename Score>
    bool keep_best(const Score& score, double least = 0) {
        std::size_t best = points_.size();
        double most = least;
        for (std::size_t i = 0; i < points_.size(); ++i) {
            const double here = score(points_[i]);
            if (!(here > most + (best < points_.size() ? kBetter * most : 0))) continue;
            best = i;
            most = here;
        }
        if (best == points_.size()) return false;
        choice.kept[choice.count++] = best;
        return true;
    }
    /// What sticks out beyond the side between two corners.
    void keep_beyond(const Flat& from, const Flat& to) {
        const Flat along = to - from;
        const Flat outward = Flat{along.y, -along.x} / (glm::length(along) * span_m_);
        keep_best(
            [&](const FlatPoint& point) {
                return is_near(point) ? glm::dot(point.place - from, outward) : 0.0;
            },
            kSticksOut);
    }
    bool is_near(const FlatPoint& point) const { return point.distance_m <= near_m_; }
    const Flat& place(std::size_t chosen) const { return points_[choice.kept[chosen]].place; }

    std::span<const FlatPoint> points_;
    double level_m_;
    double deepest_m_{std::numeric_limits<double>::max()};
    double near_m_{0};
    Flat middle_{0, 0};
    std::array<Flat, 4> corners_{};
    std::size_t corner_count_{0};
    double span_m_{0};
};

}  // namespace

PointChoice choose_points(std::span<const FlatPoint> points, double level_m) {
    if (points.size() <= PointChoice::kAllKept) return all_of(points.size());
    SpanChooser chooser(points, level_m);
    chooser.keep_corners();
    chooser.keep_deepest();
    return chooser.choice;
}

}  // namespace plumbline::physics
