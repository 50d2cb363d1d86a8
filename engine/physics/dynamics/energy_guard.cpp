#include "engine/physics/dynamics/energy_guard.h"

#include "engine/physics/dynamics/joint/joint_geometry.h"

#include <algorithm>
#include <cmath>

namespace plumbline::physics {
namespace {

/// What a step of contacts may err by, and one of joints, whose energy swings and comes back.
constexpr double kContactShare = 1e-3;
constexpr double kJointShare = 0.05;
/// What a step of joints alone may err by where nothing takes energy.
constexpr double kConservedShare = 1e-4;
/// Joints whose rows change faster, m/s or rad/s, were hit: what that costs is not given back.
constexpr double kFits_mps = 1e-3;
/// No step gives back more than so many times what it left.
constexpr double kMostGivenBack = 4;
/// Speeds that resting contacts show anyway, m/s, beside one sub-step's fall.
constexpr double kRestless_mps = 2e-3;
/// Of its speed, that sums of float32 may change a common centre's by.
constexpr double kRoundingShare = 1e-4;

bool moves_by_itself(const SolverBody& body) {
    return !body.movable() && (glm::dot(body.velocity_mps, body.velocity_mps) > 0 ||
                               glm::dot(body.spin_radps, body.spin_radps) > 0);
}

Vec3d center_velocity_mps(std::span<const SolverBody> bodies) {
    Vec3d momentum{0, 0, 0};
    double mass = 0;
    for (const SolverBody& body : bodies) {
        if (!body.movable()) continue;
        mass += body.mass_kg();
        momentum += body.mass_kg() * Vec3d(body.velocity_mps);
    }
    return mass > 0 ? momentum / mass : momentum;
}

double elastic_J(std::span<const SolverBody> bodies, std::span<const SolverJoint> joints) {
    const auto pose_of = [&bodies](std::uint32_t index) {
        const SolverBody& body = bodies[index];
        return MassPose{.position_m = body.start_position_m + Vec3d(body.delta_position_m),
                        .orientation = Quatd(body.delta_rotation) * body.start_orientation};
    };
    double sum = 0;
    for (const SolverJoint& joint : joints) {
        if (is_elastic(joint)) sum += stored_J(joint, pose_of(joint.a), pose_of(joint.b));
    }
    return sum;
}

/// What joints changed the velocity of the common centre by, m/s; bodies that are damped change it
/// too, and are taken not to.
Vec3d center_error_mps(std::span<const SolverBody> bodies,
                       const Vec3d& start_mps,
                       const Vec3d& end_mps,
                       const Vec3d& by_fields_Ns,
                       double step_s) {
    Vec3d momentum = by_fields_Ns;
    double mass = 0;
    for (const SolverBody& body : bodies) {
        if (!body.movable()) continue;
        if (body.linear_damping_factor != 1) return {0, 0, 0};
        mass += body.mass_kg();
        momentum += body.mass_kg() * Vec3d(body.acceleration_mps2) * step_s;
    }
    const Vec3d error = end_mps - (start_mps + momentum / mass);
    const double rounding_mps = kRestless_mps + kRoundingShare * glm::length(end_mps);
    return glm::length(error) > rounding_mps ? error : Vec3d{0, 0, 0};
}

/// Of gravity and the callers' forces on the way made, relative to the centre's.
double work_J(std::span<const SolverBody> bodies, double step_s) {
    double sum = 0;
    for (const SolverBody& body : bodies) {
        if (!body.movable()) continue;
        sum +=
            body.mass_kg() * glm::dot(Vec3d(body.acceleration_mps2), Vec3d(body.delta_position_m));
        if (body.angular_acceleration_radps2 == Vec3{0, 0, 0}) continue;
        // At most: the torque all along the fastest turn.
        const double most =
            std::max({body.inertia_kgm2.x, body.inertia_kgm2.y, body.inertia_kgm2.z});
        sum += most *
               static_cast<double>(glm::length(body.angular_acceleration_radps2) *
                                   glm::length(body.spin_radps)) *
               step_s;
    }
    return sum;
}

void scale_energy(std::span<SolverBody> bodies, const Vec3d& center_mps, double share) {
    const Vec3 center(center_mps);
    const auto kept = static_cast<Real>(std::sqrt(share));
    for (SolverBody& body : bodies) {
        if (!body.movable()) continue;
        body.velocity_mps = center + (body.velocity_mps - center) * kept;
        body.spin_radps *= kept;
    }
}

/// None has come farther than at the speeds that it may have had.
void bound_ways(std::span<SolverBody> bodies,
                const Vec3d& center_mps,
                double allowed_J,
                double step_s) {
    for (SolverBody& body : bodies) {
        if (!body.movable()) continue;
        const double most_mps = static_cast<double>(body.start_speed_mps) +
                                std::sqrt(2 * allowed_J / body.mass_kg()) + glm::length(center_mps);
        const auto most_m = static_cast<Real>(most_mps * step_s);
        const Real length_m = glm::length(body.delta_position_m);
        if (length_m > most_m) body.delta_position_m *= most_m / length_m;
    }
}

/// Joints without limits and springs between bodies without damping.
bool keep_energy(std::span<const SolverBody> bodies, std::span<const SolverJoint> joints) {
    const auto is_ideal = [](const SolverJoint& joint) {
        return !is_elastic(joint) && !joint.limits && !joint.twist_limits;
    };
    const auto is_undamped = [](const SolverBody& body) {
        return body.linear_damping_factor == 1 && body.angular_damping_factor == 1 &&
               body.angular_acceleration_radps2 == Vec3{0, 0, 0};
    };
    return std::ranges::all_of(joints, is_ideal) && std::ranges::all_of(bodies, is_undamped);
}

}  // namespace

void EnergyGuard::begin(std::span<const SolverBody> bodies,
                        std::span<const ContactConstraint> contacts,
                        std::span<const SolverJoint> joints,
                        double joint_speed,
                        Real h) {
    watches_ = false;
    grounded_ = false;
    if (contacts.empty() && joints.empty()) return;
    for (const ContactConstraint& constraint : contacts) {
        if (constraint.belt != 0 || moves_by_itself(bodies[constraint.b])) return;
        grounded_ = grounded_ || !bodies[constraint.b].movable();
    }
    for (const SolverJoint& joint : joints) {
        if (joint.motor) return;
        if (moves_by_itself(bodies[joint.a]) || moves_by_itself(bodies[joint.b])) return;
        grounded_ = grounded_ || !bodies[joint.a].movable() || !bodies[joint.b].movable();
    }
    watches_ = true;
    joined_ = !joints.empty();
    conserves_ =
        grounded_ && contacts.empty() && joint_speed < kFits_mps && keep_energy(bodies, joints);
    share_ = joints.empty() ? kContactShare : kJointShare;
    center_mps_ = grounded_ ? Vec3d{0, 0, 0} : center_velocity_mps(bodies);
    start_J_ = kinetic_J(bodies, center_mps_);
    elastic_J_ = elastic_J(bodies, joints);
    slack_J_ = 0;
    for (const SolverBody& body : bodies) {
        if (!body.movable()) continue;
        const double speed =
            kRestless_mps + static_cast<double>(glm::length(body.acceleration_mps2) * h);
        slack_J_ += 0.5 * body.mass_kg() * speed * speed;
    }
}

double EnergyGuard::end(std::span<SolverBody> bodies,
                        std::span<const SolverJoint> joints,
                        const FieldWork& fields,
                        double step_s) const {
    if (!watches_) return 0;
    Vec3d center_mps = grounded_ ? Vec3d{0, 0, 0} : center_velocity_mps(bodies);
    if (joined_ && !grounded_) {
        const Vec3d error_mps =
            center_error_mps(bodies, center_mps_, center_mps, fields.impulse_Ns, step_s);
        center_mps -= error_mps;
        for (SolverBody& body : bodies) {
            if (body.movable()) body.velocity_mps -= Vec3(error_mps);
        }
    }
    const double now_J = kinetic_J(bodies, center_mps);
    const double forces_J = work_J(bodies, step_s) + fields.work_J;
    const double work = grounded_ ? forces_J : std::abs(forces_J);
    const double from_springs_J = elastic_J_ > 0 ? elastic_J_ - elastic_J(bodies, joints) : 0;
    const double allowed_J = start_J_ * (1 + share_) + std::max(work, 0.0) + slack_J_ +
                             std::max(from_springs_J, 0.0) + share_ * elastic_J_;
    // Not finite: the check of single bodies isolates them.
    if (!(now_J > 0) || !std::isfinite(now_J)) return 0;
    const bool too_much = now_J > allowed_J;
    const double exact_J = std::max(start_J_ + work, 0.0);
    if (conserves_ && fields.work_J == 0 &&
        std::abs(now_J - exact_J) > kConservedShare * start_J_ + slack_J_) {
        scale_energy(bodies, center_mps, std::min(exact_J / now_J, kMostGivenBack));
    } else if (too_much) {
        scale_energy(bodies, center_mps, allowed_J / now_J);
    }
    // Joints bring back what was torn away, however far.
    if (too_much && !joined_) bound_ways(bodies, center_mps, allowed_J, step_s);
    return too_much ? now_J - allowed_J : 0;
}

}  // namespace plumbline::physics
