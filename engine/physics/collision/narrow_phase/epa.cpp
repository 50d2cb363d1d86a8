#include "engine/physics/collision/narrow_phase/epa.h"

#include "engine/physics/transform.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumbline::physics {
namespace {

using Index = std::uint8_t;

constexpr std::size_t kMostVertices = 120;
constexpr std::size_t kMostFaces = 240;
/// Of the size of the difference: a face that grows less is on the surface.
constexpr double kOnSurface = 1e-8;
/// Likewise: a vertex that lies this near to a face's plane sees the face.
constexpr double kInPlane = 1e-13;
/// Likewise: what is thinner has no volume.
constexpr double kFlat = 1e-12;

constexpr std::array<Index, 3> kNext{1, 2, 0};

/// A triangle, counter-clockwise from outside. Edge i goes from corner i to the next.
struct Face {
    std::array<Index, 3> corners;
    std::array<Index, 3> beside;          ///< the face across each edge
    std::array<Index, 3> edge_of_beside;  ///< which of its edges that is
    bool is_alive;
    Vec3d normal;
};

/// An edge between what the new vertex sees and what it does not, and the face that stays.
struct RimEdge {
    Index face;
    Index edge;
};

/// A closed convex surface round the origin that grows until it touches that of the difference.
class Polytope {
public:
    Polytope(const PlacedConvex& a, const PlacedConvex& b) : a_(a), b_(b) {}

    Penetration run(const Simplex& simplex) {
        if (!start(simplex)) return flat(simplex);
        Penetration best{.depth_m = std::numeric_limits<double>::max()};
        while (true) {
            const Index nearest = nearest_face();
            const Vec3d& normal = faces_[nearest].normal;
            const Vertex next = support_vertex(a_, b_, normal);
            const double depth_m = glm::dot(next.at, normal);
            const bool ends = depth_m - offsets_[nearest] <= kOnSurface * scale_m_;
            const double as_good_m = ends ? kOnSurface * scale_m_ : 0.0;
            if (depth_m <= best.depth_m + as_good_m) best = penetration_at(nearest, depth_m);
            if (ends || vertex_count_ == kMostVertices || !grow(nearest, next)) return best;
        }
    }

private:
    Index nearest_face() const {
        const auto end = offsets_.begin() + static_cast<std::ptrdiff_t>(face_count_);
        return static_cast<Index>(std::min_element(offsets_.begin(), end) - offsets_.begin());
    }

    bool is_new(const Vertex& vertex) const {
        return std::none_of(vertices_.begin(),
                            vertices_.begin() + static_cast<std::ptrdiff_t>(vertex_count_),
                            [&](const Vertex& known) { return known.at == vertex.at; });
    }

    /// Adds the support along the unit direction, or against it, that lies farther off what is there.
    bool add_off(const Vec3d& direction) {
        const double here = glm::dot(vertices_[0].at, direction);
        const Vertex up = support_vertex(a_, b_, direction);
        const Vertex down = support_vertex(a_, b_, -direction);
        const double above = glm::dot(up.at, direction) - here;
        const double below = here - glm::dot(down.at, direction);
        if (!(std::max(above, below) > kFlat * scale_of(up))) return false;
        vertices_[vertex_count_++] = above >= below ? up : down;
        return true;
    }

    static double scale_of(const Vertex& vertex) {
        return std::max({glm::length(vertex.on_a), glm::length(vertex.on_b), 1e-6});
    }

    /// A tetrahedron with the origin in it or on it; false: the difference has no volume.
    bool start(const Simplex& simplex) {
        for (std::size_t i = 0; i < simplex.count; ++i)
            vertices_[vertex_count_++] = simplex.corners[i];
        if (vertex_count_ == 1 && !add_off({1, 0, 0}) && !add_off({0, 1, 0}) && !add_off({0, 0, 1}))
            return false;
        if (vertex_count_ == 2) {
            const Vec3d along = vertices_[1].at - vertices_[0].at;
            const Vec3d across = across_of(along);
            if (!add_off(across) && !add_off(glm::normalize(glm::cross(along, across))))
                return false;
        }
        if (vertex_count_ == 3 && !add_off(triangle_normal())) return false;
        for (std::size_t i = 0; i < 4; ++i)
            scale_m_ = std::max(scale_m_, glm::length(vertices_[i].at));
        const Vec3d normal = triangle_normal();
        const bool is_below = glm::dot(vertices_[3].at - vertices_[0].at, normal) < 0;
        if (!is_below) std::swap(vertices_[1], vertices_[2]);
        // Now the first three run counter-clockwise, seen from the side where the fourth is not.
        return add_tetrahedron();
    }

