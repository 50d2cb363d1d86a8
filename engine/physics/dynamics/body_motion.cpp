#include "engine/physics/dynamics/body_motion.h"

#include "engine/physics/bullet/rotations.h"
#include "engine/physics/dynamics/rotation.h"
#include "engine/physics/world/body_record.h"

#include <algorithm>
#include <cmath>

namespace plumbline::physics {
namespace {

Mat3 matrix_of(const Quatd& q) {
    return Mat3{glm::mat3_cast(q)};
}

}  // namespace

// R diag(moments) R^T, in the order in which Bullet multiplies.
SymmetricMat3 inverse_inertia_of(const BodyMotion& motion) {
    const Mat3 rows = glm::transpose(motion.at.rotation);
    const Vec3 x = rows[0] * motion.inverse_moments;
    const Vec3 y = rows[1] * motion.inverse_moments;
    const Vec3 z = rows[2] * motion.inverse_moments;
    return {.xx = glm::dot(rows[0], x),
            .xy = glm::dot(rows[1], x),
            .xz = glm::dot(rows[2], x),
            .yy = glm::dot(rows[1], y),
            .yz = glm::dot(rows[2], y),
            .zz = glm::dot(rows[2], z)};
}

// The lower half of that matrix is rounded in another way than the upper.
Vec3 angular_gain(const BodyMotion& motion, const Vec3& torque_Nm) {
    const Mat3 rows = glm::transpose(motion.at.rotation);
    Vec3 gain{0, 0, 0};
    for (int axis = 0; axis < 3; ++axis)
        gain[axis] =
            glm::dot(glm::transpose(rows) * (rows[axis] * motion.inverse_moments), torque_Nm);
    return gain;
}

SurfaceMotion surface_motion(const BodyRecord& record) {
    const BodyTraits& traits = record.traits;
    if (!traits.is_belt()) return {};
    // Body axes: the mass frame's, turned back.
    const Quat world_from_body = glm::normalize(quat_of(record.motion->at.rotation) *
                                                glm::conjugate(traits.body_from_mass.orientation));
    const Vec3 spin = world_from_body * traits.surface_spin_radps;
    const Vec3 arm = world_from_body * traits.body_from_mass.position;
    return {world_from_body * traits.surface_velocity_mps + glm::cross(spin, arm), spin};
}

Vec3 limited(const Vec3& v, Real limit) {
    // Divides by the largest part first: the square of 1e30 is infinite.
    const Real largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (largest * 2 < limit) return v;
    const Vec3 direction = v * (1 / largest);
    const Real length = glm::length(direction);
    return largest > limit / length ? direction * (limit / length) : v;
}

bool limit_speed(BodyRecord& record) {
    BodyMotion& motion = *record.motion;
    // Nearly always both are far below.
    const auto is_far_below = [](const Vec3& v, Real limit) {
        return 4 * glm::dot(v, v) < limit * limit;
    };
    if (is_far_below(motion.velocity_mps, kMaxSpeed_mps) &&
        is_far_below(motion.spin_radps, kMaxSpin_radps))
        return false;
    const Vec3 velocity = limited(motion.velocity_mps, kMaxSpeed_mps);
    const Vec3 spin = limited(motion.spin_radps, kMaxSpin_radps);
    if (velocity == motion.velocity_mps && spin == motion.spin_radps) return false;
    motion.velocity_mps = velocity;
    motion.spin_radps = spin;
    motion.ballistic.going = false;
    return true;
}

bool feels_gyro(const BodyRecord& record, const WorldFeatures& features) {
    // A tenth of what islands leave out (island_loop.cpp): recorded states of bullet_* tell the two
    // apart.
    constexpr Real kLeastSpin_radps = 1e-3_r;
    const Vec3 spin = record.motion->spin_radps;
    return features.gyroscopic_torque && !record.traits.isotropic_inertia &&
           glm::dot(spin, spin) > kLeastSpin_radps * kLeastSpin_radps;
}

void integrate_ballistic(BodyRecord& record,
                         const Vec3d& gravity_mps2,
                         const WorldFeatures& features,
                         double h) {
    BallisticState& ballistic = record.motion->ballistic;
    if (!ballistic.going) {
        ballistic.position_m = Vec3d(record.before.at.position_m);
        ballistic.velocity_mps = Vec3d(record.before.velocity_mps);
        ballistic.orientation = double_quat_of(record.before.at.rotation);
        ballistic.spin_radps = Vec3d(record.before.spin_radps);
        ballistic.going = true;
    }
    Vec3d acceleration = gravity_mps2 * Vec3d(record.traits.gravity_factor);
    if (record.applied.by_caller) {
        acceleration +=
            Vec3d(record.applied.force_N - record.traits.weight_N) / record.traits.mass_kg;
    }
    const Vec3d v = ballistic.velocity_mps;
    const double k = record.traits.linear_damping_per_s;
    if (k > 0) {
        const double lost = -portable_expm1(-k * h);  // 1 - exp(-k h), exact for small k h too
        const Vec3d terminal = acceleration / k;
        ballistic.position_m += terminal * h + (v - terminal) * (lost / k);
        ballistic.velocity_mps = v + (terminal - v) * lost;
    } else {
        ballistic.position_m += v * h + acceleration * (0.5 * h * h);
        ballistic.velocity_mps = v + acceleration * h;
    }
    record.motion->velocity_mps = Vec3(ballistic.velocity_mps);

    // A torque went through the solver; without one the spin just decays.
    const Vec3 spin = record.motion->spin_radps;
    const bool torque_free =
        spin == record.before.spin_radps * record.traits.angular_damping_factor;
    const double angular_k = record.traits.angular_damping_per_s;
    double turning_s = h;
    const Vec3d turning = torque_free ? ballistic.spin_radps : Vec3d(spin);
    ballistic.spin_radps = turning;
    if (torque_free && angular_k > 0) {
        turning_s = -portable_expm1(-angular_k * h) / angular_k;
        ballistic.spin_radps *= portable_exp(-angular_k * h);
        record.motion->spin_radps = Vec3(ballistic.spin_radps);
    }

    Transform to = record.before.at;
    to.position_m = Vec3(ballistic.position_m);
    if (!feels_gyro(record, features) && turning != Vec3d{0, 0, 0}) {
        ballistic.orientation = glm::normalize(turn_by(turning, turning_s) * ballistic.orientation);
        to.rotation = matrix_of(ballistic.orientation);
    }
    record.motion->at = to;
}

void turn_freely(BodyRecord& record, double h) {
    BallisticState& ballistic = record.motion->ballistic;
    Transform to = record.motion->at;
    const FreeTurn start =
        ballistic.going ? FreeTurn{ballistic.orientation, ballistic.spin_radps}
                        : FreeTurn{double_quat_of(to.rotation), Vec3d(record.motion->spin_radps)};
    const FreeTurn end = turned_freely(start, record.traits.inertia_kgm2, h);
    ballistic.orientation = end.orientation;
    ballistic.spin_radps = end.spin_radps;
    to.rotation = matrix_of(ballistic.orientation);
    record.motion->at = to;
    record.motion->spin_radps = Vec3(ballistic.spin_radps);
}

void integrate_kinematic(BodyRecord& record, bool to_target, Real h) {
    if (stands_still(record)) return;
    Transform to = record.motion->at;
    if (to_target) {
        to = record.drive.target;  // exactly there, whatever rounding the way left
    } else {
        to.position_m += record.motion->velocity_mps * h;
        to.rotation = turned(to.rotation, record.motion->spin_radps, h);
    }
    record.motion->at = to;
}

}  // namespace plumbline::physics
