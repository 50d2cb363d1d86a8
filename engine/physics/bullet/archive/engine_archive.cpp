#include "engine/physics/bullet/archive/engine_archive.h"

#include "engine/physics/bullet/archive/box_archive.h"
#include "engine/physics/bullet/archive/bullet_fields.h"
#include "engine/physics/bullet/archive/contact_archive.h"
#include "engine/physics/bullet/engine_parts.h"
#include "engine/physics/bullet/joints.h"
#include "engine/physics/bullet/rigid_body.h"
#include "engine/physics/collision/manifold_archive.h"
#include "engine/physics/world/body_record.h"
#include "engine/physics/world/joint_record.h"

#include <algorithm>
#include <utility>

namespace plumbline::physics {
namespace {

std::vector<BodyRecord*> records_of(const btCollisionObjectArray& objects) {
    std::vector<BodyRecord*> records;
    for (int i = 0; i < objects.size(); ++i) records.push_back(&record_of(*objects[i]));
    return records;
}

/// The boxes of two bodies overlap again, as far as the pairs know.
void add_pair(btOverlappingPairCache& pairs, const BodyRecord& a, const BodyRecord& b) {
    pairs.addOverlappingPair(a.rigid->getBroadphaseHandle(), b.rigid->getBroadphaseHandle());
}

/// Who is in Bullet's world, in the order of its lists.
std::vector<BodyRecord*> serialize_lists(Archive& archive,
                                         BulletEngine::Parts& parts,
                                         const BodyScope& scope) {
    StepWorld& world = *parts.world;
    std::vector<BodyRecord*> in_world = records_of(world.getCollisionObjectArray());
    std::erase_if(in_world, [&](const BodyRecord* record) { return !scope.holds(record->id); });
    std::vector<BodyRecord*> moving;
    const auto& listed = world.getNonStaticRigidBodies();
    for (int i = 0; i < listed.size(); ++i) moving.push_back(&record_of(*listed[i]));
    serialize(archive, in_world, scope);
    serialize(archive, moving, scope);
    if (!archive.reads() || archive.failed()) return in_world;
    scope.bodies.each(
        [](BodyId, const std::unique_ptr<BodyRecord>& record) { record->in_world = false; });
    parts.broadphase->m_deferedcollide = true;  // pairs come from the archive
    for (BodyRecord* record : in_world) {
        if (!archive.expect(!std::exchange(record->in_world, true), kOtherBodies)) return in_world;
        world.addRigidBody(record->rigid.get(), -1, -1);
    }
    parts.broadphase->m_deferedcollide = false;
    const auto is_moving = [](const BodyRecord* record) {
        return record->in_world && !record->rigid->isStaticObject();
    };
    const auto count = static_cast<std::size_t>(world.getNonStaticRigidBodies().size());
    std::vector<BodyRecord*> sorted = moving;
    std::ranges::sort(sorted, by_id);
    const bool each_once = std::ranges::adjacent_find(sorted) == sorted.end();
    if (archive.expect(
            moving.size() == count && each_once && std::ranges::all_of(moving, is_moving),
            kOtherBodies))
        world.list_moving(moving);
    return in_world;
}

/// Bullet's constraints in the order in which its solvers meet them.
void serialize_constraints(Archive& archive,
                           StepWorld& world,
                           const BodyScope& scope,
                           const JointTable& joints) {
    std::vector<JointId> order;
    for (int i = 0; i < world.getNumConstraints(); ++i) {
        const JointRecord& joint = joint_of(*world.getConstraint(i));
        if (scope.holds(joint)) order.push_back(joint.id);
    }
    archive(order);
    for (const JointId id : order) {
        const auto* found = joints.find(id);
        const bool holds = found != nullptr && !(*found)->state.broken &&
                           (!archive.reads() || (*found)->bullet == nullptr);
        if (!archive.expect(holds, "a constraint has no joint")) return;
        JointRecord& joint = **found;
        if (archive.reads()) joint.bullet = std::make_unique<BulletJoint>(joint, world);
        archive(*joint.bullet);
    }
}

void serialize_small_pairs(Archive& archive, BulletEngine::Parts& parts, const BodyScope& scope) {
    scope.bodies.each([&](BodyId id, const std::unique_ptr<BodyRecord>& record) {
        if (!scope.holds(id)) return;
        std::vector<BodyId> others;
        for (const PairLink& link : record->small.pairs) {
            if (id < link.other && scope.holds(link.other)) others.push_back(link.other);
        }
        archive(others);
        if (archive.reads()) {
            for (const BodyId other : others) {
                const auto* found = scope.bodies.find(other);
                const bool is_pair = found != nullptr && (*found)->in_world && record->in_world;
                if (!archive.expect(is_pair, kOtherBodies)) return;
                add_pair(*parts.pairs, *record, **found);
            }
        }
        const auto is_meant = [&](const PairLink& link) {
            return id < link.other && scope.holds(link.other);
        };
        const auto made =
            static_cast<std::size_t>(std::ranges::count_if(record->small.pairs, is_meant));
        if (!archive.expect(made == others.size(), kOtherBodies)) return;
        for (const PairLink& link : record->small.pairs) {
            if (!is_meant(link) || archive.failed()) continue;
            serialize_pair(archive, *link.pair);
        }
    });
}

void serialize_bullet_pairs(Archive& archive,
                            btOverlappingPairCache& pairs,
                            const BodyScope& scope,
                            ContactArchive& contacts) {
    const auto end_of = [](const btBroadphaseProxy* proxy) {
        return &record_of(*static_cast<const btCollisionObject*>(proxy->m_clientObject));
    };
    std::vector<int> places;
    for (int i = 0; i < pairs.getNumOverlappingPairs(); ++i) {
        const btBroadphasePair& pair = pairs.getOverlappingPairArray()[i];
        if (scope.holds(end_of(pair.m_pProxy0)->id) && scope.holds(end_of(pair.m_pProxy1)->id))
            places.push_back(i);
    }
    const std::size_t count = archive.count(places.size());
    for (std::size_t i = 0; i < count && !archive.failed(); ++i) {
        const int at = archive.reads() ? static_cast<int>(i) : places[i];
        std::vector<BodyRecord*> ends;
        if (!archive.reads()) {
            const btBroadphasePair& pair = pairs.getOverlappingPairArray()[at];
            ends = {end_of(pair.m_pProxy0), end_of(pair.m_pProxy1)};
        }
        serialize(archive, ends, scope);
        const bool is_pair = ends.size() == 2 && ends[0]->in_world && ends[1]->in_world;
        if (!archive.expect(is_pair, kOtherBodies)) return;
        if (archive.reads()) add_pair(pairs, *ends[0], *ends[1]);
        if (!archive.expect(at < pairs.getNumOverlappingPairs(), kOtherBodies)) return;
        contacts.pair(
            pairs.getOverlappingPairArray()[at].m_algorithm, *ends[0]->rigid, *ends[1]->rigid);
    }
}

}  // namespace

void serialize_rigid(Archive& archive, BodyRecord& record) {
    btRigidBody& rigid = *record.rigid;
    btScalar idle_s = rigid.getDeactivationTime();
    int activation = rigid.getActivationState();
    archive(idle_s);
    archive.within(activation, ACTIVE_TAG, DISABLE_SIMULATION);
    if (!archive.reads()) return;
    write_rigid_motion(record);
    rigid.setDeactivationTime(idle_s);
    rigid.forceActivationState(activation);
}

void serialize_engine(Archive& archive,
                      BulletEngine& engine,
                      const BodyScope& scope,
                      const JointTable& joints) {
    BulletEngine::Parts& parts = engine.parts();
    const bool is_small = parts.own_pairs != nullptr;
    const std::vector<BodyRecord*> in_world = serialize_lists(archive, parts, scope);
    if (archive.failed()) return;
    if (!is_small) serialize_constraints(archive, *parts.world, scope, joints);
    serialize_boxes(archive, *parts.broadphase, in_world);
    if (archive.failed()) return;
    ContactArchive contacts(archive, *parts.dispatcher, parts.world->getDispatchInfo());
    parts.pair_filter->takes_crowds = true;  // those of crowds have been chosen
    if (is_small)
        serialize_small_pairs(archive, parts, scope);
    else
        serialize_bullet_pairs(archive, *parts.pairs, scope, contacts);
    parts.pair_filter->takes_crowds = false;
    scope.bodies.each([&](BodyId id, const std::unique_ptr<BodyRecord>& record) {
        if (!scope.holds(id)) return;
        bool is_crowded = record->crowd != nullptr;
        archive(is_crowded);
        if (!archive.reads()) return;
        record->crowd = is_crowded ? std::make_unique<Crowd>() : nullptr;
        parts.pair_filter->has_crowds |= is_crowded;
    });
    bool is_whole = scope.is_whole();
    archive(is_whole);
    if (is_whole) contacts.order();
}

}  // namespace plumbline::physics
