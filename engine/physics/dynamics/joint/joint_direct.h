// Joints solved exactly: one sparse factorisation a sub-step (docs/PHYSICS.md).
#pragma once

#include "engine/physics/dynamics/joint/block/block_ldlt.h"
#include "engine/physics/dynamics/joint/geometric_stiffness.h"
#include "engine/physics/dynamics/joint/joint_elastic.h"
#include "engine/physics/dynamics/joint/joint_spring.h"

namespace plumbline::physics {

/// The springs of a group that are rows.
struct StiffSprings {
    std::vector<JointSpring> lines;
    std::vector<ElasticBlock> blocks;

    bool empty() const { return lines.empty() && blocks.empty(); }
};

class DirectJoints {
public:
    /// Room for the group's topology, and the factor at its start.
    void start(JointGroup& group);
    /// The factor at the rows' latest refresh.
    void factor(const JointGroup& group) { factor(group, matrix_); }
    /// Velocities that all rows allow. Rows with bounds find their step by trying.
    void solve_velocities(JointGroup& group);
    /// The same of one component.
    void solve_component(JointGroup& group, const JointComponent& component);
    /// Of the rows held now.
    const BlockLdlt& matrix() const { return matrix_; }
    /// As JointSystem::begin_motion().
    void hold_steady_changes(JointGroup& group);
    /// Half of what that took acts at the pose after the motion, where the rows point elsewhere, as RATTLE has it (Andersen
    /// 1983): else what swings would gain energy. After factor() there.
    void hold_second_half(JointGroup& group);
    bool holds_half() const { return !taken_.empty(); }
    /// Bodies that moved are put back on the joints, and to the lengths that go with the forces of
    /// unresolved springs; velocities get what that took.
    void correct_positions(JointGroup& group, StiffSprings& springs);
    /// The damping of stiff springs and their push before the motion, in view of what the joints
    /// will make of it.
    void push_springs(JointGroup& group, StiffSprings& springs, double duration_s);
    /// What contacts changed since that push, the springs take in view. Bodies have not moved.
    void adjust_springs(JointGroup& group, StiffSprings& springs);
    /// As JointWork.
    double unresolved() const { return stiffness_.unresolved(); }

private:
    void assemble(const JointGroup& group, const JointComponent& component, BlockLdlt& matrix);
    void factor(const JointGroup& group, BlockLdlt& matrix);
    void push_solution(JointGroup& group, const JointComponent& component);
    void hold_all(JointGroup& group);
    void hold_all_rigidly(JointGroup& group);
    void hold_positions(JointGroup& group);
    void hold_springs(JointGroup& group, const StiffSprings& springs);
    void release_springs(JointGroup& group, StiffSprings& springs);
    void leave_positions(JointGroup& group);
    BlockLdlt& position_matrix();
    void factor_positions(const JointGroup& group) { factor(group, position_matrix()); }
    double gather_errors(const JointGroup& group);
    void solve_all(JointGroup& group, const BlockLdlt& matrix);
    void converge(JointGroup& group);
    double step_towards(JointGroup& group, double error);
    void keep_as_residual(JointGroup& group);
    void displace(JointGroup& group, double share, bool with_velocities);
    void factor_springs(const JointGroup& group);
    void solve_springs(JointGroup& group);
    static void activate(JointGroup& group, const StiffSprings& springs);
    void push_overdamped(JointGroup& group, std::span<JointSpring> springs);
    void push_springs_only(JointGroup& group, std::span<JointSpring> springs, bool steadily);
    void push_blocks_only(JointGroup& group, std::span<ElasticBlock> blocks);

    GeometricStiffness stiffness_;
    BlockLdlt matrix_;
    BlockLdlt spring_matrix_;
    std::vector<double> floor_;          // of pivots
    std::vector<Vec3d> x_;               // right-hand sides, then impulses along the rows
    std::vector<Vec3d> step_;            // towards smaller errors, as x_
    std::vector<Vec3d> wanted_;          // speeds of the rows that are at a bound
    std::vector<Vec3d> held_;            // errors that positions are corrected to
    std::vector<BodyVelocities> taken_;  // by hold_steady_changes(), until the motion; else none
    std::vector<double> compliance_;     // of stiff springs, by node; 0: none
    std::vector<Vec3d> bias_;            // of stiff springs, by node
    bool springs_factored_{false};       // with all of them, at the rows' latest refresh
    bool holds_springs_{false};          // positions are solved with unresolved springs' rows
    bool rigid_motors_{false};           // ... while steady changes are held
};

}  // namespace plumbline::physics
