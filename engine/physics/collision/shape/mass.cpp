#include "engine/physics/collision/shape/mass.h"

#include <algorithm>
#include <cmath>

namespace plumbline::physics {
namespace {

constexpr double kPiD = 3.14159265358979323846;

Mat3d diagonal(double x, double y, double z) {
    Mat3d m{0.0};
    m[0][0] = x;
    m[1][1] = y;
    m[2][2] = z;
    return m;
}

Mat3d outer(const Vec3d& a, const Vec3d& b) {
    return glm::outerProduct(a, b);
}

/// What moving the reference point by `d` adds to the tensor of a mass m.
Mat3d parallel_axis(double mass, const Vec3d& d) {
    return mass * (glm::dot(d, d) * Mat3d{1.0} - outer(d, d));
}

}  // namespace

SolidMass mass_of_box(const Vec3d& s) {
    const double m = s.x * s.y * s.z;
    return {.volume_m3 = m,
            .inertia = diagonal(m * (s.y * s.y + s.z * s.z) / 12.0,
                                m * (s.x * s.x + s.z * s.z) / 12.0,
                                m * (s.x * s.x + s.y * s.y) / 12.0)};
}

SolidMass mass_of_sphere(double r) {
    const double m = 4.0 / 3.0 * kPiD * r * r * r;
    const double i = 0.4 * m * r * r;
    return {.volume_m3 = m, .inertia = diagonal(i, i, i)};
}

SolidMass mass_of_cylinder(double r, double h) {
    const double m = kPiD * r * r * h;
    const double across = m * (3.0 * r * r + h * h) / 12.0;
    return {.volume_m3 = m, .inertia = diagonal(across, 0.5 * m * r * r, across)};
}

SolidMass mass_of_capsule(double r, double h) {
    const double barrel = kPiD * r * r * h;
    const double caps = 4.0 / 3.0 * kPiD * r * r * r;  // both halves
    const double along = 0.5 * barrel * r * r + 0.4 * caps * r * r;
    // A half ball's centre lies 3r/8 above its flat face.
    const double across =
        barrel * (3.0 * r * r + h * h) / 12.0 + caps * (0.4 * r * r + 0.25 * h * h + 0.375 * r * h);
    return {.volume_m3 = barrel + caps, .inertia = diagonal(across, along, across)};
}

SolidMass mass_of_cone(double r, double h) {
    const double m = kPiD * r * r * h / 3.0;
    const double across = 3.0 / 80.0 * m * (4.0 * r * r + h * h);
    return {.volume_m3 = m,
            .center_m = {0, -0.25 * h, 0},
            .inertia = diagonal(across, 0.3 * m * r * r, across)};
}

SolidMass mass_of_triangles(std::span<const Vec3d> vertices,
                            std::span<const std::array<std::uint32_t, 3>> triangles) {
    // Tetrahedra from a point near the solid: far from the origin the terms would cancel badly.
    Vec3d middle{0, 0, 0};
    for (const Vec3d& v : vertices) middle += v;
    if (!vertices.empty()) middle /= static_cast<double>(vertices.size());

    double volume = 0;
    Vec3d first{0, 0, 0};
    Mat3d second{0.0};  // integral of x x^T
    for (const auto& t : triangles) {
        const Vec3d a = vertices[t[0]] - middle;
        const Vec3d b = vertices[t[1]] - middle;
        const Vec3d c = vertices[t[2]] - middle;
        const double v = glm::dot(a, glm::cross(b, c)) / 6.0;
        const Vec3d sum = a + b + c;
        volume += v;
        first += v / 4.0 * sum;
        second += v / 20.0 * (outer(a, a) + outer(b, b) + outer(c, c) + outer(sum, sum));
    }
    if (!(volume > 0)) return {};
    const Vec3d center = first / volume;
    second -= volume * outer(center, center);
    const double trace = second[0][0] + second[1][1] + second[2][2];
    return {
        .volume_m3 = volume, .center_m = center + middle, .inertia = trace * Mat3d{1.0} - second};
}

SolidMass moved(const SolidMass& mass, const Vec3d& offset, const Quatd& rotation) {
    const Mat3d r = glm::mat3_cast(rotation);
    return {.volume_m3 = mass.volume_m3,
            .center_m = offset + r * mass.center_m,
            .inertia = r * mass.inertia * glm::transpose(r)};
}

SolidMass joined(const SolidMass& a, const SolidMass& b) {
    const double volume = a.volume_m3 + b.volume_m3;
    if (!(volume > 0)) return a;
    const Vec3d center = (a.volume_m3 * a.center_m + b.volume_m3 * b.center_m) / volume;
    return {.volume_m3 = volume,
            .center_m = center,
            .inertia = a.inertia + parallel_axis(a.volume_m3, a.center_m - center) + b.inertia +
                       parallel_axis(b.volume_m3, b.center_m - center)};
}

bool is_plate(const Vec3d& inertia) {
    constexpr double kThin = 1.0 / 6;
    const double half = (inertia.x + inertia.y + inertia.z) / 2;
    // In proportion to the squares of the box's edges.
    std::array squares{half - inertia.x, half - inertia.y, half - inertia.z};
    std::ranges::sort(squares);
    return squares[0] < kThin * kThin * squares[1];
}

PrincipalFrame principal_frame(const Mat3d& inertia) {
    Mat3d a = inertia;
    const double largest = std::max({std::abs(a[0][0]), std::abs(a[1][1]), std::abs(a[2][2])});
    const auto off_diagonal = [&a] {
        return std::max({std::abs(a[1][0]), std::abs(a[2][0]), std::abs(a[2][1])});
    };
    Mat3d axes{1.0};
    if (off_diagonal() > 1e-4 * largest) {
        // Jacobi rotations: three planes a sweep, far more sweeps than a 3x3 ever needs.
        for (int sweep = 0; sweep < 32 && off_diagonal() > 1e-15 * largest; ++sweep) {
            for (const auto& [p, q] : {std::array{0, 1}, std::array{0, 2}, std::array{1, 2}}) {
                if (a[q][p] == 0.0) continue;
                const double theta = (a[q][q] - a[p][p]) / (2.0 * a[q][p]);
                const double t =
                    (theta >= 0 ? 1.0 : -1.0) / (std::abs(theta) + std::sqrt(theta * theta + 1.0));
                const double c = 1.0 / std::sqrt(t * t + 1.0);
                Mat3d rotation{1.0};
                rotation[p][p] = c;
                rotation[q][q] = c;
                rotation[q][p] = t * c;
                rotation[p][q] = -t * c;
                a = glm::transpose(rotation) * a * rotation;
                axes = axes * rotation;
            }
        }
        if (glm::determinant(axes) < 0) axes[2] = -axes[2];
    }
    return {.inertia = {a[0][0], a[1][1], a[2][2]},
            .orientation = glm::normalize(glm::quat_cast(axes))};
}

}  // namespace plumbline::physics