    /// A unit vector across one that is not 0.
    static Vec3d across_of(const Vec3d& along) {
        const Vec3d size = magnitudes_of(along);
        Vec3d least{1, 0, 0};
        if (size.y < size.x) least = {0, 1, 0};
        if (size.z < std::min(size.x, size.y)) least = {0, 0, 1};
        return glm::normalize(glm::cross(along, least));
    }

    Vec3d triangle_normal() const {
        const Vec3d normal =
            glm::cross(vertices_[1].at - vertices_[0].at, vertices_[2].at - vertices_[0].at);
        const double length = glm::length(normal);
        return length > 0 ? normal / length : across_of(vertices_[1].at - vertices_[0].at);
    }

    bool add_tetrahedron() {
        constexpr std::array<std::array<Index, 3>, 4> kCorners{
            {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}};
        for (const auto& corners : kCorners) {
            if (!add_face(corners)) return false;
        }
        join(0, 0, 1, 2);
        join(0, 1, 2, 2);
        join(0, 2, 3, 2);
        join(1, 1, 2, 0);
        join(2, 1, 3, 0);
        join(3, 1, 1, 0);
        return true;
    }

    void join(Index face, Index edge, Index other, Index edge_of_other) {
        faces_[face].beside[edge] = other;
        faces_[face].edge_of_beside[edge] = edge_of_other;
        faces_[other].beside[edge_of_other] = face;
        faces_[other].edge_of_beside[edge_of_other] = edge;
    }

    bool add_face(const std::array<Index, 3>& corners) {
        if (free_count_ == 0 && face_count_ == kMostFaces) return false;
        const Vec3d& a = vertices_[corners[0]].at;
        const Vec3d& b = vertices_[corners[1]].at;
        const Vec3d& c = vertices_[corners[2]].at;
        const Vec3d normal = glm::cross(b - a, c - a);
        const double length2 = glm::dot(normal, normal);
        if (!(length2 > 0)) return false;
        added_ = free_count_ > 0 ? free_[--free_count_] : static_cast<Index>(face_count_++);
        Face& face = faces_[added_];
        face.corners = corners;
        face.is_alive = true;
        face.normal = normal / std::sqrt(length2);
        offsets_[added_] = glm::dot(face.normal, a);
        return true;
    }

    /// Takes out the faces that the vertex sees and closes the hole with new ones. Whether that went well.
    bool grow(Index nearest, const Vertex& next) {
        if (!is_new(next)) return false;
        std::array<RimEdge, kMostFaces> rim;
        std::size_t rim_count = 0;
        take_out(nearest);
        for (Index i = 0; i < 3; ++i) {
            const RimEdge edge{faces_[nearest].beside[i], faces_[nearest].edge_of_beside[i]};
            if (!see(next.at, edge, rim, rim_count)) return false;
        }
        const auto at = static_cast<Index>(vertex_count_);
        vertices_[vertex_count_++] = next;
        Index first = 0;
        Index last = 0;
        for (std::size_t i = 0; i < rim_count; ++i) {
            const Face& stays = faces_[rim[i].face];
            const Index from = stays.corners[kNext[rim[i].edge]];
            const Index to = stays.corners[rim[i].edge];
            if (!add_face({from, to, at})) return false;
            join(added_, 0, rim[i].face, rim[i].edge);
            if (i == 0) first = added_;
            if (i > 0) {
                if (faces_[last].corners[1] != from) return false;
                join(last, 1, added_, 2);
            }
            last = added_;
        }
        if (rim_count < 3 || faces_[last].corners[1] != faces_[first].corners[0]) return false;
        join(last, 1, first, 2);
        return true;
    }

