// Which of the places where a shape is near a mesh press on it, face by face.
#pragma once

#include "engine/physics/collision/mesh/placed_mesh.h"
#include "engine/physics/collision/narrow_phase/point_choice.h"

#include <array>
#include <span>
#include <vector>

namespace plumbline::physics {

/// Points with nearly one normal.
struct PointGroup {
    static constexpr std::size_t kMost = PointChoice::kMost;

    Vec3d normal{0, 1, 0};
    std::array<MeshPoint, kMost> points{};
    std::size_t count{0};
};

/// Faces within this angle of each other, rad, press as one.
inline constexpr double kSameMeshFace_rad = 0.0175;

/// The deepest group first. Left out is what the shape would be clear of as soon as it is out of a group that
/// is less deep: the sides below an edge that it has sunk into from above.
std::vector<PointGroup> group_points(const PlacedConvex& convex,
                                     const PlacedMesh& mesh,
                                     std::span<const MeshPoint> points,
                                     std::size_t most_groups);

}  // namespace plumbline::physics
