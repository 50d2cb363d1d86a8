// Joints: made, driven, broken and taken away; what a step left of them.
#include "engine/physics/bullet/body.h"
#include "engine/physics/bullet/rotations.h"
#include "engine/physics/dynamics/joint/joint_geometry.h"
#include "engine/physics/fracture.h"
#include "engine/physics/world/world_state.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace plumbline::physics {
namespace {

/// Closer anchors give a distance joint no direction to push in.
constexpr double kShortest_m = 1e-3;

bool has_axis(JointKind kind) {
    return kind == JointKind::Hinge || kind == JointKind::Slider || kind == JointKind::Cone;
}
bool has_motor(JointKind kind) {
    return kind == JointKind::Hinge || kind == JointKind::Slider;
}

bool is_positive_or_zero(Real number) {
    return std::isfinite(number) && number >= 0;
}
bool is_good(const JointMotor& motor) {
    return std::isfinite(motor.target) && std::isfinite(motor.turn_rad) &&
           std::isfinite(motor.position) && is_positive_or_zero(motor.max) &&
           is_positive_or_zero(motor.stiffness) && is_positive_or_zero(motor.damping);
}

std::string fault_of_limits(const std::optional<std::array<Real, 2>>& limits,
                            std::string_view name) {
    if (!limits) return {};
    const auto [low, high] = *limits;
    if (!std::isfinite(low) || !std::isfinite(high))
        return fmt::format("{} must be finite numbers", name);
    if (low > high) return fmt::format("{} cross: {} is above {}", name, low, high);
    return {};
}

/// What is wrong with the numbers alone; empty: nothing.
std::string fault_of_numbers(const JointDef& joint) {
    if (!is_finite(joint.anchor_a_world) || !is_finite(joint.anchor_b_world))
        return "anchors must be finite";
    if (has_axis(joint.kind)) {
        if (!is_finite(joint.axis_world)) return "the axis must be finite";
        if (glm::length(Vec3d{joint.axis_world}) < 1e-6) return "the axis has no direction";
    }
    if (std::string fault = fault_of_limits(joint.limits, "limits"); !fault.empty()) return fault;
    if (std::string fault = fault_of_limits(joint.twist_limits, "twist limits"); !fault.empty())
        return fault;
    if (joint.motor && !is_good(*joint.motor))
        return "a motor needs a finite target and a maximum of 0 or more";
    if (!is_positive_or_zero(joint.stiffness_Npm) || !is_positive_or_zero(joint.damping_Nspm))
        return "stiffness and damping must be 0 or more";
    if (joint.rest_length_m && !is_positive_or_zero(*joint.rest_length_m))
        return "the rest length must be 0 or more";
    if (!is_positive_or_zero(joint.bend_Nmprad) || !is_positive_or_zero(joint.damping_s) ||
        !is_positive_or_zero(joint.pressed_decay_per_s))
        return "bending stiffness and damping must be 0 or more";
    if (!is_positive_or_zero(joint.break_N)) return "the breaking force must be 0 or more";
    if (joint.kind != JointKind::Distance) return {};
    if (joint.limits) {
        if ((*joint.limits)[0] < 0) return "a distance cannot be below 0";
        return {};
    }
    const double length_m = joint.rest_length_m ? static_cast<double>(*joint.rest_length_m)
                                                : glm::distance(Vec3d{joint.anchor_a_world},
                                                                Vec3d{joint.anchor_b_world});
    if (length_m < kShortest_m) return "the anchors are on one spot; use a ball-and-socket joint";
    return {};
}

/// Rigid transforms as the joints want them: what flies keeps double precision.
MassPose mass_pose(const BodyRecord& record) {
    if (record.motion->ballistic.going)
        return {.position_m = record.motion->ballistic.position_m,
                .orientation = record.motion->ballistic.orientation};
    const Transform at = record.motion->at;
    return {.position_m = Vec3d{at.position_m}, .orientation = double_quat_of(at.rotation)};
}

MassPose mass_pose_of_b(const JointRecord& joint) {
    return joint.b != nullptr ? mass_pose(*joint.b) : MassPose{};
}

double turn_of(const std::optional<JointMotor>& motor) {
    return motor ? static_cast<double>(motor->turn_rad) : 0.0;
}

/// Error and position at the bodies' present poses.
void measure(JointRecord& joint) {
    const JointFit fit = joint_error(joint.solver, mass_pose(*joint.a), mass_pose_of_b(joint));
    joint.solver.error_m = fit.error_m;
    joint.solver.position = fit.position;
    joint.state.error_m = fit.error_m;
    joint.state.position = static_cast<Real>(fit.position);
}

void forget_one(std::vector<const BodyRecord*>& list, const BodyRecord* body) {
    const auto found = std::find(list.begin(), list.end(), body);
    if (found != list.end()) list.erase(found);
}

bool is_moving_kinematic(const BodyRecord* record) {
    return record != nullptr && record->kind == BodyKind::Kinematic && record->in_world &&
           is_active(*record);
}

/// Ends what the joint does: it carries nothing any more and its bodies may touch.
void detach_joint(JointRecord& joint, BulletEngine& engine) {
    joint.bullet.reset();
    if (joint.b == nullptr || joint.def.collide) return;
    forget_one(joint.a->excluded, joint.b);
    forget_one(joint.b->excluded, joint.a);
    engine.admit_pair(*joint.a, *joint.b);
}

void sever(JointRecord& joint, BulletEngine& engine) {
    detach_joint(joint, engine);
    joint.state.broken = true;
}

/// Seen from another body that stands there.
void move_side(Vec3d& anchor_m, Quatd& frame, const MassPose& from, const MassPose& to) {
    const Quatd back = glm::conjugate(to.orientation);
    anchor_m = back * (from.position_m + from.orientation * anchor_m - to.position_m);
    frame = glm::normalize(back * from.orientation * frame);
}

/// Elastic joints with one mark are one rope, all of which carries about the same: it tears where it carries most.
void keep_worst_of_ropes(JointTable& joints, std::vector<JointId>& broken) {
    const auto force_N = [&joints](JointId id) { return joints.get(id)->state.force_N; };
    const auto tears_elsewhere = [&](JointId id) {
        const JointDef& def = joints.get(id)->def;
        return def.kind == JointKind::Elastic && std::ranges::any_of(broken, [&](JointId other) {
                   const JointDef& of = joints.get(other)->def;
                   if (of.kind != JointKind::Elastic || of.user != def.user) return false;
                   return force_N(other) > force_N(id) ||
                          (force_N(other) == force_N(id) && other < id);
               });
    };
    std::vector<JointId> kept;
    for (const JointId id : broken) {
        if (!tears_elsewhere(id)) kept.push_back(id);
    }
    broken = kept;
}

}  // namespace

