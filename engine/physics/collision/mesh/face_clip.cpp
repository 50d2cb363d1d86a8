#include "engine/physics/collision/mesh/face_clip.h"

#include <utility>

namespace plumbline::physics {
namespace {

/// Leaves what lies inside of the triangle's edge `edge`.
void cut(const ClippedPolygon& from,
         const Vec3d& on_edge,
         const Vec3d& outward,
         double touching,
         unsigned edge,
         ClippedPolygon& kept) {
    kept.count = 0;
    if (from.count == 0) return;
    double above = glm::dot(from.corners[0] - on_edge, outward);
    for (std::size_t i = 0; i < from.count; ++i) {
        const std::size_t next = i + 1 == from.count ? 0 : i + 1;
        const double next_above = glm::dot(from.corners[next] - on_edge, outward);
        if (above <= touching) kept.add(from.corners[i], from.cuts[i]);
        // Of a line there is no way back.
        const bool crosses = above < 0 ? next_above > touching : above > touching && next_above < 0;
        if (crosses && !(from.count == 2 && next == 0)) {
            const double share = above / (above - next_above);
            kept.add(from.corners[i] + (from.corners[next] - from.corners[i]) * share,
                     (1U << edge) | (from.cuts[i] & from.cuts[next]));
        }
        above = next_above;
    }
}

}  // namespace

void clip_to_triangle(std::span<const Vec3d> polygon,
                      const std::array<Vec3d, 3>& triangle,
                      const Vec3d& normal,
                      double touching_m,
                      ClippedPolygon& clipped) {
    ClippedPolygon other;
    other.count = 0;
    for (const Vec3d& corner : polygon) other.add(corner, 0);
    ClippedPolygon* from = &other;
    ClippedPolygon* to = &clipped;
    for (unsigned i = 0; i < 3; ++i) {
        const Vec3d along = triangle[i == 2 ? 0 : i + 1] - triangle[i];
        const double touching = touching_m * glm::length(along);
        cut(*from, triangle[i], glm::cross(along, normal), touching, i, *to);
        std::swap(from, to);
    }
}

}  // namespace plumbline::physics
