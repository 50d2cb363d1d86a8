// small_step: which bodies steps move, and who wakes and falls asleep with whom.
#pragma once

#include "engine/physics/collision/pair.h"
#include "engine/physics/dynamics/island.h"
#include "engine/physics/world/body_scope.h"
#include "engine/physics/world/island_sleep.h"

#include <cstdint>
#include <span>
#include <vector>

namespace plumbline::physics {

/// Every order is one of ids.
class AwakeBodies {
public:
    /// The body has been added to Bullet's world. Dynamic ones are awake; others wake what sleeps
    /// where they appear.
    void enter(BodyRecord& record);
    /// The body is about to leave Bullet's world: what fell asleep with it wakes.
    void leave(BodyRecord& record);
    /// Wakes a dynamic body with all that fell asleep with it.
    void wake(BodyRecord& record);
    void wake_touching(const BodyRecord& record);
    /// Wakes what is where the body has been put.
    void wake_overlapping(const BodyRecord& record);
    /// A kinematic body may move in the next step.
    void wake_kinematic(BodyRecord& record);
    /// The boxes of all that are awake are too small or too large for steps to come.
    void make_boxes_stale();

    std::span<BodyRecord* const> dynamic() const { return awake_; }
    std::span<BodyRecord* const> kinematic() const { return kinematic_; }
    /// Woken since the latest admit_woken(); more may be added while they are walked.
    const std::vector<BodyRecord*>& woken() const { return woken_; }
    std::size_t count() const { return awake_.size() + woken_.size(); }
    /// Nothing moves.
    bool idle() const { return awake_.empty() && kinematic_.empty(); }

    /// Those that were woken stand among the others from now on. Whether there were any.
    bool admit_woken();
    /// Before a step: kinematic bodies that stand still go, what hangs on an awake body wakes, and all
    /// note how they moved before.
    void begin_step(const JointTable& joints);
    /// Lays the bodies of islands down. Contact points keep their impulses: a pile wakes as it fell
    /// asleep.
    void put_to_sleep(std::span<const Island* const> islands);

    void serialize(Archive& archive, const BodyScope& scope);

private:
    bool is_sound(const BodyScope& scope) const;
    void wake_one(BodyRecord& record);
    void wake_joined(const JointTable& joints);

    std::vector<BodyRecord*> awake_;      ///< dynamic, by id
    std::vector<BodyRecord*> woken_;      ///< dynamic, not yet among them
    std::vector<BodyRecord*> kinematic_;  ///< by id
    SleepingIslands sleeping_islands_;
};

}  // namespace plumbline::physics
