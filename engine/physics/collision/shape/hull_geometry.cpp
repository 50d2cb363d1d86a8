#include "engine/physics/collision/shape/hull_geometry.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

namespace plumbline::physics {
namespace {

using Triangle = std::array<std::uint32_t, 3>;
using Edge = std::pair<std::uint32_t, std::uint32_t>;

class HullBuilder {
public:
    HullBuilder(std::span<const Vec3d> corners, std::span<const Triangle> triangles)
        : corners_(corners), triangles_(triangles) {
        Vec3d low{std::numeric_limits<double>::max()};
        Vec3d high{std::numeric_limits<double>::lowest()};
        for (const Vec3d& corner : corners) {
            low = glm::min(low, corner);
            high = glm::max(high, corner);
        }
        const Vec3d size = high - low;
        sag_m_ = kFaceSag * std::max({size.x, size.y, size.z});
        for (std::size_t t = 0; t < triangles.size(); ++t) {
            for (std::size_t i = 0; i < 3; ++i)
                beside_[{triangles[t][i], triangles[t][(i + 1) % 3]}] = t;
        }
    }

    HullGeometry build() {
        HullGeometry hull;
        hull.corners_m.assign(corners_.begin(), corners_.end());
        merge_faces(hull);
        list_neighbours(hull);
        measure_width(hull);
        return hull;
    }

private:
    Vec3d area_normal(std::size_t t) const {
        const auto& [a, b, c] = triangles_[t];
        return glm::cross(corners_[b] - corners_[a], corners_[c] - corners_[a]);
    }

    /// Larger triangles first: they say best how a face lies.
    std::vector<std::size_t> by_area() const {
        std::vector<std::size_t> order(triangles_.size());
        std::iota(order.begin(), order.end(), 0U);
        std::stable_sort(order.begin(), order.end(), [this](std::size_t a, std::size_t b) {
            return glm::length(area_normal(a)) > glm::length(area_normal(b));
        });
        return order;
    }

    void merge_faces(HullGeometry& hull) {
        face_of_.assign(triangles_.size(), -1);
        for (const std::size_t seed : by_area()) {
            if (face_of_[seed] >= 0) continue;
            const Vec3d normal = area_normal(seed);
            if (!(glm::length(normal) > 0)) continue;
            const std::vector<std::size_t> members =
                grow(seed, glm::normalize(normal), static_cast<int>(hull.faces.size()));
            add_face(hull, members);
        }
    }

    /// The triangles next to each other, from `seed` on, that lie in its plane.
    std::vector<std::size_t> grow(std::size_t seed, const Vec3d& normal, int face) {
        std::vector<std::size_t> members{seed};
        face_of_[seed] = face;
        const double plane_m = glm::dot(normal, corners_[triangles_[seed][0]]);
        const auto lies_in_plane = [&](std::size_t t) {
            const Vec3d across = area_normal(t);
            const double area = glm::length(across);
            if (area > 0 && glm::dot(across, normal) < portable_cos(kSameFace_rad) * area)
                return false;
            return std::ranges::all_of(triangles_[t], [&](std::uint32_t corner) {
                return std::abs(glm::dot(normal, corners_[corner]) - plane_m) <= sag_m_;
            });
        };
        for (std::size_t next = 0; next < members.size(); ++next) {
            const Triangle triangle = triangles_[members[next]];
            for (std::size_t i = 0; i < 3; ++i) {
                const auto found = beside_.find({triangle[(i + 1) % 3], triangle[i]});
                if (found == beside_.end()) continue;
                const std::size_t other = found->second;
                if (face_of_[other] >= 0 || !lies_in_plane(other)) continue;
                face_of_[other] = face;
                members.push_back(other);
            }
        }
        return members;
    }

