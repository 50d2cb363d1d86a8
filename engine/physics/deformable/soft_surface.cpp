// The surface of a soft body: its volume, what touches others, and the water on it.
#include "engine/physics/medium.h"
#include "engine/physics/soft_body.h"

#include <algorithm>
#include <cmath>

namespace plumbline::physics {
namespace {

/// The part of a triangle under water, by the depths of its corners: the depth's integrals over it, in shares of the triangle's area.
struct WetPart {
    double share{0};
    std::array<double, 3> of_corners_m{};  ///< of depth times the corners' linear weights
    double of_square_m2{0};                ///< of its square
};

WetPart whole(const std::array<double, 3>& d) {
    const double sum = d[0] + d[1] + d[2];
    return {.share = 1,
            .of_corners_m = {(sum + d[0]) / 12, (sum + d[1]) / 12, (sum + d[2]) / 12},
            .of_square_m2 = (sum * sum + d[0] * d[0] + d[1] * d[1] + d[2] * d[2]) / 12};
}

/// What the water's level cuts off at one corner, above it or below.
WetPart corner_of(const std::array<double, 3>& d, std::size_t i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    const double to_j = d[i] / (d[i] - d[j]);
    const double to_k = d[i] / (d[i] - d[k]);
    WetPart part{.share = to_j * to_k, .of_square_m2 = to_j * to_k * d[i] * d[i] / 6};
    const double twelfth = part.share * d[i] / 12;
    part.of_corners_m[i] = twelfth * (4 - to_j - to_k);
    part.of_corners_m[j] = twelfth * to_j;
    part.of_corners_m[k] = twelfth * to_k;
    return part;
}

WetPart wet_part(const std::array<double, 3>& d) {
    const auto wet = std::ranges::count_if(d, [](double depth_m) { return depth_m > 0; });
    if (wet == 0) return {};
    if (wet == 3) return whole(d);
    const auto odd =
        std::ranges::find_if(d, [&](double depth_m) { return (depth_m > 0) == (wet == 1); });
    const WetPart corner = corner_of(d, static_cast<std::size_t>(odd - d.begin()));
    if (wet == 1) return corner;
    WetPart rest = whole(d);
    rest.share -= corner.share;
    rest.of_square_m2 -= corner.of_square_m2;
    for (std::size_t i = 0; i < 3; ++i) rest.of_corners_m[i] -= corner.of_corners_m[i];
    return rest;
}

}  // namespace

/// Faces are bilinear patches: the mean of their two ways to be cut in two. `visit` gets half of each triangle's area.
template <class F>
void SoftBody::for_half_triangles(const std::vector<Vec3d>& points_m, const F& visit) const {
    for (const SoftGrid::Face& face : def_.grid.faces) {
        for (std::size_t i = 0; i < 4; ++i) {
            const std::array<std::uint32_t, 3> points{
                face.points[i], face.points[(i + 1) % 4], face.points[(i + 2) % 4]};
            const Vec3d& a = points_m[points[0]];
            visit(points, glm::cross(points_m[points[1]] - a, points_m[points[2]] - a) / 4.0);
        }
    }
}

/// By the flux of x / 3.
double SoftBody::volume_of(const std::vector<Vec3d>& points_m) const {
    double three = 0;
    for_half_triangles(points_m, [&](const auto& points, const Vec3d& area_m2) {
        three += glm::dot(points_m[points[0]], area_m2);
    });
    return three / 3;
}

void SoftBody::list_parts(SurfaceParts& parts) const {
    if (!parts.triangles.empty()) return;
    parts = {.encloses = true};
    for (const SoftGrid::Face& face : def_.grid.faces) {
        parts.triangles.push_back({face.points[0], face.points[1], face.points[2]});
        parts.triangles.push_back({face.points[0], face.points[2], face.points[3]});
        for (std::size_t i = 0; i < 4; ++i) {
            // Each side is one of two faces; they run along it one this way, one that.
            const std::uint32_t from = face.points[i];
            const std::uint32_t to = face.points[(i + 1) % 4];
            if (from < to) parts.edges.push_back({from, to});
        }
    }
}

std::vector<SurfacePlace> SoftBody::places(std::uint32_t along) const {
    std::vector<SurfacePlace> places;
    std::vector<bool> has(positions_m_.size(), false);
    for (const SoftGrid::Face& face : def_.grid.faces) {
        for (const std::uint32_t point : face.points) {
            if (!has[point])
                places.push_back({.points = {point, point, point, point}, .weights = {1, 0, 0, 0}});
            has[point] = true;
        }
        for (std::uint32_t i = 0; i < (along + 1) * (along + 1); ++i) {
            const std::uint32_t row = i / (along + 1);
            const double x = static_cast<double>(i % (along + 1)) / along;
            const double y = static_cast<double>(row) / along;
            const bool is_corner = (x == 0 || x == 1) && (y == 0 || y == 1);
            if (is_corner) continue;
            places.push_back({.points = face.points,
                              .weights = {(1 - x) * (1 - y), x * (1 - y), x * y, (1 - x) * y}});
        }
    }
    return places;
}

std::array<double, 3> SoftBody::depths_m(const std::array<std::uint32_t, 3>& points) const {
    std::array<double, 3> depths{};
    for (std::size_t i = 0; i < 3; ++i)
        depths[i] = fluids_[points[i]].level_m - positions_m_[points[i]].y;
    return depths;
}

/// The pressure on its surface, exactly, and what resists the surface that goes ahead, as of rigid bodies.
void SoftBody::add_water() {
    drag_kgps_.assign(positions_m_.size(), 0);
    double waterline_m2 = 0;
    for_half_triangles(positions_m_, [&](const auto& points, const Vec3d& area_m2) {
        const WetPart wet = wet_part(depths_m(points));
        if (wet.share == 0) return;
        waterline_m2 -= wet.share * area_m2.y;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t point = points[i];
            const FluidAtPoint& water = fluids_[point];
            impulses_Ns_[point] -= area_m2 * (water.weight_Npm3 * wet.of_corners_m[i] * substep_s_);
            const double ahead =
                wet.share * glm::dot(area_m2, velocities_mps_[point] - water.flow_mps);
            drag_kgps_[point] += std::max(ahead, 0.0) * water.density_kgpm3 * water.drag / 6;
        }
    });
    resist(std::max(waterline_m2, 0.0));
}

