// What the rules of a hard case may watch: one number a step of bodies, joints or the whole world.
#pragma once

#include "engine/core/pose.h"
#include "engine/physics/physics_world.h"
#include "engine/scene/state_report.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <variant>

namespace plumbline::study {

/// Where a body was when the case began.
struct BodyStart {
    Pose world_from_body{};
    Vec3d velocity_mps{0, 0, 0};
};

/// A body as a measure sees it.
struct BodyObservation {
    physics::BodyId id{};
    BodyStart start{};
    physics::BodyState now{};
    double lowest_m{0};      ///< of its origin, since the start
    double gravity_mps2{0};  ///< magnitude
    /// relative_to: that body; else the world's origin, which stands still.
    physics::BodyId other{};
    BodyStart other_start{};
    physics::BodyState other_now{};
    /// Of the latest step; filled where a rule asks for contact forces.
    std::span<const physics::ContactEvent> contacts{};
    double step_s{1.0 / 60};
};

/// What the whole world began with.
struct WorldStart {
    double energy_J{0};
    double energy_scale_J{1};  ///< what a gain of 1 means
    Vec3d momentum_kgmps{0, 0, 0};
    Vec3d angular_momentum_kgm2ps{0, 0, 0};
};

/// The whole world as a measure sees it.
struct WorldObservation {
    const physics::PhysicsWorld& world;
    const scene::Totals& totals;
    const WorldStart& start;
    double added_energy_J{0};               ///< by the case's events
    double braked_J{0};                     ///< what the energy guard has taken out so far
    std::optional<double> penetration_m{};  ///< the deepest; none: the contact points say it
    std::uint32_t removed{0};
};

using BodyMeasure = double (*)(const BodyObservation&);
using BodiesMeasure = double (*)(std::span<const BodyObservation>);  ///< of all at once
using JointMeasure = double (*)(const physics::JointState&);
using WorldMeasure = double (*)(const WorldObservation&);

struct Measure {
    std::string_view name;  ///< as scene files write it, the unit at its end
    std::variant<BodyMeasure, BodiesMeasure, JointMeasure, WorldMeasure> value;
};

std::span<const Measure> measures();
/// Null where no measure has the name.
const Measure* find_measure(std::string_view name);

}  // namespace plumbline::study
