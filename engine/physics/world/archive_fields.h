// The fields of the physics' plain data, for archives.
#pragma once

#include "engine/core/io/pose_archive.h"
#include "engine/physics/dynamics/body_motion.h"
#include "engine/physics/transform.h"
#include "engine/physics/world/island_sleep.h"
#include "engine/physics/world/joint_record.h"

namespace plumbline::physics {

constexpr Solver last_of(Solver) {
    return kSolvers.back();
}
constexpr JointKind last_of(JointKind) {
    return JointKind::Elastic;
}
constexpr JointMethod last_of(JointMethod) {
    return JointMethod::Iterative;
}

inline void serialize(Archive& archive, WorldDef& def) {
    archive(def.gravity_mps2,
            def.step_s,
            def.substeps,
            def.substeps_max,
            def.iterations,
            def.solver,
            def.joints,
            def.seed);
}

inline void serialize(Archive& archive, Transform& at) {
    archive(at.rotation[0], at.rotation[1], at.rotation[2], at.position_m);
}

inline void serialize(Archive& archive, BallisticState& ballistic) {
    archive(ballistic.position_m,
            ballistic.velocity_mps,
            ballistic.orientation,
            ballistic.spin_radps,
            ballistic.going);
}

inline void serialize(Archive& archive, Rest& rest) {
    archive(rest.position_m, rest.orientation, rest.stretch_s, rest.went_m, rest.slow_stretches);
}

inline void serialize(Archive& archive, ContactEvent& event) {
    archive(event.a,
            event.b,
            event.user_a,
            event.user_b,
            event.point_world,
            event.normal_world,
            event.impulse_Ns,
            event.closing_speed_mps,
            event.sliding_speed_mps,
            event.began);
}

inline void serialize(Archive& archive, JointMotor& motor) {
    archive(motor.target,
            motor.max,
            motor.stiffness,
            motor.damping,
            motor.position,
            motor.by_mass,
            motor.turn_rad);
}

inline void serialize(Archive& archive, JointDef& def) {
    archive(def.kind,
            def.a,
            def.b,
            def.anchor_a_world,
            def.anchor_b_world,
            def.axis_world,
            def.limits,
            def.twist_limits,
            def.motor,
            def.stiffness_Npm,
            def.damping_Nspm,
            def.rest_length_m,
            def.bend_Nmprad,
            def.damping_s,
            def.pressed_decay_per_s,
            def.substeps,
            def.straight,
            def.collide,
            def.break_N,
            def.user);
}

inline void serialize(Archive& archive, JointState& state) {
    archive(state.error_m, state.force_N, state.torque_Nm, state.position, state.broken);
}

inline void serialize(Archive& archive, SolverJoint& joint) {
    archive(joint.kind,
            joint.key,
            joint.anchor_in_a,
            joint.anchor_in_b,
            joint.frame_in_a,
            joint.frame_in_b,
            joint.limits,
            joint.twist_limits,
            joint.motor,
            joint.stiffness_Npm,
            joint.damping_Nspm,
            joint.rest_length_m,
            joint.bend_Nmprad,
            joint.damping_s,
            joint.pressed_decay_per_s,
            joint.bound_load,
            joint.mean_load,
            joint.elastic_speed,
            joint.total_impulse_Ns,
            joint.total_angular_impulse_Nms,
            joint.error_m,
            joint.position);
}

}  // namespace plumbline::physics
