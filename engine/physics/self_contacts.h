// Where a deforming surface touches itself: points against triangles, edges against edges.
#pragma once

#include "engine/physics/point_body.h"

#include <array>
#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

namespace plumbline {
class Archive;
}

namespace plumbline::physics {

/// Balls by the cubes of space that their middles lie in.
class PlaceBins {
public:
    struct Place {
        Vec3d middle_m{0, 0, 0};
        double radius_m{0};
        std::uint32_t number{0};
        std::uint32_t next{0};  ///< in the same bin
    };

    /// For `count` places; two that touch have middles no farther apart than `side_m`.
    void clear(std::size_t count, double side_m);
    void add(const Place& place);
    /// Gives the numbers of those that touch it.
    template <class F>
    void for_near(const Place& place, const F& visit) const;

private:
    std::size_t bin_of(const Vec3d& at_m, const std::array<int, 3>& away) const;

    double side_m_{1};
    std::vector<Place> places_;
    std::vector<std::uint32_t> heads_;  ///< of the bins: numbers of places
};

/// What has passed through is sent back: on which side of each other two parts were when they came near is remembered for as long
/// as they are.
class SelfContacts {
public:
    /// `body` as it is at rest: what lies closer together there than the thickness may stay so.
    SelfContacts(const PointBody& body, double thickness_m, double friction);

    /// Lists what may touch within `seconds`; solve() does so anew where points move faster than expected.
    void find(const PointBody& body, double seconds);
    /// Changes velocities so that nothing comes closer than the thickness within `h`, with friction; momentum is kept.
    void solve(PointBody& body, double h);

    void serialize(Archive& archive);

private:
    /// Two parts that are near each other: a point and a triangle, or two edges, by their numbers.
    struct Pair {
        std::uint32_t first{0};
        std::uint32_t second{0};
        bool are_edges{false};
        std::int8_t side{0};  ///< of the second that the first is on; 0: not known

        bool operator<(const Pair& other) const {
            return std::tie(are_edges, first, second) <
                   std::tie(other.are_edges, other.first, other.second);
        }
        void serialize(Archive& archive);
    };
    /// A place on one part of the surface against one on another: weights of the first sum to 1, of the second to -1.
    struct Contact {
        std::array<std::uint32_t, 4> points{};
        std::array<double, 4> weights{};
        std::int8_t side{0};    ///< 0: beyond the edge of one of them
        Vec3d normal{0, 1, 0};  ///< from the second to the first
        double inverse_mass{0};
        double gap_m{0};
    };
    void bin_parts(std::span<const Vec3d> at_m);
    bool share_points(const Pair& pair) const;
    Contact contact_of(const Pair& pair, std::span<const Vec3d> at_m) const;
    Contact point_contact(const Pair& pair, std::span<const Vec3d> at_m) const;
    Contact edge_contact(const Pair& pair, std::span<const Vec3d> at_m) const;
    void add(const PointBody& body, Pair& pair, double h);
    void solve_one(const Contact& contact, PointBody& body, double h) const;

    double thickness_m_;
    double friction_;
    double margin_m_;
    std::vector<Vec3d> rest_m_;
    SurfaceParts parts_;
    PlaceBins points_;
    PlaceBins edges_;
    std::vector<Pair> pairs_;      ///< sorted
    std::vector<Vec3d> listed_m_;  ///< where points were when pairs were listed
    double seconds_{0};            ///< ... and for how long
    std::vector<Contact> contacts_;
};

}  // namespace plumbline::physics