void SoftBody::resist(double waterline_m2) {
    for (std::size_t i = 0; i < positions_m_.size(); ++i) {
        const FluidAtPoint& water = fluids_[i];
        if (!(positions_m_[i].y < water.level_m)) continue;
        const Vec3d against = velocities_mps_[i] - water.flow_mps;
        const double radiated = water.has_waves ? 0 : 2 * kRadiated * std::min(water.drag, 1.0);
        const double bobbing_ps =
            radiated * std::sqrt(water.weight_Npm3 * waterline_m2 / mass_kg());
        const double drag_ps = drag_kgps_[i] / masses_kg_[i];
        const auto lost = [this](double rate_ps) { return 1 - 1 / (1 + rate_ps * substep_s_); };
        impulses_Ns_[i] -= against * (lost(drag_ps) * masses_kg_[i]);
        impulses_Ns_[i].y -= lost(bobbing_ps) * against.y * masses_kg_[i];
    }
}

/// Of the water that its point displaces, some moves along.
double SoftBody::weight_of(std::size_t point) const {
    if (fluids_.empty()) return 1;
    const FluidAtPoint& water = fluids_[point];
    const double depth_m = water.level_m - positions_m_[point].y;
    const double under = std::clamp(depth_m / longest_side_m_ + 0.5, 0.0, 1.0);
    return 1 / (1 + kAddedShare * water.drag * under * water.density_kgpm3 / def_.density_kgpm3);
}

/// By the flux of the depth.
double SoftBody::displaced_m3() const {
    if (fluids_.empty()) return 0;
    double sum = 0;
    for_half_triangles(positions_m_, [&](const auto& points, const Vec3d& area_m2) {
        const WetPart wet = wet_part(depths_m(points));
        sum -= area_m2.y * (wet.of_corners_m[0] + wet.of_corners_m[1] + wet.of_corners_m[2]);
    });
    return std::max(sum, 0.0);
}

/// By the flux of half the depth's square.
double SoftBody::water_J() const {
    if (fluids_.empty()) return 0;
    double sum = 0;
    for_half_triangles(positions_m_, [&](const auto& points, const Vec3d& area_m2) {
        sum -= fluids_[points[0]].weight_Npm3 / 2 * area_m2.y *
               wet_part(depths_m(points)).of_square_m2;
    });
    return sum;
}

}  // namespace plumbline::physics
