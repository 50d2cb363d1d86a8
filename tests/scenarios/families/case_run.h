// The settings that rows are asked at, and what is read off a run.
#pragma once

#include "engine/physics/totals.h"
#include "engine/study/scenarios/scenario.h"
#include "tests/engine/physics/test_world.h"
#include "tests/scenarios/families/rows.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace plumbline::study {

using physics::BodyDef;
using physics::BodyId;
using physics::BodyKind;
using physics::BodyState;
using physics::JointId;
using physics::JointKind;
using physics::kRounding;
using physics::WorldDef;

/// How fast the solver drives bodies apart at most.
inline constexpr double kPush_mps = 3;
inline constexpr bool kDouble = sizeof(Real) == sizeof(double);
inline constexpr Vec3d kWeightless{0, 0, 0};

inline double degrees(double radians) {
    return radians * 180 / kPi_d;
}

/// The preset that scenes get: an island has the sub-steps it asks for.
inline Setting balanced(int hz = 60) {
    return {.step_hz = hz};
}
/// Every island has as many.
inline Setting exactly(int substeps, int hz = 60) {
    return {.step_hz = hz, .substeps = substeps};
}
/// The preset and the fixed numbers of sub-steps of rows that ask for "every S".
inline std::vector<Setting> every_s(int hz = 60) {
    return {balanced(hz), exactly(1, hz), exactly(4, hz), exactly(16, hz)};
}
/// What rows call it: "balanced", "S=4".
inline std::string name_of(const Setting& setting) {
    return setting.substeps == 0 ? "balanced" : fmt::format("S={}", setting.substeps);
}

inline int steps_of(const ScenarioWorld& world, double seconds) {
    return static_cast<int>(std::lround(seconds / world.step_s()));
}
inline double top_speed_mps(const ScenarioWorld& world) {
    double top = 0;
    for (const BodyId id : world.movers) top = std::max(top, glm::length(world.velocity(id)));
    return top;
}
inline bool all_finite(const ScenarioWorld& world) {
    return std::all_of(world.movers.begin(), world.movers.end(), [&](BodyId id) {
        return is_finite(world.at(id)) && is_finite(world.velocity(id)) &&
               is_finite(world.spin(id)) && is_finite(world.turn(id));
    });
}

/// What every hard case is watched for.
struct Watch {
    double energy_gain{0};    ///< most energy above the start's, as a share of it
    double penetration_m{0};  ///< most, after settling
    double speed_mps{0};      ///< most, after settling
    bool finite{true};
};

/// Steps for `seconds` with what counts only after `settle_s`.
inline Watch watch(ScenarioWorld& world, double seconds, double settle_s) {
    Watch seen;
    const double start_J = world.energy_J();
    const int steps = steps_of(world, seconds);
    const int settled = steps_of(world, settle_s);
    for (int i = 0; i < steps; ++i) {
        world.physics.step();
        seen.energy_gain =
            std::max(seen.energy_gain, (world.energy_J() - start_J) / std::abs(start_J));
        if (i < settled) continue;
        seen.penetration_m = std::max(seen.penetration_m, max_penetration_m(world.physics));
        seen.speed_mps = std::max(seen.speed_mps, top_speed_mps(world));
    }
    seen.finite = all_finite(world);
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

}  // namespace plumbline::study
