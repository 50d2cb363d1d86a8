#include "engine/assets/primitives.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <span>

namespace plumbline::assets {
namespace {

constexpr std::uint32_t kSegments = 32;         // around the axis
constexpr std::uint32_t kHalfCircleRings = 16;  // from pole to pole
constexpr float kPiF = 3.14159265F;

/// One ring of a surface of revolution about y, from the top down.
struct Ring {
    float radius_m;
    float y_m;
    float normal_out;  ///< the normal's part away from the axis
    float normal_up;   ///< and along it
    float v_m;         ///< length along the profile, from its top
};

std::uint32_t count_of(const MeshData& mesh) {
    return static_cast<std::uint32_t>(mesh.vertices.size());
}

void add_triangle(MeshData& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh.indices.insert(mesh.indices.end(), {a, b, c});
}

float angle_of(float segment) {
    return 2.0F * kPiF * segment / static_cast<float>(kSegments);
}

/// The angle starts at +z and grows towards +x, so that u runs to the right seen from outside.
Vec3f around(float angle_rad, float radius, float y) {
    return {radius * std::sin(angle_rad), y, radius * std::cos(angle_rad)};
}

/// Rings of radius 0 are points: their vertices sit between two segments, and one triangle of
/// each quad there is left out.
void add_revolution(MeshData& mesh, std::span<const Ring> rings, float u_radius_m) {
    const std::uint32_t first = count_of(mesh);
    for (const Ring& ring : rings) {
        const float shift = ring.radius_m == 0.0F ? 0.5F : 0.0F;
        for (std::uint32_t i = 0; i <= kSegments; ++i) {
            const float angle = angle_of(static_cast<float>(i) + shift);
            // The last column repeats the first one's position exactly: no crack at the seam.
            const float place = angle_of(static_cast<float>(i % kSegments) + shift);
            mesh.vertices.push_back(
                {.position_body = around(place, ring.radius_m, ring.y_m),
                 .normal_body = glm::normalize(around(place, ring.normal_out, ring.normal_up)),
                 .uv = {angle * u_radius_m, ring.v_m}});
        }
    }
    for (std::uint32_t row = 0; row + 1 < rings.size(); ++row) {
        for (std::uint32_t i = 0; i < kSegments; ++i) {
            const std::uint32_t upper_left = first + row * (kSegments + 1) + i;
            const std::uint32_t lower_left = upper_left + kSegments + 1;
            if (rings[row + 1].radius_m > 0.0F) {
                add_triangle(mesh, upper_left, lower_left, lower_left + 1);
            }
            if (rings[row].radius_m > 0.0F) {
                // At a lower pole the point between the two segments is this column's own.
                const std::uint32_t below =
                    rings[row + 1].radius_m > 0.0F ? lower_left + 1 : lower_left;
                add_triangle(mesh, upper_left, below, upper_left + 1);
            }
        }
    }
}

/// A disc across the axis; `side` +1 looks up, -1 down.
void add_disc(MeshData& mesh, float radius_m, float y_m, float side) {
    const std::uint32_t first = count_of(mesh);
    const Vec3f normal{0.0F, side, 0.0F};
    const auto add = [&](const Vec3f& position) {
        // Seen along the normal with +x to the right, the image's top is at -z above, +z below.
        mesh.vertices.push_back({.position_body = position,
                                 .normal_body = normal,
                                 .uv = {position.x + radius_m, side * position.z + radius_m}});
    };
    add({0.0F, y_m, 0.0F});
    for (std::uint32_t i = 0; i < kSegments; ++i) {
        add(around(angle_of(static_cast<float>(i)), radius_m, y_m));
    }
    for (std::uint32_t i = 0; i < kSegments; ++i) {
        const std::uint32_t here = first + 1 + i;
        const std::uint32_t next = first + 1 + (i + 1) % kSegments;
        if (side > 0.0F) {
            add_triangle(mesh, first, here, next);
        } else {
            add_triangle(mesh, first, next, here);
        }
    }
}

/// A rectangle around `center`; `right` and `up` are unit, right x up is the normal.
void add_quad(
    MeshData& mesh, const Vec3f& center, const Vec3f& right, const Vec3f& up, const Vec2f& size_m) {
    const std::uint32_t first = count_of(mesh);
    const Vec3f normal = glm::cross(right, up);
    for (const Vec2f& corner : {Vec2f{0, 0}, Vec2f{0, 1}, Vec2f{1, 1}, Vec2f{1, 0}}) {
        const Vec2f uv = corner * size_m;
        mesh.vertices.push_back({.position_body = center + right * (uv.x - size_m.x * 0.5F) +
                                                  up * (size_m.y * 0.5F - uv.y),
                                 .normal_body = normal,
                                 .uv = uv});
    }
    add_triangle(mesh, first, first + 1, first + 2);
    add_triangle(mesh, first, first + 2, first + 3);
}

/// Half-circle rings between two polar angles (0 is the top), about a centre on the axis.
void add_arc(std::vector<Ring>& rings,
             float radius_m,
             float center_y_m,
             std::uint32_t first_ring,
             std::uint32_t last_ring) {
    float v_m = 0.0F;
    if (!rings.empty()) {
        const float gap_m = rings.back().y_m - center_y_m;  // the straight part above this arc
        v_m = rings.back().v_m + gap_m;
    }
    const float ring_step = kPiF / static_cast<float>(kHalfCircleRings);
    const float first_polar = ring_step * static_cast<float>(first_ring);
    for (std::uint32_t i = first_ring; i <= last_ring; ++i) {
        const float polar = ring_step * static_cast<float>(i);
        const bool pole = i == 0 || i == kHalfCircleRings;
        rings.push_back({.radius_m = pole ? 0.0F : radius_m * std::sin(polar),
                         .y_m = center_y_m + radius_m * std::cos(polar),
                         .normal_out = pole ? 0.0F : std::sin(polar),
                         .normal_up = std::cos(polar),
                         .v_m = v_m + radius_m * (polar - first_polar)});
    }
}

}  // namespace

MeshData box_mesh(const Vec3f& size_m) {
    const Vec3f half = size_m * 0.5F;
    const Vec3f x{1, 0, 0};
    const Vec3f y{0, 1, 0};
    const Vec3f z{0, 0, 1};
    MeshData mesh;
    add_quad(mesh, x * half.x, -z, y, {size_m.z, size_m.y});
    add_quad(mesh, -x * half.x, z, y, {size_m.z, size_m.y});
    add_quad(mesh, y * half.y, x, -z, {size_m.x, size_m.z});
    add_quad(mesh, -y * half.y, x, z, {size_m.x, size_m.z});
    add_quad(mesh, z * half.z, x, y, {size_m.x, size_m.y});
    add_quad(mesh, -z * half.z, -x, y, {size_m.x, size_m.y});
    return finished(std::move(mesh));
}

MeshData sphere_mesh(float radius_m) {
    std::vector<Ring> rings;
    add_arc(rings, radius_m, 0.0F, 0, kHalfCircleRings);
    MeshData mesh;
    add_revolution(mesh, rings, radius_m);
    return finished(std::move(mesh));
}

MeshData cylinder_mesh(float radius_m, float height_m) {
    const float half_m = height_m * 0.5F;
    const std::array rings{Ring{radius_m, half_m, 1.0F, 0.0F, 0.0F},
                           Ring{radius_m, -half_m, 1.0F, 0.0F, height_m}};
    MeshData mesh;
    add_revolution(mesh, rings, radius_m);
    add_disc(mesh, radius_m, half_m, 1.0F);
    add_disc(mesh, radius_m, -half_m, -1.0F);
    return finished(std::move(mesh));
}

MeshData capsule_mesh(float radius_m, float height_m) {
    std::vector<Ring> rings;
    add_arc(rings, radius_m, height_m * 0.5F, 0, kHalfCircleRings / 2);
    add_arc(rings, radius_m, -height_m * 0.5F, kHalfCircleRings / 2, kHalfCircleRings);
    MeshData mesh;
    add_revolution(mesh, rings, radius_m);
    return finished(std::move(mesh));
}

MeshData cone_mesh(float radius_m, float height_m) {
    const float slant_m = std::hypot(radius_m, height_m);
    const float out = height_m / slant_m;
    const float up = radius_m / slant_m;
    const std::array rings{Ring{0.0F, height_m * 0.5F, out, up, 0.0F},
                           Ring{radius_m, -height_m * 0.5F, out, up, slant_m}};
    MeshData mesh;
    add_revolution(mesh, rings, radius_m);
    add_disc(mesh, radius_m, -height_m * 0.5F, -1.0F);
    return finished(std::move(mesh));
}

MeshData plane_mesh(const Vec2f& size_m) {
    MeshData mesh;
    add_quad(mesh, Vec3f{0.0F}, {1, 0, 0}, {0, 0, -1}, size_m);
    return finished(std::move(mesh));
}

}  // namespace plumbline::assets
