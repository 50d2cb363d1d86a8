// Stiff springs and elastic joints as rows of the direct solve.
#include "engine/physics/dynamics/joint/joint_direct.h"

#include <algorithm>

namespace plumbline::physics {

/// Springs whose bodies turn, and all elastic blocks, are solved at the end of the motion: their force is the one that
/// belongs to the length there, however far the bodies turned.
void DirectJoints::hold_springs(JointGroup& group, const StiffSprings& springs) {
    holds_springs_ = false;
    for (const JointSpring& spring : springs.lines) {
        if (spring.turns && spring.stiffness_Npm > 0 && !spring.overdamped) {
            group.rows[spring.node].active = 0b001;
            held_[spring.node].x = spring.extension_m - group.substep_s * bias_[spring.node].x;
            holds_springs_ = true;
        } else {
            compliance_[spring.node] = 0;
        }
    }
    for (const ElasticBlock& block : springs.blocks) {
        group.rows[block.node].active = 0b111;
        held_[block.node] = block.extension - group.substep_s * bias_[block.node];
        holds_springs_ = true;
    }
    // Else the factor is still the one that their push was found with.
    if (holds_springs_ && !(springs.lines.empty() && group.bounds.empty())) factor_positions(group);
}

void DirectJoints::release_springs(JointGroup& group, StiffSprings& springs) {
    if (!holds_springs_) return;
    holds_springs_ = false;
    for (JointSpring& spring : springs.lines) {
        if (!group.rows[spring.node].is_active(0)) continue;
        group.rows[spring.node].active = 0;
        const double target_m = spring.extension_m - group.substep_s * bias_[spring.node].x;
        spring.kept_Ns +=
            (target_m - held_[spring.node].x) / (compliance_[spring.node] * group.substep_s);
    }
    for (ElasticBlock& block : springs.blocks) {
        group.rows[block.node].active = 0;
        const Vec3d target = block.extension - group.substep_s * bias_[block.node];
        block.kept += (target - held_[block.node]) / (compliance_[block.node] * group.substep_s);
        held_[block.node] = {0, 0, 0};
    }
}

void DirectJoints::factor_springs(const JointGroup& group) {
    if (springs_factored_ && group.bounds.empty()) return;
    spring_matrix_.fit(group.topology->pattern);
    factor(group, spring_matrix_);
    springs_factored_ = true;
}

/// Leaves the springs' impulses, in view of what the joints will make of them, in x_.
void DirectJoints::solve_springs(JointGroup& group) {
    factor_springs(group);
    for (const JointBound& bound : group.bounds) {
        wanted_[bound.node][bound.row] = bound.at_bound() ? bound.wanted_speed() : 0;
    }
    for (std::size_t i = 0; i < group.rows.size(); ++i) {
        const JointRows& rows = group.rows[i];
        x_[i] = masked(wanted_[i] - bias_[i] - rows.speeds(group.bodies), rows.active);
    }
    solve_all(group, spring_matrix_);
}

/// Only what the springs themselves give: the joints' part is found once all forces are in.
void DirectJoints::push_springs_only(JointGroup& group,
                                     std::span<JointSpring> springs,
                                     bool steadily) {
    for (JointSpring& spring : springs) {
        const double impulse_Ns = group.rows[spring.node].is_active(0) ? x_[spring.node].x : 0.0;
        if (steadily) {
            SpringLine(spring).push_steadily(spring, impulse_Ns);
        } else {
            if (group.rows[spring.node].is_active(0))
                keep_as_steady(spring, impulse_Ns, group.substep_s);
            group.rows[spring.node].push(group.bodies, {impulse_Ns, 0, 0});
        }
        group.impulses[spring.node].x += impulse_Ns;
        group.rows[spring.node].active = 0;
    }
}

void DirectJoints::push_overdamped(JointGroup& group, std::span<JointSpring> springs) {
    bool any = false;
    for (JointSpring& spring : springs) {
        const SpringLine line(spring);
        spring.overdamped = is_overdamped(spring, line);
        if (!spring.overdamped) continue;
        any = true;
        const StiffRow row = overdamped_row(spring, line, group.substep_s);
        bias_[spring.node].x = row.bias_mps;
        compliance_[spring.node] = row.compliance;
        group.rows[spring.node].active = 0b001;
    }
    if (!any) return;
    springs_factored_ = false;
    solve_springs(group);
    push_springs_only(group, springs, false);
}

void DirectJoints::activate(JointGroup& group, const StiffSprings& springs) {
    for (const JointSpring& spring : springs.lines) {
        if (spring.stiffness_Npm > 0 && !spring.overdamped) group.rows[spring.node].active = 0b001;
    }
    for (const ElasticBlock& block : springs.blocks) group.rows[block.node].active = 0b111;
}

void DirectJoints::push_blocks_only(JointGroup& group, std::span<ElasticBlock> blocks) {
    for (ElasticBlock& block : blocks) {
        push_steadily(block, x_[block.node], group);
        group.impulses[block.node] += x_[block.node];
        group.rows[block.node].active = 0;
    }
}

void DirectJoints::push_springs(JointGroup& group, StiffSprings& springs, double duration_s) {
    if (springs.empty()) return;
    compliance_.assign(group.rows.size(), 0.0);
    bias_.assign(group.rows.size(), Vec3d{0, 0, 0});
    push_overdamped(group, springs.lines);
    springs_factored_ = false;
    for (JointSpring& spring : springs.lines) {
        spring.kept_Ns = spring.ahead_Ns = 0;
        if (!(spring.stiffness_Npm > 0) || spring.overdamped) continue;
        const SpringLine line(spring);
        spring.extension_m = line.length_m - spring.rest_m;
        const StiffRow row = push_row(spring, line, duration_s);
        bias_[spring.node].x = row.bias_mps;
        compliance_[spring.node] = row.compliance;
    }
    for (ElasticBlock& block : springs.blocks) {
        begin_push(block, group);
        const BlockRow row = push_row(block, group.substep_s);
        bias_[block.node] = row.bias;
        compliance_[block.node] = row.compliance;
    }
    adjust_springs(group, springs);
}

void DirectJoints::adjust_springs(JointGroup& group, StiffSprings& springs) {
    activate(group, springs);
    group.with_motion(mean_motion_of, [&] { solve_springs(group); });
    for (const JointSpring& spring : springs.lines) {
        if (!group.rows[spring.node].is_active(0)) continue;
        bias_[spring.node].x += compliance_[spring.node] * x_[spring.node].x;
    }
    for (const ElasticBlock& block : springs.blocks)
        bias_[block.node] += compliance_[block.node] * x_[block.node];
    push_springs_only(group, springs.lines, true);
    push_blocks_only(group, springs.blocks);
}

}  // namespace plumbline::physics
