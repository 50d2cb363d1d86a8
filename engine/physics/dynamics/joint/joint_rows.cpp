#include "engine/physics/dynamics/joint/joint_rows.h"

#include "engine/physics/dynamics/joint/joint_geometry.h"

#include <algorithm>

namespace plumbline::physics {
namespace {

/// Less than this between the axes of a cone's sides is none.
constexpr double kNoSwing_rad = 1e-4;
/// Beyond the swing with this cosine (172 degrees) twist means nothing and is left alone.
constexpr double kNoTwistCosine = -0.99;

double inverse_or_zero(double value) {
    return value > 0 ? 1 / value : 0;
}

/// What an impulse at the arm does to the spin, as a matrix.
Block3 spin_from_impulse(const Symmetric3& inertia, const Vec3d& arm) {
    return {{glm::cross(Vec3d{inertia.xx, inertia.xy, inertia.xz}, arm),
             glm::cross(Vec3d{inertia.xy, inertia.yy, inertia.yz}, arm),
             glm::cross(Vec3d{inertia.xz, inertia.yz, inertia.zz}, arm)}};
}

/// The inertia times the transposed matrix.
Block3 inertia_times_transposed(const Symmetric3& inertia, const Block3& m) {
    const Block3 columns = m * inertia;
    return {{Vec3d{columns.row[0].x, columns.row[1].x, columns.row[2].x},
             Vec3d{columns.row[0].y, columns.row[1].y, columns.row[2].y},
             Vec3d{columns.row[0].z, columns.row[1].z, columns.row[2].z}}};
}

/// A quaternion that is of unit length but for float32's rounding, without a root.
Quatd renormalized(const Quatd& q) {
    return q * (1.5 - 0.5 * glm::dot(q, q));
}

Block3 negated(const Block3& m) {
    return {{-m.row[0], -m.row[1], -m.row[2]}};
}

/// Rows of `m` times matrix p.
Block3 product(const Block3& m, const Block3& p) {
    return {
        {p.transposed_times(m.row[0]), p.transposed_times(m.row[1]), p.transposed_times(m.row[2])}};
}

/// The turn, as axis times angle, that takes one unit vector to another.
Vec3d turn_between(const Vec3d& from, const Vec3d& to) {
    const Vec3d sine = glm::cross(from, to);
    const double length = glm::length(sine);
    const double cosine = glm::dot(from, to);
    if (length > 1e-12) return sine * (portable_atan2(length, cosine) / length);
    if (cosine > 0) return sine;
    // Opposite: any way round.
    const Vec3d other = std::abs(from.x) < 0.5 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0};
    return glm::normalize(glm::cross(from, other)) * glm::pi<double>();
}

/// The rotation as axis times angle, the short way.
Vec3d turn_of(const Quatd& rotation) {
    const double sign = rotation.w < 0 ? -1 : 1;
    const Vec3d sine{sign * rotation.x, sign * rotation.y, sign * rotation.z};
    const double length = glm::length(sine);
    if (length < 1e-12) return 2.0 * sine;
    return sine * (2.0 * portable_atan2(length, sign * rotation.w) / length);
}

}  // namespace

JointBody JointBody::of(SolverBody& body) {
    JointBody made;
    made.body = &body;
    made.movable = body.movable();
    if (!made.movable) return made;
    made.own_inverse_mass = static_cast<double>(body.inverse_mass);
    made.inverse_mass = made.own_inverse_mass;
    made.moments = body.inertia_kgm2;
    made.set_effective_inertia(made.moments);
    made.round = body.isotropic_inertia;
    return made;
}

void JointBody::read_velocities() {
    velocity_mps = Vec3d(body->velocity_mps);
    spin_radps = Vec3d(body->spin_radps);
}

void JointBody::write_velocities() const {
    if (!movable) return;
    body->velocity_mps = Vec3(velocity_mps);
    body->spin_radps = Vec3(spin_radps);
}

void JointBody::read_pose() {
    position_m = body->start_position_m + Vec3d(body->delta_position_m);
    orientation = renormalized(Quatd(body->delta_rotation) * body->start_orientation);
    axes = rows_of(orientation);
}

void JointBody::write_pose() const {
    if (!movable) return;
    body->delta_position_m = Vec3(position_m - body->start_position_m);
    body->delta_rotation = Quat(orientation * glm::conjugate(body->start_orientation));
}

