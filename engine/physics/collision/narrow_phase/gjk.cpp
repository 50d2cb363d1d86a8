#include "engine/physics/collision/narrow_phase/gjk.h"

#include <algorithm>
#include <cmath>

namespace plumbline::physics {
namespace {

constexpr int kMostRounds = 64;
/// Of the size of the cores: as near the origin the difference counts as reached.
constexpr double kTouching = 1e-10;
/// Of the distance: a corner that brings no more than this ends the search.
constexpr double kNoGain = 1e-10;

/// The corners of a face or an edge that a point is nearest to, as indices and weights.
struct Nearest {
    Vec3d point{0, 0, 0};
    std::array<std::size_t, 3> corners{};
    std::array<double, 3> weights{};
    std::size_t count{0};
};

Nearest nearest_on_edge(const Simplex& s, std::size_t i, std::size_t k) {
    const Vec3d& a = s.corners[i].at;
    const Vec3d along = s.corners[k].at - a;
    const double length2 = glm::dot(along, along);
    const double t = length2 > 0 ? -glm::dot(a, along) / length2 : 0.0;
    if (t <= 0) return {.point = a, .corners = {i}, .weights = {1}, .count = 1};
    if (t >= 1) return {.point = s.corners[k].at, .corners = {k}, .weights = {1}, .count = 1};
    return {.point = a + along * t, .corners = {i, k}, .weights = {1 - t, t}, .count = 2};
}

Nearest nearest_of_edges(const Simplex& s, std::size_t i, std::size_t k, std::size_t l) {
    Nearest best = nearest_on_edge(s, i, k);
    for (const Nearest& other : {nearest_on_edge(s, k, l), nearest_on_edge(s, l, i)}) {
        if (glm::dot(other.point, other.point) < glm::dot(best.point, best.point)) best = other;
    }
    return best;
}

Nearest nearest_on_triangle(const Simplex& s, std::size_t i, std::size_t k, std::size_t l) {
    const Vec3d& a = s.corners[i].at;
    const Vec3d& b = s.corners[k].at;
    const Vec3d& c = s.corners[l].at;
    const Vec3d normal = glm::cross(b - a, c - a);
    const double area2 = glm::dot(normal, normal);
    if (!(area2 > 0)) return nearest_of_edges(s, i, k, l);
    const double of_a = glm::dot(glm::cross(b, c), normal);
    const double of_b = glm::dot(glm::cross(c, a), normal);
    const double of_c = glm::dot(glm::cross(a, b), normal);
    if (of_a <= 0 || of_b <= 0 || of_c <= 0) return nearest_of_edges(s, i, k, l);
    const double sum = of_a + of_b + of_c;
    return {.point = normal * (glm::dot(a, normal) / area2),
            .corners = {i, k, l},
            .weights = {of_a / sum, of_b / sum, of_c / sum},
            .count = 3};
}

/// Leaves in the simplex what the origin is nearest to and returns the point there; all four corners
/// where it lies inside.
Vec3d reduce(Simplex& s) {
    Nearest best;
    if (s.count == 1) best = {.point = s.corners[0].at, .corners = {0}, .weights = {1}, .count = 1};
    if (s.count == 2) best = nearest_on_edge(s, 0, 1);
    if (s.count == 3) best = nearest_on_triangle(s, 0, 1, 2);
    if (s.count == 4) {
        constexpr std::array<std::array<std::size_t, 4>, 4> kFaces{
            {{0, 1, 2, 3}, {0, 3, 1, 2}, {0, 2, 3, 1}, {1, 3, 2, 0}}};
        bool inside = true;
        for (const auto& [i, k, l, opposite] : kFaces) {
            const Vec3d& a = s.corners[i].at;
            const Vec3d normal = glm::cross(s.corners[k].at - a, s.corners[l].at - a);
            const double side = glm::dot(s.corners[opposite].at - a, normal);
            const double of_origin = -glm::dot(a, normal);
            if (side != 0 && side * of_origin > 0) continue;
            inside = false;
            const Nearest found = nearest_on_triangle(s, i, k, l);
            if (best.count == 0 ||
                glm::dot(found.point, found.point) < glm::dot(best.point, best.point))
                best = found;
        }
        if (inside) return {0, 0, 0};
    }
    const Simplex from = s;
    s.count = best.count;
    for (std::size_t i = 0; i < best.count; ++i) {
        s.corners[i] = from.corners[best.corners[i]];
        s.weights[i] = best.weights[i];
    }
    return best.point;
}

bool has_corner(const Simplex& s, const Vec3d& at) {
    return std::any_of(s.corners.begin(),
                       s.corners.begin() + static_cast<std::ptrdiff_t>(s.count),
                       [&at](const Vertex& corner) { return corner.at == at; });
}

double scale_of(const Vertex& vertex) {
    return std::max({glm::length(vertex.on_a), glm::length(vertex.on_b), 1e-6});
}

}  // namespace

Vertex support_vertex(const PlacedConvex& a, const PlacedConvex& b, const Vec3d& direction) {
    const Vec3d on_a = support(a, direction);
    const Vec3d on_b = support(b, -direction);
    return {.at = on_a - on_b, .on_a = on_a, .on_b = on_b};
}

Closest closest_points(const PlacedConvex& a, const PlacedConvex& b, double reach_m) {
    Closest found;
    Simplex& s = found.simplex;
    Vec3d towards = b.center_m - a.center_m;
    if (glm::dot(towards, towards) == 0) towards = {1, 0, 0};
    s.corners[0] = support_vertex(a, b, towards);
    s.weights[0] = 1;
    s.count = 1;
    Vec3d nearest = s.corners[0].at;
    const double touching_m = kTouching * scale_of(s.corners[0]);
    double nearest2 = glm::dot(nearest, nearest);
    for (int round = 0; round < kMostRounds; ++round) {
        if (nearest2 <= touching_m * touching_m) break;
        const Vertex next = support_vertex(a, b, -nearest);
        const double along = glm::dot(nearest, next.at);
        // The plane through the corner bounds the distance from below.
        if (along > 0 && along * along > reach_m * reach_m * nearest2) break;
        if (nearest2 - along <= kNoGain * nearest2 || has_corner(s, next.at)) break;
        const Simplex before = s;
        s.corners[s.count++] = next;
        const Vec3d point = reduce(s);
        const double point2 = glm::dot(point, point);
        if (s.count == 4) {
            nearest = {0, 0, 0};
            nearest2 = 0;
            break;
        }
        if (point2 >= nearest2) {
            s = before;
            break;
        }
        nearest = point;
        nearest2 = point2;
    }
    if (nearest2 > touching_m * touching_m) found.distance_m = std::sqrt(nearest2);
    if (s.count == 4) return found;
    for (std::size_t i = 0; i < s.count; ++i) {
        found.on_a += s.corners[i].on_a * s.weights[i];
        found.on_b += s.corners[i].on_b * s.weights[i];
    }
    return found;
}

}  // namespace plumbline::physics
