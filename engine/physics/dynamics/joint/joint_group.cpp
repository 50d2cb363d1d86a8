#include "engine/physics/dynamics/joint/joint_group.h"

#include <algorithm>

namespace plumbline::physics {
namespace {

/// Errors below it, m or rad, that a step begins with are corrected at once.
constexpr double kSmallError = 1e-5;
/// Larger ones are come back from at this speed plus their own size per second: from 5 m within a

}  // namespace

void JointGroup::start(std::span<SolverBody> island_bodies) {
    bodies.clear();
    for (const std::uint32_t index : topology->bodies) {
        JointBody& body = bodies.emplace_back(JointBody::of(island_bodies[index]));
        body.read_pose();
        body.update_inertia();
    }
    rows.clear();
    bounds.clear();
    for (std::uint32_t i = 0; i < topology->nodes.size(); ++i) {
        const JointNode& node = topology->nodes[i];
        const SolverJoint& joint = joints[node.joint];
        rows.push_back(JointRows::of(node, joint));
        add_bounds(i, node, joint, substep_s, rows.back(), bounds);
    }
    impulses.assign(rows.size(), Vec3d{0, 0, 0});
    totals.assign(joints.size(), JointTotal{});
    for (JointRows& row : rows) row.refresh(bodies);
    read_bounds();
    for (const JointBound& bound : bounds) set_active(bound);
    find_residual();
}

void JointGroup::refresh() {
    collect_totals();
    for (JointRows& row : rows) row.refresh(bodies);
    read_bounds();
    for (JointBound& bound : bounds) bound.after_motion(substep_s);
}

void JointGroup::read_bounds() {
    for (JointBound& bound : bounds) {
        JointRows& row = rows[bound.node];
        bound.position = row.errors(bodies)[bound.row];
        if (!row.has_position(bound.row, bodies)) {
            bound.let_go();
            set_active(bound);
        }
        if (row.kind == NodeKind::Align || bound.row == 2) row.near_rad = bound.position;
        const Symmetric3 inverse = own_coupling(row, bodies);
        const double own = bound.row == 0 ? inverse.xx : bound.row == 1 ? inverse.yy : inverse.zz;
        bound.mass = own > 0 ? 1 / own : 0;
    }
}

void JointGroup::find_residual() {
    residual.assign(rows.size(), Vec3d{0, 0, 0});
    any_residual = false;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        Vec3d error = rows[i].errors(bodies);
        for (int k = 0; k < 3; ++k) {
            if (!rows[i].is_active(k) || ((rows[i].bounded >> k) & 1) != 0) error[k] = 0;
        }
        if (glm::dot(error, error) < kSmallError * kSmallError) continue;
        residual[i] = error;
        any_residual = true;
    }
}

void JointGroup::collect_totals() {
    for (std::size_t i = 0; i < rows.size(); ++i) {
        JointTotal& total = totals[topology->nodes[i].joint];
        total.impulse_Ns += rows[i].force_on_a(impulses[i]);
        total.angular_impulse_Nms += rows[i].torque_on_a(impulses[i]);
        impulses[i] = {0, 0, 0};
    }
}

void JointGroup::set_active(const JointBound& bound) {
    std::uint8_t& active = rows[bound.node].active;
    const unsigned bit = 1U << bound.row;
    active = static_cast<std::uint8_t>(bound.at_bound() ? active | bit : active & ~bit);
}

std::span<JointBound> JointGroup::bounds_of(const JointComponent& component) {
    const auto first =
        std::ranges::lower_bound(bounds, component.first_node, {}, &JointBound::node);
    const auto last = std::ranges::lower_bound(bounds, component.last_node, {}, &JointBound::node);
    return {first, last};
}

Vec3d JointGroup::come_back(const Vec3d& residual, double substep_s) {
    const double length = glm::length(residual);
    if (length < kSmallError) return {0, 0, 0};
    return residual * std::max(0.0, 1 - (kPush_mps / length + 1) * substep_s);
}

}  // namespace plumbline::physics
