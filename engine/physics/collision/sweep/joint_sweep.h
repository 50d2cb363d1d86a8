// Continuous collision of jointed bodies: they stop together.
//
// A body stopped by itself in mid-step would be torn from its partners, by 2.5 m within a few steps of
// a train of boxes at 40 m/s. So all that joints hold together stops at the same moment, and members
// of such a group do not stop each other: where they meet is for their contacts to tell.
#pragma once

#include "engine/core/slot_map.h"
#include "engine/physics/dynamics/body_motion.h"
#include "engine/physics/world/joint_record.h"

#include <memory>
#include <vector>

namespace plumbline::physics {

class StepWorld;

class JointSweep {
public:
    using Joints = SlotMap<JointId, std::unique_ptr<JointRecord>>;

    explicit JointSweep(const Joints& joints) : joints_(joints) {}

    void begin_step();
    /// As stop_at_hit() of body_sweep.h; a body without joints stops alone.
    void stop_at_hit(const StepWorld& world, BodyRecord& record, Real duration_s);

private:
    std::vector<BodyRecord*>& group_of(BodyRecord& record, double step_s);

    const Joints& joints_;
    std::uint32_t groups_made_{0};                  ///< ever; numbers them
    std::uint32_t first_of_step_{1};                ///< number of this step's first
    std::vector<std::vector<BodyRecord*>> groups_;  ///< of this step, in order of their numbers
};

}  // namespace plumbline::physics
