#include "engine/physics/dynamics/body_motion.h"

#include "engine/physics/bullet/convert.h"
#include "engine/physics/bullet/convex_query.h"
#include "engine/physics/dynamics/rotation.h"
#include "engine/physics/world/world_state.h"

#include <algorithm>
#include <cmath>

namespace plumbline::physics {
namespace {

/// Turns slower than this gain less than 1e-6 rad/s2 from the gyroscopic torque.
constexpr double kLeastGyroSpin_radps = 1e-3;

btQuaternion bullet_turn_by(const btVector3& spin, btScalar step_s) {
    const Quat q = plumbline::physics::turn_by(from_bullet(spin), step_s);
    return {q.x, q.y, q.z, q.w};
}

btMatrix3x3 basis_of(const Quatd& q) {
    const Mat3d m = glm::mat3_cast(q);
    const auto at = [&m](int row, int column) { return static_cast<btScalar>(m[column][row]); };
    return {
        at(0, 0), at(0, 1), at(0, 2), at(1, 0), at(1, 1), at(1, 2), at(2, 0), at(2, 1), at(2, 2)};
}

}  // namespace

btMatrix3x3 turned(const btMatrix3x3& basis, const btVector3& spin, btScalar duration_s) {
    btQuaternion q;
    basis.getRotation(q);
    return btMatrix3x3((bullet_turn_by(spin, duration_s) * q).normalized());
}

bool feels_gyro(const BodyRecord& record, const WorldFeatures& features) {
    return features.gyroscopic_torque && !record.round_inertia &&
           record.rigid->getAngularVelocity().length2() >
               static_cast<btScalar>(kLeastGyroSpin_radps * kLeastGyroSpin_radps);
}

void fly(BodyRecord& record, const Vec3d& gravity_mps2, const WorldFeatures& features, double h) {
    btRigidBody& rigid = *record.rigid;
    Flight& flight = record.flight;
    if (!flight.going) {
        flight.position_m = double_from_bullet(record.before.getOrigin());
        flight.velocity_mps = double_from_bullet(record.velocity_before);
        flight.orientation = double_quat_from_bullet(record.before.getBasis());
        flight.spin_radps = double_from_bullet(record.spin_before);
        flight.going = true;
    }
    Vec3d acceleration = gravity_mps2 * Vec3d(record.linear_factor);
    if (record.forced) {
        acceleration +=
            double_from_bullet(rigid.getTotalForce() - record.weight_N) / record.mass_kg;
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
    rigid.setLinearVelocity(bullet_from_double(flight.velocity_mps));

    // A torque went through the solver; without one the spin just decays.
    const bool torque_free = rigid.getAngularVelocity() == record.spin_before * record.angular_keep;
    const double angular_k = record.angular_damping_per_s;
    double turning_s = h;
    Vec3d turning =
        torque_free ? flight.spin_radps : double_from_bullet(rigid.getAngularVelocity());
    flight.spin_radps = turning;
    if (torque_free && angular_k > 0) {
        turning_s = -std::expm1(-angular_k * h) / angular_k;
        flight.spin_radps *= std::exp(-angular_k * h);
        rigid.setAngularVelocity(bullet_from_double(flight.spin_radps));
    }

    btTransform to = record.before;
    to.setOrigin(bullet_from_double(flight.position_m));
    if (!feels_gyro(record, features) && turning != Vec3d{0, 0, 0}) {
        flight.orientation = glm::normalize(turn_by(turning, turning_s) * flight.orientation);
        to.setBasis(basis_of(flight.orientation));
    }
    rigid.setCenterOfMassTransform(to);
}

void turn_freely(BodyRecord& record, double h) {
    btRigidBody& rigid = *record.rigid;
    Flight& flight = record.flight;
    const FreeTurn start =
        flight.going ? FreeTurn{flight.orientation, flight.spin_radps}
                     : FreeTurn{double_quat_from_bullet(rigid.getWorldTransform().getBasis()),
                                double_from_bullet(rigid.getAngularVelocity())};
    const FreeTurn end = turned_freely(start, record.inertia_kgm2, h);
    flight.orientation = end.orientation;
    flight.spin_radps = end.spin_radps;
    btTransform to = rigid.getWorldTransform();
    to.setBasis(basis_of(flight.orientation));
    rigid.setCenterOfMassTransform(to);
    rigid.setAngularVelocity(bullet_from_double(flight.spin_radps));
}

void carry(BodyRecord& record, bool to_target, btScalar h) {
    btRigidBody& rigid = *record.rigid;
    if (rigid.getLinearVelocity().isZero() && rigid.getAngularVelocity().isZero()) return;
    btTransform to = rigid.getWorldTransform();
    if (to_target) {
        to = record.target;  // exactly there, whatever rounding the way left
    } else {
        to.setOrigin(to.getOrigin() + rigid.getLinearVelocity() * h);
        to.setBasis(turned(to.getBasis(), rigid.getAngularVelocity(), h));
    }
    rigid.setCenterOfMassTransform(to);
}

/// Of a step's way: below it a body was at the hit when the step began.
constexpr btScalar kStuckShare = btScalar(0.02);

bool moves_past_itself(const BodyRecord& record) {
    if (record.cores.empty() || record.ccd == ContinuousCollision::Off) return false;
    if (record.ccd == ContinuousCollision::On) return true;
    const btVector3 path =
        record.rigid->getWorldTransform().getOrigin() - record.before.getOrigin();
    return path.length2() > record.smallest_core_m * record.smallest_core_m;
}

WayToHit way_to_hit(const btCollisionWorld& world,
                    const BodyRecord& record,
                    std::uint32_t unseen_group) {
    // Smaller than the core, so that a body sliding fast over a floor is not stopped by it.
    constexpr btScalar kShare = btScalar(0.8);
    constexpr btScalar kInside = btScalar(1e-3);
    const btTransform to = record.rigid->getWorldTransform();
    WayToHit way;
    for (const Core& core : record.cores) {
        const btVector3 center = to_bullet(core.center_m);
        const btVector3 from_point = record.before(center);
        const btVector3 motion = to(center) - from_point;
        btSphereShape ball(core.radius_m * kShare);
        const auto hit = cast_among(world,
                                    ball,
                                    btTransform(btMatrix3x3::getIdentity(), from_point),
                                    motion,
                                    {.group = record.group,
                                     .collides_with = record.collides_with,
                                     .ignored = &record,
                                     .unseen_group = unseen_group});
        if (!hit) continue;
        const btScalar approach = -hit->normal.dot(motion);
        // A hair inside: what is found by touch alone has no contact before it overlaps.
        const btScalar back = core.radius_m * (1 - kShare - kInside) / approach;
        const btScalar share = std::max(btScalar(0), hit->fraction - back);
        if (share < way.share) way = {share, hit->normal};
    }
    return way;
}

void stop_at_hit(const btCollisionWorld& world, BodyRecord& record, btScalar duration_s) {
    const WayToHit way = way_to_hit(world, record, 0);
    if (way.share >= 1) return;
    btRigidBody& rigid = *record.rigid;
    const btTransform to = rigid.getWorldTransform();
    record.flight.going = false;
    btTransform stopped = record.before;
    stopped.setOrigin(record.before.getOrigin().lerp(to.getOrigin(), way.share));
    // What stands at the hit already and still heads for it has contacts elsewhere, about which it
    // turns. It goes on turning; the speed that it cannot have would grow from step to step.
    const bool stuck = way.share < kStuckShare;
    stopped.setBasis(turned(record.before.getBasis(),
                            rigid.getAngularVelocity(),
                            stuck ? duration_s : duration_s * way.share));
    // Less the speed of the fall that it did not make.
    btVector3 velocity = rigid.getLinearVelocity() -
                         record.weight_N * rigid.getInvMass() * (duration_s * (1 - way.share));
    const btScalar into = velocity.dot(way.normal);
    if (stuck && into < 0) velocity -= way.normal * into;
    rigid.setLinearVelocity(velocity);
    rigid.setCenterOfMassTransform(stopped);
}

void stop_part_way(BodyRecord& record, btScalar share) {
    const btTransform& to = record.rigid->getWorldTransform();
    record.flight.going = false;
    btTransform stopped = record.before;
    stopped.setOrigin(record.before.getOrigin().lerp(to.getOrigin(), share));
    stopped.setRotation(record.before.getRotation().slerp(to.getRotation(), share).normalized());
    record.rigid->setCenterOfMassTransform(stopped);
}

}  // namespace plumbline::physics