    void add_face(HullGeometry& hull, std::span<const std::size_t> members) const {
        Vec3d normal{0, 0, 0};
        for (const std::size_t t : members) normal += area_normal(t);
        HullFace face{.normal = glm::normalize(normal),
                      .offset_m = std::numeric_limits<double>::lowest(),
                      .first = static_cast<std::uint32_t>(hull.face_corners.size())};
        std::vector<std::uint32_t> rim = rim_of(members);
        if (rim.size() < 3) return;
        for (const Vec3d& corner : corners_)
            face.offset_m = std::max(face.offset_m, glm::dot(face.normal, corner));
        drop_straight_corners(rim, face.normal);
        face.count = static_cast<std::uint32_t>(rim.size());
        hull.face_corners.insert(hull.face_corners.end(), rim.begin(), rim.end());
        hull.faces.push_back(face);
    }

    /// The corners round the triangles, in order.
    std::vector<std::uint32_t> rim_of(std::span<const std::size_t> members) const {
        const int face = face_of_[members.front()];
        std::map<std::uint32_t, std::uint32_t> next_of;
        for (const std::size_t t : members) {
            for (std::size_t i = 0; i < 3; ++i) {
                const Edge edge{triangles_[t][i], triangles_[t][(i + 1) % 3]};
                const auto other = beside_.find({edge.second, edge.first});
                if (other == beside_.end() || face_of_[other->second] != face)
                    next_of[edge.first] = edge.second;
            }
        }
        std::vector<std::uint32_t> rim;
        if (next_of.empty()) return rim;
        const std::uint32_t start = next_of.begin()->first;
        std::uint32_t at = start;
        do {
            rim.push_back(at);
            const auto found = next_of.find(at);
            if (found == next_of.end()) break;
            at = found->second;
        } while (at != start && rim.size() <= next_of.size());
        return rim;
    }

    /// Points along an edge are no corners of a face.
    void drop_straight_corners(std::vector<std::uint32_t>& rim, const Vec3d& normal) const {
        for (std::size_t i = 0; i < rim.size() && rim.size() > 3;) {
            const Vec3d& before = corners_[rim[(i + rim.size() - 1) % rim.size()]];
            const Vec3d& here = corners_[rim[i]];
            const Vec3d& after = corners_[rim[(i + 1) % rim.size()]];
            const Vec3d along = after - before;
            const double length = glm::length(along);
            const double out_m =
                length > 0 ? glm::dot(glm::cross(here - before, along), normal) / -length : 0.0;
            if (std::abs(out_m) <= sag_m_ * 1e-2)
                rim.erase(rim.begin() + static_cast<std::ptrdiff_t>(i));
            else
                ++i;
        }
    }

    void list_neighbours(HullGeometry& hull) const {
        hull.first_neighbour.assign(corners_.size() + 1, 0);
        for (const auto& [edge, triangle] : beside_) {
            hull.neighbours.push_back(edge.second);
            ++hull.first_neighbour[edge.first + 1];
        }
        std::partial_sum(
            hull.first_neighbour.begin(), hull.first_neighbour.end(), hull.first_neighbour.begin());
    }

    static void measure_width(HullGeometry& hull) {
        hull.width_m = std::numeric_limits<double>::max();
        for (const HullFace& face : hull.faces) {
            double lowest = face.offset_m;
            for (const Vec3d& corner : hull.corners_m)
                lowest = std::min(lowest, glm::dot(face.normal, corner));
            hull.width_m = std::min(hull.width_m, face.offset_m - lowest);
        }
    }

    std::span<const Vec3d> corners_;
    std::span<const Triangle> triangles_;
    std::map<Edge, std::size_t> beside_;  ///< the triangle on the left of a directed edge
    std::vector<int> face_of_;            ///< of each triangle; -1: none yet
    double sag_m_{0};
};

}  // namespace

HullGeometry hull_geometry(std::span<const Vec3d> corners_m,
                           std::span<const std::array<std::uint32_t, 3>> triangles) {
    return HullBuilder(corners_m, triangles).build();
}

}  // namespace plumbline::physics
