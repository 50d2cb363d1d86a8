#include "engine/render/culling/convex_volume.h"

#include "engine/render/culling/frustum.h"

#include <glm/gtc/matrix_access.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace plumbline::render {
namespace {

using Polygon = std::vector<Vec3f>;

constexpr std::size_t kConeSides = 8;
constexpr float kWidest_rad = radians_from_degrees(80.0F);

float height_over(const Vec4f& plane, const Vec3f& point) {
    return glm::dot(Vec3f{plane}, point) + plane.w;
}

/// The part of a convex polygon on the plane's inner side.
Polygon clipped(const Polygon& polygon, const Vec4f& plane) {
    Polygon inside;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3f& from = polygon[i];
        const Vec3f& to = polygon[(i + 1) % polygon.size()];
        const float from_m = height_over(plane, from);
        const float to_m = height_over(plane, to);
        if (from_m >= 0.0F) inside.push_back(from);
        if ((from_m >= 0.0F) != (to_m >= 0.0F)) {
            inside.push_back(glm::mix(from, to, from_m / (from_m - to_m)));
        }
    }
    return inside;
}

std::array<Vec4f, 6> planes_of(const Aabb& box) {
    std::array<Vec4f, 6> planes{};
    for (int axis = 0; axis < 3; ++axis) {
        Vec3f normal{0.0F};
        normal[axis] = 1.0F;
        planes[static_cast<std::size_t>(axis) * 2] = Vec4f{normal, -box.min[axis]};
        planes[static_cast<std::size_t>(axis) * 2 + 1] = Vec4f{-normal, box.max[axis]};
    }
    return planes;
}

std::vector<Polygon> faces_of(const Aabb& box) {
    std::vector<Polygon> faces;
    for (int axis = 0; axis < 3; ++axis) {
        const int u = (axis + 1) % 3;
        const int v = (axis + 2) % 3;
        for (const float at : {box.min[axis], box.max[axis]}) {
            Polygon face(4, Vec3f{at});
            for (std::size_t i = 0; i < 4; ++i) {
                face[i][u] = i == 1 || i == 2 ? box.max[u] : box.min[u];
                face[i][v] = i >= 2 ? box.max[v] : box.min[v];
            }
            faces.push_back(std::move(face));
        }
    }
    return faces;
}

void include_part(ClipRect& rect,
                  Polygon polygon,
                  std::span<const Vec4f> planes,
                  const Mat4f& clip_from_world) {
    for (const Vec4f& plane : planes) polygon = clipped(polygon, plane);
    const Vec4f near_plane = glm::row(clip_from_world, 3) + glm::row(clip_from_world, 2);
    for (const Vec3f& point : clipped(polygon, near_plane)) {
        const Vec4f clip = clip_from_world * Vec4f{point, 1.0F};
        const Vec2f at = glm::clamp(Vec2f{clip} / std::max(clip.w, 1e-6F), -1.0F, 1.0F);
        rect.min = glm::min(rect.min, at);
        rect.max = glm::max(rect.max, at);
    }
}

}  // namespace

Mat3f axes_along(const Vec3f& direction_world) {
    const Vec3f aside =
        std::abs(direction_world.y) < 0.9F ? Vec3f{0.0F, 1.0F, 0.0F} : Vec3f{1.0F, 0.0F, 0.0F};
    const Vec3f right = glm::normalize(glm::cross(direction_world, aside));
    return glm::transpose(Mat3f{right, glm::cross(right, direction_world), direction_world});
}

ClipRect intersection(const ClipRect& a, const ClipRect& b) {
    return {.min = glm::max(a.min, b.min), .max = glm::min(a.max, b.max)};
}

ClipRect part_seen(const Aabb& box_world, const Mat4f& clip_from_world) {
    ClipRect rect;
    if (box_world.empty()) return rect;
    for (const Polygon& face : faces_of(box_world)) include_part(rect, face, {}, clip_from_world);
    return rect;
}

ConvexVolume ConvexVolume::cone(const Vec3f& position_world,
                                const Vec3f& direction_world,
                                float half_angle_rad,
                                float radius_m) {
    ConvexVolume volume;
    volume.is_everywhere_ = half_angle_rad > kWidest_rad;
    const Mat3f axes = glm::transpose(axes_along(direction_world));
    // The pyramid's sides touch the cone, so its edges stand out of it.
    const float half_side_rad = glm::pi<float>() / static_cast<float>(kConeSides);
    const float reach_m =
        radius_m * std::tan(std::min(half_angle_rad, kWidest_rad)) / std::cos(half_side_rad);
    const Vec3f end_world = position_world + direction_world * radius_m;
    Polygon end;
    for (std::size_t i = 0; i < kConeSides; ++i) {
        const float turn = 2.0F * half_side_rad * static_cast<float>(i);
        end.push_back(end_world + reach_m * (std::cos(turn) * axes[0] + std::sin(turn) * axes[1]));
    }
    for (std::size_t i = 0; i < kConeSides; ++i) {
        const Vec3f& a = end[i];
        const Vec3f& b = end[(i + 1) % kConeSides];
        Vec3f normal = glm::normalize(glm::cross(a - position_world, b - position_world));
        if (glm::dot(normal, direction_world) < 0.0F) normal = -normal;
        volume.planes_world_.emplace_back(normal, -glm::dot(normal, position_world));
        volume.faces_world_.push_back({position_world, a, b});
    }
    volume.planes_world_.emplace_back(-direction_world, glm::dot(direction_world, end_world));
    volume.faces_world_.push_back(std::move(end));
    return volume;
}

ConvexVolume ConvexVolume::prism(const Vec3f& direction_world, const Aabb& along) {
    ConvexVolume volume;
    const Mat3f along_from_world = axes_along(direction_world);
    for (const Vec4f& plane : planes_of(along))
        volume.planes_world_.emplace_back(Vec3f{plane} * along_from_world, plane.w);
    for (Polygon& face : faces_of(along)) {
        for (Vec3f& corner : face) corner = corner * along_from_world;
        volume.faces_world_.push_back(std::move(face));
    }
    return volume;
}

bool ConvexVolume::reaches(const Aabb& box_world) const {
    if (is_everywhere_) return !box_world.empty();
    return may_touch(planes_world_, box_world);
}

ClipRect ConvexVolume::part_seen(const Aabb& box_world, const Mat4f& clip_from_world) const {
    if (box_world.empty()) return {};
    if (is_everywhere_) return {.min = Vec2f{-1.0F}, .max = Vec2f{1.0F}};
    ClipRect rect;
    const std::array<Vec4f, 6> box_planes = planes_of(box_world);
    for (const Polygon& face : faces_of(box_world)) {
        include_part(rect, face, planes_world_, clip_from_world);
    }
    for (const Polygon& face : faces_world_) {
        include_part(rect, face, box_planes, clip_from_world);
    }
    return rect;
}

}  // namespace plumbline::render
