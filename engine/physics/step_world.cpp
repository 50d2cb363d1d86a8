#include "engine/core/stopwatch.h"
#include "engine/physics/bullet_convert_impl.h"
#include "engine/physics/convex_query_impl.h"
#include "engine/physics/physics_world_impl.h"
#include "engine/physics/small_step/rotation.h"

#include <algorithm>
#include <cmath>

namespace plumbline::physics {
namespace {

/// Turns slower than this gain less than 1e-6 rad/s2 from the gyroscopic torque.
constexpr double kGyroSpin_radps = 1e-3;

btQuaternion turn_by(const btVector3& spin, btScalar step_s) {
    const Quat q = plumbline::physics::turn_by(from_bullet(spin), step_s);
    return {q.x, q.y, q.z, q.w};
}

btMatrix3x3 turned(const btMatrix3x3& basis, const btVector3& spin, btScalar step_s) {
    btQuaternion q;
    basis.getRotation(q);
    return btMatrix3x3((turn_by(spin, step_s) * q).normalized());
}

Quatd double_quat(const btMatrix3x3& basis) {
    btQuaternion q;
    basis.getRotation(q);
    return glm::normalize(Quatd{static_cast<double>(q.w()),
                                static_cast<double>(q.x()),
                                static_cast<double>(q.y()),
                                static_cast<double>(q.z())});
}

btMatrix3x3 basis_of(const Quatd& q) {
    const Mat3d m = glm::mat3_cast(q);
    const auto at = [&m](int row, int column) { return static_cast<btScalar>(m[column][row]); };
    return {
        at(0, 0), at(0, 1), at(0, 2), at(1, 0), at(1, 1), at(1, 2), at(2, 0), at(2, 1), at(2, 2)};
}

}  // namespace

StepWorld::StepWorld(btDispatcher* dispatcher,
                     btBroadphaseInterface* pairs,
                     btConstraintSolver* solver,
                     btCollisionConfiguration* configuration,
                     const Vec3& gravity_mps2)
    : btDiscreteDynamicsWorld(dispatcher, pairs, solver, configuration),
      gravity_mps2_(gravity_mps2) {
    setGravity(to_bullet(gravity_mps2));
    // Same calls, same bits: pair order must not depend on where the heap put things.
    getDispatchInfo().m_deterministicOverlappingPairs = true;
    // Sweeping is ours; Bullet's own would stretch every body's box by its path.
    getDispatchInfo().m_useContinuous = false;
    setForceUpdateAllAabbs(false);
}

double StepWorld::lap_ms() {
    const double now_s = thread_cpu_s();
    const double lap = (now_s - lap_start_s_) * 1e3;
    lap_start_s_ = now_s;
    return lap;
}

void StepWorld::advance(btScalar step_s) {
    lap_start_s_ = thread_cpu_s();
    internalSingleStepSimulation(step_s);
    cost.integrate_ms += lap_ms();
}

void StepWorld::predictUnconstraintMotion(btScalar) {
    for (int i = 0; i < m_nonStaticRigidBodies.size(); ++i) {
        btRigidBody& rigid = *m_nonStaticRigidBodies[i];
        BodyRecord& record = record_of(rigid);
        record.before = rigid.getWorldTransform();
        record.velocity_before = rigid.getLinearVelocity();
        record.spin_before = rigid.getAngularVelocity();
        if (rigid.isKinematicObject()) continue;
        if (record.linear_keep != 1) {
            rigid.setLinearVelocity(rigid.getLinearVelocity() * record.linear_keep);
        }
        if (record.angular_keep != 1) {
            rigid.setAngularVelocity(rigid.getAngularVelocity() * record.angular_keep);
        }
    }
    cost.integrate_ms += lap_ms();
}

void StepWorld::createPredictiveContacts(btScalar) {}

void StepWorld::performDiscreteCollisionDetection() {
    // Boxes are up to date: integrateTransforms() left them so, and whoever moves a body between
    // steps updates its box there.
    computeOverlappingPairs();
    cost.broad_ms += lap_ms();
    getDispatcher()->dispatchAllCollisionPairs(
        getBroadphase()->getOverlappingPairCache(), getDispatchInfo(), getDispatcher());
    cost.narrow_ms += lap_ms();
}

void StepWorld::solveConstraints(btContactSolverInfo& info) {
    btDiscreteDynamicsWorld::solveConstraints(info);
    cost.solve_ms += lap_ms();
    if (want_contacts) {
        after_solve();
        use.events_ms += lap_ms();
    }
}

/// Whether the solver gave the body nothing but its forces' share: then no contact pressed on it.
bool StepWorld::flew_free(const BodyRecord& record, btScalar step_s) const {
    const btRigidBody& rigid = *record.rigid;
    const btVector3 from_forces = rigid.getTotalForce() * (rigid.getInvMass() * step_s);
    const btVector3 started = record.velocity_before * record.linear_keep;
    const btVector3 change = rigid.getLinearVelocity() - (started + from_forces);
    // A few roundings of the numbers compared; a push this small moves nothing that we can show.
    const btScalar slack = 4 * SIMD_EPSILON * (started.length() + from_forces.length());
    return change.length2() <= slack * slack &&
           rigid.getWorldTransform() == record.before;  // else the solver pushed it out of overlap
}

/// Moves a body that nothing touched along the closed form of v' = g + f/m - k v.
void StepWorld::fly(BodyRecord& record, double h) {
    btRigidBody& rigid = *record.rigid;
    Flight& flight = record.flight;
    if (!flight.going) {
        flight.position_m = double_from_bullet(record.before.getOrigin());
        flight.velocity_mps = double_from_bullet(record.velocity_before);
        flight.orientation = double_quat(record.before.getBasis());
        flight.spin_radps = double_from_bullet(record.spin_before);
        flight.going = true;
    }
    Vec3d acceleration = gravity_mps2_;
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
    if (!feels_gyro(record) && turning != Vec3d{0, 0, 0}) {
        flight.orientation = glm::normalize(turn_by(turning, turning_s) * flight.orientation);
        to.setBasis(basis_of(flight.orientation));
    }
    rigid.setCenterOfMassTransform(to);
}

/// Semi-implicit Euler, as Bullet has it, for bodies that the solver pushed.
void StepWorld::slide(BodyRecord& record, btScalar h) {
    btRigidBody& rigid = *record.rigid;
    record.flight.going = false;
    btTransform to = rigid.getWorldTransform();
    to.setOrigin(to.getOrigin() + rigid.getLinearVelocity() * h);
    const btVector3& spin = rigid.getAngularVelocity();
    if (!feels_gyro(record) && !spin.isZero()) to.setBasis(turned(to.getBasis(), spin, h));
    rigid.setCenterOfMassTransform(to);
}

bool StepWorld::feels_gyro(const BodyRecord& record) const {
    return features.gyroscopic_torque && !record.round_inertia &&
           record.rigid->getAngularVelocity().length2() >
               static_cast<btScalar>(kGyroSpin_radps * kGyroSpin_radps);
}

/// The gyroscopic torque is in the turning; nothing is added to the solver.
void StepWorld::turn_freely(BodyRecord& record, double h) {
    btRigidBody& rigid = *record.rigid;
    Flight& flight = record.flight;
    const FreeTurn start = flight.going
                               ? FreeTurn{flight.orientation, flight.spin_radps}
                               : FreeTurn{double_quat(rigid.getWorldTransform().getBasis()),
                                          double_from_bullet(rigid.getAngularVelocity())};
    const FreeTurn end = turned_freely(start, record.inertia_kgm2, h);
    flight.orientation = end.orientation;
    flight.spin_radps = end.spin_radps;
    btTransform to = rigid.getWorldTransform();
    to.setBasis(basis_of(flight.orientation));
    rigid.setCenterOfMassTransform(to);
    rigid.setAngularVelocity(bullet_from_double(flight.spin_radps));
}

void StepWorld::carry(BodyRecord& record, btScalar h) {
    btRigidBody& rigid = *record.rigid;
    if (rigid.getLinearVelocity().isZero() && rigid.getAngularVelocity().isZero()) return;
    btTransform to = rigid.getWorldTransform();
    if (record.has_target && last_substep) {
        to = record.target;  // exactly there, whatever rounding the way left
    } else {
        to.setOrigin(to.getOrigin() + rigid.getLinearVelocity() * h);
        to.setBasis(turned(to.getBasis(), rigid.getAngularVelocity(), h));
    }
    rigid.setCenterOfMassTransform(to);
}

bool StepWorld::moves_past_itself(const BodyRecord& record) const {
    if (record.cores.empty() || record.ccd == ContinuousCollision::Off) return false;
    if (record.ccd == ContinuousCollision::On) return true;
    const btVector3 path =
        record.rigid->getWorldTransform().getOrigin() - record.before.getOrigin();
    return path.length2() > record.smallest_core_m * record.smallest_core_m;
}

void StepWorld::integrateTransforms(btScalar step_s) {
    turning_.clear();
    swept_.clear();
    for (int i = 0; i < m_nonStaticRigidBodies.size(); ++i) {
        btRigidBody& rigid = *m_nonStaticRigidBodies[i];
        BodyRecord& record = record_of(rigid);
        if (rigid.isKinematicObject()) {
            carry(record, step_s);
        } else if (rigid.isActive()) {
            if (flew_free(record, step_s)) {
                fly(record, static_cast<double>(step_s));
            } else {
                slide(record, step_s);
            }
            if (feels_gyro(record)) turning_.push_back(&record);
            if (features.continuous_collision && moves_past_itself(record)) {
                swept_.push_back(&record);
            }
        }
    }
    if (!turning_.empty()) {
        cost.integrate_ms += lap_ms();
        for (BodyRecord* record : turning_) turn_freely(*record, static_cast<double>(step_s));
        use.gyro_bodies += static_cast<std::uint32_t>(turning_.size());
        use.gyro_ms += lap_ms();
    }
    if (!swept_.empty()) {
        cost.integrate_ms += lap_ms();
        for (BodyRecord* record : swept_) stop_at_hit(*record, step_s);
        use.swept_bodies += static_cast<std::uint32_t>(swept_.size());
        use.sweep_ms += lap_ms();
    }
    updateAabbs();
}

/// Sweeps the balls inside the body along its path; on a hit the body stops where its surface
/// touches and keeps its velocity, so that the next step's contact bounces it as it should.
void StepWorld::stop_at_hit(BodyRecord& record, btScalar step_s) {
    // Smaller than the core, so that a body sliding fast over a floor is not stopped by it.
    constexpr btScalar kShare = btScalar(0.8);
    btRigidBody& rigid = *record.rigid;
    const btTransform to = rigid.getWorldTransform();
    btScalar reached = 1;
    for (const Core& core : record.cores) {
        const btVector3 center = to_bullet(core.center_m);
        const btVector3 from_point = record.before(center);
        const btVector3 motion = to(center) - from_point;
        btSphereShape ball(core.radius_m * kShare);
        const auto hit = cast_among(
            *this,
            ball,
            btTransform(btMatrix3x3::getIdentity(), from_point),
            motion,
            {.group = record.group, .collides_with = record.collides_with, .ignored = &record});
        if (!hit) continue;
        const btScalar approach = -hit->normal.dot(motion);
        const btScalar back = core.radius_m * (1 - kShare) / approach;
        reached = std::min(reached, std::max(btScalar(0), hit->fraction - back));
    }
    if (reached >= 1) return;
    record.flight.going = false;
    btTransform stopped = record.before;
    stopped.setOrigin(record.before.getOrigin().lerp(to.getOrigin(), reached));
    stopped.setBasis(
        turned(record.before.getBasis(), rigid.getAngularVelocity(), step_s * reached));
    rigid.setCenterOfMassTransform(stopped);
}

void StepWorld::updateActivationState(btScalar step_s) {
    for (int i = 0; i < m_nonStaticRigidBodies.size(); ++i) {
        btRigidBody& rigid = *m_nonStaticRigidBodies[i];
        if (rigid.isKinematicObject()) continue;
        if (record_of(rigid).flight.going) {
            // In the air nothing rests, however slow: the top of a throw, a balloon, no gravity.
            rigid.setDeactivationTime(0);
            rigid.setActivationState(ACTIVE_TAG);
            continue;
        }
        rigid.updateDeactivation(step_s);
        if (rigid.wantsSleeping()) {
            if (rigid.getActivationState() == ACTIVE_TAG) {
                rigid.setActivationState(WANTS_DEACTIVATION);
            } else if (rigid.getActivationState() == ISLAND_SLEEPING) {
                rigid.setLinearVelocity({0, 0, 0});
                rigid.setAngularVelocity({0, 0, 0});
            }
        } else {
            rigid.setActivationState(ACTIVE_TAG);  // a body that may not sleep keeps its own state
        }
    }
}

}  // namespace plumbline::physics
