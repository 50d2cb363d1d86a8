// Worlds for the families: the settings that rows are asked at, bodies in a line, and what is read
// off a run.
#pragma once

#include "tests/engine/physics/test_world.h"
#include "tests/scenarios/families/rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace plumbline::physics {

/// How fast the solver drives bodies apart at most.
inline constexpr double kPush_mps = 3;
inline constexpr bool kDouble = sizeof(Real) == sizeof(double);

inline Real real(double value) {
    return static_cast<Real>(value);
}
inline Vec3 vec(double x, double y, double z) {
    return {real(x), real(y), real(z)};
}
inline double degrees(double radians) {
    return radians * 180 / kPiD;
}

/// The preset that scenes get: an island has the sub-steps it asks for.
inline WorldDef balanced(int hz = 60) {
    return {.step_s = 1.0 / hz,
            .substeps = 2,
            .substeps_max = 16,
            .iterations = 1,
            .solver = Solver::SmallStep};
}
/// Every island has as many.
inline WorldDef exactly(int substeps, int hz = 60) {
    WorldDef def = balanced(hz);
    def.substeps = def.substeps_max = substeps;
    return def;
}
inline WorldDef afloat(WorldDef def) {
    def.gravity_mps2 = {0, 0, 0};
    return def;
}

/// A setting and what rows call it.
struct Setting {
    std::string name;
    WorldDef def;
};
/// The preset and the fixed numbers of sub-steps of rows that ask for "every S".
inline std::vector<Setting> every_s(int hz = 60) {
    return {{"balanced", balanced(hz)},
            {"S=1", exactly(1, hz)},
            {"S=4", exactly(4, hz)},
            {"S=16", exactly(16, hz)}};
}

/// What a body of the families is beyond its shape and place. Never sleeps unless asked to.
struct Stuff {
    double mass_kg{1};
    double friction{0.5};
    double restitution{0};
    Vec3d velocity_mps{0, 0, 0};
    Vec3d spin_radps{0, 0, 0};
    Quatd turn{1, 0, 0, 0};
    bool can_sleep{false};
};

struct Rig : TestWorld {
    using TestWorld::TestWorld;

    std::vector<BodyId> movers;  ///< dynamic bodies in the order they were added

    static BodyDef def_of(BodyKind kind, const Stuff& stuff) {
        BodyDef def;
        def.kind = kind;
        def.mass_kg = real(stuff.mass_kg);
        def.friction = real(stuff.friction);
        def.restitution = real(stuff.restitution);
        def.velocity_mps = Vec3(stuff.velocity_mps);
        def.angular_velocity_radps = Vec3(stuff.spin_radps);
        def.world_from_body.orientation = Quat(stuff.turn);
        def.can_sleep = stuff.can_sleep;
        return def;
    }
    BodyId drop(const ShapeDef& shape_def, const Vec3d& at, const Stuff& stuff = {}) {
        movers.push_back(add(shape_def, Vec3(at), def_of(BodyKind::Dynamic, stuff)));
        return movers.back();
    }
    BodyId box(const Vec3d& at, const Vec3d& size, const Stuff& stuff = {}) {
        return drop(BoxShape{.size_m = Vec3(size)}, at, stuff);
    }
    BodyId ball(const Vec3d& at, double radius, const Stuff& stuff = {}) {
        return drop(SphereShape{.radius_m = real(radius)}, at, stuff);
    }
    BodyId fixed_box(const Vec3d& at, const Vec3d& size, const Stuff& stuff = {}) {
        return add(BoxShape{.size_m = Vec3(size)}, Vec3(at), def_of(BodyKind::Static, stuff));
    }
    BodyId carrier(const Vec3d& at, const Vec3d& size, const Stuff& stuff = {}) {
        return add(BoxShape{.size_m = Vec3(size)}, Vec3(at), def_of(BodyKind::Kinematic, stuff));
    }
    /// 200 m square, top at y = 0.
    BodyId floor(double friction = 0.5, double restitution = 0) {
        return fixed_box(
            {0, -1, 0}, {200, 2, 200}, {.friction = friction, .restitution = restitution});
    }
    JointId join(const JointDef& def) {
        const Result<JointId> made = world.create_joint(def);
        EXPECT_TRUE(made.ok()) << (made.ok() ? "" : made.error().message);
        return made ? *made : JointId{};
    }

    Quatd turn(BodyId id) const { return Quatd{world.state(id).world_from_body.orientation}; }
    double energy_J() const {
        const Energy energy = world.energy();
        return energy.kinetic_J + energy.potential_J;
    }
    double top_speed_mps() const {
        double top = 0;
        for (const BodyId id : movers) top = std::max(top, glm::length(velocity(id)));
        return top;
    }
    bool all_finite() const {
        return std::all_of(movers.begin(), movers.end(), [this](BodyId id) {
            return is_finite(at(id)) && is_finite(velocity(id)) && is_finite(spin(id)) &&
                   is_finite(turn(id));
        });
    }
};

inline int steps_of(const WorldDef& def, double seconds) {
    return static_cast<int>(seconds / def.step_s + 0.5);
}

/// What every hard case is watched for.
struct Watch {
    double energy_gain{0};    ///< most energy above the start's, as a share of it
    double penetration_m{0};  ///< most, after settling
    double speed_mps{0};      ///< most, after settling
    bool finite{true};
};

/// Steps for `seconds` with what counts only after `settle_s`.
inline Watch watch(Rig& rig, double seconds, double settle_s) {
    Watch seen;
    const double start_J = rig.energy_J();
    const int steps = steps_of(rig.world.def(), seconds);
    const int settled = steps_of(rig.world.def(), settle_s);
    for (int i = 0; i < steps; ++i) {
        rig.world.step();
        seen.energy_gain =
            std::max(seen.energy_gain, (rig.energy_J() - start_J) / std::abs(start_J));
        if (i < settled) continue;
        seen.penetration_m = std::max(seen.penetration_m, rig.world.max_penetration_m());
        seen.speed_mps = std::max(seen.speed_mps, rig.top_speed_mps());
    }
    seen.finite = rig.all_finite();
    return seen;
}

/// What every hard case must pass: nothing not finite, no energy from nowhere, nothing deep.
inline void expect_sound(const std::string& row, const Watch& seen, double edge_m = 1) {
    EXPECT_TRUE(seen.finite) << row;
    expect_at_most(row + " energy gain", seen.energy_gain, 0.01);
    expect_at_most(row + " penetration m", seen.penetration_m, 0.02 * edge_m);
}

/// Where a body is against where it was, across the vertical.
inline double drift_m(const Vec3d& now, const Vec3d& then) {
    return std::hypot(now.x - then.x, now.z - then.z);
}

}  // namespace plumbline::physics