void JointBody::update_inertia() {
    if (!movable) return;
    inverse_inertia =
        round ? Symmetric3{inverse_moments.x, 0, 0, inverse_moments.x, 0, inverse_moments.x}
              : in_world(inverse_moments, axes);
    if (round && !of_rod) return;
    const auto real = [](double value) { return static_cast<Real>(value); };
    body->inverse_inertia = {real(inverse_inertia.xx),
                             real(inverse_inertia.xy),
                             real(inverse_inertia.xz),
                             real(inverse_inertia.yy),
                             real(inverse_inertia.yz),
                             real(inverse_inertia.zz)};
}

void JointBody::set_effective_inertia(const Vec3d& felt) {
    effective_inertia = felt;
    inverse_moments = {inverse_or_zero(felt.x), inverse_or_zero(felt.y), inverse_or_zero(felt.z)};
}

void JointBody::slow_down(const Vec3d& kept, double duration_s) {
    const Vec3d slower = axes * (kept * axes.transposed_times(spin_radps));
    orientation = small_turn((slower - spin_radps) * duration_s) * orientation;
    axes = rows_of(orientation);
    spin_radps = slower;
    note_momentum();
}

void JointBody::note_momentum() {
    if (!movable || round) return;
    momentum_Nms = axes * (effective_inertia * axes.transposed_times(spin_radps));
}

void JointBody::set_spin(double substep_s) {
    const Vec3d added = twisted_in_all_kgm2 / substep_s;
    twisted_in_all_kgm2 = {0, 0, 0};
    if (!movable) return;
    if (round) {
        spin_radps += inverse_moments * added;
    } else {
        spin_radps = inverse_inertia * (momentum_Nms + added);
    }
}

void JointBody::displace() {
    position_m += pushed_kgm * inverse_mass;
    orientation = small_turn(inverse_inertia * twisted_kgm2) * orientation;
    axes = rows_of(orientation);
}

JointRows JointRows::of(const JointNode& node, const SolverJoint& joint) {
    JointRows rows;
    rows.kind = node.kind;
    rows.a = node.a;
    rows.b = node.b;
    rows.anchor_in_a = joint.anchor_in_a;
    rows.anchor_in_b = joint.anchor_in_b;
    if (joint.kind == JointKind::Elastic &&
        (node.kind == NodeKind::Lock || joint.stiffness_Npm > 0))
        rows.elastic = true;
    if (node.kind == NodeKind::Point) {
        rows.active = rows.elastic ? 0 : 0b111;
        return rows;
    }
    rows.frames.turn_in_a = joint.frame_in_a;
    rows.frames.turn_in_b = joint.frame_in_b;
    const Block3 from_a = rows_of(joint.frame_in_a);
    const Block3 from_b = rows_of(joint.frame_in_b);
    rows.frames.axis_in_a = {from_a.row[0].x, from_a.row[1].x, from_a.row[2].x};
    rows.frames.axes_in_b = {{Vec3d{from_b.row[0].x, from_b.row[1].x, from_b.row[2].x},
                              Vec3d{from_b.row[0].y, from_b.row[1].y, from_b.row[2].y},
                              Vec3d{from_b.row[0].z, from_b.row[1].z, from_b.row[2].z}}};
    rows.rest_m = static_cast<double>(joint.rest_length_m);
    rows.near_rad = joint.kind == JointKind::Hinge ? joint.position : 0;
    const bool locked = node.kind == NodeKind::Lock;
    const bool across = node.kind == NodeKind::Across || node.kind == NodeKind::Align;
    rows.active = rows.elastic ? 0 : locked ? 0b111 : across ? 0b011 : 0;
    if (node.kind == NodeKind::Length && joint.kind == JointKind::Distance) rows.active = 0b001;
    if (node.kind == NodeKind::Swing && joint.limits) {
        const auto [low, high] = *joint.limits;
        const auto widest = static_cast<double>(std::max(std::abs(low), std::abs(high)));
        rows.fixed_swing = widest < kNoSwing_rad;
        if (rows.fixed_swing) rows.active = 0b011;
    }
    return rows;
}

