// Volume of a convex hull by Quickhull (Barber, Dobkin and Huhdanpaa 1996): a body's mass follows from
// its density before the physics has the shape.
#include "engine/scene/build/shape_factory.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>

namespace plumbline::scene {

namespace {

/// The point that lies farthest by some measure.
template <class Measure>
std::size_t farthest(const std::vector<Vec3d>& points, Measure measure) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        if (measure(points[i]) > measure(points[best])) best = i;
    }
    return best;
}

/// A hull that grows: each face keeps the points outside that see it, and the farthest of them comes next.
class Quickhull {
public:
    Quickhull(const std::vector<Vec3d>& points, double skin_m)
        : points_(points), skin_m_(skin_m), face_from_(points.size()) {}

    /// `corners` span a tetrahedron.
    void grow_from(std::array<std::uint32_t, 4> corners) {
        auto& [a, b, c, d] = corners;
        const Vec3d normal = glm::cross(points_[b] - points_[a], points_[c] - points_[a]);
        if (glm::dot(normal, points_[d] - points_[a]) > 0.0) std::swap(b, c);
        add_face({a, b, c}, {3, 2, 1});
        add_face({a, c, d}, {0, 2, 3});
        add_face({c, b, d}, {0, 3, 1});
        add_face({b, a, d}, {0, 1, 2});
        std::vector<std::uint32_t> all(points_.size());
        std::iota(all.begin(), all.end(), 0U);
        distribute(all, 0);
        // Faces that appear meanwhile come last.
        for (std::uint32_t face = 0; face < faces_.size(); ++face) {
            if (faces_[face].is_hull && !faces_[face].outside.empty()) add_farthest_of(face);
        }
    }

    std::vector<std::array<std::uint32_t, 3>> triangles() const {
        std::vector<std::array<std::uint32_t, 3>> corners;
        for (const Face& face : faces_) {
            if (face.is_hull) corners.push_back(face.corners);
        }
        return corners;
    }

    double volume_m3(const Vec3d& inside) const {
        double volume_m3 = 0.0;
        for (const Face& face : faces_) {
            if (!face.is_hull) continue;
            const Vec3d p = points_[face.corners[0]] - inside;
            const Vec3d q = points_[face.corners[1]] - inside;
            const Vec3d r = points_[face.corners[2]] - inside;
            volume_m3 += glm::dot(p, glm::cross(q, r)) / 6.0;
        }
        return volume_m3;
    }

private:
    using Triple = std::array<std::uint32_t, 3>;
    struct Face {
        Triple corners{};    ///< counter-clockwise from outside
        Triple neighbors{};  ///< faces across the edges from each corner to the next
        Vec3d normal{0.0};
        double offset{0.0};
        std::vector<std::uint32_t> outside{};
        double farthest_m{0.0};  ///< height of the first of them, which is the farthest
        bool is_hull{true};
        bool is_seen{false};  ///< from the point that is being added
    };
    /// An edge of a face that is not seen, in the direction of the seen face that goes.
    struct HorizonEdge {
        std::uint32_t from;
        std::uint32_t to;
        std::uint32_t beyond;
    };

    double height_m(const Face& face, std::uint32_t point) const {
        return glm::dot(face.normal, points_[point]) - face.offset;
    }

    void add_face(const Triple& corners, const Triple& neighbors) {
        const Vec3d& a = points_[corners[0]];
        Face face{.corners = corners, .neighbors = neighbors};
        face.normal =
            normalize_or(glm::cross(points_[corners[1]] - a, points_[corners[2]] - a), Vec3d{0.0});
        face.offset = glm::dot(face.normal, a);
        faces_.push_back(std::move(face));
    }

    /// Gives each point to the first of the faces from `first` on that it sees; others are inside.
    void distribute(const std::vector<std::uint32_t>& points, std::size_t first) {
        for (const std::uint32_t point : points) {
            for (std::size_t i = first; i < faces_.size(); ++i) {
                Face& face = faces_[i];
                const double height = height_m(face, point);
                if (height <= skin_m_) continue;
                face.outside.push_back(point);
                if (height > face.farthest_m) {
                    face.farthest_m = height;
                    std::swap(face.outside.front(), face.outside.back());
                }
                break;
            }
        }
    }

    /// Marks the faces that the point sees, found from one of them over their edges.
    std::vector<std::uint32_t> faces_seen_from(std::uint32_t point,
                                               std::uint32_t first,
                                               std::vector<HorizonEdge>& horizon) {
        std::vector<std::uint32_t> seen{first};
        faces_[first].is_seen = true;
        for (std::size_t next = 0; next < seen.size(); ++next) {
            for (const std::uint32_t neighbor : faces_[seen[next]].neighbors) {
                Face& face = faces_[neighbor];
                if (face.is_seen || height_m(face, point) <= skin_m_) continue;
                face.is_seen = true;
                seen.push_back(neighbor);
            }
        }
        for (const std::uint32_t each : seen) {
            const Face& face = faces_[each];
            for (std::size_t i = 0; i < 3; ++i) {
                if (faces_[face.neighbors[i]].is_seen) continue;
                horizon.push_back({face.corners[i], face.corners[(i + 1) % 3], face.neighbors[i]});
            }
        }
        return seen;
    }

