#include "engine/physics/small_step/geometric_stiffness.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumbline::physics {
namespace {

/// Motion with a larger square of (angular frequency * sub-step) is slowed down, to the other one.
constexpr double kTooFast = 3.0;
constexpr double kSlowEnough = 2.0;
/// Smaller changes of inertia are not worth a new factor.
constexpr double kNoticeable = 1.02;

bool pulls_at_arms(NodeKind kind) {
    return kind == NodeKind::Point || kind == NodeKind::Across || kind == NodeKind::Length;
}

/// The inverse of the least mass that the body shows at the anchor.
double most_inverse_mass(const JointBody& body, const Vec3d& anchor) {
    const Vec3d& inverse = body.inverse_moments;
    return body.inverse_mass +
           glm::dot(anchor, anchor) * std::max({inverse.x, inverse.y, inverse.z});
}

/// Distances of a point from the three axes.
Vec3d distances_from_axes(const Vec3d& point) {
    const Vec3d square = point * point;
    return {std::sqrt(square.y + square.z),
            std::sqrt(square.x + square.z),
            std::sqrt(square.x + square.y)};
}

/// Not less than those, without roots.
Vec3d levers_of(const Vec3d& point) {
    const double x = std::abs(point.x);
    const double y = std::abs(point.y);
    const double z = std::abs(point.z);
    return {y + z, x + z, x + y};
}

/// The stiffness that a force at an arm gives about each axis and any direction near it: the
/// larger eigenvalue of the symmetric part of [f]x[r]x, of what is across the axis.
Vec3d stiffness_of(const Vec3d& force, const Vec3d& arm) {
    const Vec3d both = force * arm;
    const double sum = both.x + both.y + both.z;
    const Vec3d product = distances_from_axes(force) * distances_from_axes(arm);
    return 0.5 * (Vec3d{sum - both.x, sum - both.y, sum - both.z} + product);
}

}  // namespace

void GeometricStiffness::start(const JointGroup& group) {
    const std::size_t count = group.bodies.size();
    raised_ = false;
    stiffness_Nm_.assign(count, Vec3d{0, 0, 0});
    pivot_kgm2_.assign(count, 0.0);
    joints_at_.assign(count, 0);
    pulls_.clear();
    for (std::uint32_t i = 0; i < group.rows.size(); ++i) {
        const JointRows& rows = group.rows[i];
        if (!pulls_at_arms(rows.kind)) continue;
        // A slider's b feels the rows wherever a is.
        const bool anywhere = rows.kind == NodeKind::Across;
        pulls_.push_back(
            {.node = i,
             .lever_a_m = levers_of(rows.anchor_in_a),
             .lever_b_m = anywhere ? Vec3d(glm::length(rows.arm_b)) : levers_of(rows.anchor_in_b)});
        ++joints_at_[rows.a];
        ++joints_at_[rows.b];
    }
    find_pivots(group);
    limit_Nm_.assign(count, Vec3d(std::numeric_limits<double>::infinity()));
    const double per_square = 1 / (group.substep_s * group.substep_s);
    for (std::size_t i = 0; i < count; ++i) {
        const JointBody& body = group.bodies[i];
        for (int k = 0; k < 3 && body.movable; ++k) {
            if (!(body.moments[k] > 0)) continue;
            limit_Nm_[i][k] = kTooFast * per_square * (body.moments[k] + pivot_kgm2_[i]);
        }
    }
}

/// A body that hangs on one joint turns about it, not about its own centre.
void GeometricStiffness::find_pivots(const JointGroup& group) {
    for (const Pull& pull : pulls_) {
        const JointRows& rows = group.rows[pull.node];
        if (rows.kind != NodeKind::Point) continue;
        for (const bool of_b : {false, true}) {
            const std::uint32_t index = of_b ? rows.b : rows.a;
            const JointBody& body = group.bodies[index];
            const JointBody& other = group.bodies[of_b ? rows.a : rows.b];
            if (!body.movable || (other.movable && joints_at_[index] > 1)) continue;
            const Vec3d& arm = of_b ? rows.anchor_in_b : rows.anchor_in_a;
            const Vec3d& other_arm = of_b ? rows.anchor_in_a : rows.anchor_in_b;
            const double mass =
                1 / (body.inverse_mass + (other.movable ? most_inverse_mass(other, other_arm) : 0));
            pivot_kgm2_[index] = std::max(pivot_kgm2_[index], mass * glm::dot(arm, arm));
        }
    }
}

