#include "engine/physics/world/awake_bodies.h"

#include "engine/physics/bullet/body.h"
#include "engine/physics/bullet/contact/pair_boxes.h"
#include "engine/physics/world/body_record.h"
#include "engine/physics/world/joint_record.h"

#include <algorithm>

namespace plumbline::physics {

void AwakeBodies::enter(BodyRecord& record) {
    record.small.awake = false;
    record.small.sleeping_island = 0;
    record.sweep.group = 0;
    if (pushable(record)) {
        wake_one(record);
        return;
    }
    set_activity(record, Activity::Asleep);
    wake_overlapping(record);
}

void AwakeBodies::leave(BodyRecord& record) {
    if (record.small.sleeping_island != 0) wake(record);
    record.small.awake = false;
    std::erase(awake_, &record);
    std::erase(woken_, &record);
    std::erase(kinematic_, &record);
}

void AwakeBodies::wake(BodyRecord& record) {
    if (!pushable(record)) return;
    record.small.box_stale = true;
    break_rest(record);
    if (record.small.awake) return;
    if (record.small.sleeping_island == 0) return wake_one(record);
    for (BodyRecord* sleeper : sleeping_islands_.end(record.small.sleeping_island))
        wake_one(*sleeper);
}

void AwakeBodies::wake_one(BodyRecord& record) {
    record.small.awake = true;
    record.small.sleeping_island = 0;
    record.small.box_stale = true;
    break_rest(record);
    note_before(record);
    set_activity(record, Activity::Awake);
    woken_.push_back(&record);
}

void AwakeBodies::wake_touching(const BodyRecord& record) {
    for (const PairLink& link : record.small.pairs) {
        if (link.pair->touches) wake(partner(*link.pair, record));
    }
}

void AwakeBodies::wake_overlapping(const BodyRecord& record) {
    for (const PairLink& link : record.small.pairs) {
        BodyRecord& other = partner(*link.pair, record);
        if (sleeps(other) && boxes_overlap(*link.pair)) wake(other);
    }
}

void AwakeBodies::wake_kinematic(BodyRecord& record) {
    if (record.small.awake) return;
    record.small.awake = true;
    kinematic_.insert(std::upper_bound(kinematic_.begin(), kinematic_.end(), &record, by_id),
                      &record);
}

void AwakeBodies::make_boxes_stale() {
    for (const auto* list : {&awake_, &woken_}) {
        for (BodyRecord* record : *list) record->small.box_stale = true;
    }
}

bool AwakeBodies::admit_woken() {
    if (woken_.empty()) return false;
    std::sort(woken_.begin(), woken_.end(), by_id);
    const auto old_count = static_cast<std::ptrdiff_t>(awake_.size());
    awake_.insert(awake_.end(), woken_.begin(), woken_.end());
    std::inplace_merge(awake_.begin(), awake_.begin() + old_count, awake_.end(), by_id);
    woken_.clear();
    return true;
}

void AwakeBodies::begin_step(const JointTable& joints) {
    std::erase_if(kinematic_, [](BodyRecord* record) {
        record->small.awake = is_active(*record);
        if (!record->small.awake) note_before(*record);
        return !record->small.awake;
    });
    wake_joined(joints);
    admit_woken();
    for (BodyRecord* record : awake_) note_before(*record);
    for (BodyRecord* record : kinematic_) note_before(*record);
}

/// A joint holds what sleeps and what does not only if it is new or its body was put back.
void AwakeBodies::wake_joined(const JointTable& joints) {
    for (BodyRecord* record : awake_) {
        for (const JointId id : record->joints) {
            const JointRecord& joint = *joints.get(id);
            if (joint.state.broken || joint.b == nullptr) continue;
            BodyRecord& other = joint.a == record ? *joint.b : *joint.a;
            if (sleeps(other)) wake(other);
        }
    }
}

void AwakeBodies::put_to_sleep(std::span<const Island* const> islands) {
    if (islands.empty()) return;
    for (const Island* island : islands) {
        const std::uint32_t sleeping_island = sleeping_islands_.add(island->bodies);
        for (BodyRecord* record : island->bodies) {
            stand_still(*record);
            clear_forces(*record);
            note_before(*record);
            record->small.awake = false;
            record->small.sleeping_island = sleeping_island;
            set_activity(*record, Activity::Asleep);
        }
    }
    std::erase_if(awake_, [](const BodyRecord* record) { return !record->small.awake; });
}

void AwakeBodies::serialize(Archive& archive, const BodyScope& scope) {
    for (std::vector<BodyRecord*>* list : {&awake_, &woken_, &kinematic_})
        physics::serialize(archive, *list, scope);
    sleeping_islands_.serialize(archive, scope);
    archive.expect(!archive.reads() || is_sound(scope), "who sleeps and who is awake do not agree");
}

/// Whether each body is where its own record says, once.
bool AwakeBodies::is_sound(const BodyScope& scope) const {
    const auto is_awake = [](const BodyRecord* record) {
        return pushable(*record) && record->small.awake;
    };
    const auto drives = [](const BodyRecord* record) {
        return record->kind == BodyKind::Kinematic && record->in_world && record->small.awake;
    };
    const auto rises = [](const std::vector<BodyRecord*>& list) {
        return std::ranges::adjacent_find(list, [](const BodyRecord* a, const BodyRecord* b) {
                   return !by_id(a, b);
               }) == list.end();
    };
    if (!rises(awake_) || !rises(kinematic_) || !std::ranges::all_of(awake_, is_awake) ||
        !std::ranges::all_of(woken_, is_awake) || !std::ranges::all_of(kinematic_, drives))
        return false;
    std::vector<const BodyRecord*> all(awake_.begin(), awake_.end());
    all.insert(all.end(), woken_.begin(), woken_.end());
    all.insert(all.end(), kinematic_.begin(), kinematic_.end());
    std::ranges::sort(all, by_id);
    std::size_t awake = 0;
    std::size_t asleep = 0;
    scope.bodies.each([&](BodyId, const std::unique_ptr<BodyRecord>& record) {
        awake += record->small.awake ? 1U : 0U;
        asleep += record->small.sleeping_island != 0 ? 1U : 0U;
    });
    return std::ranges::adjacent_find(all) == all.end() && all.size() == awake &&
           sleeping_islands_.count() == asleep;
}

}  // namespace plumbline::physics
