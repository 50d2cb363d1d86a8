// The places where a convex shape is near the triangles of a mesh, triangle by triangle.
#pragma once

#include "engine/physics/collision/mesh/placed_mesh.h"
#include "engine/physics/collision/narrow_phase/contact_region.h"

#include <array>
#include <optional>
#include <vector>

namespace plumbline::physics {

/// Points on the same face within this share of the shape's size are one.
inline constexpr double kSameMeshPoint = 1e-3;
/// Points whose depths differ by less than this share of the shape's size are equally deep.
inline constexpr double kLevelMeshPoint = 2e-4;

class TriangleContacts {
public:
    /// The arguments outlive it.
    TriangleContacts(const PlacedConvex& convex, const PlacedMesh& mesh, double reach_m);

    void add(std::uint32_t triangle);
    /// Call once, after the last add().
    std::vector<MeshPoint>& points();

private:
    /// A triangle from the side on which the shape is.
    struct Side {
        std::uint32_t index{0};
        std::array<Vec3d, 3> corners{};
        Vec3d normal{0, 1, 0};
        double offset_m{0};     ///< of the plane
        bool is_behind{false};  ///< the triangle's back
        std::array<bool, 3> sticks_out{};
        std::array<bool, 3> is_seam{};
    };
    /// Of a side's corners: an edge, or a corner where both are one.
    struct Edge {
        std::size_t from{0};
        std::size_t to{0};
    };
    /// How the shape looks along a normal.
    struct Aspect {
        Vec3d normal{0, 0, 0};
        Vec3d lowest{0, 0, 0};  ///< of the core
        double lowest_m{0};     ///< of the surface, along the normal
        Feature feature;
        std::array<Vec3d, Feature::kMostCorners>
            outward;  ///< of a polygon's edges; as long as they
        std::array<double, Feature::kMostCorners>
            touching;  ///< so much outward still is on the edge
    };

    enum class Cover : std::uint8_t { None, Part, Whole };

    Side side_of(std::uint32_t triangle) const;
    void look_along(const Vec3d& normal);
    Cover cover_of(const Side& side) const;
    void add_inner(const Side& side);
    void keep_deepest(const MeshPoint& inside);
    double add_face(const Side& side);
    double add_polygon(const Side& side, double touching_m);
    double add_disc(const Side& side, double touching_m);
    void put_over(const Side& side, const Vec3d& core, MeshPoint::Kind kind);
    bool is_on_seam(const Side& side, const RegionPoint& point) const;
    void add_edge(const Side& side, std::size_t first);
    static Edge edge_along(const Side& side, const Vec3d& normal, const Vec3d& place);
    static bool sticks_out(const Side& side, const Edge& edge);
    void add_sphere(const Side& side);
    bool is_outermost(const Side& side, const Vec3d& place, const Vec3d& normal) const;
    void put(const Side& side, const Vec3d& normal, const RegionPoint& core, MeshPoint::Kind kind);
    void press_with_edge(const Side& side,
                         const Edge& edge,
                         const Vec3d& normal,
                         const RegionPoint& nearest);

    const PlacedConvex& convex_;
    const PlacedMesh& mesh_;
    double reach_m_;
    double size_m_;
    Aspect aspect_;
    std::vector<MeshPoint> points_;
    std::vector<MeshPoint> inner_;  ///< the deepest inside each face
};

}  // namespace plumbline::physics
