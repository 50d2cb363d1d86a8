#include "engine/physics/bullet/step_world.h"

#include "engine/physics/bullet/body.h"
#include "engine/physics/bullet/contact/contact_copy.h"
#include "engine/physics/bullet/convert.h"
#include "engine/physics/bullet/rotations.h"
#include "engine/physics/dynamics/body_motion.h"
#include "engine/physics/world/body_record.h"

#include <algorithm>
#include <cmath>

namespace plumbline::physics {

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

void StepWorld::list_moving(const std::vector<BodyRecord*>& records) {
    m_nonStaticRigidBodies.resize(0);
    for (const BodyRecord* record : records) m_nonStaticRigidBodies.push_back(record->rigid.get());
}

void StepWorld::advance(btScalar step_s) {
    laps_.start();
    internalSingleStepSimulation(step_s);
    cost.integrate_ms += laps_.lap_ms();
}

void StepWorld::predictUnconstraintMotion(btScalar) {
    for (int i = 0; i < m_nonStaticRigidBodies.size(); ++i) {
        btRigidBody& rigid = *m_nonStaticRigidBodies[i];
        BodyRecord& record = record_of(rigid);
        record.before = transform_from_bullet(rigid.getWorldTransform());
        record.velocity_before = from_bullet(rigid.getLinearVelocity());
        record.spin_before = from_bullet(rigid.getAngularVelocity());
        if (rigid.isKinematicObject()) continue;
        if (record.linear_keep != 1) {
            rigid.setLinearVelocity(rigid.getLinearVelocity() * record.linear_keep);
        }
        if (record.angular_keep != 1) {
            rigid.setAngularVelocity(rigid.getAngularVelocity() * record.angular_keep);
        }
    }
    cost.integrate_ms += laps_.lap_ms();
}

void StepWorld::createPredictiveContacts(btScalar) {}

void StepWorld::performDiscreteCollisionDetection() {
    // Boxes are up to date: integrateTransforms() left them so, and whoever moves a body between
    // steps updates its box there.
    computeOverlappingPairs();
    cost.broad_ms += laps_.lap_ms();
    getDispatcher()->dispatchAllCollisionPairs(
        getBroadphase()->getOverlappingPairCache(), getDispatchInfo(), getDispatcher());
    cost.narrow_ms += laps_.lap_ms();
}

void StepWorld::solveConstraints(btContactSolverInfo& info) {
    btDiscreteDynamicsWorld::solveConstraints(info);
    cost.solve_ms += laps_.lap_ms();
    if (after_solve) {
        after_solve();
        use.events_ms += laps_.lap_ms();
    }
}

/// Whether the solver gave the body nothing but its forces' share: then no contact pressed on it.
bool StepWorld::flew_free(const BodyRecord& record, btScalar step_s) const {
    const btRigidBody& rigid = *record.rigid;
    const btVector3 from_forces = rigid.getTotalForce() * (rigid.getInvMass() * step_s);
    const btVector3 started = to_bullet(record.velocity_before * record.linear_keep);
    const btVector3 change = rigid.getLinearVelocity() - (started + from_forces);
    // A few roundings of the numbers compared; a push this small moves nothing that we can show.
    const btScalar slack = 4 * SIMD_EPSILON * (started.length() + from_forces.length());
    return change.length2() <= slack * slack &&
           rigid_transform(record) == record.before;  // else the solver pushed it out of overlap
}

/// Semi-implicit Euler, as Bullet has it, for bodies that the solver pushed.
void StepWorld::slide(BodyRecord& record, btScalar h) {
    btRigidBody& rigid = *record.rigid;
    record.flight.going = false;
    Transform to = rigid_transform(record);
    to.position_m += linear_velocity(record) * h;
    if (!feels_gyro(record, features) && !rigid.getAngularVelocity().isZero())
        to.rotation = turned(to.rotation, angular_velocity(record), h);
    set_rigid_transform(record, to);
}

void StepWorld::integrateTransforms(btScalar step_s) {
    turning_.clear();
    swept_.clear();
    for (int i = 0; i < m_nonStaticRigidBodies.size(); ++i) {
        btRigidBody& rigid = *m_nonStaticRigidBodies[i];
        BodyRecord& record = record_of(rigid);
        if (rigid.isKinematicObject()) {
            carry(record, record.has_target && last_substep, step_s);
        } else if (rigid.isActive()) {
            if (flew_free(record, step_s)) {
                fly(record, gravity_mps2_, features, static_cast<double>(step_s));
            } else {
                slide(record, step_s);
            }
            if (feels_gyro(record, features)) turning_.push_back(&record);
            if (features.continuous_collision && moves_past_itself(record)) {
                swept_.push_back(&record);
            }
        }
    }
    if (!turning_.empty()) {
        cost.integrate_ms += laps_.lap_ms();
        for (BodyRecord* record : turning_) turn_freely(*record, static_cast<double>(step_s));
        use.gyro_bodies += static_cast<std::uint32_t>(turning_.size());
        use.gyro_ms += laps_.lap_ms();
    }
    if (!swept_.empty()) {
        cost.integrate_ms += laps_.lap_ms();
        for (BodyRecord* record : swept_) stop_at_hit(*this, *record, step_s);
        use.swept_bodies += static_cast<std::uint32_t>(swept_.size());
        use.sweep_ms += laps_.lap_ms();
    }
    updateAabbs();
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
