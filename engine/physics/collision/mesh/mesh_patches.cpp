#include "engine/physics/collision/mesh/mesh_patches.h"

#include "engine/physics/collision/mesh/triangle_contact.h"
#include "engine/physics/transform.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumbline::physics {
namespace {

using PointKind = MeshPoint::Kind;
using Flat = glm::dvec2;
using Points = std::vector<MeshPoint>;

/// Of a mesh that is curved in many small steps only the deepest faces are looked at.
constexpr std::size_t kMostGroups = 48;
constexpr double kFar_m = std::numeric_limits<double>::max();

double deepest_of(std::span<const MeshPoint> points) {
    double deepest_m = kFar_m;
    for (const MeshPoint& point : points) deepest_m = std::min(deepest_m, point.distance_m);
    return deepest_m;
}

/// Of points that are as deep within `level_m` the first counts, so that a body at rest keeps its groups.
const MeshPoint& leader_of(std::span<const MeshPoint> points, double level_m) {
    const double deepest_m = deepest_of(points);
    return *std::ranges::find_if(
        points, [&](const MeshPoint& point) { return point.distance_m <= deepest_m + level_m; });
}

std::vector<Points> by_normal(Points rest, double level_m) {
    const double same = portable_cos(kSameMeshFace_rad);
    std::vector<Points> groups;
    while (!rest.empty() && groups.size() < kMostGroups) {
        const Vec3d normal = leader_of(rest, level_m).normal;
        Points& group = groups.emplace_back();
        std::size_t others = 0;
        for (const MeshPoint& point : rest) {
            if (glm::dot(point.normal, normal) > same)
                group.push_back(point);
            else
                rest[others++] = point;
        }
        rest.resize(others);
    }
    return groups;
}

/// A point of a face where an edge or a corner presses is no second one.
Points without_repeats(std::span<const MeshPoint> points, double same_m) {
    Points edges;
    for (const MeshPoint& point : points) {
        if (point.kind == PointKind::Edge) edges.push_back(point);
    }
    Points kept(points.begin(), points.end());
    if (edges.empty()) return kept;
    std::erase_if(kept, [&](const MeshPoint& point) {
        if (point.kind == PointKind::Edge) return false;
        return std::ranges::any_of(edges, [&](const MeshPoint& edge) {
            const Vec3d away = edge.on_mesh - point.on_mesh;
            return glm::dot(away, away) < same_m * same_m;
        });
    });
    return kept;
}

/// Drops what is behind groups that are less deep.
void drop_hidden(const PlacedConvex& convex,
                 const PlacedMesh& mesh,
                 double level_m,
                 std::vector<Points>& groups) {
    // The least deep come last.
    for (std::size_t i = groups.size(); i-- > 0;) {
        const double depth_m = -deepest_of(groups[i]);
        if (groups[i].empty() || !(depth_m > 0)) continue;
        const Vec3d normal = leader_of(groups[i], level_m).normal;
        const double clear_m =
            glm::dot(support(convex, -normal), normal) - convex.radius_m + depth_m + level_m;
        const auto is_hidden = [&](const MeshPoint& point) {
            if (-point.distance_m <= depth_m + level_m) return false;
            return std::ranges::all_of(mesh.corners_m(point.triangle), [&](const Vec3d& corner) {
                return glm::dot(corner, normal) <= clear_m;
            });
        };
        for (std::size_t k = 0; k < i; ++k) std::erase_if(groups[k], is_hidden);
    }
    std::erase_if(groups, [](const Points& group) { return group.empty(); });
}

/// Chooses from the points of one group.
class Chooser {
public:
    Chooser(const Vec3d& normal, double same_m, double level_m)
        : same_m_(same_m), level_m_(level_m) {
        const Vec3d size = magnitudes_of(normal);
        Vec3d least{1, 0, 0};
        if (size.y < size.x) least = {0, 1, 0};
        if (size.z < std::min(size.x, size.y)) least = {0, 0, 1};
        x_ = glm::normalize(glm::cross(normal, least));
        y_ = glm::cross(normal, x_);
    }

    Points choose(const Points& group) const {
        Points chosen;
        for (const MeshPoint& point : group) {
            if (point.kind != PointKind::Seam) add(chosen, point);
        }
        Points seams;
        for (const MeshPoint& point : group) {
            if (point.kind == PointKind::Seam) add(seams, point);
        }
        if (chosen.empty()) return reduced(seams);
        chosen = reduced(chosen);
        // A face that is not quite flat may be deepest inside.
        if (!seams.empty() && deepest_of(seams) < deepest_of(chosen) - level_m_) {
            if (chosen.size() == PointGroup::kMost) chosen.pop_back();
            chosen.push_back(leader_of(seams, level_m_));
        }
        return chosen;
    }

private:
    Flat flat(const MeshPoint& point) const {
        return {glm::dot(point.on_mesh, x_), glm::dot(point.on_mesh, y_)};
    }

    /// Of two points at one place the deeper counts.
    void add(Points& chosen, const MeshPoint& point) const {
        for (MeshPoint& known : chosen) {
            const Flat away = flat(known) - flat(point);
            if (glm::dot(away, away) > same_m_ * same_m_) continue;
            if (point.distance_m < known.distance_m - level_m_) known = point;
            return;
        }
        chosen.push_back(point);
    }

    Points reduced(const Points& all) const {
        if (all.size() <= PointChoice::kAllKept) return all;
        std::vector<FlatPoint> places;
        for (const MeshPoint& point : all) places.push_back({flat(point), point.distance_m});
        Points chosen;
        const PointChoice choice = choose_points(places, level_m_);
        for (const std::size_t index : choice.points()) chosen.push_back(all[index]);
        return chosen;
    }

    double same_m_;
    double level_m_;
    Vec3d x_;
    Vec3d y_;
};

}  // namespace

std::vector<PointGroup> group_points(const PlacedConvex& convex,
                                     const PlacedMesh& mesh,
                                     std::span<const MeshPoint> points,
                                     std::size_t most_groups) {
    if (points.size() == 1) {
        PointGroup only{.normal = points[0].normal, .count = 1};
        only.points[0] = points[0];
        return {only};
    }
    const double size_m = size_of(convex);
    const double level_m = kLevelMeshPoint * size_m;
    const double same_m = kSameMeshPoint * size_m;
    std::vector<Points> groups = by_normal(without_repeats(points, same_m), level_m);
    if (groups.size() > 1) drop_hidden(convex, mesh, level_m, groups);
    if (groups.size() > most_groups) groups.resize(most_groups);
    std::vector<PointGroup> found;
    for (const Points& group : groups) {
        PointGroup& last = found.emplace_back();
        last.normal = leader_of(group, level_m).normal;
        const Chooser chooser(last.normal, same_m, level_m);
        for (const MeshPoint& point : chooser.choose(group)) last.points[last.count++] = point;
    }
    return found;
}

}  // namespace plumbline::physics
