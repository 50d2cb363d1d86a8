#include "engine/physics/dynamics/joint/joint_elastic.h"

#include <algorithm>
#include <cmath>

namespace plumbline::physics {
namespace {

/// Above this of (angular frequency * sub-step)^2 a swing is too fast to show.
constexpr double kFast = 1;
/// So much of a second's push is nearer to the end of the motion.
constexpr double kLate_per_s = 20;

/// Which no turn of the bodies changes.
double trace_of_inverse_mass(const JointRows& rows, const JointGroup& group) {
    const Symmetric3 own = own_coupling(rows, group.bodies);
    return own.xx + own.yy + own.zz;
}

Vec3d load_of(const SolverJoint& joint, std::size_t first) {
    return {static_cast<double>(joint.mean_load[first]),
            static_cast<double>(joint.mean_load[first + 1]),
            static_cast<double>(joint.mean_load[first + 2])};
}

/// The motion's speed is without half of a steady change.
void add_steady(const JointRows& rows, const Vec3d& impulse, JointGroup& group) {
    JointBody& a = group.bodies[rows.a];
    JointBody& b = group.bodies[rows.b];
    const Vec3d force = -rows.force_on_a(impulse);
    a.body->velocity_increment_mps -= Vec3(force * a.inverse_mass);
    b.body->velocity_increment_mps += Vec3(force * b.inverse_mass);
    a.body->spin_increment_radps += Vec3(rows.response_a * impulse);
    b.body->spin_increment_radps += Vec3(rows.response_b * impulse);
}

/// What is ahead is none of the motion's speed.
void set_ahead(ElasticBlock& block, const Vec3d& ahead, JointGroup& group) {
    const Vec3d more = ahead - block.ahead;
    block.ahead = ahead;
    group.rows[block.node].push(group.bodies, more);
    add_steady(group.rows[block.node], 2.0 * more, group);
}

}  // namespace

void list_elastic_blocks(JointGroup& group, std::vector<ElasticBlock>& blocks) {
    blocks.clear();
    for (std::uint32_t node = 0; node < group.rows.size(); ++node) {
        JointRows& rows = group.rows[node];
        if (!rows.is_elastic()) continue;
        const SolverJoint& joint = group.joints[group.topology->nodes[node].joint];
        const bool bends = rows.kind == NodeKind::Lock;
        ElasticBlock& block = blocks.emplace_back();
        block.node = node;
        block.stiffness = static_cast<double>(bends ? joint.bend_Nmprad : joint.stiffness_Npm);
        block.damping = block.stiffness * static_cast<double>(joint.damping_s);
        const double square = block.stiffness * group.substep_s * group.substep_s *
                              trace_of_inverse_mass(rows, group);
        if (square > kFast) block.share = std::min(1.0, 0.5 + kLate_per_s * group.substep_s);
        block.before = load_of(joint, bends ? 3 : 0) * group.substep_s;
        rows.push_share = block.share;
    }
}

void begin_push(ElasticBlock& block, const JointGroup& group) {
    block.kept = block.ahead = {0, 0, 0};
    block.extension = group.rows[block.node].errors(group.bodies);
}

BlockRow push_row(const ElasticBlock& block, double substep_s) {
    const double duration_s = block.share * substep_s;
    const double per_speed = block.stiffness * duration_s + block.damping;
    return {.bias = block.extension * (block.stiffness / per_speed),
            .compliance = 1 / (duration_s * per_speed)};
}

void push_steadily(ElasticBlock& block, const Vec3d& impulse, JointGroup& group) {
    block.kept += impulse;
    group.rows[block.node].push(group.bodies, impulse);
    const Vec3d after = block.after();
    const Vec3d before = block.before * (1 - block.share);
    const double size = glm::length(after);
    const double steady = std::min(size, glm::length(before)) - glm::length(after - before);
    set_ahead(block, steady > 0 ? after * (steady / size) : Vec3d{0, 0, 0}, group);
}

void take_back_ahead(ElasticBlock& block, JointGroup& group) {
    if (block.ahead != Vec3d{0, 0, 0}) set_ahead(block, {0, 0, 0}, group);
}

void push_rest(ElasticBlock& block, JointGroup& group) {
    const Vec3d after = block.after();
    JointRows& rows = group.rows[block.node];
    rows.refresh(group.bodies);
    rows.push(group.bodies, after);
    group.impulses[block.node] += after;
    block.before = block.kept + after;
}

void adjust_block(ElasticBlock& block, JointGroup& group) {
    const JointRows& rows = group.rows[block.node];
    const BlockRow row = push_row(block, group.substep_s);
    Symmetric3 own = own_coupling(rows, group.bodies);
    own.xx += row.compliance;
    own.yy += row.compliance;
    own.zz += row.compliance;
    Vec3d speeds{0, 0, 0};
    group.with_motion(mean_motion_of, [&] { speeds = rows.speeds(group.bodies); });
    const Vec3d wanted = -(speeds + row.bias + row.compliance * block.kept);
    const Vec3d more = factored(own, 1e-300).substitute(wanted);
    push_steadily(block, more, group);
    group.impulses[block.node] += more;
}

}  // namespace plumbline::physics
