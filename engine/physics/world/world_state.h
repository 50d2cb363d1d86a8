// What stands behind PhysicsWorld: Bullet's objects and the tables from ids to them.
#pragma once

#include "engine/core/slot_map.h"
#include "engine/physics/bullet/box_contacts.h"
#include "engine/physics/bullet/mesh_contact.h"
#include "engine/physics/bullet/pair_list.h"
#include "engine/physics/bullet/step_world.h"
#include "engine/physics/dynamics/mass.h"
#include "engine/physics/physics_world.h"
#include "engine/physics/world/island_sleep.h"
#include "engine/physics/world/joint_record.h"

#include <BulletDynamics/MLCPSolvers/btMLCPSolverInterface.h>
#include <btBulletDynamicsCommon.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

class btTriangleIndexVertexArray;
struct btTriangleInfoMap;

namespace plumbline::physics {

/// Faster is never simulated: a wall at 60 Hz would be 170 m away when the body is next looked at.
inline constexpr Real kMaxSpeed_mps = 1e4_r;
inline constexpr Real kMaxSpin_radps = 1e4_r;
/// Beyond it a body is taken out: float32 places it no better than to 6 cm there.
inline constexpr Real kMaxDistance_m = 1e6_r;

/// A ball inside a shape; continuous collision sweeps these.
struct Core {
    Vec3 center_m{0, 0, 0};  ///< mass frame
    Real radius_m{0};
};

/// Triangles as Bullet reads them; it keeps pointers into these.
struct TriangleStore {
    std::vector<btScalar> coordinates;
    std::vector<int> indices;
    std::unique_ptr<btTriangleIndexVertexArray> view;
    std::unique_ptr<btTriangleInfoMap> edges;

    TriangleStore();
    ~TriangleStore();
    TriangleStore(const TriangleStore&) = delete;
    TriangleStore& operator=(const TriangleStore&) = delete;
};

/// A shape as bodies share it. "Mass frame": at the centre of mass, along the principal axes, which
/// is where Bullet wants a body's origin.
struct ShapeRecord {
    TriangleStore triangles;  // only meshes use it; must outlive the shapes
    std::vector<std::unique_ptr<btCollisionShape>> parts;
    btCollisionShape* collision{nullptr};  ///< in the mass frame; one of `parts`
    const btConvexShape* convex{nullptr};  ///< what queries move; none for meshes and compounds
    btTransform mass_from_convex{btTransform::getIdentity()};
    Pose body_from_mass{};
    bool mass_frame_is_body{true};
    bool static_only{false};
    bool mesh{false};
    Vec3d inertia_per_kg{0, 0, 0};  ///< principal
    std::vector<Core> cores;
};

struct BodyRecord {
    BodyId id{};
    ShapeId shape{};
    BodyKind kind{BodyKind::Static};
    std::uint64_t user{0};
    std::uint32_t group{1};
    std::uint32_t collides_with{~0U};
    ContinuousCollision ccd{ContinuousCollision::Auto};
    bool can_sleep{true};
    bool contact_events{false};
    bool frozen{false};
    bool in_world{false};      ///< false once quarantined
    bool poisoned{false};      ///< somebody gave it a non-finite number: out before the next step
    bool has_target{false};    ///< kinematic: move_kinematic was called for the next step
    bool driven{false};        ///< kinematic: its velocity is that of the last move_kinematic
    bool forced{false};        ///< a force or torque of the caller acts in the next step
    bool awake{false};         ///< small_step: steps move it
    bool box_stale{false};     ///< small_step: somebody changed its motion since the last step
    int substeps{0};           ///< small_step: of its island in the latest step
    int substeps_held{0};      ///< small_step: steps since its island really asked for as many
    std::uint32_t slumber{0};  ///< small_step: bodies that fell asleep together share it; 0: awake
    std::vector<JointId> joints;  ///< that hold it, broken ones included, in order of creation
    /// Bodies that joints keep it from touching, once for each such joint.
    std::vector<const BodyRecord*> apart;
    std::uint32_t sweep_group{0};  ///< bodies that stop together share it; 0: stops alone

    Rest rest{};                  ///< small_step
    std::vector<PairLink> pairs;  ///< small_step: by the other body's id
    std::uint32_t row{0};         ///< small_step: among the awake bodies, while islands are built
    Jolt jolt{};                  ///< small_step
    Real radius_m{0};             ///< of the farthest point from the centre of mass
    Real touch_m{0};              ///< points count as near up to this distance

