// Everything that decides how bodies and joints go on, as fields of an archive.
#include "engine/physics/bullet/archive.h"

#include "engine/physics/bullet/joints.h"
#include "engine/physics/bullet/pair_dispatch.h"
#include "engine/physics/world/archive_fields.h"
#include "engine/physics/world/small_step_world.h"
#include "engine/physics/world/world_state.h"

#include <algorithm>
#include <map>
#include <utility>

namespace plumbline::physics {
namespace {

constexpr std::string_view kOtherBodies = "its bodies are not those of this scene";

}  // namespace

namespace {

bool is_possible(const WorldDef& def) {
    return def.step_s > 0 && def.step_s <= 1 && def.substeps >= 1 && def.substeps <= 1'000 &&
           def.substeps_max <= 1'000 && def.iterations >= 1 && def.iterations <= 10'000 &&
           is_finite(def.gravity_mps2) && !solver_name(def.solver).empty();
}

/// Its velocities, forces, materials and sleep; mass and shape are those of its definition.
void serialize_rigid(Archive& archive, BodyRecord& record) {
    btRigidBody& rigid = *record.rigid;
    btTransform at = rigid.getWorldTransform();
    btVector3 velocity = rigid.getLinearVelocity();
    btVector3 spin = rigid.getAngularVelocity();
    btVector3 force = rigid.getTotalForce();
    btVector3 torque = rigid.getTotalTorque();
    btScalar friction = rigid.getFriction();
    btScalar restitution = rigid.getRestitution();
    btScalar idle_s = rigid.getDeactivationTime();
    int activation = rigid.getActivationState();
    archive(at, velocity, spin, force, torque, friction, restitution, idle_s, activation);
    if (!archive.reads()) return;
    rigid.setCenterOfMassTransform(at);
    rigid.setLinearVelocity(velocity);
    rigid.setAngularVelocity(spin);
    rigid.clearForces();
    // Bullet scales what is applied along the axes that the body does not move along.
    const btVector3 factor = rigid.getLinearFactor();
    rigid.setLinearFactor({1, 1, 1});
    rigid.applyCentralForce(force);
    rigid.setLinearFactor(factor);
    rigid.applyTorque(torque);
    rigid.setFriction(friction);
    rigid.setRestitution(restitution);
    rigid.setDeactivationTime(idle_s);
    rigid.forceActivationState(activation);
}

void serialize_body(Archive& archive, BodyRecord& record) {
    archive(record.contact_events,
            record.frozen,
            record.in_world,
            record.poisoned,
            record.has_target,
            record.driven,
            record.forced,
            record.awake,
            record.box_stale,
            record.substeps,
            record.substeps_held,
            record.slumber,
            record.joints,
            record.rest,
            record.target,
            record.before,
            record.velocity_before,
            record.spin_before,
            record.flight);
}

std::vector<BodyRecord*> records_of(const btCollisionObjectArray& objects) {
    std::vector<BodyRecord*> records;
    for (int i = 0; i < objects.size(); ++i) records.push_back(&record_of(*objects[i]));
    return records;
}

/// The boxes of two bodies overlap again, as far as the pairs know.
void add_pair(btOverlappingPairCache& pairs, const BodyRecord& a, const BodyRecord& b) {
    pairs.addOverlappingPair(a.rigid->getBroadphaseHandle(), b.rigid->getBroadphaseHandle());
}

}  // namespace

bool BodyScope::holds(const JointRecord& joint) const {
    return holds(joint.def.a) && (!joint.def.b || holds(joint.def.b));
}

void serialize(Archive& archive, std::vector<BodyRecord*>& list, const BodyScope& scope) {
    std::vector<BodyId> ids;
    for (const BodyRecord* record : list) {
        if (scope.holds(record->id)) ids.push_back(record->id);
    }
    archive(ids);
    if (!archive.reads()) return;
    list.clear();
    for (const BodyId id : ids) {
        const auto* record = scope.bodies.find(id);
        if (!archive.expect(record != nullptr, kOtherBodies)) return;
        list.push_back(record->get());
    }
}

void PhysicsWorld::serialize(Archive& archive, const std::function<bool(BodyId)>& keeps) {
    Impl& impl = *impl_;
    const BodyScope scope{impl.bodies, keeps};
    WorldDef def = impl.def;
    bool is_whole = !keeps;
    archive(def, is_whole);
    std::vector<BodyId> ids;
    impl.bodies.each([&](BodyId id, const std::unique_ptr<BodyRecord>&) {
        if (scope.holds(id)) ids.push_back(id);
    });
    std::vector<BodyId> saved = ids;
    archive(saved);
    if (!archive.expect(is_possible(def), "no world steps like that")) return;
    if (!archive.expect(saved == ids, kOtherBodies)) return;
    if (is_whole) impl.bodies.serialize_slots(archive);
    if (archive.failed()) return;
    if (archive.reads()) {
        impl.take_engine_down();
        impl.def = def;
    }
    impl.serialize_bodies(archive, scope);
    impl.serialize_joints(archive, scope);
    if (archive.reads() && !archive.failed()) impl.build_engine();
    if (!archive.failed()) impl.serialize_engine(archive, scope);
    if (is_whole && !archive.failed()) {
        archive(impl.poisoned,
                impl.quarantined,
                impl.broken_joints,
                impl.events,
                impl.events_asleep,
                impl.slept_through);
    }
    if (archive.reads() && archive.failed()) impl.abandon();
}

/// After a fault: bodies without a world, which can only be taken down.
void PhysicsWorld::Impl::abandon() {
    if (world) take_engine_down();
    bodies.each([](BodyId, std::unique_ptr<BodyRecord>& record) {
        record->in_world = record->awake = false;
        record->slumber = 0;
        record->joints.clear();
        record->apart.clear();
        record->pairs.clear();
    });
    joints = {};
    for (auto* ids : {&poisoned, &quarantined}) ids->clear();
    broken_joints.clear();
    build_engine();
}

void PhysicsWorld::Impl::serialize_bodies(Archive& archive, const BodyScope& scope) {
    if (archive.reads()) event_bodies = 0;
    bodies.each([&](BodyId id, std::unique_ptr<BodyRecord>& record) {
        if (!scope.holds(id)) return;
        const bool was_frozen = record->frozen;
        serialize_body(archive, *record);
        if (archive.reads()) {
            if (record->contact_events) ++event_bodies;
            if (was_frozen != record->frozen) weigh(*record);
            record->apart.clear();
            record->sweep_group = 0;
        }
        serialize_rigid(archive, *record);
    });
}

void PhysicsWorld::Impl::serialize_joints(Archive& archive, const BodyScope& scope) {
    std::vector<JointId> ids;
    joints.each([&](JointId id, const std::unique_ptr<JointRecord>& joint) {
        if (scope.holds(*joint)) ids.push_back(id);
    });
    archive(ids);
    if (archive.reads()) {
        joints = {};
        for (const JointId id : ids) {
            if (!archive.expect(joints.reserve(id), "a joint has no number")) return;
            joints.insert(std::make_unique<JointRecord>());
        }
    }
    bool is_whole = !scope.keeps;
    archive(is_whole);
    if (is_whole) joints.serialize_slots(archive);
    joints.each([&](JointId id, std::unique_ptr<JointRecord>& record) {
        JointRecord& joint = *record;
        if (!archive.reads() && !scope.holds(joint)) return;
        archive(joint.def, joint.solver, joint.state);
        if (!archive.reads() || archive.failed()) return;
        const auto* a = bodies.find(joint.def.a);
        const auto* b = bodies.find(joint.def.b);
        if (!archive.expect(a != nullptr && (b != nullptr || !joint.def.b), kOtherBodies)) return;
        joint.id = id;
        joint.a = a->get();
        joint.b = b != nullptr ? b->get() : nullptr;
        if (!joint.state.broken) keep_apart(joint);
    });
}

void PhysicsWorld::Impl::serialize_engine(Archive& archive, const BodyScope& scope) {
    std::vector<BodyRecord*> in_world = records_of(world->getCollisionObjectArray());
    std::erase_if(in_world, [&](const BodyRecord* record) { return !scope.holds(record->id); });
    std::vector<BodyRecord*> moving;
    const auto& listed = world->getNonStaticRigidBodies();
    for (int i = 0; i < listed.size(); ++i) moving.push_back(&record_of(*listed[i]));
    physics::serialize(archive, in_world, scope);
    physics::serialize(archive, moving, scope);
    if (archive.failed()) return;
    if (archive.reads()) {
        bodies.each([](BodyId, std::unique_ptr<BodyRecord>& record) { record->in_world = false; });
        broadphase->m_deferedcollide = true;  // pairs come from the archive
        for (BodyRecord* record : in_world) {
            if (!archive.expect(!std::exchange(record->in_world, true), kOtherBodies)) return;
            suit_to_world(*record);
            world->addRigidBody(record->rigid.get(), -1, -1);
        }
        broadphase->m_deferedcollide = false;
        const auto is_moving = [](const BodyRecord* record) {
            return record->in_world && !record->rigid->isStaticObject();
        };
        const auto count = static_cast<std::size_t>(world->getNonStaticRigidBodies().size());
        if (!archive.expect(moving.size() == count && std::ranges::all_of(moving, is_moving),
                            kOtherBodies))
            return;
        world->list_moving(moving);
    }
    serialize_constraints(archive, scope);
    serialize_boxes(archive, *broadphase, in_world);
    if (archive.failed()) return;
    ContactArchive contacts(archive, *dispatcher, world->getDispatchInfo());
    if (small)
        serialize_small_pairs(archive, scope, contacts);
    else
        serialize_bullet_pairs(archive, scope, contacts);
    bool is_whole = !scope.keeps;
    archive(is_whole);
    if (is_whole) contacts.order();
    if (small && !archive.failed()) small->serialize(archive, scope);
}

/// Bullet's constraints in the order in which its solvers meet them.
void PhysicsWorld::Impl::serialize_constraints(Archive& archive, const BodyScope& scope) {
    if (!bullet_joints) return;
    std::map<const btTypedConstraint*, JointId> id_of;
    joints.each([&](JointId id, const std::unique_ptr<JointRecord>& joint) {
        if (joint->bullet) id_of[&joint->bullet->constraint()] = id;
    });
    std::vector<JointId> order;
    for (int i = 0; i < world->getNumConstraints(); ++i) {
        const JointId id = id_of.at(world->getConstraint(i));
        if (scope.holds(*joints.get(id))) order.push_back(id);
    }
    archive(order);
    for (const JointId id : order) {
        if (!archive.expect(joints.contains(id), "a constraint has no joint")) return;
        JointRecord& joint = *joints.get(id);
        if (archive.reads()) joint.bullet = std::make_unique<BulletJoint>(joint, *world);
        archive(joint.bullet->feedback());
    }
}

void PhysicsWorld::Impl::serialize_small_pairs(Archive& archive,
                                               const BodyScope& scope,
                                               ContactArchive& contacts) {
    auto& meetings = static_cast<PairDispatcher&>(*dispatcher);
    bodies.each([&](BodyId id, std::unique_ptr<BodyRecord>& record) {
        if (!scope.holds(id)) return;
        std::vector<BodyId> others;
        for (const PairLink& link : record->pairs) {
            if (id < link.other && scope.holds(link.other)) others.push_back(link.other);
        }
        archive(others);
        if (archive.reads()) {
            for (const BodyId other : others) {
                const auto* found = bodies.find(other);
                const bool is_pair = found != nullptr && (*found)->in_world && record->in_world;
                if (!archive.expect(is_pair, kOtherBodies)) return;
                add_pair(*pairs, *record, **found);
            }
        }
        for (const PairLink& link : record->pairs) {
            if (link.other < id || !scope.holds(link.other) || archive.failed()) continue;
            Pair& pair = *link.pair;
            archive(pair.reach_m, pair.touches);
            meetings.reach_m = pair.reach_m;
            contacts.small_pair(pair);
        }
    });
    // Last: pairs that are made anew have counted too.
    archive(meetings.manifolds_made);
}

void PhysicsWorld::Impl::serialize_bullet_pairs(Archive& archive,
                                                const BodyScope& scope,
                                                ContactArchive& contacts) {
    const auto end_of = [](const btBroadphaseProxy* proxy) {
        return &record_of(*static_cast<const btCollisionObject*>(proxy->m_clientObject));
    };
    std::vector<int> places;
    for (int i = 0; i < pairs->getNumOverlappingPairs(); ++i) {
        const btBroadphasePair& pair = pairs->getOverlappingPairArray()[i];
        if (scope.holds(end_of(pair.m_pProxy0)->id) && scope.holds(end_of(pair.m_pProxy1)->id))
            places.push_back(i);
    }
    const std::size_t count = archive.count(places.size());
    for (std::size_t i = 0; i < count && !archive.failed(); ++i) {
        const int at = archive.reads() ? static_cast<int>(i) : places[i];
        std::vector<BodyRecord*> ends;
        if (!archive.reads()) {
            const btBroadphasePair& pair = pairs->getOverlappingPairArray()[at];
            ends = {end_of(pair.m_pProxy0), end_of(pair.m_pProxy1)};
        }
        physics::serialize(archive, ends, scope);
        const bool is_pair = ends.size() == 2 && ends[0]->in_world && ends[1]->in_world;
        if (!archive.expect(is_pair, kOtherBodies)) return;
        if (archive.reads()) add_pair(*pairs, *ends[0], *ends[1]);
        if (!archive.expect(at < pairs->getNumOverlappingPairs(), kOtherBodies)) return;
        contacts.pair(
            pairs->getOverlappingPairArray()[at].m_algorithm, *ends[0]->rigid, *ends[1]->rigid);
    }
}

}  // namespace plumbline::physics
