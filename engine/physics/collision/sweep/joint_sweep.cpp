#include "engine/physics/collision/sweep/joint_sweep.h"

#include "engine/physics/dynamics/body_sweep.h"
#include "engine/physics/world/body_record.h"

#include <algorithm>

namespace plumbline::physics {
namespace {

/// What an impulse at the anchor changes the anchor's velocity by, at most.
double inverse_mass_at(const BodyRecord& body, const Vec3d& anchor) {
    const Vec3& inverse = body.motion->inverse_moments;
    return static_cast<double>(body.motion->inverse_mass) +
           glm::dot(anchor, anchor) *
               static_cast<double>(std::max({inverse.x, inverse.y, inverse.z}));
}

/// Whether the joint holds its bodies so that one cannot stop without the other. A spring does that
/// swings them within the step: what stopping one stretches it by would be energy from nothing.
bool holds(const JointRecord& joint, double step_s) {
    if (joint.state.broken || joint.b == nullptr || !pushable(*joint.a) || !pushable(*joint.b))
        return false;
    const SolverJoint& spring = joint.solver;
    const bool coincide = spring.kind == JointKind::Elastic && !(spring.stiffness_Npm > 0);
    if (coincide || !is_elastic(spring)) return true;
    return static_cast<double>(spring.stiffness_Npm) * step_s * step_s *
               (inverse_mass_at(*joint.a, spring.anchor_in_a) +
                inverse_mass_at(*joint.b, spring.anchor_in_b)) >
           1;
}

}  // namespace

void JointSweep::begin_step() {
    first_of_step_ = groups_made_ + 1;
    groups_.clear();
}

std::vector<BodyRecord*>& JointSweep::group_of(BodyRecord& record, double step_s) {
    if (record.sweep.group >= first_of_step_) return groups_[record.sweep.group - first_of_step_];
    std::vector<BodyRecord*>& group = groups_.emplace_back();
    const std::uint32_t number = ++groups_made_;
    record.sweep.group = number;
    group.push_back(&record);
    for (std::size_t next = 0; next < group.size(); ++next) {
        for (const JointId id : group[next]->joints) {
            const JointRecord& joint = *joints_.get(id);
            if (!holds(joint, step_s)) continue;
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
    const std::vector<BodyRecord*>& group = group_of(record, static_cast<double>(duration_s));
    const Impact impact = first_impact(world, record, record.sweep.group);
    if (impact.share >= 1) return;
    for (BodyRecord* member : group) stop_at_share(*member, static_cast<Real>(impact.share));
}

}  // namespace plumbline::physics
