// What stands behind PhysicsWorld: the tables from ids to bodies, shapes and joints.
#pragma once

#include "engine/physics/bullet/engine.h"
#include "engine/physics/bullet/shape/shape_store.h"
#include "engine/physics/physics_world.h"
#include "engine/physics/world/body_motions.h"
#include "engine/physics/world/body_record.h"
#include "engine/physics/world/body_scope.h"
#include "engine/physics/world/joint_record.h"
#include "engine/physics/world/small_step_world.h"

#include <memory>
#include <span>
#include <vector>

namespace plumbline::physics {

struct WorldState {
    explicit WorldState(const WorldDef& world_def);
    ~WorldState();
    WorldState(const WorldState&) = delete;
    WorldState& operator=(const WorldState&) = delete;

    BodyRecord& body(BodyId id) const;

    /// Adds the record's rigid body to Bullet's world with its filter.
    void enter_world(BodyRecord& record);
    /// Wakes what touches the body, then takes it out of Bullet's world.
    void leave_world(BodyRecord& record);
    void wake(BodyRecord& record);
    /// What touches the body or is joined to it.
    void wake_neighbours(const BodyRecord& record);
    void wake_ends(const JointRecord& joint);
    /// Takes the body out of the simulation for good.
    void isolate(BodyRecord& record);
    /// A dynamic body has got a number that is not finite.
    void mark_invalid(BodyRecord& record);
    void place(BodyRecord& record, const Transform& world_from_mass);
    void remove_joint(JointId id);

    /// An empty engine for the definition, which is the world's from now on.
    void build_engine(const WorldDef& world_def);
    /// Takes bodies and joints out of Bullet's world, and that down.
    void take_engine_down();

    WorldDef def;
    WorldFeatures features{};
    std::unique_ptr<BulletEngine> engine;
    std::unique_ptr<SmallStepWorld>
        small;  ///< steps the world; none: Bullet does, and holds joints

    ShapeStore shapes;
    BodyMotions motions;  ///< outlive the bodies
    BodyTable bodies;
    JointTable joints;
    std::vector<BodyId> invalid;  ///< to be isolated before the next step
    std::size_t event_bodies{0};  ///< how many bodies asked for contact events
    bool events_asleep{false};    ///< small_step: all that is listed sleeps
    bool slept_through{false};    ///< small_step: nothing moved in the latest step

    StepReport report{};
    std::vector<ContactEvent> gathered;  ///< of the running step, not yet merged
};

/// For the functions of query.h, totals.h and debug_lines.h.
const WorldState& internals(const PhysicsWorld& world);

/// What the rate and gravity of a world make of a body's numbers.
void suit_to_world(const WorldDef& def, BodyRecord& record);
/// Where the body's mass frame is when its origin is there.
Transform world_from_mass(const BodyRecord& record, const Pose& world_from_body);

// --- events.cpp
/// Adds a line for each manifold that touches: of the bodies that asked for events, or of all.
void gather_events(const WorldState& world, bool all, std::vector<ContactEvent>& out);
/// A step's lines, one a pair, in the order of ids. With small_step pairs of the step `before` that
/// sleep go on touching as they did.
std::vector<ContactEvent> finished_events(const WorldState& world,
                                          std::vector<ContactEvent> gathered,
                                          std::vector<ContactEvent> before);

// --- joints.cpp
/// What is wrong with a joint that somebody asks for, between bodies as they are; empty: nothing.
std::string fault_of(const JointDef& joint, const BodyTable& bodies);
/// By which the solver knows a joint again.
constexpr std::uint64_t key_of(JointId id) {
    return (std::uint64_t{id.index} << 32U) | id.generation;
}
/// The two do not touch while the joint holds.
void exclude_collision(JointRecord& joint);
/// Before the first substep: what a moving kinematic body holds wakes.
void prepare_joints(WorldState& world);
/// After a substep: adds up what Bullet's joints carried.
void gather_joint_loads(JointTable& joints, double substep_s);
/// After the step: forces and errors of Bullet's joints. Those that carried too much break: they carry
/// nothing any more, and their bodies may touch.
void settle_joints(WorldState& world);
/// Joints that broke in the step before carry nothing in this one.
void unload_broken_joints(WorldState& world);
double elastic_energy_J(const JointTable& joints);

}  // namespace plumbline::physics
