#include "engine/assets/mesh_files/polygon_triangles_impl.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace plumbline::assets {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// Twice the polygon's area along its mean direction (Newell).
Vec3f area_of(std::span<const Vec3f> polygon) {
    Vec3f area{0.0F};
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
        area += glm::cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
    }
    return area;
}

/// The polygon seen along its direction, counter-clockwise, and what is left of it.
struct Flat {
    std::vector<Vec2f> places;
    std::vector<std::uint32_t> left;

    float turn_at(std::size_t i) const {
        return turn(corner(i + left.size() - 1), corner(i), corner(i + 1));
    }
    std::uint32_t corner(std::size_t i) const { return left[i % left.size()]; }
    float turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
        const Vec2f ab = places[b] - places[a];
        const Vec2f bc = places[c] - places[b];
        return ab.x * bc.y - ab.y * bc.x;
    }
    /// Nothing else of the polygon lies in the triangle at corner i.
    bool is_ear(std::size_t i, std::size_t& tests) const {
        const std::uint32_t a = corner(i + left.size() - 1);
        const std::uint32_t b = corner(i);
        const std::uint32_t c = corner(i + 1);
        if (turn(a, b, c) <= 0.0F) return false;
        return std::none_of(left.begin(), left.end(), [&](std::uint32_t other) {
            if (other == a || other == b || other == c) return false;
            ++tests;
            return turn(a, b, other) >= 0.0F && turn(b, c, other) >= 0.0F &&
                   turn(c, a, other) >= 0.0F && places[other] != places[a] &&
                   places[other] != places[c];
        });
    }
};

Flat seen_along(const Vec3f& area, std::span<const Vec3f> polygon) {
    const Vec3f size = glm::abs(area);
    const int axis = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
    const int right = (axis + (area[axis] > 0.0F ? 1 : 2)) % 3;
    const int up = 3 - axis - right;
    Flat flat;
    for (const Vec3f& place : polygon) flat.places.push_back({place[right], place[up]});
    flat.left.resize(polygon.size());
    std::iota(flat.left.begin(), flat.left.end(), 0U);
    return flat;
}

void append_fan(std::span<const std::uint32_t> corners, std::vector<Triangle>& triangles) {
    for (std::size_t i = 2; i < corners.size(); ++i) {
        triangles.push_back({corners[0], corners[i - 1], corners[i]});
    }
}

}  // namespace

std::vector<Triangle> triangles_of(std::span<const Vec3f> polygon) {
    std::vector<Triangle> triangles;
    if (polygon.size() < 3) return triangles;
    triangles.reserve(polygon.size() - 2);
    Flat flat = seen_along(area_of(polygon), polygon);
    bool convex = true;
    for (std::size_t i = 0; i < polygon.size() && convex; ++i) convex = flat.turn_at(i) >= 0.0F;
    // Whoever makes polygons to waste time gets a fan for the rest of it.
    const std::size_t most_tests = polygon.size() * polygon.size();
    std::size_t tests = 0;
    std::size_t refused = 0;
    std::size_t at = 0;
    while (!convex && flat.left.size() > 3 && tests <= most_tests && refused <= flat.left.size()) {
        at %= flat.left.size();
        if (!flat.is_ear(at, tests)) {
            ++at;
            ++refused;  // all of them: it crosses itself
            continue;
        }
        triangles.push_back(
            {flat.corner(at + flat.left.size() - 1), flat.corner(at), flat.corner(at + 1)});
        flat.left.erase(flat.left.begin() + static_cast<std::ptrdiff_t>(at));
        refused = 0;
    }
    append_fan(flat.left, triangles);
    return triangles;
}

}  // namespace plumbline::assets