bool GeometricStiffness::is_too_fast() const {
    for (std::size_t i = 0; i < limit_Nm_.size(); ++i) {
        const Vec3d& stiffness = stiffness_Nm_[i];
        const Vec3d& limit = limit_Nm_[i];
        if (stiffness.x > limit.x || stiffness.y > limit.y || stiffness.z > limit.z) return true;
    }
    return false;
}

/// Bounds by forces and levers alone; where they are too much for some body, more exactly.
bool GeometricStiffness::find_stiffness(const JointGroup& group,
                                        std::span<const Vec3d> corrections) {
    const double per_substep = 1 / group.substep_s;
    std::ranges::fill(stiffness_Nm_, Vec3d{0, 0, 0});
    for (const Pull& pull : pulls_) {
        const JointRows& rows = group.rows[pull.node];
        const Vec3d impulse = group.impulses[pull.node] + corrections[pull.node] * per_substep;
        const double force = glm::length(impulse) * per_substep;
        stiffness_Nm_[rows.a] += pull.lever_a_m * force;
        stiffness_Nm_[rows.b] += pull.lever_b_m * force;
    }
    if (!is_too_fast()) return false;
    std::ranges::fill(stiffness_Nm_, Vec3d{0, 0, 0});
    for (const Pull& pull : pulls_) {
        const JointRows& rows = group.rows[pull.node];
        const Vec3d impulse = group.impulses[pull.node] + corrections[pull.node] * per_substep;
        const Vec3d force_on_a = rows.force_on_a(impulse) * per_substep;
        const Block3& axes_a = group.bodies[rows.a].axes;
        const Block3& axes_b = group.bodies[rows.b].axes;
        stiffness_Nm_[rows.a] +=
            stiffness_of(axes_a.transposed_times(force_on_a), axes_a.transposed_times(rows.arm_a));
        stiffness_Nm_[rows.b] +=
            stiffness_of(axes_b.transposed_times(-force_on_a), axes_b.transposed_times(rows.arm_b));
    }
    return is_too_fast();
}

double GeometricStiffness::wanted_moment(const JointGroup& group,
                                         std::size_t body,
                                         int axis) const {
    const double moment = group.bodies[body].moments[axis];
    const double stiffness = stiffness_Nm_[body][axis];
    if (!(stiffness > limit_Nm_[body][axis])) return moment;
    const double square = group.substep_s * group.substep_s;
    return std::max(moment, stiffness * square / kSlowEnough - pivot_kgm2_[body]);
}

bool GeometricStiffness::raise(JointGroup& group, std::span<const Vec3d> corrections) {
    if (!find_stiffness(group, corrections)) return false;
    bool any = false;
    for (std::size_t i = 0; i < group.bodies.size(); ++i) {
        JointBody& body = group.bodies[i];
        if (!body.movable) continue;
        Vec3d kept{1, 1, 1};
        for (int k = 0; k < 3; ++k) {
            if (!(body.moments[k] > 0)) continue;
            kept[k] = std::min(1.0, body.felt_moments[k] / wanted_moment(group, i, k));
        }
        if (std::min({kept.x, kept.y, kept.z}) * kNoticeable > 1) continue;
        any = true;
        body.set_felt_moments(body.felt_moments / kept);
        body.slow_down(kept, group.substep_s);
        body.update_inertia();
    }
    if (any) {
        for (JointRows& rows : group.rows) rows.update_responses(group.bodies);
    }
    raised_ = raised_ || any;
    return any;
}

void GeometricStiffness::lower(JointGroup& group) {
    if (!raised_) return;
    raised_ = false;
    for (std::size_t i = 0; i < group.bodies.size(); ++i) {
        JointBody& body = group.bodies[i];
        if (!body.movable || body.felt_moments == body.moments) continue;
        Vec3d felt = body.moments;
        for (int k = 0; k < 3; ++k) {
            felt[k] = std::min(body.felt_moments[k], wanted_moment(group, i, k));
        }
        body.set_felt_moments(felt);
        body.update_inertia();
        raised_ = raised_ || felt != body.moments;
    }
}

}  // namespace plumbline::physics
