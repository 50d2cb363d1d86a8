#include "engine/physics/dynamics/joint/geometric_stiffness.h"

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
/// A mass that is felt adds to the pull that asks for it: without a bound they would raise each
/// other.
constexpr double kMostMass = 10;

/// What pulls through a spring counts for so much more: between pushes of different sub-steps, its bodies swing apart sooner.
constexpr double kElasticPull = 3;

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

void GeometricStiffness::start(JointGroup& group) {
    raised_ = false;
    unresolved_ = 0;
    list_pulls(group);
    find_pivots(group);
    const double per_square = kTooFast / (group.substep_s * group.substep_s);
    for (std::size_t i = 0; i < loads_.size(); ++i) {
        const JointBody& body = group.bodies[i];
        Load& load = loads_[i];
        load.turning_limit_Nm = Vec3d(std::numeric_limits<double>::infinity());
        load.across_limit_Npm = std::numeric_limits<double>::infinity();
        if (!body.movable) continue;
        load.across_limit_Npm = per_square / body.own_inverse_mass;
        for (int k = 0; k < 3; ++k) {
            if (!(body.moments[k] > 0)) continue;
            load.turning_limit_Nm[k] = per_square * (body.moments[k] + load.pivot_kgm2);
        }
    }
    for (Pull& pull : pulls_) {
        const SolverJoint& joint = group.joints[group.topology->nodes[pull.node].joint];
        pull.force_N = {static_cast<double>(joint.mean_load[0]),
                        static_cast<double>(joint.mean_load[1]),
                        static_cast<double>(joint.mean_load[2])};
        if (group.rows[pull.node].elastic) pull.force_N *= kElasticPull;
    }
    if (!find_stiffness(group)) return;
    for (std::size_t i = 0; i < loads_.size(); ++i) {
        const bool turns = raise_moments(group, i, false);
        const bool moves = raise_mass(group, i, false);
        raised_ = raised_ || turns || moves;
    }
    for (JointRows& rows : group.rows) rows.update_responses(group.bodies);
}

void GeometricStiffness::list_pulls(const JointGroup& group) {
    loads_.assign(group.bodies.size(), Load{});
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
        ++loads_[rows.a].joints;
        ++loads_[rows.b].joints;
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
            if (!body.movable || (other.movable && loads_[index].joints > 1)) continue;
            const Vec3d& arm = of_b ? rows.anchor_in_b : rows.anchor_in_a;
            const Vec3d& other_arm = of_b ? rows.anchor_in_a : rows.anchor_in_b;
            const double mass =
                1 / (body.inverse_mass + (other.movable ? most_inverse_mass(other, other_arm) : 0));
            loads_[index].pivot_kgm2 =
                std::max(loads_[index].pivot_kgm2, mass * glm::dot(arm, arm));
        }
    }
}

bool GeometricStiffness::is_too_fast() const {
    return std::ranges::any_of(loads_, [](const Load& load) {
        return load.turning_Nm.x > load.turning_limit_Nm.x ||
               load.turning_Nm.y > load.turning_limit_Nm.y ||
               load.turning_Nm.z > load.turning_limit_Nm.z ||
               load.across_Npm > load.across_limit_Npm;
    });
}

/// Bounds by forces and levers alone; where they are too much for some body, more exactly.
bool GeometricStiffness::find_stiffness(const JointGroup& group) {
    for (Load& load : loads_) {
        load.turning_Nm = {0, 0, 0};
        load.across_Npm = 0;
    }
    for (const Pull& pull : pulls_) {
        const JointRows& rows = group.rows[pull.node];
        const double force = glm::length(pull.force_N);
        loads_[rows.a].turning_Nm += pull.lever_a_m * force;
        loads_[rows.b].turning_Nm += pull.lever_b_m * force;
        if (rows.kind != NodeKind::Length || !(rows.length_m > kNoLength_m)) continue;
        loads_[rows.a].across_Npm += force / rows.length_m;
        loads_[rows.b].across_Npm += force / rows.length_m;
    }
    if (!is_too_fast()) return false;
    for (Load& load : loads_) load.turning_Nm = {0, 0, 0};
    for (const Pull& pull : pulls_) {
        const JointRows& rows = group.rows[pull.node];
        const Block3& axes_a = group.bodies[rows.a].axes;
        const Block3& axes_b = group.bodies[rows.b].axes;
        loads_[rows.a].turning_Nm += stiffness_of(axes_a.transposed_times(-pull.force_N),
                                                  axes_a.transposed_times(rows.arm_a));
        loads_[rows.b].turning_Nm += stiffness_of(axes_b.transposed_times(pull.force_N),
                                                  axes_b.transposed_times(rows.arm_b));
    }
    return is_too_fast();
}

double GeometricStiffness::wanted_moment(const JointGroup& group,
                                         std::size_t body,
                                         int axis) const {
    const double moment = group.bodies[body].moments[axis];
    const Load& load = loads_[body];
    if (!(load.turning_Nm[axis] > load.turning_limit_Nm[axis])) return moment;
    const double square = group.substep_s * group.substep_s;
    return std::max(moment, load.turning_Nm[axis] * square / kSlowEnough - load.pivot_kgm2);
}