    void add_farthest_of(std::uint32_t face) {
        const std::uint32_t point = faces_[face].outside.front();
        std::vector<HorizonEdge> horizon;
        std::vector<std::uint32_t> orphans;
        for (const std::uint32_t each : faces_seen_from(point, face, horizon)) {
            const std::vector<std::uint32_t> outside = std::exchange(faces_[each].outside, {});
            orphans.insert(orphans.end(), outside.begin(), outside.end());
            faces_[each].is_hull = false;
        }
        const auto first = static_cast<std::uint32_t>(faces_.size());
        for (const HorizonEdge& edge : horizon) {
            const auto added = static_cast<std::uint32_t>(faces_.size());
            face_from_[edge.from] = added;
            Face& beyond = faces_[edge.beyond];
            for (std::size_t i = 0; i < 3; ++i) {
                if (beyond.corners[i] == edge.to) beyond.neighbors[i] = added;
            }
            add_face({edge.from, edge.to, point}, {edge.beyond, 0, 0});
        }
        for (std::uint32_t i = first; i < faces_.size(); ++i) {
            const std::uint32_t next = face_from_[faces_[i].corners[1]];
            faces_[i].neighbors[1] = next;
            faces_[next].neighbors[2] = i;
        }
        distribute(orphans, first);
    }

    const std::vector<Vec3d>& points_;
    double skin_m_;
    std::vector<Face> faces_;
    std::vector<std::uint32_t>
        face_from_;  ///< by corner: the face added over the horizon's edge from it
};

/// Four points that span a volume, of a set that does.
std::optional<std::array<std::uint32_t, 4>> tetrahedron_of(const std::vector<Vec3d>& points,
                                                           double& skin_m) {
    if (points.size() < 4) return {};
    const std::size_t a = farthest(points, [](const Vec3d& p) { return -p.x; });
    const std::size_t b =
        farthest(points, [&](const Vec3d& p) { return glm::distance(p, points[a]); });
    const double size_m = glm::distance(points[a], points[b]);
    skin_m = size_m * 1e-9;
    if (size_m <= 0.0) return {};
    const Vec3d along = (points[b] - points[a]) / size_m;
    const auto from_line = [&](const Vec3d& p) {
        return glm::length(glm::cross(p - points[a], along));
    };
    const std::size_t c = farthest(points, from_line);
    if (from_line(points[c]) <= skin_m) return {};
    const Vec3d up = glm::normalize(glm::cross(along, points[c] - points[a]));
    const auto from_plane = [&](const Vec3d& p) { return std::abs(glm::dot(p - points[a], up)); };
    const std::size_t d = farthest(points, from_plane);
    if (from_plane(points[d]) <= skin_m) return {};
    return std::array{static_cast<std::uint32_t>(a),
                      static_cast<std::uint32_t>(b),
                      static_cast<std::uint32_t>(c),
                      static_cast<std::uint32_t>(d)};
}

/// What `ask` says of the hull; nothing of a flat set.
template <class Ask>
auto ask_hull(const std::vector<Vec3>& points_m, Ask ask)
    -> std::optional<decltype(ask(std::declval<const Quickhull&>(), Vec3d{}))> {
    std::vector<Vec3d> points;
    points.reserve(points_m.size());
    for (const Vec3& p : points_m) points.push_back(Vec3d(p));
    double skin_m = 0;
    const auto corners = tetrahedron_of(points, skin_m);
    if (!corners) return {};
    Quickhull hull(points, skin_m);
    hull.grow_from(*corners);
    Vec3d inside{0, 0, 0};
    for (const std::uint32_t corner : *corners) inside += points[corner];
    return ask(hull, inside * 0.25);
}

}  // namespace

Real hull_volume_m3(const std::vector<Vec3>& points_m) {
    const auto volume_m3 = [](const Quickhull& hull, const Vec3d& inside) {
        return static_cast<Real>(hull.volume_m3(inside));
    };
    return ask_hull(points_m, volume_m3).value_or(Real{0});
}

std::vector<std::array<std::uint32_t, 3>> hull_triangles(const std::vector<Vec3>& points_m) {
    const auto triangles = [](const Quickhull& hull, const Vec3d&) { return hull.triangles(); };
    return ask_hull(points_m, triangles).value_or(std::vector<std::array<std::uint32_t, 3>>{});
}

}  // namespace plumbline::scene
