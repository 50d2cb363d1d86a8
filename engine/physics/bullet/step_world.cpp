#include "engine/physics/bullet/step_world.h"

#include "engine/core/time/trace_events.h"
#include "engine/physics/bullet/body.h"
#include "engine/physics/bullet/contact/nearest_pairs.h"
#include "engine/physics/bullet/contact/pair_filter.h"
#include "engine/physics/bullet/convert.h"
#include "engine/physics/bullet/rigid_body.h"
#include "engine/physics/bullet/rotations.h"
#include "engine/physics/dynamics/body_motion.h"
#include "engine/physics/dynamics/body_sweep.h"
#include "engine/physics/world/body_record.h"

#include <algorithm>
#include <cmath>

namespace plumbline::physics {

StepWorld::StepWorld(btDispatcher* dispatcher,
                     btBroadphaseInterface* pairs,
                     btConstraintSolver* solver,
                     btCollisionConfiguration* configuration,
                     NearestPairs& nearest,
                     StepReport& report)
    : btDiscreteDynamicsWorld(dispatcher, pairs, solver, configuration),
      nearest_(nearest),
      report_(report) {
    // Same calls, same bits: pair order must not depend on where the heap put things.
    getDispatchInfo().m_deterministicOverlappingPairs = true;
    // Sweeping is ours; Bullet's own would stretch every body's box by its path.
    getDispatchInfo().m_useContinuous = false;
    setForceUpdateAllAabbs(false);
}

void StepWorld::set_gravity(const Vec3& gravity_mps2) {
    gravity_mps2_ = Vec3d(gravity_mps2);
    setGravity(to_bullet(gravity_mps2));
}

void StepWorld::list_moving(const std::vector<BodyRecord*>& records) {
    m_nonStaticRigidBodies.resize(0);
    for (const BodyRecord* record : records) m_nonStaticRigidBodies.push_back(record->rigid.get());
}

void StepWorld::advance(btScalar step_s) {
    laps_.start();
    internalSingleStepSimulation(step_s);
    report_.cost.integrate_ms += laps_.lap_ms();
}

void StepWorld::predictUnconstraintMotion(btScalar) {
    for (int i = 0; i < m_nonStaticRigidBodies.size(); ++i) {
        btRigidBody& rigid = *m_nonStaticRigidBodies[i];
        BodyRecord& record = record_of(rigid);
        // What the substep before made no number keeps its last place: there it is taken out.
        if (is_finite(record.motion->at.position_m)) note_before(record);
        if (rigid.isKinematicObject()) continue;
        if (record.traits.linear_damping_factor != 1) {
            rigid.setLinearVelocity(rigid.getLinearVelocity() *
                                    record.traits.linear_damping_factor);
        }
        if (record.traits.angular_damping_factor != 1) {
            rigid.setAngularVelocity(rigid.getAngularVelocity() *
                                     record.traits.angular_damping_factor);
        }
    }
    report_.cost.integrate_ms += laps_.lap_ms();
}

void StepWorld::createPredictiveContacts(btScalar) {}

void StepWorld::performDiscreteCollisionDetection() {
    // Boxes are up to date: integrateTransforms() left them so, and whoever moves a body between
    // steps updates its box there.
    {
        const TraceSpan span("broad phase");
        computeOverlappingPairs();
        if (nearest_.needed()) thin_crowds();
    }
    report_.cost.broad_ms += laps_.lap_ms();
    {
        const TraceSpan span("narrow phase");
        getDispatcher()->dispatchAllCollisionPairs(
            getBroadphase()->getOverlappingPairCache(), getDispatchInfo(), getDispatcher());
    }
    report_.cost.narrow_ms += laps_.lap_ms();
}

/// Crowded bodies get the pairs that they miss and lose those that take no part.
void StepWorld::thin_crowds() {
    nearest_.begin_step();
    bool any_crowded = false;
    for (int i = 0; i < m_nonStaticRigidBodies.size(); ++i) {
        BodyRecord& record = record_of(*m_nonStaticRigidBodies[i]);
        if (record.crowd == nullptr || !is_active(record)) continue;
        any_crowded = true;
        nearest_.complete(record);
    }
    if (!any_crowded) return;
    btOverlappingPairCache& pairs = *getPairCache();
    for (int i = pairs.getNumOverlappingPairs() - 1; i >= 0; --i) {
        btBroadphaseProxy* first = pairs.getOverlappingPairArray()[i].m_pProxy0;
        btBroadphaseProxy* second = pairs.getOverlappingPairArray()[i].m_pProxy1;
        const BodyRecord& a = record_behind(*first);
        const BodyRecord& b = record_behind(*second);
        if ((is_active(a) || is_active(b)) && !nearest_.takes_part(a, b))
            pairs.removeOverlappingPair(first, second, getDispatcher());
    }
    report_.cost.interventions.left_out_pairs = nearest_.left_out();
}

void StepWorld::solveConstraints(btContactSolverInfo& info) {
    {
        const TraceSpan span("solve islands");
        btDiscreteDynamicsWorld::solveConstraints(info);
    }
    report_.cost.solve_ms += laps_.lap_ms();
    if (after_solve) {
        after_solve();
        report_.use.events_ms += laps_.lap_ms();
    }
}

/// Whether the solver gave the body nothing but its forces' share: then no contact pressed on it.
bool StepWorld::flew_free(const BodyRecord& record, btScalar step_s) const {
    const BodyMotion& motion = *record.motion;
    const Vec3 from_forces = record.applied.force_N * (motion.inverse_mass * step_s);
    const Vec3 started = record.before.velocity_mps * record.traits.linear_damping_factor;
    const Vec3 change = motion.velocity_mps - (started + from_forces);
    // A few roundings of the numbers compared; a push this small moves nothing that we can show.
    const Real slack = 4 * SIMD_EPSILON * (glm::length(started) + glm::length(from_forces));
    return glm::dot(change, change) <= slack * slack &&
           motion.at == record.before.at;  // else the solver pushed it out of penetration
}

/// Semi-implicit Euler, as Bullet has it, for bodies that the solver pushed.
void StepWorld::slide(BodyRecord& record, btScalar h) {
    BodyMotion& motion = *record.motion;
    motion.ballistic.going = false;
    motion.at.position_m += motion.velocity_mps * h;
    if (!feels_gyro(record, features) && motion.spin_radps != Vec3{0, 0, 0})
        motion.at.rotation = turned(motion.at.rotation, motion.spin_radps, h);
}

void StepWorld::move(BodyRecord& record, btScalar step_s) {
    if (flew_free(record, step_s)) {
        integrate_ballistic(record, gravity_mps2_, features, static_cast<double>(step_s));
    } else {
        slide(record, step_s);
    }
    if (feels_gyro(record, features)) turning_.push_back(&record);
    if (features.continuous_collision && moves_past_itself(record)) swept_.push_back(&record);
}

void StepWorld::integrateTransforms(btScalar step_s) {
    turning_.clear();
    swept_.clear();
    for (int i = 0; i < m_nonStaticRigidBodies.size(); ++i) {
        BodyRecord& record = record_of(*m_nonStaticRigidBodies[i]);
        if (record.kind == BodyKind::Kinematic) {
            integrate_kinematic(record, record.drive.has_target && last_substep, step_s);
        } else {
            read_rigid_motion(record);
            report_.cost.interventions.limited_bodies += limit_speed(record) ? 1U : 0U;
            if (is_active(record)) move(record, step_s);
        }
    }
    if (!turning_.empty()) {
        report_.cost.integrate_ms += laps_.lap_ms();
        for (BodyRecord* record : turning_) turn_freely(*record, static_cast<double>(step_s));
        report_.use.gyro_bodies += static_cast<std::uint32_t>(turning_.size());
        if (!report_.use.turned) report_.use.turned = turning_.front()->id;
        report_.use.gyro_ms += laps_.lap_ms();
    }
    for (int i = 0; i < m_nonStaticRigidBodies.size(); ++i) {
        if (m_nonStaticRigidBodies[i]->isActive())
            write_rigid_motion(record_of(*m_nonStaticRigidBodies[i]));
    }
    if (!swept_.empty()) {
        report_.cost.integrate_ms += laps_.lap_ms();
        for (BodyRecord* record : swept_) {
            if (stop_at_hit(*this, *record, step_s)) write_rigid_motion(*record);
        }
        report_.use.swept_bodies += static_cast<std::uint32_t>(swept_.size());
        if (!report_.use.swept) report_.use.swept = swept_.front()->id;
        report_.use.sweep_ms += laps_.lap_ms();
    }
    updateAabbs();
}

void StepWorld::updateActivationState(btScalar step_s) {
    for (int i = 0; i < m_nonStaticRigidBodies.size(); ++i) {
        btRigidBody& rigid = *m_nonStaticRigidBodies[i];
        if (rigid.isKinematicObject()) continue;
        BodyRecord& record = record_of(rigid);
        if (record.motion->ballistic.going) {
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
                stand_still(record);
                write_rigid_motion(record);
            }
        } else {
            rigid.setActivationState(ACTIVE_TAG);  // a body that may not sleep keeps its own state
        }
    }
}

}  // namespace plumbline::physics
