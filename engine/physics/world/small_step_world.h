// One step around the island solver: who is awake, what touches what, who moves how, who falls
// asleep.
//
// Bullet finds overlapping boxes and contact points; nothing else of it runs. A step looks at awake
// bodies, moving kinematic ones and their pairs only: what sleeps costs nothing. Every order is one
// of ids.
#pragma once

#include "engine/core/slot_map.h"
#include "engine/core/time/stopwatch.h"
#include "engine/physics/bullet/contact/pair_collider.h"
#include "engine/physics/bullet/engine.h"
#include "engine/physics/collision/sweep/joint_sweep.h"
#include "engine/physics/dynamics/islands.h"
#include "engine/physics/world/island_sleep.h"

#include <functional>
#include <span>
#include <vector>

namespace plumbline::physics {

/// What the step works on; all of it outlives the step.
struct SmallStepParts {
    const WorldDef& def;
    BulletEngine& engine;  ///< holds the bodies
    const SlotMap<JointId, std::unique_ptr<JointRecord>>& joints;
};

class SmallStepWorld {
public:
    explicit SmallStepWorld(const SmallStepParts& parts);

    // --- bookkeeping between steps
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
    /// The definition's rate and gravity have changed.
    void take_rate();
    std::size_t awake_count() const { return awake_.size() + fresh_.size(); }

    // --- the step
    /// Lists who moves; then forces and kinematic velocities are prepared.
    void begin_step();
    std::span<BodyRecord* const> awake() const { return awake_; }
    std::span<BodyRecord* const> kinematic_bodies() const {
        return kinematic_;
    }  ///< kinematic ones
    /// Nothing moves.
    bool idle() const { return awake_.empty() && kinematic_.empty(); }
    void step(const WorldFeatures& features, bool want_contacts);
    /// Who is awake, who sleeps with whom.
    void serialize(Archive& archive, const BodyScope& scope);
    /// Manifolds that had points in the latest step.
    std::span<Manifold* const> touching() const { return touching_; }

    StepCost cost{};
    FeatureUse use{};
    std::vector<IslandReport> reports;  ///< of the latest step
    std::function<void()> after_solve;  ///< velocities before are in the records

private:
    void wake_one(BodyRecord& record);
    void admit_fresh();
    void drop_still_kinematic_bodies();
    void remember();
    void wake_joined();

    void refresh_stale_boxes();
    void refresh_box(BodyRecord& record);

    void collide_pairs();
    void look_at(BodyRecord& body);
    void look(Pair& pair);
    void note_impact(BodyRecord& record, const PredictedChange& impact);
    bool spread_impacts();
    void list_touching();
    void list_joints();

    void solve_islands();
    void move_free_bodies();
    void move_kinematic_bodies();
    void show_poses();
    void stop_swept_bodies();
    void put_to_sleep();
    void lay_down(const Island& island);

    SmallStepParts parts_;
    JointSweep sweep_;
    PairCollider collider_;
    IslandBuilder builder_;
    IslandSolver solver_;
    SleepingIslands sleeping_islands_;
    LapTimer laps_;
    WorldFeatures features_{};
    double gravity_mps2_{0};
    Real step_s_{0};

    std::vector<BodyRecord*> awake_;      ///< dynamic, by id
    std::vector<BodyRecord*> fresh_;      ///< dynamic, woken since the list was made
    std::vector<BodyRecord*> kinematic_;  ///< kinematic, by id

    std::uint32_t walk_{0};  ///< numbers the walks over pairs
    bool met_in_order_{true};
    std::vector<Pair*> met_;  ///< with points
    std::vector<BodyRecord*> struck_;
    std::vector<BodyRecord*> spreading_;
    std::vector<Manifold*> touching_;
    std::vector<JointRecord*> joined_;
    std::vector<BodyRecord*> turning_;
};

}  // namespace plumbline::physics