std::string fault_of(const JointDef& joint, const BodyTable& bodies) {
    const auto* a = bodies.find(joint.a);
    if (a == nullptr) return "a is no body";
    if (joint.a == joint.b) return "a body cannot be joined to itself";
    const auto* b = bodies.find(joint.b);
    if (b == nullptr && joint.b) return "b is no body";
    if (!(*a)->in_world || (b != nullptr && !(*b)->in_world))
        return "a body was taken out of the simulation";
    if ((*a)->kind != BodyKind::Dynamic && (b == nullptr || (*b)->kind != BodyKind::Dynamic))
        return "neither body can move; at least one must be dynamic";
    return fault_of_numbers(joint);
}

void exclude_collision(JointRecord& joint) {
    if (joint.b == nullptr || joint.def.collide) return;
    joint.a->excluded.push_back(joint.b);
    joint.b->excluded.push_back(joint.a);
}

void WorldState::remove_joint(JointId id) {
    JointRecord& joint = *joints.get(id);
    wake_ends(joint);
    if (!joint.state.broken) detach_joint(joint, *engine);
    std::erase(joint.a->joints, id);
    if (joint.b != nullptr) std::erase(joint.b->joints, id);
    joints.erase(id);
}

void destroy_joint(PhysicsWorld& world, JointId id) {
    world.state_->remove_joint(id);
}

void prepare_joints(WorldState& world) {
    world.joints.each([&world](JointId, std::unique_ptr<JointRecord>& record) {
        JointRecord& joint = *record;
        if (joint.state.broken) return;
        if (is_moving_kinematic(joint.a) || is_moving_kinematic(joint.b)) world.wake_ends(joint);
        if (joint.bullet) joint.bullet->begin_step();
    });
}

void gather_joint_loads(JointTable& joints, double substep_s) {
    joints.each([substep_s](JointId, std::unique_ptr<JointRecord>& record) {
        if (record->bullet) record->bullet->gather(substep_s);
    });
}

void settle_joints(WorldState& world) {
    std::vector<JointId>& broken = world.report.broken_joints;
    world.joints.each([&broken](JointId id, std::unique_ptr<JointRecord>& record) {
        JointRecord& joint = *record;
        if (joint.state.broken) return;
        if (const auto load = joint.bullet ? joint.bullet->mean_load() : std::nullopt) {
            joint.state.force_N = static_cast<Real>(load->force_N);
            joint.state.torque_Nm = static_cast<Real>(load->torque_Nm);
            measure(joint);
        }
        if (joint.def.break_N > 0 && joint.state.force_N > joint.def.break_N) broken.push_back(id);
    });
    keep_worst_of_ropes(world.joints, broken);
    for (const JointId id : broken) {
        JointRecord& joint = *world.joints.get(id);
        world.wake_ends(joint);
        sever(joint, *world.engine);
    }
}