void JointRows::refresh_others(std::span<const JointBody> bodies) {
    const JointBody& body_a = bodies[a];
    const JointBody& body_b = bodies[b];
    switch (kind) {
        case NodeKind::Across:
            refresh_across(body_a, body_b);
            break;
        case NodeKind::Length:
            refresh_length(bodies);
            break;
        case NodeKind::Align:
            refresh_align(body_a, body_b);
            break;
        case NodeKind::Lock:
            angular_b = {{Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}}};
            angular_a = negated(angular_b);
            break;
        default:
            refresh_swing(body_a, body_b);
            break;
    }
}

void JointRows::update_responses(std::span<const JointBody> bodies) {
    const Symmetric3& inertia_a = bodies[a].inverse_inertia;
    const Symmetric3& inertia_b = bodies[b].inverse_inertia;
    if (kind == NodeKind::Point) {
        response_a = spin_from_impulse(inertia_a, -arm_a);
        response_b = spin_from_impulse(inertia_b, arm_b);
        return;
    }
    response_a = inertia_times_transposed(inertia_a, angular_a);
    response_b = inertia_times_transposed(inertia_b, angular_b);
}

void JointRows::refresh_across(const JointBody& body_a, const JointBody& body_b) {
    arm_a = body_a.axes * anchor_in_a;
    // The rows turn with b, so b feels them where a's anchor is.
    arm_b = arm_a + (body_a.position_m - body_b.position_m);
    const Vec3d axis = body_b.axes * frames.axes_in_b.row[0];
    linear = {
        {body_b.axes * frames.axes_in_b.row[1], body_b.axes * frames.axes_in_b.row[2], -axis}};
    for (std::size_t i = 0; i < 3; ++i) {
        angular_a.row[i] = glm::cross(linear.row[i], arm_a);
        angular_b.row[i] = glm::cross(arm_b, linear.row[i]);
    }
}

void JointRows::refresh_length(std::span<const JointBody> bodies) {
    const JointBody& body_a = bodies[a];
    const JointBody& body_b = bodies[b];
    arm_a = body_a.axes * anchor_in_a;
    arm_b = body_b.axes * anchor_in_b;
    const Vec3d between = gap(bodies);
    length_m = glm::length(between);
    if (length_m > kNoLength_m) linear.row[0] = between / length_m;
    if (linear.row[0] == Vec3d{0, 0, 0}) linear.row[0] = body_b.axes * frames.axes_in_b.row[0];
    angular_a.row[0] = glm::cross(linear.row[0], arm_a);
    angular_b.row[0] = glm::cross(arm_b, linear.row[0]);
}

void JointRows::refresh_align(const JointBody& body_a, const JointBody& body_b) {
    const Vec3d axis =
        fixed_swing ? body_a.axes * frames.axis_in_a : body_b.axes * frames.axes_in_b.row[0];
    angular_b = {
        {body_b.axes * frames.axes_in_b.row[1], body_b.axes * frames.axes_in_b.row[2], -axis}};
    angular_a = negated(angular_b);
}

void JointRows::refresh_swing(const JointBody& body_a, const JointBody& body_b) {
    if (fixed_swing) {
        refresh_align(body_a, body_b);
        return;
    }
    const Vec3d axis_a = body_a.axes * frames.axis_in_a;
    const Vec3d axis_b = body_b.axes * frames.axes_in_b.row[0];
    const double cosine = glm::dot(axis_a, axis_b);
    // With parallel axes every direction of swing is as good; b's y axis turns with the body.
    const Vec3d swing =
        normalize_or(glm::cross(axis_b, axis_a), body_b.axes * frames.axes_in_b.row[1]);
    // The gradient of the twist left when the shortest swing is taken out.
    const Vec3d twist_axis = (axis_a + axis_b) / std::max(1 + cosine, 1 + kNoTwistCosine);
    angular_a = {{swing, Vec3d{0, 0, 0}, twist_axis}};
    angular_b = negated(angular_a);
}

