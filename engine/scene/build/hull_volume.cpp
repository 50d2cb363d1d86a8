// Volume of a convex hull, built point by point (Kallay 1981; de Berg et al., "Computational
// Geometry", chapter 11): a body's mass follows from its density before the physics has the shape.
#include "engine/scene/build/shape_factory.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace plumbline::scene {

namespace {

struct Face {
    std::array<std::size_t, 3> corners{};
    Vec3d normal{0.0};
    double offset{0.0};
};

Face face_of(const std::vector<Vec3d>& points,
             const std::array<std::size_t, 3>& corners,
             const Vec3d& inside) {
    Face face{.corners = corners};
    const Vec3d& a = points[corners[0]];
    face.normal = glm::cross(points[corners[1]] - a, points[corners[2]] - a);
    if (glm::dot(face.normal, inside - a) > 0.0) {
        std::swap(face.corners[1], face.corners[2]);
        face.normal = -face.normal;
    }
    face.normal = normalize_or(face.normal, Vec3d{0.0});
    face.offset = glm::dot(face.normal, a);
    return face;
}

/// The point that lies farthest by some measure.
template <class Measure>
std::size_t farthest(const std::vector<Vec3d>& points, Measure measure) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        if (measure(points[i]) > measure(points[best])) best = i;
    }
    return best;
}

void add_point(std::vector<Face>& faces,
               const std::vector<Vec3d>& points,
               std::size_t point,
               const Vec3d& inside,
               double skin_m) {
    std::set<std::pair<std::size_t, std::size_t>> edges;
    std::vector<Face> kept;
    for (const Face& face : faces) {
        if (glm::dot(face.normal, points[point]) - face.offset <= skin_m) {
            kept.push_back(face);
            continue;
        }
        for (std::size_t i = 0; i < 3; ++i) {
            edges.emplace(face.corners[i], face.corners[(i + 1) % 3]);
        }
    }
    if (edges.empty()) return;
    for (const auto& [from, to] : edges) {
        // An edge seen from one side only is on the horizon.
        if (edges.count({to, from}) == 0)
            kept.push_back(face_of(points, {from, to, point}, inside));
    }
    faces = std::move(kept);
}

}  // namespace

Real hull_volume_m3(const std::vector<Vec3>& points_m) {
    if (points_m.size() < 4) return 0;
    std::vector<Vec3d> points;
    points.reserve(points_m.size());
    for (const Vec3& p : points_m) points.push_back(Vec3d(p));

    const std::size_t a = farthest(points, [](const Vec3d& p) { return -p.x; });
    const std::size_t b =
        farthest(points, [&](const Vec3d& p) { return glm::distance(p, points[a]); });
    const double size_m = glm::distance(points[a], points[b]);
    const double skin_m = size_m * 1e-9;
    if (size_m <= 0.0) return 0;
    const Vec3d along = (points[b] - points[a]) / size_m;
    const auto from_line = [&](const Vec3d& p) {
        return glm::length(glm::cross(p - points[a], along));
    };
    const std::size_t c = farthest(points, from_line);
    if (from_line(points[c]) <= skin_m) return 0;
    const Vec3d up = glm::normalize(glm::cross(along, points[c] - points[a]));
    const auto from_plane = [&](const Vec3d& p) { return std::abs(glm::dot(p - points[a], up)); };
    const std::size_t d = farthest(points, from_plane);
    if (from_plane(points[d]) <= skin_m) return 0;

    const Vec3d inside = (points[a] + points[b] + points[c] + points[d]) * 0.25;
    std::vector<Face> faces;
    for (const auto& corners :
         std::array<std::array<std::size_t, 3>, 4>{{{a, b, c}, {a, b, d}, {a, c, d}, {b, c, d}}}) {
        faces.push_back(face_of(points, corners, inside));
    }
    for (std::size_t i = 0; i < points.size(); ++i) add_point(faces, points, i, inside, skin_m);

    double volume_m3 = 0.0;
    for (const Face& face : faces) {
        const Vec3d p = points[face.corners[0]] - inside;
        const Vec3d q = points[face.corners[1]] - inside;
        const Vec3d r = points[face.corners[2]] - inside;
        volume_m3 += glm::dot(p, glm::cross(q, r)) / 6.0;
    }
    return static_cast<Real>(volume_m3);
}

}  // namespace plumbline::scene
