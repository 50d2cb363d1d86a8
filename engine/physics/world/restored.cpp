#include "engine/physics/world/restored.h"

#include "engine/physics/world/world_state.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumbline::physics {
namespace {

// A body is taken out at kMaxDistance_m and limited to kMaxSpeed_mps once a step; between that, and of
// kinematic bodies, numbers may be larger. Those beyond these overflow what is computed from them.
constexpr double kFarthest_m = 1e8;
constexpr double kFastest_mps = 1e9;
constexpr double kLargest = 1e15;  // forces, torques, loads
constexpr double kSlack = 1e-2;    // of unit lengths and right angles

bool is_below(const auto& v, double most) {
    return glm::length(Vec3d{v}) <= most;
}

bool is_unit(const Quatd& q) {
    return std::abs(glm::length(q) - 1) <= kSlack;
}

bool is_placed(const Transform& at) {
    for (int i = 0; i < 3; ++i) {
        const Vec3d axis{at.rotation[i]};
        const Vec3d next{at.rotation[(i + 1) % 3]};
        if (std::abs(glm::length(axis) - 1) > kSlack || std::abs(glm::dot(axis, next)) > kSlack)
            return false;
    }
    return is_below(at.position_m, kFarthest_m);
}

bool moves_possibly(const Vec3& velocity_mps, const Vec3& spin_radps) {
    return is_below(velocity_mps, kFastest_mps) && is_below(spin_radps, kFastest_mps);
}

bool is_possible(const BodyMotion& motion) {
    const BallisticState& flight = motion.ballistic;
    return is_placed(motion.at) && moves_possibly(motion.velocity_mps, motion.spin_radps) &&
           is_below(flight.position_m, kFarthest_m) && is_unit(flight.orientation) &&
           is_below(flight.velocity_mps, kFastest_mps) && is_below(flight.spin_radps, kFastest_mps);
}

/// The joints that hold a body, each once.
bool lists_its_joints(const BodyRecord& record, const JointTable& joints) {
    std::vector<JointId> ids = record.joints;
    std::ranges::sort(ids);
    return std::ranges::adjacent_find(ids) == ids.end() &&
           std::ranges::all_of(ids, [&](JointId id) {
               const auto* found = joints.find(id);
               return found != nullptr && ((*found)->a == &record || (*found)->b == &record);
           });
}

std::string_view fault_of(const BodyRecord& record, const JointTable& joints) {
    if (record.frozen && record.kind != BodyKind::Dynamic) return "what cannot move is frozen";
    if (!is_possible(*record.motion)) return "it moves as nothing can";
    if (!is_placed(record.before.at) ||
        !moves_possibly(record.before.velocity_mps, record.before.spin_radps))
        return "it moved as nothing can";
    if (record.drive.has_target && !is_placed(record.drive.target)) return "it is led nowhere";
    if (!is_below(record.applied.force_N, kLargest) ||
        !is_below(record.applied.torque_Nm, kLargest))
        return "its forces are too large";
    if (record.small.rest.slow_stretches < 0) return "it rested less than not at all";
    if (!lists_its_joints(record, joints)) return "its joints are not those that hold it";
    return {};
}

bool is_possible(const SolverJoint& joint) {
    const auto is_small = [](Real load) { return std::abs(load) <= static_cast<Real>(kLargest); };
    return is_below(joint.anchor_in_a, kFarthest_m) && is_below(joint.anchor_in_b, kFarthest_m) &&
           is_unit(joint.frame_in_a) && is_unit(joint.frame_in_b) && joint.stiffness_Npm >= 0 &&
           joint.damping_Nspm >= 0 && joint.rest_length_m >= 0 &&
           (!joint.limits || (*joint.limits)[0] <= (*joint.limits)[1]) &&
           (!joint.twist_limits || (*joint.twist_limits)[0] <= (*joint.twist_limits)[1]) &&
           (!joint.motor || joint.motor->max >= 0) &&
           std::ranges::all_of(joint.bound_load, is_small) &&
           std::ranges::all_of(joint.mean_load, is_small) &&
           std::ranges::all_of(joint.elastic_speed, is_small);
}

std::string fault_of(JointId id, const JointRecord& joint, const BodyTable& bodies) {
    if (std::string fault = fault_of(joint.def, bodies); !fault.empty()) return fault;
    if (joint.solver.kind != joint.def.kind || joint.solver.key != key_of(id))
        return "it is solved as another";
    if (!is_possible(joint.solver)) return "its numbers are out of range";
    for (const BodyRecord* end : {joint.a, joint.b}) {
        if (end != nullptr && !std::ranges::count(end->joints, id))
            return "its bodies do not list it";
    }
    return {};
}

}  // namespace

std::string fault_of_restored(const WorldState& world) {
    std::string found;
    world.bodies.each([&](BodyId id, const std::unique_ptr<BodyRecord>& record) {
        const std::string_view fault = fault_of(*record, world.joints);
        if (found.empty() && !fault.empty()) found = fmt::format("body {}: {}", id.index, fault);
    });
    world.joints.each([&](JointId id, const std::unique_ptr<JointRecord>& joint) {
        if (!found.empty()) return;
        if (const std::string fault = fault_of(id, *joint, world.bodies); !fault.empty())
            found = fmt::format("joint {}: {}", id.index, fault);
    });
    return found;
}

}  // namespace plumbline::physics
