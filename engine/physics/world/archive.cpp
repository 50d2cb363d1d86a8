// Everything that decides how bodies and joints go on, as fields of an archive.
#include "engine/physics/bullet/archive/engine_archive.h"
#include "engine/physics/world/archive_fields.h"
#include "engine/physics/world/restored.h"
#include "engine/physics/world/world_state.h"

#include <algorithm>
#include <limits>

namespace plumbline::physics {
namespace {

constexpr int kPossibleSubsteps = 1'000;

bool is_possible(const WorldDef& def) {
    return def.step_s > 0 && def.step_s <= 1 && def.substeps >= 1 &&
           def.substeps <= kPossibleSubsteps && def.substeps_max <= kPossibleSubsteps &&
           def.iterations >= 1 && def.iterations <= 10'000;
}

void serialize_body(Archive& archive, BodyRecord& record) {
    archive(record.contact_events,
            record.frozen,
            record.in_world,
            record.invalid,
            record.drive.has_target,
            record.drive.driven,
            record.applied.by_caller,
            record.small.awake,
            record.small.box_stale);
    archive.within(record.small.substeps, 0, kPossibleSubsteps);
    archive.within(record.small.substeps_held, 0, std::numeric_limits<int>::max());
    archive(record.small.sleeping_island,
            record.joints,
            record.small.rest,
            record.drive.target,
            record.before.at,
            record.before.velocity_mps,
            record.before.spin_radps,
            record.motion->ballistic,
            record.motion->at,
            record.motion->velocity_mps,
            record.motion->spin_radps,
            record.applied.force_N,
            record.applied.torque_Nm);
}

/// After a fault: bodies without a world, which can only be taken down.
void abandon(WorldState& world) {
    if (world.engine) world.take_engine_down();
    world.bodies.each([](BodyId, std::unique_ptr<BodyRecord>& record) {
        record->in_world = record->small.awake = false;
        record->small.sleeping_island = 0;
        record->joints.clear();
        record->excluded.clear();
        record->small.pairs.clear();
    });
    world.joints = {};
    world.invalid.clear();
    world.report.isolated.clear();
    world.report.broken_joints.clear();
    world.build_engine(world.def);
}

void serialize_bodies(Archive& archive, const BodyScope& scope, WorldState& world) {
    if (archive.reads()) world.event_bodies = 0;
    world.bodies.each([&](BodyId id, std::unique_ptr<BodyRecord>& record) {
        if (!scope.holds(id)) return;
        const bool was_frozen = record->frozen;
        serialize_body(archive, *record);
        if (archive.reads()) {
            if (record->contact_events) ++world.event_bodies;
            if (was_frozen != record->frozen) set_rigid_mass(*record, record->frozen);
            record->excluded.clear();
            record->sweep.group = 0;
        }
        serialize_rigid(archive, *record);
    });
}

void serialize_joints(Archive& archive, const BodyScope& scope, JointTable& joints) {
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
    bool is_whole = scope.is_whole();
    archive(is_whole);
    if (is_whole) joints.serialize_slots(archive);
    joints.each([&](JointId id, std::unique_ptr<JointRecord>& record) {
        JointRecord& joint = *record;
        if (!archive.reads() && !scope.holds(joint)) return;
        archive(joint.def, joint.solver, joint.state);
        if (!archive.reads() || archive.failed()) return;
        const auto* a = scope.bodies.find(joint.def.a);
        const auto* b = scope.bodies.find(joint.def.b);
        if (!archive.expect(a != nullptr && (b != nullptr || !joint.def.b), kOtherBodies)) return;
        joint.id = id;
        joint.a = a->get();
        joint.b = b != nullptr ? b->get() : nullptr;
        if (!joint.state.broken) exclude_collision(joint);
    });
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
    WorldState& world = *state_;
    const BodyScope scope{world.bodies, keeps};
    WorldDef def = world.def;
    bool is_whole = scope.is_whole();
    archive(def, is_whole);
    std::vector<BodyId> ids;
    world.bodies.each([&](BodyId id, const std::unique_ptr<BodyRecord>&) {
        if (scope.holds(id)) ids.push_back(id);
    });
    std::vector<BodyId> saved = ids;
    archive(saved);
    if (!archive.expect(is_possible(def), "no world steps like that")) return;
    if (!archive.expect(saved == ids, kOtherBodies)) return;
    if (is_whole) world.bodies.serialize_slots(archive);
    if (archive.failed()) return;
    if (archive.reads()) world.take_engine_down();
    serialize_bodies(archive, scope, world);
    serialize_joints(archive, scope, world.joints);
    if (archive.reads() && !archive.failed()) {
        if (const std::string fault = fault_of_restored(world); !fault.empty()) archive.fail(fault);
    }
    if (archive.reads() && !archive.failed()) {
        world.build_engine(def);
        world.bodies.each(
            [&](BodyId, std::unique_ptr<BodyRecord>& record) { suit_to_world(def, *record); });
    }
    if (!archive.failed()) physics::serialize_engine(archive, *world.engine, scope, world.joints);
    if (world.small && !archive.failed()) world.small->serialize(archive, scope);
    if (is_whole && !archive.failed()) {
        archive(world.invalid,
                world.report.isolated,
                world.report.broken_joints,
                world.report.contacts,
                world.events_asleep,
                world.slept_through);
        archive.expect(std::ranges::all_of(world.report.broken_joints,
                                           [&](JointId id) { return world.joints.contains(id); }),
                       "a joint that broke is not there");
    }
    if (archive.reads() && archive.failed()) abandon(world);
}

}  // namespace plumbline::physics
