// Which parts of deforming surfaces are near each other, of one or of two: points and triangles, edges and edges.
#pragma once

#include "engine/physics/point_body.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

namespace plumbline {
class Archive;
}

namespace plumbline::physics {

/// A point and a triangle, or two edges, by their numbers.
struct PartPair {
    std::uint32_t first{0};
    std::uint32_t second{0};
    bool are_edges{false};
    std::int8_t side{0};  ///< of the second that the first is on; 0: not known
    double idle_s{0};     ///< until they can touch at the soonest

    bool operator<(const PartPair& other) const {
        return std::tie(are_edges, first, second) <
               std::tie(other.are_edges, other.first, other.second);
    }
    void serialize(Archive& archive);
};

/// Where a pair is nearest: weights of the first sum to 1, of the second to -1.
struct PartPlace {
    std::array<std::uint32_t, 4> points{};
    std::array<double, 4> weights{};
    std::int8_t side{0};    ///< 0: beyond the edge of one of them, or they run along each other
    bool run_along{false};  ///< edges

    /// What the first has more of than the second.
    template <class Values>
    Vec3d difference(const Values& values) const {
        Vec3d sum{0, 0, 0};
        for (std::size_t i = 0; i < 4; ++i) sum += weights[i] * values[points[i]];
        return sum;
    }
};

/// Of all points, those of the second body after those of the first.
class PointValues {
public:
    PointValues(std::span<const Vec3d> first, std::span<const Vec3d> second)
        : first_(first), second_(second) {}
    std::size_t size() const { return first_.size() + second_.size(); }
    const Vec3d& operator[](std::size_t i) const {
        return i < first_.size() ? first_[i] : second_[i - first_.size()];
    }

private:
    std::span<const Vec3d> first_;
    std::span<const Vec3d> second_;
};

/// The list of such pairs. It is kept while points stay near where they were when it was made (Verlet 1967, a neighbour list). The
/// bodies outlive it.
class PartPairs {
public:
    /// `second`: null for pairs of one body with itself. They touch at `thickness_m`.
    PartPairs(const PointBody& first, const PointBody* second, double thickness_m);

    std::span<PartPair> pairs() { return pairs_; }
    PartPlace place_of(const PartPair& pair) const;
    PointValues positions_m() const;
    PointValues velocities_mps() const;
    const SurfaceParts& parts() const { return parts_; }  ///< of both
    /// Whether one of the surfaces encloses something, and whether that which a point is on does.
    bool enclose() const { return own_parts_[0].encloses || own_parts_[1].encloses; }
    bool encloses(std::uint32_t point) const { return own_parts_[is_of_second(point)].encloses; }
    bool is_of_second(std::uint32_t point) const { return point >= second_from_; }

    /// Lists what may touch within `seconds`, unless what is listed still holds it.
    void begin_step(double seconds);
    /// The same in the middle of the step, where no point has moved farther than `most_m` since its start. Returns whether it listed.
    bool keep_up(double most_m);

    void serialize(Archive& archive);

private:
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
    /// From number `begin` to the one before `end`.
    struct Numbers {
        std::uint32_t begin{0};
        std::uint32_t end{0};
    };
    /// What pairs are listed by.
    struct Search {
        Within within;
        double longest_m{0};               ///< edge
        std::span<const PartPair> before;  ///< what was listed
    };
    /// Returns whether they are others than before.
    bool list_parts();
    double moved_since_listed_m() const;
    Within meeting_place() const;
    void find();
    void list_points(Numbers points, Numbers triangles, const Search& search);
    void list_edges(Numbers firsts, Numbers seconds, const Search& search);
    bool may_touch(const PartPair& pair) const;
    void list(PartPair pair, std::span<const PartPair> before);
    PartPlace place_at_triangle(const PartPair& pair) const;
    PartPlace place_between_edges(const PartPair& pair) const;

    const PointBody* first_;
    const PointBody* second_;
    std::uint32_t second_from_;  ///< number of its first point
    double thickness_m_;
    double margin_m_;
    double reach_m_;  ///< how far apart points and edges are looked up
    std::array<SurfaceParts, 2> own_parts_;
    SurfaceParts parts_;
    std::vector<PartPair> pairs_;  ///< sorted
    std::vector<Vec3d> listed_m_;  ///< where points were when pairs were listed
    double moved_m_{0};            ///< by how much they had moved since, at the step's start
    double seconds_{0};            ///< of the step
};

}  // namespace plumbline::physics