double GeometricStiffness::wanted_mass(const JointGroup& group, std::size_t body) const {
    const double mass = 1 / group.bodies[body].own_inverse_mass;
    const Load& load = loads_[body];
    if (!(load.across_Npm > load.across_limit_Npm)) return mass;
    const double needed = load.across_Npm * group.substep_s * group.substep_s / kSlowEnough;
    return std::clamp(needed, mass, kMostMass * mass);
}

bool GeometricStiffness::raise_moments(JointGroup& group, std::size_t index, bool slow_down) {
    JointBody& body = group.bodies[index];
    if (!body.movable) return false;
    Vec3d kept{1, 1, 1};
    for (int k = 0; k < 3; ++k) {
        if (!(body.moments[k] > 0)) continue;
        kept[k] = std::min(1.0, body.effective_inertia[k] / wanted_moment(group, index, k));
    }
    const double least = std::min({kept.x, kept.y, kept.z});
    if (least * kNoticeable > 1) return false;
    if (body.round) kept = Vec3d(least);  // it stays so: its axes are the world's
    body.set_effective_inertia(body.effective_inertia / kept);
    if (slow_down) body.slow_down(kept, group.substep_s);
    body.update_inertia();
    return true;
}

bool GeometricStiffness::raise_mass(JointGroup& group, std::size_t index, bool slow_down) {
    JointBody& body = group.bodies[index];
    if (!body.movable) return false;
    const double kept = std::min(1.0, 1 / (body.inverse_mass * wanted_mass(group, index)));
    if (kept * kNoticeable > 1) return false;
    body.inverse_mass *= kept;
    if (!slow_down) return true;
    const Vec3d change = (velocity_around(group, index) - body.velocity_mps) * (1 - kept);
    body.velocity_mps += change;
    body.position_m += change * group.substep_s;
    return true;
}

Vec3d GeometricStiffness::velocity_around(const JointGroup& group, std::size_t body) const {
    Vec3d sum{0, 0, 0};
    for (const Pull& pull : pulls_) {
        const JointRows& rows = group.rows[pull.node];
        if (rows.kind != NodeKind::Length || (rows.a != body && rows.b != body)) continue;
        const bool is_a = rows.a == body;
        const JointBody& other = group.bodies[is_a ? rows.b : rows.a];
        sum += other.velocity_at(is_a ? rows.arm_b : rows.arm_a) *
               (glm::length(pull.force_N) / rows.length_m);
    }
    return sum / loads_[body].across_Npm;
}

bool GeometricStiffness::raise(JointGroup& group, std::span<const Vec3d> corrections) {
    const double per_substep = 1 / group.substep_s;
    for (Pull& pull : pulls_) {
        Vec3d impulse = group.impulses[pull.node] + corrections[pull.node] * per_substep;
        const JointRows& rows = group.rows[pull.node];
        // The rest of a spring's push is still to come.
        if (rows.elastic) impulse *= 2 * kElasticPull;
        pull.force_N = rows.force_on_a(impulse) * -per_substep;
    }
    if (!find_stiffness(group)) return false;
    unresolved_ = std::max(unresolved_, times_too_long(loads_));
    bool any = false;
    for (std::size_t i = 0; i < loads_.size(); ++i) {
        const bool turns = raise_moments(group, i, true);
        const bool moves = raise_mass(group, i, true);
        any = any || turns || moves;
    }
    if (any) {
        for (JointRows& rows : group.rows) rows.update_responses(group.bodies);
    }
    raised_ = raised_ || any;
    return any;
}

double GeometricStiffness::times_too_long(std::span<const Load> loads) {
    double most = 0;
    for (const Load& load : loads) {
        const Vec3d turning = load.turning_Nm / load.turning_limit_Nm;
        most = std::max({most, turning.x, turning.y, turning.z});
        most = std::max(most, load.across_Npm / load.across_limit_Npm);
    }
    return std::sqrt(most);
}

void GeometricStiffness::lower(JointGroup& group) {
    if (!raised_) return;
    raised_ = false;
    for (std::size_t i = 0; i < group.bodies.size(); ++i) {
        JointBody& body = group.bodies[i];
        if (!body.movable) continue;
        body.inverse_mass = std::max(body.inverse_mass, 1 / wanted_mass(group, i));
        raised_ = raised_ || body.inverse_mass < body.own_inverse_mass;
        if (body.effective_inertia == body.moments) continue;
        Vec3d felt = body.moments;
        for (int k = 0; k < 3; ++k) {
            felt[k] = std::min(body.effective_inertia[k], wanted_moment(group, i, k));
        }
        if (body.round) felt = Vec3d(std::max({felt.x, felt.y, felt.z}));
        body.set_effective_inertia(felt);
        body.update_inertia();
        raised_ = raised_ || felt != body.moments;
    }
}

}  // namespace plumbline::physics