Vec3d JointRows::other_errors(std::span<const JointBody> bodies) const {
    const JointBody& body_a = bodies[a];
    const JointBody& body_b = bodies[b];
    switch (kind) {
        case NodeKind::Across: {
            const Vec3d seen = frames.axes_in_b * Vec3d{body_b.axes.transposed_times(gap(bodies))};
            return {seen.y, seen.z, -seen.x};
        }
        case NodeKind::Length: {
            const double length = glm::length(gap(bodies));
            return {bounded != 0 ? length : length - rest_m, 0, 0};
        }
        case NodeKind::Align:
            return align_errors(body_a, body_b);
        case NodeKind::Lock:
            return turn_of((body_b.orientation * frames.turn_in_b) *
                           glm::conjugate(body_a.orientation * frames.turn_in_a));
        default:
            return swing_errors(body_a, body_b);
    }
}

Vec3d JointRows::align_errors(const JointBody& body_a, const JointBody& body_b) const {
    const Vec3d axis_a = body_a.axes * frames.axis_in_a;
    const Vec3d axis_b = body_b.axes * frames.axes_in_b.row[0];
    const Vec3d turn = turn_between(axis_a, axis_b);
    const Vec3d seen = frames.axes_in_b * Vec3d{body_b.axes.transposed_times(turn)};
    return {seen.y, seen.z, (bounded & 0b100) != 0 ? twist(body_a, body_b) : 0.0};
}

Vec3d JointRows::swing_errors(const JointBody& body_a, const JointBody& body_b) const {
    if (fixed_swing) return align_errors(body_a, body_b);
    const Vec3d axis_a = body_a.axes * frames.axis_in_a;
    const Vec3d axis_b = body_b.axes * frames.axes_in_b.row[0];
    const double cosine = glm::dot(axis_a, axis_b);
    const double swing = portable_atan2(glm::length(glm::cross(axis_a, axis_b)), cosine);
    return {swing, 0, (bounded & 0b100) != 0 ? twist(body_a, body_b) : 0.0};
}

bool JointRows::has_position(int row, std::span<const JointBody> bodies) const {
    if (kind != NodeKind::Swing || fixed_swing || row != 2) return true;
    return glm::dot(bodies[a].axes * frames.axis_in_a, bodies[b].axes * frames.axes_in_b.row[0]) >
           kNoTwistCosine;
}

double JointRows::twist(const JointBody& body_a, const JointBody& body_b) const {
    const Quatd turned = glm::conjugate(body_b.orientation * frames.turn_in_b) *
                         (body_a.orientation * frames.turn_in_a);
    return unwrapped(2.0 * portable_atan2(turned.x, turned.w), near_rad);
}

Vec3d JointRows::force_on_a(const Vec3d& impulse) const {
    return kind == NodeKind::Point ? -impulse : -linear.transposed_times(impulse);
}

Vec3d JointRows::torque_on_a(const Vec3d& impulse) const {
    const bool places =
        kind == NodeKind::Point || kind == NodeKind::Across || kind == NodeKind::Length;
    return places ? Vec3d{0, 0, 0} : angular_a.transposed_times(impulse);
}

Block3 coupling_of_others(const JointRows& row,
                          bool row_is_b,
                          const JointRows& column,
                          bool column_is_b,
                          double inverse_mass) {
    constexpr Block3 kUnit{{Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}}};
    const bool row_is_point = row.kind == NodeKind::Point;
    const Block3& response = column_is_b ? column.response_b : column.response_a;
    Block3 block = row_is_point ? spin_times(row_is_b ? row.arm_b : -row.arm_a, response)
                                : product(row_is_b ? row.angular_b : row.angular_a, response);
    const Block3& rows = row_is_point ? kUnit : row.linear;
    const Block3& columns = column.kind == NodeKind::Point ? kUnit : column.linear;
    const Block3 linear = times_transposed(rows, columns);
    for (std::size_t i = 0; i < 3; ++i) block.row[i] += linear.row[i] * inverse_mass;
    return block;
}

Symmetric3 own_coupling_of_others(const JointRows& rows, std::span<const JointBody> bodies) {
    const Block3 a = coupling(rows, false, rows, false, bodies[rows.a].inverse_mass);
    const Block3 b = coupling(rows, true, rows, true, bodies[rows.b].inverse_mass);
    return {a.row[0].x + b.row[0].x,
            a.row[0].y + b.row[0].y,
            a.row[0].z + b.row[0].z,
            a.row[1].y + b.row[1].y,
            a.row[1].z + b.row[1].z,
            a.row[2].z + b.row[2].z};
}

}  // namespace plumbline::physics
