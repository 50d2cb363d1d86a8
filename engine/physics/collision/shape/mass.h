// What solids of uniform density weigh: volumes, centres and inertia in closed form.
//
// Always double, whatever Real is.
#pragma once

#include "engine/core/pose.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace plumbline::physics {

using Mat3d = glm::dmat3;

/// A solid of density 1 kg/m3.
struct SolidMass {
    double volume_m3{0};
    Vec3d center_m{0, 0, 0};
    Mat3d inertia{0.0};  ///< about the centre, for a mass of volume_m3 kg
};

/// The frame in which an inertia tensor is diagonal.
struct PrincipalFrame {
    Vec3d inertia{0, 0, 0};
    Quatd orientation{1, 0, 0, 0};  ///< outer_from_principal
};

SolidMass mass_of_box(const Vec3d& size_m);
SolidMass mass_of_sphere(double radius_m);
SolidMass mass_of_cylinder(double radius_m, double height_m);
SolidMass mass_of_capsule(double radius_m, double height_m);  ///< height between cap centres
SolidMass mass_of_cone(double radius_m, double height_m);     ///< origin half-way up

/// Closed surface, counter-clockwise from outside, by signed tetrahedra.
SolidMass mass_of_triangles(std::span<const Vec3d> vertices_m,
                            std::span<const std::array<std::uint32_t, 3>> triangles);

/// The same solid seen from another frame.
SolidMass moved(const SolidMass& mass, const Vec3d& offset_m, const Quatd& rotation);
/// Both together; they must be in one frame. Overlaps count twice.
SolidMass joined(const SolidMass& a, const SolidMass& b);

/// Of principal moments: whether the box that has the same is thinner than a sixth of its width.
bool is_plate(const Vec3d& inertia);

/// Off-diagonal terms below a ten-thousandth of the largest moment count as none, so that a body
/// that is symmetric but for rounding keeps its own axes.
PrincipalFrame principal_frame(const Mat3d& inertia);

}  // namespace plumbline::physics
