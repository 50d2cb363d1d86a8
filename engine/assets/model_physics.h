// What a glTF file says of rigid bodies: KHR_physics_rigid_bodies and KHR_implicit_shapes, and their drafts of
// 2024, in SI units and radians, with names resolved. Nodes are those of ModelData.
#pragma once

#include "engine/core/math.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace plumbline::assets {

// Shapes of KHR_implicit_shapes: sizes are full lengths, the axis is +Y.
struct ModelBox {
    Vec3d size_m{1, 1, 1};
};
struct ModelSphere {
    double radius_m{0.5};
};
/// Of a capsule the height is between the centres of its caps. A radius of a cylinder may be 0.
struct ModelRound {
    bool is_capsule{false};
    double height_m{1};
    double radius_bottom_m{0.5};
    double radius_top_m{0.5};
};
/// Triangles of one of ModelData::meshes.
struct ColliderMesh {
    std::uint32_t mesh{0};
    Mat4f collider_from_mesh{1.0F};
};
struct ModelTriangles {
    std::vector<ColliderMesh> meshes;
    bool convex_hull{false};
};
using ModelShape = std::variant<ModelBox, ModelSphere, ModelRound, ModelTriangles>;

/// How two bodies' coefficients become one: the lower of their two modes here decides.
enum class CombineMode : std::uint8_t { Average, Minimum, Maximum, Multiply };

struct PhysicsMaterial {
    std::optional<double> static_friction{};
    std::optional<double> dynamic_friction{};
    std::optional<double> restitution{};
    CombineMode friction_combine{CombineMode::Average};
    CombineMode restitution_combine{CombineMode::Average};
    std::string extras{};  ///< as ModelNode::extras
};

/// Which colliders touch each other, by names of systems.
struct ModelCollisionFilter {
    std::vector<std::string> member_of;
    std::optional<std::vector<std::string>>
        with{};  ///< of these at least one; none: all but `without`
    std::vector<std::string> without;

    /// Whether it touches what is a member of these. Both of a pair must.
    bool accepts(const std::vector<std::string>& systems) const;
};

struct ModelCollider {
    std::uint32_t node{0};
    ModelShape shape{};
    std::optional<std::uint32_t> material{};
    std::optional<std::uint32_t> filter{};
    bool is_trigger{false};
};

/// Makes a node, with all below it that have none of their own, one body.
struct ModelMotion {
    std::uint32_t node{0};
    bool is_kinematic{false};
    std::optional<double> mass_kg{};          ///< 0: infinite
    std::optional<Vec3d> inertia_kgm2{};      ///< principal; a moment of 0: infinite
    Quatd node_from_inertia{1, 0, 0, 0};      ///< unit
    std::optional<Vec3d> center_of_mass_m{};  ///< node frame
    Vec3d velocity_mps{0, 0, 0};              ///< node frame
    Vec3d angular_velocity_radps{0, 0, 0};    ///< node frame
    double gravity_factor{1};
};

/// Bounds how far the joint's two frames are apart along, or turned about, some axes of the first.
struct ModelJointLimit {
    bool is_angular{false};
    std::array<bool, 3> axes{};
    std::optional<double> min{};  ///< m or rad; none: no bound
    std::optional<double> max{};
    std::optional<double> stiffness{};  ///< N/m or N m/rad; none: the limit is hard
    double damping{0};
};
/// N s/m or N m s/rad: a drive so damped that has no stiffness keeps its speed, as motors of ours do.
inline constexpr double kHardDrive = 1e6;
struct ModelJointDrive {
    bool is_angular{false};
    std::size_t axis{0};
    bool by_mass{false};                ///< stiffness and damping are times the driven mass
    std::optional<double> max_force{};  ///< N or N m; none: any
    double position_target{0};
    double velocity_target{0};  ///< of the connected node in the joint's frame
    double stiffness{0};
    double damping{0};
};
struct ModelJoint {
    std::uint32_t node{0};
    std::uint32_t connected{0};
    std::vector<ModelJointLimit> limits;
    std::vector<ModelJointDrive> drives;
    bool collide{false};
};

struct ModelPhysics {
    std::vector<PhysicsMaterial> materials;
    std::vector<ModelCollisionFilter> filters;
    std::vector<ModelCollider> colliders;
    std::vector<ModelMotion> motions;
    std::vector<ModelJoint> joints;

    bool is_empty() const { return colliders.empty() && motions.empty() && joints.empty(); }
};

}  // namespace plumbline::assets
