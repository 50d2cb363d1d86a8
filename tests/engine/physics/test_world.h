// A physics world in a line, for tests that predict.
#pragma once

#include "engine/core/hash.h"
#include "engine/physics/physics_world.h"

#include <gtest/gtest.h>

#include <initializer_list>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace plumbline::physics {

inline constexpr Real kNan = std::numeric_limits<Real>::quiet_NaN();
inline constexpr double kG = 9.81;
inline constexpr double kPiD = std::numbers::pi;
/// What rounding of a single number of size 10 costs at Real's precision.
inline constexpr double kRounding = sizeof(Real) == sizeof(float) ? 1e-6 : 1e-14;

/// Of every bit of the bodies' states.
inline std::uint64_t state_hash(const PhysicsWorld& world, const std::vector<BodyId>& ids) {
    Hasher hasher;
    for (const BodyId id : ids) {
        const BodyState state = world.state(id);
        hasher.add(&state.world_from_body.position, sizeof(Vec3));
        hasher.add(&state.world_from_body.orientation, sizeof(Quat));
        hasher.add(&state.velocity_mps, sizeof(Vec3));
        hasher.add(&state.angular_velocity_radps, sizeof(Vec3));
    }
    return hasher.digest();
}

struct TestWorld {
    explicit TestWorld(const WorldDef& def = {}) : world(def) {}

    ShapeId shape(const ShapeDef& def) {
        auto made = world.create_shape(def);
        EXPECT_TRUE(made.ok()) << (made.ok() ? "" : made.error().message);
        return *made;
    }
    /// Top at y = 0.
    BodyId ground(Real friction = 0.5_r, Real restitution = 0) {
        return world.create_body(
            {.shape = shape(PlaneShape{}), .friction = friction, .restitution = restitution});
    }
    BodyId add(const ShapeDef& def,
               const Vec3& position,
               BodyDef body = {.kind = BodyKind::Dynamic}) {
        body.shape = shape(def);
        body.world_from_body.position = position;
        return world.create_body(body);
    }
    void run(double seconds) {
        const auto steps = static_cast<int>(seconds / world.def().step_s + 0.5);
        for (int i = 0; i < steps; ++i) world.step();
    }
    Vec3d at(BodyId id) const { return Vec3d{world.state(id).world_from_body.position}; }
    Vec3d velocity(BodyId id) const { return Vec3d{world.state(id).velocity_mps}; }
    Vec3d spin(BodyId id) const { return Vec3d{world.state(id).angular_velocity_radps}; }

    std::uint64_t hash(const std::vector<BodyId>& ids) const { return state_hash(world, ids); }

    PhysicsWorld world;
};

inline WorldDef at_hz(int hz, int substeps = 1) {
    return {.step_s = 1.0 / hz, .substeps = substeps};
}

/// Our solver with a fixed number of sub-steps.
inline WorldDef in_small_steps(int substeps = 4) {
    return {.substeps = substeps,
            .substeps_max = substeps,
            .iterations = 1,
            .solver = Solver::SmallStep};
}

inline WorldDef weightless() {
    return {.gravity_mps2 = {0, 0, 0}};
}

/// A grid of size n x n quads in the plane y = 0, cell_m apart, centred.
inline MeshShape flat_mesh(int n, Real cell_m) {
    MeshShape mesh;
    for (int z = 0; z <= n; ++z) {
        for (int x = 0; x <= n; ++x) {
            mesh.vertices_m.push_back(
                {(static_cast<Real>(x) - 0.5_r * static_cast<Real>(n)) * cell_m,
                 0,
                 (static_cast<Real>(z) - 0.5_r * static_cast<Real>(n)) * cell_m});
        }
    }
    const auto corner = [n](int x, int z) { return static_cast<std::uint32_t>(z * (n + 1) + x); };
    for (int z = 0; z < n; ++z) {
        for (int x = 0; x < n; ++x) {
            mesh.triangles.push_back({corner(x, z), corner(x, z + 1), corner(x + 1, z)});
            mesh.triangles.push_back({corner(x + 1, z), corner(x, z + 1), corner(x + 1, z + 1)});
        }
    }
    return mesh;
}

}  // namespace plumbline::physics