void unload_broken_joints(WorldState& world) {
    for (const JointId id : world.report.broken_joints) {
        if (!world.joints.contains(id)) continue;
        JointState& state = world.joints.get(id)->state;
        state.force_N = 0;
        state.torque_Nm = 0;
    }
    world.report.broken_joints.clear();
}

double elastic_energy_J(const JointTable& joints) {
    double sum_J = 0;
    joints.each([&sum_J](JointId, const std::unique_ptr<JointRecord>& record) {
        const JointRecord& joint = *record;
        if (joint.state.broken) return;
        sum_J += stored_J(joint.solver, mass_pose(*joint.a), mass_pose_of_b(joint));
    });
    return sum_J;
}

Result<JointId> PhysicsWorld::create_joint(const JointDef& joint_def) {
    const std::string fault = fault_of(joint_def, state_->bodies);
    if (!fault.empty()) return Error{fault, ExitCode::Refused};
    const JointId id = state_->joints.insert(std::make_unique<JointRecord>());
    JointRecord& joint = *state_->joints.get(id);
    joint.id = id;
    joint.def = joint_def;
    joint.a = &state_->body(joint_def.a);
    joint.b = joint_def.b ? &state_->body(joint_def.b) : nullptr;
    joint.solver = placed_joint(joint_def, mass_pose(*joint.a), mass_pose_of_b(joint));
    joint.solver.key = key_of(id);
    measure(joint);
    joint.a->joints.push_back(id);
    if (joint.b != nullptr) joint.b->joints.push_back(id);
    if (joint.b != nullptr && !joint.def.collide) {
        exclude_collision(joint);
        state_->engine->forget_pair(*joint.a, *joint.b);
    }
    if (!state_->small)
        joint.bullet = std::make_unique<BulletJoint>(joint, state_->engine->world());
    state_->wake_ends(joint);
    return id;
}

bool PhysicsWorld::contains(JointId id) const {
    return state_->joints.contains(id);
}
JointView PhysicsWorld::joint(JointId id) const {
    const JointRecord& joint = *state_->joints.get(id);
    return {.def = joint.def, .state = joint.state};
}

void PhysicsWorld::set_joint_motor(JointId id, const std::optional<JointMotor>& motor) {
    JointRecord& joint = *state_->joints.get(id);
    if (!has_motor(joint.def.kind) || (motor && !is_good(*motor))) return;
    if (joint.def.kind == JointKind::Slider) {
        const double more_rad = turn_of(motor) - turn_of(joint.def.motor);
        joint.solver.frame_in_b =
            glm::normalize(joint.solver.frame_in_b * portable_angle_axis(more_rad, Vec3d{1, 0, 0}));
    }
    joint.def.motor = motor;
    joint.solver.motor = motor;
    if (joint.bullet) joint.bullet->drive();
    state_->wake_ends(joint);
}

void cut_joint(PhysicsWorld& world, JointId id) {
    const WorldState& state = internals(world);
    JointRecord& joint = *state.joints.get(id);
    if (joint.state.broken) return;
    world.wake(joint.def.a);
    if (joint.b != nullptr) world.wake(joint.def.b);
    sever(joint, *state.engine);
    joint.state.force_N = 0;
    joint.state.torque_Nm = 0;
}

void hand_over_joints(PhysicsWorld& world,
                      BodyId from,
                      const std::function<BodyId(const Vec3& anchor_world)>& to) {
    const WorldState& state = internals(world);
    BodyRecord& old = state.body(from);
    const MassPose was = mass_pose(old);
    for (const JointId id : std::exchange(old.joints, {})) {
        JointRecord& joint = *state.joints.get(id);
        if (!joint.state.broken) detach_joint(joint, *state.engine);
        const bool is_a = joint.a == &old;
        SolverJoint& solver = joint.solver;
        Vec3d& anchor_m = is_a ? solver.anchor_in_a : solver.anchor_in_b;
        const BodyId other = to(Vec3(was.position_m + was.orientation * anchor_m));
        BodyRecord& next = state.body(other);
        move_side(anchor_m, is_a ? solver.frame_in_a : solver.frame_in_b, was, mass_pose(next));
        (is_a ? joint.a : joint.b) = &next;
        (is_a ? joint.def.a : joint.def.b) = other;
        next.joints.push_back(id);
        world.wake(joint.def.a);
        if (joint.b != nullptr) world.wake(joint.def.b);
        if (joint.state.broken) continue;
        exclude_collision(joint);
        if (joint.b != nullptr && !joint.def.collide) state.engine->forget_pair(*joint.a, *joint.b);
        if (!state.small)
            joint.bullet = std::make_unique<BulletJoint>(joint, state.engine->world());
    }
}

}  // namespace plumbline::physics