    Pose body_from_mass{};
    bool mass_frame_is_body{true};
    double mass_kg{0};
    Vec3d inertia_kgm2{0, 0, 0};
    bool round_inertia{true};  ///< all three moments equal: no gyroscopic torque
    double linear_damping_per_s{0};
    double angular_damping_per_s{0};
    Vec3 linear_factor{1, 1, 1};  ///< 0 along world axes that the body does not move along
    btVector3 weight_N{0, 0, 0};
    btScalar linear_keep{1};  ///< share of speed left after a substep
    btScalar angular_keep{1};
    std::vector<Core> cores;  ///< mass frame; empty: never swept
    Real smallest_core_m{0};
    btTransform target{btTransform::getIdentity()};  ///< kinematic, mass frame

    std::unique_ptr<btCompoundShape> wrapper;  ///< when the mass frame is not the shape's own
    std::unique_ptr<btRigidBody> rigid;

    bool held_along_axes() const { return linear_factor != Vec3{1, 1, 1}; }

    // As the latest substep found it.
    btTransform before{btTransform::getIdentity()};
    btVector3 velocity_before{0, 0, 0};
    btVector3 spin_before{0, 0, 0};
    Flight flight{};
};

class SmallStepWorld;
class ContactArchive;
struct BodyScope;

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
    void change_material(BodyRecord& record);
    template <class Fn>
    void each_manifold_of(const BodyRecord& record, Fn&& fn);
    void quarantine(BodyRecord& record);
    void poison(BodyRecord& record);
    void place(BodyRecord& record, const btTransform& world_from_mass);
    /// Bullet's mass and inertia: none while frozen.
    static void weigh(BodyRecord& record);
    btTransform world_from_mass(const BodyRecord& record, const Pose& world_from_body) const;

    WorldDef def;
    WorldFeatures features{};
    std::unique_ptr<btDefaultCollisionConfiguration> configuration;
    std::unique_ptr<BoxContacts> box_contacts;  ///< small_step only
    std::unique_ptr<MeshContacts> mesh_contacts;
    std::unique_ptr<btCollisionDispatcher> dispatcher;
    std::unique_ptr<btOverlapFilterCallback> pair_filter;
    std::unique_ptr<btOverlappingPairCache> pairs;
    std::unique_ptr<btDbvtBroadphase> broadphase;
    std::unique_ptr<btMLCPSolverInterface> pivot_solver;
    std::unique_ptr<btConstraintSolver> solver;
    std::unique_ptr<StepWorld> world;
    std::unique_ptr<SmallStepWorld> small;  ///< steps the world; none: Bullet does

    SlotMap<ShapeId, std::unique_ptr<ShapeRecord>> shapes;
    SlotMap<BodyId, std::unique_ptr<BodyRecord>> bodies;
    SlotMap<JointId, std::unique_ptr<JointRecord>> joints;
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

    // --- world_rebuild.cpp
    void check_def() const;
    void build_engine();
    void build_solver();
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

    // --- world_joints.cpp
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

    // --- world_archive.cpp
    void abandon();
    void serialize_bodies(Archive& archive, const BodyScope& scope);
    void serialize_joints(Archive& archive, const BodyScope& scope);
    void serialize_engine(Archive& archive, const BodyScope& scope);
    void serialize_constraints(Archive& archive, const BodyScope& scope);
    void serialize_small_pairs(Archive& archive, const BodyScope& scope, ContactArchive& contacts);
    void serialize_bullet_pairs(Archive& archive, const BodyScope& scope, ContactArchive& contacts);
};

/// Whether forces can move the body now.
inline bool pushable(const BodyRecord& record) {
    return record.kind == BodyKind::Dynamic && record.in_world && !record.frozen;
}

/// small_step: whether forces could move the body and steps do not.
inline bool sleeps(const BodyRecord& record) {
    return pushable(record) && !record.awake;
}

inline bool by_id(const BodyRecord* a, const BodyRecord* b) {
    return a->id < b->id;
}

/// Whether a joint keeps the two from touching.
inline bool kept_apart(const BodyRecord& a, const BodyRecord& b) {
    const bool a_has_fewer = a.apart.size() < b.apart.size();
    const auto& list = a_has_fewer ? a.apart : b.apart;
    return std::find(list.begin(), list.end(), a_has_fewer ? &b : &a) != list.end();
}

/// The record behind a Bullet object of ours.
inline BodyRecord& record_of(const btCollisionObject& object) {
    return *static_cast<BodyRecord*>(object.getUserPointer());
}

/// Makes a shape's Bullet side. Refuses what ShapeDef's comments forbid.
Result<std::unique_ptr<ShapeRecord>> build_shape(const ShapeDef& def,
                                                 std::vector<std::string>* notes);

}  // namespace plumbline::physics
