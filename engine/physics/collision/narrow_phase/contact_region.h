// Where the features of two cores face each other: contact points of a whole face, cap or line.
#pragma once

#include "engine/physics/collision/narrow_phase/placed_convex.h"
#include "engine/physics/collision/narrow_phase/point_choice.h"

#include <array>
#include <cstdint>
#include <span>

namespace plumbline::physics {

/// A point of the region: its two surface points lie one over the other along the normal.
/// Not initialised: there are arrays of them.
struct RegionPoint {
    Vec3d on_a;
    Vec3d on_b;
    double distance_m;  ///< along the normal; negative: penetration
};

/// The corners of the common region of two features, seen along a normal.
class ContactRegion {
public:
    static constexpr std::size_t kMost = PointChoice::kMost;

    /// `normal`: unit, from b to a. Points farther apart than `reach_m` are left out; those nearer to each
    /// other than `same_m` are one, and so near beside a face a point still counts as over it.
    ContactRegion(
        const Feature& a, const Feature& b, const Vec3d& normal, double reach_m, double same_m);

    std::span<const RegionPoint> points() const { return {points_.data(), count_}; }
    /// Leaves at most kMost, by choose_points().
    void reduce(double level_m);
    /// The least extent of the region across the normal; 0 where it is no more than a line.
    double width_m() const;

private:
    /// Across the normal: `x` and `y` of the plane's axes.
    using Flat = glm::dvec2;
    /// The line of an edge, seen along the normal: positive on the inner side.
    struct Line {
        Flat inward;
        double offset_m;
    };
    /// A feature seen along the normal.
    struct Outline {
        explicit Outline(const Feature& seen) : feature(seen) {}

        const Feature& feature;
        std::array<Flat, Feature::kMostCorners> corners;
        std::array<Line, Feature::kMostCorners> lines;  ///< from each corner to the next
        std::array<std::uint64_t, Feature::kMostCorners>
            inside_of;                                       ///< bit k: of the other's line k
        std::array<bool, Feature::kMostCorners> is_covered;  ///< over the other feature
        std::size_t edges{0};
    };

    void outline(Outline& of) const;
    void compare(Outline& of, const Outline& with) const;
    void add_corners(const Outline& from, const Outline& onto, bool is_b);
    void add_crossings(const Outline& a, const Outline& b);
    void add_crossing(const Outline& a, std::size_t i, const Outline& b, std::size_t k);
    void add_disc_crossings(const Outline& disc, const Outline& other, bool is_b);
    void add_rim_crossings(const Feature& disc, const Feature& other, bool is_b);
    void add_overlap_of_segments(const Feature& a, const Feature& b);
    void add(const Vec3d& on_a, const Vec3d& on_b);
    void add_in_order(const Vec3d& first, const Vec3d& second, bool first_is_b);
    Flat flat(const Vec3d& point) const { return {glm::dot(point, x_), glm::dot(point, y_)}; }
    bool lift(const Feature& feature, const Vec3d& point, Vec3d& lifted) const;

    static constexpr std::size_t kRoom = 96;
    Vec3d normal_;
    Vec3d x_;
    Vec3d y_;
    double reach_m_;
    double same_m_;
    std::array<RegionPoint, kRoom> points_;
    std::array<Flat, kRoom> places_;  ///< of the points' on_a
    std::size_t count_{0};
};

}  // namespace plumbline::physics
