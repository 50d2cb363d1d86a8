#include "engine/physics/collision/sweep/joint_sweep.h"

#include "engine/physics/dynamics/body_motion.h"
#include "engine/physics/world/body_record.h"

#include <algorithm>

namespace plumbline::physics {
namespace {

/// Whether the joint holds its bodies so that one cannot stop without the other.
bool holds(const JointRecord& joint) {
    return !joint.state.broken && joint.def.kind != JointKind::Spring && joint.b != nullptr &&
           pushable(*joint.a) && pushable(*joint.b);
}

}  // namespace

void JointSweep::begin_step() {
    first_of_step_ = groups_made_ + 1;
    groups_.clear();
}

std::vector<BodyRecord*>& JointSweep::group_of(BodyRecord& record) {
    if (record.sweep.group >= first_of_step_) return groups_[record.sweep.group - first_of_step_];
    std::vector<BodyRecord*>& group = groups_.emplace_back();
    const std::uint32_t number = ++groups_made_;
    record.sweep.group = number;
    group.push_back(&record);
    for (std::size_t next = 0; next < group.size(); ++next) {
        for (const JointId id : group[next]->joints) {
            const JointRecord& joint = *joints_.get(id);
            if (!holds(joint)) continue;
            BodyRecord& other = joint.a == group[next] ? *joint.b : *joint.a;
            if (other.sweep.group == number) continue;
            other.sweep.group = number;
            group.push_back(&other);
        }
    }
    return group;
}

void JointSweep::stop_at_hit(const StepWorld& world, BodyRecord& record, Real duration_s) {
    if (record.joints.empty()) {
        record.sweep.group = 0;
        physics::stop_at_hit(world, record, duration_s);
        return;
    }
    const std::vector<BodyRecord*>& group = group_of(record);
    const Real share = swept_fraction(world, record, record.sweep.group).share;
    if (share >= 1) return;
    for (BodyRecord* member : group) stop_part_way(*member, share);
}

}  // namespace plumbline::physics
