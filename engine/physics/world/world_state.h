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
#include <string>
#include <vector>

namespace plumbline::physics {

struct PhysicsWorld::Impl {
    explicit Impl(const WorldDef& world_def);
    ~Impl();
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;

    BodyRecord& body(BodyId id);
    const BodyRecord& body(BodyId id) const;

    /// Adds the record's rigid body to Bullet's world with its filter.
    void enter_world(BodyRecord& record);
    /// Wakes what touches the body, then takes it out of Bullet's world.
    void leave_world(BodyRecord& record);
    void wake(BodyRecord& record);
    /// What touches the body or is joined to it.
    void wake_neighbours(const BodyRecord& record);
    void quarantine(BodyRecord& record);
    void poison(BodyRecord& record);
    void place(BodyRecord& record, const Transform& world_from_mass);
    Transform world_from_mass(const BodyRecord& record, const Pose& world_from_body) const;

    WorldDef def;
    WorldFeatures features{};
    std::unique_ptr<BulletEngine> engine;
    std::unique_ptr<SmallStepWorld> small;  ///< steps the world; none: Bullet does

    ShapeStore shapes;
    BodyMotions motions;  ///< outlive the bodies
    BodyTable bodies;
    JointTable joints;
    std::vector<BodyId> poisoned;  ///< to be taken out before the next step
    std::vector<BodyId> quarantined;
    std::vector<JointId> broken_joints;  ///< by the latest step
    bool bullet_joints{true};            ///< joints are Bullet's constraints, not an island's rows
    std::size_t event_bodies{0};         ///< how many bodies asked for contact events
    bool events_asleep{false};           ///< small_step: all that is listed sleeps
    bool slept_through{false};           ///< small_step: nothing moved in the latest step

    StepCost cost{};
    std::uint32_t limited_bodies{0};  ///< that the speed limit cut before the latest step
    FeatureUse use{};
    std::vector<ContactEvent> events;
    std::vector<ContactEvent> gathered;  ///< of the running step, not yet merged

    // --- rebuild.cpp
    void check_def() const;
    void build_engine();
    /// Takes bodies and joints out of Bullet's world, and that down.
    void take_engine_down();
    /// small_step: another rate, gravity or number of sub-steps; contacts go on.
    void change_rate(const WorldDef& changed);
    /// What the world's rate and gravity make of a body's numbers.
    void suit_to_world(BodyRecord& record) const;

    void advance_bullet(bool want_contacts);
    void advance_small(bool want_contacts);
    void prepare_bodies(Real step_s);
    void settle_bodies();
    template <class Fn>
    void each_moving(Fn&& fn);
    void gather_events(bool all, std::vector<ContactEvent>& out) const;
    void finish_events();
    bool sleeps_on(const ContactEvent& event) const;

    // --- joints.cpp
    /// Why there can be no such joint; empty: there can.
    std::string fault_of(const JointDef& joint) const;
    JointId add_joint(const JointDef& joint);
    void remove_joint(JointId id);
    void remove_joints_of(const BodyRecord& record);
    /// Ends what the joint does: it carries nothing any more and its bodies may touch.
    void detach_joint(JointRecord& joint);
    void wake_ends(const JointRecord& joint);
    /// Before the first substep: what a moving kinematic body holds wakes.
    void prepare_joints();
    /// After a substep: adds up what Bullet's joints carried.
    void gather_joint_loads(double substep_s);
    /// After the step: forces and errors of Bullet's joints; any joint that carried too much breaks.
    void settle_joints();
    double elastic_energy_J() const;
    /// The two do not touch while the joint holds.
    static void keep_apart(JointRecord& joint);

    // --- archive.cpp
    void abandon();
    void serialize_bodies(Archive& archive, const BodyScope& scope);
    void serialize_joints(Archive& archive, const BodyScope& scope);
};

}  // namespace plumbline::physics
