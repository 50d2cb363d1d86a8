#include "engine/physics/dynamics/body_motion.h"

#include "engine/physics/bullet/body.h"
#include "engine/physics/bullet/cast.h"
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

bool feels_gyro(const BodyRecord& record, const WorldFeatures& features) {
    const Vec3 spin = angular_velocity(record);
    return features.gyroscopic_torque && !record.round_inertia &&
           glm::dot(spin, spin) > static_cast<Real>(kLeastGyroSpin_radps * kLeastGyroSpin_radps);
}

void fly(BodyRecord& record, const Vec3d& gravity_mps2, const WorldFeatures& features, double h) {
    Flight& flight = record.flight;
    if (!flight.going) {
        flight.position_m = Vec3d(record.before.position_m);
        flight.velocity_mps = Vec3d(record.velocity_before);
        flight.orientation = double_quat_of(record.before.rotation);
        flight.spin_radps = Vec3d(record.spin_before);
        flight.going = true;
    }
    Vec3d acceleration = gravity_mps2 * Vec3d(record.linear_factor);
    if (record.forced) {
        acceleration += Vec3d(total_force_N(record) - record.weight_N) / record.mass_kg;
    }
    const Vec3d v = flight.velocity_mps;
    const double k = record.linear_damping_per_s;
    if (k > 0) {
        const double lost = -std::expm1(-k * h);  // 1 - exp(-k h), exact for small k h too
        const Vec3d terminal = acceleration / k;
        flight.position_m += terminal * h + (v - terminal) * (lost / k);
        flight.velocity_mps = v + (terminal - v) * lost;
    } else {
        flight.position_m += v * h + acceleration * (0.5 * h * h);
        flight.velocity_mps = v + acceleration * h;
    }
    set_linear_velocity(record, Vec3(flight.velocity_mps));

    // A torque went through the solver; without one the spin just decays.
    const Vec3 spin = angular_velocity(record);
    const bool torque_free = spin == record.spin_before * record.angular_keep;
    const double angular_k = record.angular_damping_per_s;
    double turning_s = h;
    const Vec3d turning = torque_free ? flight.spin_radps : Vec3d(spin);
    flight.spin_radps = turning;
    if (torque_free && angular_k > 0) {
        turning_s = -std::expm1(-angular_k * h) / angular_k;
        flight.spin_radps *= std::exp(-angular_k * h);
        set_angular_velocity(record, Vec3(flight.spin_radps));
    }

    Transform to = record.before;
    to.position_m = Vec3(flight.position_m);
    if (!feels_gyro(record, features) && turning != Vec3d{0, 0, 0}) {
        flight.orientation = glm::normalize(turn_by(turning, turning_s) * flight.orientation);
        to.rotation = matrix_of(flight.orientation);
    }
    set_rigid_transform(record, to);
}

void turn_freely(BodyRecord& record, double h) {
    Flight& flight = record.flight;
    Transform to = rigid_transform(record);
    const FreeTurn start =
        flight.going ? FreeTurn{flight.orientation, flight.spin_radps}
                     : FreeTurn{double_quat_of(to.rotation), Vec3d(angular_velocity(record))};
    const FreeTurn end = turned_freely(start, record.inertia_kgm2, h);
    flight.orientation = end.orientation;
    flight.spin_radps = end.spin_radps;
    to.rotation = matrix_of(flight.orientation);
    set_rigid_transform(record, to);
    set_angular_velocity(record, Vec3(flight.spin_radps));
}

void carry(BodyRecord& record, bool to_target, Real h) {
    if (stands_still(record)) return;
    Transform to = rigid_transform(record);
    if (to_target) {
        to = record.target;  // exactly there, whatever rounding the way left
    } else {
        to.position_m += linear_velocity(record) * h;
        to.rotation = turned(to.rotation, angular_velocity(record), h);
    }
    set_rigid_transform(record, to);
}

/// Of a step's way: below it a body was at the hit when the step began.
constexpr Real kStuckShare = 0.02_r;

bool moves_past_itself(const BodyRecord& record) {
    if (record.cores.empty() || record.ccd == ContinuousCollision::Off) return false;
    if (record.ccd == ContinuousCollision::On) return true;
    const Vec3 path = rigid_position(record) - record.before.position_m;
    return glm::dot(path, path) > record.smallest_core_m * record.smallest_core_m;
}

WayToHit way_to_hit(const StepWorld& world, const BodyRecord& record, std::uint32_t unseen_group) {
    // Smaller than the core, so that a body sliding fast over a floor is not stopped by it.
    constexpr Real kShare = 0.8_r;
    constexpr Real kInside = 1e-3_r;
    const Transform to = rigid_transform(record);
    WayToHit way;
    for (const Core& core : record.cores) {
        const Vec3 from = record.before(core.center_m);
        const Vec3 motion = to(core.center_m) - from;
        const auto hit = cast_sphere(
            world,
            {.from_world = from, .motion_m = motion, .radius_m = core.radius_m * kShare},
            {.group = record.group,
             .collides_with = record.collides_with,
             .ignored = &record,
             .unseen_group = unseen_group});
        if (!hit) continue;
        const Real approach = -glm::dot(hit->normal_world, motion);
        // A hair inside: what is found by touch alone has no contact before it overlaps.
        const Real back = core.radius_m * (1 - kShare - kInside) / approach;
        const Real share = std::max(Real{0}, hit->fraction - back);
        if (share < way.share) way = {share, hit->normal_world};
    }
    return way;
}

void stop_at_hit(const StepWorld& world, BodyRecord& record, Real duration_s) {
    const WayToHit way = way_to_hit(world, record, 0);
    if (way.share >= 1) return;
    record.flight.going = false;
    Transform stopped = record.before;
    stopped.position_m += (rigid_position(record) - stopped.position_m) * way.share;
    // What stands at the hit already and still heads for it has contacts elsewhere, about which it
    // turns. It goes on turning; the speed that it cannot have would grow from step to step.
    const bool stuck = way.share < kStuckShare;
    stopped.rotation = turned(record.before.rotation,
                              angular_velocity(record),
                              stuck ? duration_s : duration_s * way.share);
    // Less the speed of the fall that it did not make.
    Vec3 velocity = linear_velocity(record) -
                    record.weight_N * inverse_mass_of(record) * (duration_s * (1 - way.share));
    const Real into = glm::dot(velocity, way.normal);
    if (stuck && into < 0) velocity -= way.normal * into;
    set_linear_velocity(record, velocity);
    set_rigid_transform(record, stopped);
}

void stop_part_way(BodyRecord& record, Real share) {
    const Transform to = rigid_transform(record);
    record.flight.going = false;
    Transform stopped = record.before;
    stopped.position_m += (to.position_m - stopped.position_m) * share;
    stopped.rotation = turned_part_way(record.before.rotation, to.rotation, share);
    set_rigid_transform(record, stopped);
}

}  // namespace plumbline::physics
