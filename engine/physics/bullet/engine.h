// Bullet's world of one PhysicsWorld: made for a solver, taken down with it.
#pragma once

#include "engine/physics/bullet/body.h"
#include "engine/physics/collision/pair.h"
#include "engine/physics/physics_world.h"

#include <functional>
#include <memory>
#include <span>

namespace plumbline::physics {

class NearestPairs;
class StepWorld;

class BulletEngine {
public:
    /// Adds what it does to `report`, which outlives the engine.
    BulletEngine(const WorldDef& def, StepReport& report);
    ~BulletEngine();
    BulletEngine(const BulletEngine&) = delete;
    BulletEngine& operator=(const BulletEngine&) = delete;

    void add(BodyRecord& record);
    void remove(BodyRecord& record);
    /// The body has been moved by hand.
    void refresh_box(BodyRecord& record);
    /// The two may not touch any more: with the pair go its contact points.
    void forget_pair(const BodyRecord& a, const BodyRecord& b);
    /// The two may touch again. The broad phase looks for pairs only where boxes moved: what is near
    /// already must be told. It drops the pair again if the two are apart.
    void admit_pair(const BodyRecord& a, const BodyRecord& b);
    /// Those without points too, in an order that does not depend on addresses. bullet_*: copies,
    /// whose points tell the impulses of the latest substep.
    void each_manifold(const std::function<void(const Manifold&)>& visit) const;
    StepWorld& world() const;  ///< what casts and joints ask for

    // --- small_step
    void find_pairs();
    void set_box(const BodyRecord& record, const Box& box);
    void drop(Pair& pair);
    NearestPairs& nearest_pairs() const;

    // --- bullet_*
    /// `after_solve` is called in each substep, with the velocities before it in the records.
    void begin_step(const WorldFeatures& features, std::function<void()> after_solve);
    void advance(Real substep_s, bool last);
    /// Another of Bullet's solvers, another rate or gravity. Contacts stay, and go on carrying the same
    /// mean forces in substeps of another length.
    void change(const WorldDef& before, const WorldDef& after);
    /// Those that are not static, in the order of its lists, as they are when a step begins.
    void list_moving();
    std::span<BodyRecord* const> moving() const;

    struct Parts;
    Parts& parts() const { return *parts_; }

private:
    std::unique_ptr<Parts> parts_;
};

}  // namespace plumbline::physics