    void take_out(Index face) {
        faces_[face].is_alive = false;
        offsets_[face] = std::numeric_limits<double>::max();
        free_[free_count_++] = face;
    }

    /// Walks round what the vertex sees, from edge to edge in order.
    bool see(const Vec3d& vertex,
             const RimEdge& start,
             std::array<RimEdge, kMostFaces>& rim,
             std::size_t& rim_count) {
        std::array<RimEdge, kMostFaces> to_visit;
        std::size_t left = 0;
        to_visit[left++] = start;
        while (left > 0) {
            const RimEdge edge = to_visit[--left];
            const Face& face = faces_[edge.face];
            if (!face.is_alive) continue;
            const double above_m = glm::dot(face.normal, vertex) - offsets_[edge.face];
            if (above_m < -kInPlane * scale_m_) {
                if (rim_count == kMostFaces) return false;
                rim[rim_count++] = edge;
                continue;
            }
            take_out(edge.face);
            if (left + 2 > kMostFaces) return false;
            const Index second = kNext[kNext[edge.edge]];
            to_visit[left++] = {face.beside[second], face.edge_of_beside[second]};
            const Index first = kNext[edge.edge];
            to_visit[left++] = {face.beside[first], face.edge_of_beside[first]};
        }
        return true;
    }

    Penetration penetration_at(Index index, double depth_m) const {
        const Face& face = faces_[index];
        const Vertex& i = vertices_[face.corners[0]];
        const Vertex& k = vertices_[face.corners[1]];
        const Vertex& l = vertices_[face.corners[2]];
        const Vec3d nearest = face.normal * offsets_[index];
        const Vec3d& a = i.at;
        const Vec3d& b = k.at;
        const Vec3d& c = l.at;
        const Vec3d across = glm::cross(b - a, c - a);
        const double area2 = glm::dot(across, across);
        const double of_a = glm::dot(glm::cross(b - nearest, c - nearest), across) / area2;
        const double of_b = glm::dot(glm::cross(c - nearest, a - nearest), across) / area2;
        const double of_c = 1 - of_a - of_b;
        const auto between = [&](auto side) {
            return i.*side * of_a + k.*side * of_b + l.*side * of_c;
        };
        return {.normal = -face.normal,
                .depth_m = depth_m,
                .on_a = between(&Vertex::on_a),
                .on_b = between(&Vertex::on_b)};
    }

    /// Of a difference without volume: out of its plane, or away from its line or point.
    Penetration flat(const Simplex& simplex) const {
        Vec3d normal{1, 0, 0};
        if (vertex_count_ == 2) normal = across_of(vertices_[1].at - vertices_[0].at);
        if (vertex_count_ >= 3) normal = triangle_normal();
        if (glm::dot(a_.center_m - b_.center_m, normal) < 0) normal = -normal;
        Penetration found{.normal = normal};
        const Vertex far = support_vertex(a_, b_, -normal);
        found.depth_m = -glm::dot(far.at, normal);
        const double share = 1 / static_cast<double>(std::max<std::size_t>(simplex.count, 1));
        for (std::size_t i = 0; i < simplex.count; ++i) {
            const double weight = simplex.count < 4 ? simplex.weights[i] : share;
            found.on_a += simplex.corners[i].on_a * weight;
            found.on_b += simplex.corners[i].on_b * weight;
        }
        return found;
    }

    const PlacedConvex& a_;
    const PlacedConvex& b_;
    std::array<Vertex, kMostVertices> vertices_;
    std::size_t vertex_count_{0};
    std::array<Face, kMostFaces> faces_;
    std::array<double, kMostFaces>
        offsets_;  ///< of the faces' planes; greatest where there is none
    std::size_t face_count_{0};
    std::array<Index, kMostFaces> free_;  ///< places of faces taken out
    std::size_t free_count_{0};
    Index added_{0};
    double scale_m_{0};
};

}  // namespace

Penetration penetration_of(const PlacedConvex& a, const PlacedConvex& b, const Simplex& simplex) {
    return Polytope(a, b).run(simplex);
}

}  // namespace plumbline::physics
