#include "engine/physics/dynamics/joint/joint_group.h"

#include <algorithm>
#include <limits>

namespace plumbline::physics {
namespace {

/// Errors below it, m or rad, that a step begins with are corrected at once.
constexpr double kSmallError = 1e-5;

/// Rounds in which all bounds on a wrong step change at once; then one by one.
constexpr int kRoundsOfAll = 4;

/// Of a body about an axis through a point of it; endless where nothing moves it.
double moment_about(const JointBody& body, const Vec3d& axis, const Vec3d& arm) {
    if (!body.movable) return std::numeric_limits<double>::infinity();
    const Vec3d own = body.axes.transposed_times(axis);
    const Vec3d beside = arm - axis * glm::dot(axis, arm);
    return glm::dot(body.moments, own * own) + glm::dot(beside, beside) / body.own_inverse_mass;
}

/// What a hinge turns or a slider moves, of two bodies that the rest of the joint holds.
double driven_mass(const JointRows& row,
                   const SolverJoint& joint,
                   std::span<const JointBody> bodies) {
    const JointBody& a = bodies[row.a];
    const JointBody& b = bodies[row.b];
    if (row.kind == NodeKind::Across) return 1 / (a.own_inverse_mass + b.own_inverse_mass);
    const Vec3d axis = row.angular_b.row[2];
    return 1 / (1 / moment_about(a, axis, a.axes * joint.anchor_in_a) +
                1 / moment_about(b, axis, b.axes * joint.anchor_in_b));
}

/// Position and mass of a bound at the bodies' poses. One without a position is out of the solve.
void read_bound(JointBound& bound, JointGroup& group) {
    JointRows& row = group.rows[bound.node];
    bound.position = row.errors(group.bodies)[bound.row];
    if (!row.has_position(bound.row, group.bodies)) {
        bound.release();
        group.set_active(bound);
    }
    if (row.kind == NodeKind::Align || bound.row == 2) row.near_rad = bound.position;
    const Symmetric3 inverse = own_coupling(row, group.bodies);
    const double own = bound.row == 0 ? inverse.xx : bound.row == 1 ? inverse.yy : inverse.zz;
    bound.mass = own > 0 ? 1 / own : 0;
    if (bound.spring.by_mass)
        bound.driven = driven_mass(row, group.joints[bound.joint_index], group.bodies);
}

/// What the rows' errors are held at; nothing where they are small or bounded.
Vec3d residual_of(const JointRows& row, std::span<const JointBody> bodies) {
    Vec3d error = row.errors(bodies);
    for (int k = 0; k < 3; ++k) {
        if (!row.is_active(k) || ((row.bounded >> k) & 1) != 0) error[k] = 0;
    }
    return glm::dot(error, error) < kSmallError * kSmallError ? Vec3d{0, 0, 0} : error;
}

template <class Bound>
std::span<Bound> part_of(std::span<Bound> bounds, const JointComponent& component) {
    const auto first =
        std::ranges::lower_bound(bounds, component.first_node, {}, &JointBound::node);
    const auto last = std::ranges::lower_bound(bounds, component.last_node, {}, &JointBound::node);
    return {first, last};
}

}  // namespace

void JointGroup::start(std::span<SolverBody> island_bodies) {
    bodies.clear();
    for (const std::uint32_t index : topology->bodies) {
        JointBody& body = bodies.emplace_back(JointBody::of(island_bodies[index]));
        body.read_pose();
        body.update_inertia();
    }
    for (std::size_t i = 0; i < joints.size(); ++i) {
        if (joints[i].kind != JointKind::Elastic) continue;
        for (const std::uint32_t end : topology->sides[i]) bodies[end].of_rod = true;
    }
    island_ = island_bodies;
    find_pieces();
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
    for (JointBound& bound : bounds) {
        read_bound(bound, *this);
        bound.after_motion(substep_s);
        bound.aim(substep_s);
        bound.start_motor(rows[bound.node].speeds(bodies)[bound.row]);
        set_active(bound);
    }
    residual.clear();
    for (const JointRows& row : rows) residual.push_back(residual_of(row, bodies));
    any_residual = std::ranges::any_of(residual, [](const Vec3d& error) {
        return error != Vec3d{0, 0, 0};
    });
}

void JointGroup::refresh() {
    collect_totals();
    for (JointRows& row : rows) row.refresh(bodies);
    for (JointBound& bound : bounds) {
        read_bound(bound, *this);
        bound.after_motion(substep_s);
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
    return part_of(std::span(bounds), component);
}

std::span<const JointBound> JointGroup::bounds_of(const JointComponent& component) const {
    return part_of(std::span(bounds), component);
}

void JointGroup::push_constant_bounds(std::span<JointBound> component_bounds) {
    for (JointBound& bound : component_bounds) {
        if (bound.at_bound() || bound.impulse == bound.constant_impulse()) continue;
        Vec3d change{0, 0, 0};
        change[bound.row] = bound.constant_impulse() - bound.impulse;
        bound.impulse = bound.constant_impulse();
        rows[bound.node].push(bodies, change);
        impulses[bound.node] += change;
    }
}

bool JointGroup::pushes_steadily() {
    const auto drives = [](const JointBound& bound) { return bound.drives() || bound.is_soft(); };
    if (std::ranges::any_of(bounds, drives)) return true;
    if (std::ranges::none_of(bounds, &JointBound::at_limit)) return false;
    bool is_far = false;
    with_motion(steady_change_of, [&] {
        for (const JointBound& bound : bounds) {
            const double speed = rows[bound.node].speeds(bodies)[bound.row];
            is_far = is_far || (bound.at_limit() && std::abs(speed) > kPush_mps);
        }
    });
    return is_far;
}

void JointGroup::push_constants() {
    for (const JointBound& bound : bounds) {
        if (!bound.drives()) continue;
        Vec3d push{0, 0, 0};
        push[bound.row] = bound.constant_impulse();
        rows[bound.node].push(bodies, push);
    }
}

bool JointGroup::update_steps(std::span<JointBound> component_bounds, int round) {
    bool changed = false;
    for (JointBound& bound : component_bounds) {
        const double speed =
            bound.at_bound() ? bound.wanted_speed() : rows[bound.node].speeds(bodies)[bound.row];
        if (!bound.update_step(speed)) continue;
        set_active(bound);
        changed = true;
        if (round >= kRoundsOfAll) break;
    }
    return changed;
}

bool JointGroup::ease_pushes(std::span<JointBound> component_bounds,
                             std::span<const Vec3d> more_impulses) {
    bool eased = false;
    for (JointBound& bound : component_bounds)
        eased = bound.ease_push(more_impulses[bound.node][bound.row]) || eased;
    return eased;
}

void JointGroup::hold_rows(const BlockLdlt& factor,
                           const JointComponent& component,
                           std::span<Vec3d> x) {
    for (std::uint32_t i = component.first_node; i < component.last_node; ++i)
        x[i] = masked(-rows[i].speeds(bodies), rows[i].active);
    factor.solve(component.first_node, component.last_node, x);
    for (std::uint32_t i = component.first_node; i < component.last_node; ++i)
        rows[i].push(bodies, x[i]);
}

void JointGroup::find_pieces() {
    sides_.assign(island_.size(), Side{});
    for (std::uint32_t piece = 0; piece < topology->components.size(); ++piece) {
        const JointComponent& component = topology->components[piece];
        for (std::uint32_t i = component.first_node; i < component.last_node; ++i) {
            for (const std::uint32_t member : {topology->nodes[i].a, topology->nodes[i].b}) {
                if (bodies[member].movable)
                    sides_[topology->bodies[member]] = {.piece = piece, .member = member};
            }
        }
    }
}

void JointGroup::stop_piece(std::uint32_t piece) {
    const JointComponent& component = topology->components[piece];
    for (std::uint32_t i = component.first_node; i < component.last_node; ++i) {
        for (const std::uint32_t member : {rows[i].a, rows[i].b})
            bodies[member].velocity_mps = bodies[member].spin_radps = {0, 0, 0};
    }
}

void JointGroup::respond(const BlockLdlt& factor,
                         const ImpulseLine& pushed,
                         std::span<const ImpulseLine> lines,
                         std::span<double> changes) {
    struct End {
        std::uint32_t body;
        Side side;
        SolverBody alone;
    };
    std::array ends{End{pushed.a, sides_[pushed.a], island_[pushed.a]},
                    End{pushed.b, sides_[pushed.b], island_[pushed.b]}};
    for (End& end : ends) {
        end.alone.velocity_mps = end.alone.spin_radps = {0, 0, 0};
        if (end.side.piece != kNoPiece) stop_piece(end.side.piece);
    }
    ends[0].alone.push(pushed.direction, pushed.arm_a);
    ends[1].alone.push(-pushed.direction, pushed.arm_b);
    held_.resize(rows.size());
    for (const End& end : ends) {
        if (end.side.piece == kNoPiece) continue;
        bodies[end.side.member].velocity_mps += Vec3d(end.alone.velocity_mps);
        bodies[end.side.member].spin_radps += Vec3d(end.alone.spin_radps);
    }
    const auto hold = [&](std::uint32_t piece) {
        if (piece != kNoPiece) hold_rows(factor, topology->components[piece], held_);
    };
    hold(ends[0].side.piece);
    if (ends[1].side.piece != ends[0].side.piece) hold(ends[1].side.piece);
    const auto velocity_at = [&](std::uint32_t body, const Vec3& arm) {
        const Side& side = sides_[body];
        if (side.piece != kNoPiece) return bodies[side.member].velocity_at(Vec3d(arm));
        for (const End& end : ends) {
            if (end.body == body) return Vec3d(end.alone.velocity_at(arm));
        }
        return Vec3d{0, 0, 0};
    };
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const ImpulseLine& line = lines[i];
        changes[i] = glm::dot(velocity_at(line.a, line.arm_a) - velocity_at(line.b, line.arm_b),
                              Vec3d(line.direction));
    }
}

Vec3d JointGroup::reduced_residual(const Vec3d& residual, double substep_s) {
    const double length = glm::length(residual);
    if (length < kSmallError) return {0, 0, 0};
    return residual * std::max(0.0, 1 - (kPush_mps / length + 1) * substep_s);
}

}  // namespace plumbline::physics
