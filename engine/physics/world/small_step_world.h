// One step around the island solver: who is awake, what touches what, who moves how, who falls
// asleep.
//
// Bullet finds overlapping boxes and contact points; nothing else of it runs. A step visits awake
// bodies, moving kinematic ones and their pairs only: what sleeps costs nothing. Every order is one
// of ids.
#pragma once

#include "engine/core/time/stopwatch.h"
#include "engine/physics/bullet/engine.h"
#include "engine/physics/collision/sweep/joint_sweep.h"
#include "engine/physics/dynamics/island_team.h"
#include "engine/physics/dynamics/islands.h"
#include "engine/physics/world/awake_bodies.h"
#include "engine/physics/world/pair_walk.h"

#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace plumbline::physics {

/// What the step works on; all of it outlives the step.
struct SmallStepParts {
    const WorldDef& def;
    BulletEngine& engine;  ///< holds the bodies
    const BodyTable& bodies;
    const JointTable& joints;
    StepReport& report;  ///< added to
};

class SmallStepWorld {
public:
    explicit SmallStepWorld(const SmallStepParts& parts);

    /// The definition's rate and gravity have changed.
    void take_rate();
    /// Lists who moves; then forces and kinematic velocities are prepared.
    void begin_step();
    void step(const WorldFeatures& wanted, std::span<ForceField* const> fields, bool want_contacts);
    /// Who is awake, who sleeps with whom.
    void serialize(Archive& archive, const BodyScope& scope);
    /// Manifolds that had points in the latest step.
    std::span<Manifold* const> touching() const { return touching_; }

    AwakeBodies bodies;
    std::function<void()> after_solve;  ///< velocities before are in the records

private:
    void find_pairs();
    void find_points(Team* team);
    bool find_turning(const WorldFeatures& features);
    void list_islands(const WorldFeatures& features, std::span<ForceField* const> fields);
    void refresh_boxes();
    void refresh_box(BodyRecord& record);
    FieldTies ties_of(std::span<ForceField* const> fields);
    void solve_islands(const WorldFeatures& features,
                       std::span<ForceField* const> fields,
                       Team* team);
    void move(const WorldFeatures& wanted,
              std::span<ForceField* const> fields,
              bool want_contacts,
              Team* team);
    void look_ahead(const WorldFeatures& features);
    void move_free_bodies(const WorldFeatures& features);
    void stop_swept_bodies(std::span<BodyRecord* const> moved);
    void put_to_sleep(std::span<const Island> islands);

    SmallStepParts parts_;
    StepReport& report_;
    std::unique_ptr<Team> team_;  ///< of more than one thread
    PairWalk pairs_;
    JointSweep sweep_;
    IslandBuilder builder_;
    IslandTeam islands_;
    LapTimer laps_;
    double gravity_mps2_{0};
    Real step_s_{0};
    Real drop_m_{0};  ///< what gravity adds to any motion within the step, at most

    std::vector<Manifold*> touching_;
    std::vector<JointRecord*> joined_;
    std::vector<SweptPath> ahead_;
    std::vector<ForceField::Pair> field_pairs_;
    std::vector<std::pair<BodyRecord*, BodyRecord*>> tied_;
    std::vector<BodyRecord*> turning_;
    std::vector<const Island*> resting_;
};

}  // namespace plumbline::physics
