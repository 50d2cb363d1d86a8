// Where deforming surfaces touch, one itself or two each other: points against triangles, edges against edges.
#pragma once

#include "engine/physics/deformable/place_bins.h"
#include "engine/physics/point_body.h"
#include "engine/physics/surface_contacts.h"

#include <array>
#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

namespace plumbline {
class Archive;
}

namespace plumbline::physics {

/// What has passed through is sent back: on which side of each other two parts were when they came near is remembered for as long
/// as they are. What encloses something is touched from outside. The bodies outlive it.
class PartContacts {
public:
    /// Of a body with itself, as it is at rest: what lies closer together there than the thickness may stay so.
    PartContacts(PointBody& body, const SurfaceTraits& traits);
    /// Of two bodies with each other.
    PartContacts(PointBody& first, PointBody& second, const SurfaceTraits& traits);

    /// Lists what may touch within `seconds`; solve() does so anew where points move faster than expected.
    void find(double seconds);
    /// Changes velocities so that nothing comes closer than the thickness within `h`, with friction; momentum is kept.
    void solve(double h);
    /// After points have moved for `h`.
    void follow(double h);

    void serialize(Archive& archive);

private:
    /// Two parts that are near each other: a point and a triangle, or two edges, by their numbers.
    struct Pair {
        std::uint32_t first{0};
        std::uint32_t second{0};
        bool are_edges{false};
        std::int8_t side{0};  ///< of the second that the first is on; 0: not known
        double idle_s{0};     ///< until they can touch at the soonest

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
        std::int8_t side{0};    ///< 0: beyond the edge of one of them, or they run along each other
        bool run_along{false};  ///< edges
        Vec3d normal{0, 1, 0};  ///< from the second to the first
        double inverse_mass{0};
        double gap_m{0};
        double pressed_Ns{0};  ///< in the sub-step at hand
        Vec3d rubbed_Ns{0, 0, 0};
    };
    /// Of all points, those of the second body after those of the first.
    class Values {
    public:
        Values(std::span<const Vec3d> first, std::span<const Vec3d> second)
            : first_(first), second_(second) {}
        std::size_t size() const { return first_.size() + second_.size(); }
        const Vec3d& operator[](std::size_t i) const {
            return i < first_.size() ? first_[i] : second_[i - first_.size()];
        }

    private:
        std::span<const Vec3d> first_;
        std::span<const Vec3d> second_;
    };
    /// A box round what may touch.
    struct Within {
        Vec3d low_m{-1e30, -1e30, -1e30};
        Vec3d high_m{1e30, 1e30, 1e30};

        bool is_empty() const { return glm::any(glm::greaterThan(low_m, high_m)); }
        bool has(const Vec3d& at_m, double radius_m) const {
            return glm::all(glm::greaterThanEqual(at_m, low_m - radius_m)) &&
                   glm::all(glm::lessThanEqual(at_m, high_m + radius_m));
        }
    };
    Values positions_m() const;
    Values velocities_mps() const;
    double inverse_mass(std::size_t point) const;
    void change_velocity(std::size_t point, const Vec3d& by_mps);
    bool is_of_second(std::uint32_t point) const { return point >= second_from_; }
    bool has_moved() const;
    void find_fastest();
    void look(double h);
    /// Returns whether they are others than before.
    bool list_parts();
    Within meeting_place() const;
    void bin_parts(const Within& within);
    bool may_touch(const Pair& pair) const;
    void list(Pair pair, std::span<const Pair> before, double seconds);
    Contact contact_of(const Pair& pair) const;
    Contact point_contact(const Pair& pair) const;
    Contact edge_contact(const Pair& pair) const;
    void find_normals();
    Vec3d facing_of(const Contact& contact, bool are_edges) const;
    bool turn(const Pair& pair, Contact& contact, double& distance_m) const;
    void add(Pair& pair, double seconds);
    void solve_one(Contact& contact, double h);

    PointBody* first_;
    PointBody* second_{nullptr};  ///< none: of one with itself
    std::uint32_t second_from_;   ///< number of its first point
    SurfaceTraits traits_;
    double margin_m_;
    double longest_m_{0};        ///< of triangles' sides, when pairs were listed
    std::vector<Vec3d> rest_m_;  ///< of one with itself
    std::array<SurfaceParts, 2> own_parts_;
    SurfaceParts parts_;          ///< of both
    std::vector<Vec3d> normals_;  ///< of all points, when pairs were listed
    PlaceBins points_;
    PlaceBins edges_;
    std::vector<Pair> pairs_;      ///< sorted
    std::vector<Vec3d> listed_m_;  ///< where points were when pairs were listed
    double seconds_{0};            ///< ... and for how long
    double fastest_mps_{0};        ///< of points then, and what it may become
    double looked_for_s_{0};       ///< so long contacts_ are what may touch ...
    double look_in_s_{0};          ///< ... of which so much is left
    std::vector<Contact> contacts_;
};

}  // namespace plumbline::physics
