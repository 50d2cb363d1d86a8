#include "engine/physics/dynamics/joint/joint_geometry.h"

#include <algorithm>
#include <cmath>

namespace plumbline::physics {
namespace {

constexpr double kFullTurn_rad = 2.0 * glm::pi<double>();

bool has_two_anchors(JointKind kind) {
    return kind == JointKind::Distance || kind == JointKind::Spring || kind == JointKind::Elastic;
}

/// A frame whose x axis is `axis`: the shortest way there from the world's.
Quatd frame_along(const Vec3d& axis) {
    const Vec3d x{1, 0, 0};
    // Half the angle's cosine and sine are in proportion to these; at 180 degrees any way will do.
    const Quatd half{1 + glm::dot(x, axis), glm::cross(x, axis)};
    return half.w < 1e-9 ? Quatd{0, 0, 0, 1} : glm::normalize(half);
}

/// Beyond the limits by how much; 0 within, or without any.
double excess(double value, const std::optional<std::array<Real, 2>>& limits) {
    if (!limits) return 0;
    const auto low = static_cast<double>((*limits)[0]);
    const auto high = static_cast<double>((*limits)[1]);
    return std::max({0.0, low - value, value - high});
}

double angle_of(const Quatd& rotation) {
    return 2.0 * portable_atan2(glm::length(Vec3d{rotation.x, rotation.y, rotation.z}),
                                std::abs(rotation.w));
}

double cone_excess(const SolverJoint& joint, const JointSides& sides) {
    double swing = 0;
    if (joint.limits) {
        const auto [low, high] = *joint.limits;
        const auto widest = static_cast<double>(std::max(std::abs(low), std::abs(high)));
        swing = std::max(0.0, sides.angle_between_rad - widest);
    }
    return std::max(swing, excess(twist_about_x(sides.turned), joint.twist_limits));
}

}  // namespace

SolverJoint placed_joint(const JointDef& def, const MassPose& a, const MassPose& b) {
    const Vec3d anchor_a{def.anchor_a_world};
    const Vec3d anchor_b = has_two_anchors(def.kind) ? Vec3d{def.anchor_b_world} : anchor_a;
    const Quatd frame = frame_along(normalize_or(Vec3d{def.axis_world}, Vec3d{1, 0, 0}));
    const Quatd a_from_world = glm::conjugate(a.orientation);
    const Quatd b_from_world = glm::conjugate(b.orientation);
    SolverJoint joint;
    joint.kind = def.kind;
    joint.anchor_in_a = a_from_world * (anchor_a - a.position_m);
    joint.anchor_in_b = b_from_world * (anchor_b - b.position_m);
    joint.frame_in_a = glm::normalize(a_from_world * frame);
    joint.frame_in_b = glm::normalize(b_from_world * frame);
    if (def.straight) joint.frame_in_a = joint.frame_in_b = Quatd{1, 0, 0, 0};
    joint.limits = def.limits;
    joint.twist_limits = def.twist_limits;
    joint.motor = def.motor;
    joint.stiffness_Npm = def.stiffness_Npm;
    joint.damping_Nspm = def.damping_Nspm;
    joint.bend_Nmprad = def.bend_Nmprad;
    joint.damping_s = def.damping_s;
    joint.pressed_decay_per_s = def.pressed_decay_per_s;
    joint.rest_length_m =
        def.rest_length_m.value_or(static_cast<Real>(glm::distance(anchor_a, anchor_b)));
    return joint;
}

JointSides joint_sides(const SolverJoint& joint, const MassPose& a, const MassPose& b) {
    const Quatd frame_a = a.orientation * joint.frame_in_a;
    const Quatd frame_b = b.orientation * joint.frame_in_b;
    JointSides sides;
    // Subtracted before the arms are added: far from the origin the arms keep their digits.
    sides.gap_m = (a.position_m - b.position_m) +
                  (a.orientation * joint.anchor_in_a - b.orientation * joint.anchor_in_b);
    sides.axis_a = frame_a * Vec3d{1, 0, 0};
    sides.axis_b = frame_b * Vec3d{1, 0, 0};
    sides.turned = glm::conjugate(frame_b) * frame_a;
    sides.along_m = glm::dot(sides.gap_m, sides.axis_b);
    sides.across_m = glm::length(sides.gap_m - sides.along_m * sides.axis_b);
    sides.angle_between_rad = portable_atan2(glm::length(glm::cross(sides.axis_a, sides.axis_b)),
                                             glm::dot(sides.axis_a, sides.axis_b));
    return sides;
}

double twist_about_x(const Quatd& rotation) {
    return unwrapped(2.0 * portable_atan2(rotation.x, rotation.w), 0);
}

double unwrapped(double angle_rad, double near_rad) {
    return near_rad + std::remainder(angle_rad - near_rad, kFullTurn_rad);
}

JointFit joint_error(const SolverJoint& joint, const MassPose& a, const MassPose& b) {
    const JointSides sides = joint_sides(joint, a, b);
    const double gap_m = glm::length(sides.gap_m);
    switch (joint.kind) {
        case JointKind::BallAndSocket:
            return {.error_m = gap_m};
        case JointKind::Hinge: {
            const double angle = unwrapped(twist_about_x(sides.turned), joint.position);
            return {
                .error_m = std::max({gap_m, sides.angle_between_rad, excess(angle, joint.limits)}),
                .position = angle};
        }
        case JointKind::Slider:
            return {
                .error_m = std::max(
                    {sides.across_m, angle_of(sides.turned), excess(sides.along_m, joint.limits)}),
                .position = sides.along_m};
        case JointKind::Fixed:
            return {.error_m = std::max(gap_m, angle_of(sides.turned))};
        case JointKind::Cone:
            return {.error_m = std::max(gap_m, cone_excess(joint, sides)),
                    .position = sides.angle_between_rad};
        case JointKind::Distance:
            return {.error_m = joint.limits
                                   ? excess(gap_m, joint.limits)
                                   : std::abs(gap_m - static_cast<double>(joint.rest_length_m)),
                    .position = gap_m};
        case JointKind::Spring:
            return {.error_m = 0, .position = gap_m};
        case JointKind::Elastic:
            return {.error_m = joint.stiffness_Npm > 0 ? 0.0 : gap_m, .position = gap_m};
    }
    return {};
}

double stored_J(const SolverJoint& joint, const MassPose& a, const MassPose& b) {
    if (!is_elastic(joint)) return 0;
    const JointSides sides = joint_sides(joint, a, b);
    const double gap_m = glm::length(sides.gap_m);
    const bool is_line = joint.kind == JointKind::Spring;
    const double stretch_m = is_line ? gap_m - static_cast<double>(joint.rest_length_m) : gap_m;
    const double stretched_J =
        0.5 * static_cast<double>(joint.stiffness_Npm) * stretch_m * stretch_m;
    if (is_line || !(joint.bend_Nmprad > 0)) return stretched_J;
    const double turn_rad = angle_of(sides.turned);
    return stretched_J + 0.5 * static_cast<double>(joint.bend_Nmprad) * turn_rad * turn_rad;
}

}  // namespace plumbline::physics
