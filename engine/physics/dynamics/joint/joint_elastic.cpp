#include "engine/physics/dynamics/joint/joint_elastic.h"

#include <algorithm>
#include <cmath>

namespace plumbline::physics {
namespace {

/// Above this of (angular frequency * sub-step)^2 a swing is too fast to show.
constexpr double kFast = 1;
/// Of a sub-step: for so long the change of its speed adds to the extension. Larger shares damp swings of a few radians a sub-step more, and
/// those of many less.
constexpr double kLate = 1.0 / 16;

/// Which no turn of the bodies changes.
double trace_of_inverse_mass(const JointRows& rows, const JointGroup& group) {
    const Symmetric3 own = own_coupling(rows, group.bodies);
    return own.xx + own.yy + own.zz;
}

Vec3d part_of(const std::array<Real, 6>& numbers, std::size_t first) {
    return {static_cast<double>(numbers[first]),
            static_cast<double>(numbers[first + 1]),
            static_cast<double>(numbers[first + 2])};
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
        if (!rows.elastic) continue;
        const SolverJoint& joint = group.joints[group.topology->nodes[node].joint];
        const bool bends = rows.kind == NodeKind::Lock;
        ElasticBlock& block = blocks.emplace_back();
        block.node = node;
        block.stiffness = static_cast<double>(bends ? joint.bend_Nmprad : joint.stiffness_Npm);
        block.damping = block.stiffness * static_cast<double>(joint.damping_s);
        const double square = block.stiffness * group.substep_s * group.substep_s *
                              trace_of_inverse_mass(rows, group);
        block.fast = square > kFast;
        const std::size_t first = bends ? 3 : 0;
        block.before = part_of(joint.mean_load, first) * group.substep_s;
        block.speed = part_of(joint.elastic_speed, first);
    }
}

void begin_push(ElasticBlock& block, const JointGroup& group) {
    block.kept = block.ahead = {0, 0, 0};
    block.extension = group.rows[block.node].errors(group.bodies);
}

BlockRow push_row(const ElasticBlock& block, double substep_s) {
    const double late_s = block.fast ? kLate * substep_s : 0;
    const double per_speed = block.stiffness * (substep_s / 2 + late_s) + block.damping;
    return {.bias = (block.extension - block.speed * late_s) * (block.stiffness / per_speed),
            .compliance = 2 / (substep_s * per_speed)};
}

void push_steadily(ElasticBlock& block, const Vec3d& impulse, JointGroup& group) {
    block.kept += impulse;
    group.rows[block.node].push(group.bodies, impulse);
    const Vec3d before = block.before / 2.0;
    const double size = glm::length(block.kept);
    const double steady = std::min(size, glm::length(before)) - glm::length(block.kept - before);
    set_ahead(block, steady > 0 ? block.kept * (steady / size) : Vec3d{0, 0, 0}, group);
}

void take_back_ahead(ElasticBlock& block, JointGroup& group) {
    if (block.ahead != Vec3d{0, 0, 0}) set_ahead(block, {0, 0, 0}, group);
}

void push_rest(ElasticBlock& block, JointGroup& group) {
    JointRows& rows = group.rows[block.node];
    const BlockRow row = push_row(block, group.substep_s);
    block.speed = -(row.bias + row.compliance * block.kept);
    rows.refresh(group.bodies);
    rows.push(group.bodies, block.kept);
    group.impulses[block.node] += block.kept;
    block.before = 2.0 * block.kept;
}

void keep_speed(const ElasticBlock& block, JointGroup& group) {
    const JointNode& node = group.topology->nodes[block.node];
    const std::size_t first = group.rows[block.node].kind == NodeKind::Lock ? 3 : 0;
    for (std::size_t k = 0; k < 3; ++k)
        group.joints[node.joint].elastic_speed[first + k] =
            static_cast<Real>(block.speed[static_cast<int>(k)]);
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
