// Rigid bodies, stepped at a fixed rate, and questions about them.
//
// Knows nothing of entities, drawing or sound: callers copy states out after a step.
// Does not interpolate and has no clock: see core/time/frame_clock.h for who does.
// Not thread-safe. One PhysicsWorld per scene. How two materials combine is set for the whole
// process (Bullet keeps it in global pointers) and is the same for every world. Same calls in the
// same order give the same bits.
#pragma once

#include "engine/core/lines.h"
#include "engine/core/result.h"
#include "engine/core/text/diagnostics.h"
#include "engine/physics/body.h"
#include "engine/physics/contact.h"
#include "engine/physics/joint.h"
#include "engine/physics/query.h"

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace plumbline {
class Archive;
}

namespace plumbline::physics {

/// Constraint solvers by the names that scenes and the command line use.
enum class Solver : std::uint8_t {
    SmallStep,  ///< ours: soft sub-stepped contacts, joints solved directly (docs/PHYSICS.md)
    BulletSi,
    BulletNncg,
    BulletDantzig,
    BulletPgs,
};
inline constexpr std::array kSolvers{Solver::SmallStep,
                                     Solver::BulletSi,
                                     Solver::BulletNncg,
                                     Solver::BulletDantzig,
                                     Solver::BulletPgs};

std::string_view solver_name(Solver solver);  ///< "bullet_si"
std::optional<Solver> solver_from_name(std::string_view name);

struct WorldDef {
    Vec3 gravity_mps2{0, -9.81_r, 0};
    double step_s{1.0 / 60.0};  ///< one fixed step; > 0
    /// bullet_*: each step is this many whole steps. small_step: the least sub-steps an island gets.
    int substeps{2};
    /// small_step: the most sub-steps an island gets; at most `substeps`: exactly `substeps`.
    int substeps_max{16};
    int iterations{1};  ///< solver sweeps per substep; >= 1
    Solver solver{Solver::SmallStep};
    JointMethod joints{JointMethod::Direct};  ///< small_step only
    std::uint32_t seed{0};                    ///< of the solver's own shuffling, where it has any
};

/// Optional behaviour of the world. Each costs nothing while off (effects decide).
struct WorldFeatures {
    bool continuous_collision{true};
    bool gyroscopic_torque{true};
    /// A step that begins with no body turning so that the torque shows goes without it.
    bool gyro_waits_for_spin{false};
    bool contact_events{true};
};

/// In a crowd so many dynamic bodies are near a dynamic one. Spheres of one size touch 12.
inline constexpr std::uint32_t kNearestPairs = 100;

/// What the latest step did to motion beside solving for it. small_step only, but for the speed
/// limit, crowds and islands too large for a matrix.
struct Interventions {
    double braked_J{0};               ///< that the energy guard took out
    std::uint32_t braked_islands{0};  ///< from so many islands
    std::uint32_t clamped_bodies{
        0};  ///< that penetration pushed out too fast, and that were slowed
    std::uint32_t unresolved_islands{0};  ///< whose joints swung too fast for a sub-step: damped
    std::uint32_t restored_islands{0};    ///< without a sane state: stand as before the step
    std::uint32_t limited_bodies{0};      ///< at the speed limit of the world
    std::uint32_t impacts{0};             ///< contacts that bounced
    std::uint32_t oversized_islands{0};   ///< bullet_dantzig and bullet_pgs: swept, as by bullet_si
    std::uint64_t left_out_pairs{0};      ///< of crowded bodies, for others that were nearer

    void add(const Interventions& more);
};

/// CPU time and work of the latest step, by phase.
struct StepCost {
    double broad_ms{0};
    double narrow_ms{0};
    double solve_ms{0};
    double integrate_ms{0};
    double total_ms{0};           ///< whole step; the rest is "other"
    std::uint64_t row_solves{0};  ///< constraint rows times sweeps: work without a clock
    std::uint32_t contacts{0};    ///< contact points
    std::uint32_t pairs{0};       ///< small_step: pairs of bodies looked at for contact points
    Interventions interventions{};
};

/// How often the optional parts of the latest step really ran.
struct FeatureUse {
    std::uint32_t swept_bodies{0};  ///< continuous collision
    std::uint32_t gyro_bodies{0};   ///< gyroscopic torque
    BodyId swept{};                 ///< the first of them
    BodyId turned{};
    std::uint32_t events{0};  ///< contact events listed
    double sweep_ms{0};
    double gyro_ms{0};
    double events_ms{0};
};

/// Who got how many sub-steps in the latest step, and why. small_step only.
struct IslandReport {
    std::uint64_t user{0};  ///< mark of its first body
    std::uint32_t bodies{0};
    std::uint32_t contacts{0};  ///< points
    std::uint32_t joints{0};
    int substeps{0};
    std::string_view reason;  ///< "least", "load", "height", "turning", "error", "held", "fixed"
};

struct Energy {
    double kinetic_J{0};
    /// m*g*h above the plane through the origin, against gravity, and what springs hold.
    double potential_J{0};

    double total_J() const { return kinetic_J + potential_J; }
};

struct WorldState;

// What callers see of a world, by what they want of it. PhysicsWorld is all of it; a function that
// only asks may take WorldQueries alone.

/// Bodies: made, moved, pushed, frozen and taken out.
///
/// Numbers that are not finite are taken as they come: a dynamic body that gets one is quarantined
/// before the next step, others do not obey the call.
class WorldBodies {
public:
    BodyId create_body(const BodyDef& def);
    void destroy_body(BodyId id);  ///< its joints go too; what rested on it wakes
    /// The next body made gets this id. False where another body has its place.
    bool reserve_body(BodyId id);
    bool contains(BodyId id) const;
    std::size_t body_count() const;
    std::size_t awake_count() const;

    BodyState state(BodyId id) const;
    BodyKind kind(BodyId id) const;
    MassProperties mass_properties(BodyId id) const;
    std::uint64_t user(BodyId id) const;
    bool groups_touch(BodyId a, BodyId b) const;  ///< their groups do not keep them apart
    /// World-space box of the shape at the body's present pose.
    void bounds(BodyId id, Vec3& min_world, Vec3& max_world) const;

    /// Puts a body somewhere else at once; velocities stay. Wakes it.
    void set_pose(BodyId id, const Pose& world_from_body);
    /// Where a kinematic body is to be at the end of the next step; it gets the velocity for it.
    void move_kinematic(BodyId id, const Pose& world_from_body);
    /// Of the body's origin. A kinematic body keeps it until told otherwise. Speeds end at 10^4 m/s.
    void set_velocity(BodyId id, const Vec3& velocity_mps, const Vec3& angular_velocity_radps);
    void apply_force(BodyId id, const Vec3& force_N);  ///< at the centre of mass, next step only
    void apply_force_at(BodyId id, const Vec3& force_N, const Vec3& point_world);
    void apply_torque(BodyId id, const Vec3& torque_Nm);
    void apply_impulse(BodyId id, const Vec3& impulse_Ns);
    void apply_impulse_at(BodyId id, const Vec3& impulse_Ns, const Vec3& point_world);
    /// A frozen body stands as if static and keeps its mass for later.
    void set_frozen(BodyId id, bool frozen);
    bool frozen(BodyId id) const;
    void set_contact_events(BodyId id, bool listed);
    void wake(BodyId id);

protected:
    explicit WorldBodies(WorldState& world) : world_(world) {}

private:
    WorldState& world_;
};

/// Joints; they go with either body, also when it is quarantined.
class WorldJoints {
public:
    /// Holds two bodies, or one and the world, as they are now. Both wake. Refused: no body that
    /// could ever move, a body and itself, an axis without direction, limits that cross, numbers
    /// that are not finite or of the wrong sign.
    Result<JointId> create_joint(const JointDef& def);
    bool contains(JointId id) const;
    std::size_t joint_count() const;  ///< broken ones included
    /// As asked for, with the motor as it is now.
    const JointDef& joint_def(JointId id) const;
    const JointState& joint_state(JointId id) const;
    /// Hinge and slider: drives it, or with none lets it go. Both bodies wake. Other kinds, and
    /// numbers that are not finite or a negative maximum, change nothing.
    void set_joint_motor(JointId id, const std::optional<JointMotor>& motor);
    /// Joints that broke in the latest step, in the order of their ids. They stay, and carry
    /// nothing, until destroyed.
    std::span<const JointId> broken_joints() const;
    double max_joint_error_m() const;  ///< of joints that are not broken; walks all

protected:
    explicit WorldJoints(WorldState& world) : world_(world) {}

private:
    WorldState& world_;
};

/// Questions about where bodies are.
class WorldQueries {
public:
    /// The first body met from outside; one that the ray starts in is not met.
    std::optional<RayHit> cast_ray(const Vec3& from_world,
                                   const Vec3& to_world,
                                   const QueryFilter& filter = {}) const;
    /// Moves a convex shape along a straight line; meshes and compounds may be hit, not swept. Stops
    /// within 0.01 mm of touching. Overlap at the start stops it at fraction 0 only on a way deeper.
    std::optional<SweepHit> sweep(ShapeId shape,
                                  const Pose& from,
                                  const Vec3& to_position_world,
                                  const QueryFilter& filter = {}) const;
    /// Bodies within `margin_m` of a convex shape, deepest first; a body of several pieces or
    /// triangles may be listed several times.
    std::vector<OverlapHit> overlaps(ShapeId shape,
                                     const Pose& pose,
                                     Real margin_m,
                                     const QueryFilter& filter = {}) const;

    /// Outline of a shape at a pose of its body, whether or not a body is there.
    void add_shape_lines(ShapeId shape,
                         const Pose& world_from_body,
                         const Vec3f& color,
                         LineList& lines) const;
    /// Outlines of every collision shape, coloured by kind and sleep, and contact normals. The capsule
    /// of a character round the eye, if one is given, is left out: it would be all there is to see.
    void add_debug_lines(LineList& lines, const std::optional<Vec3>& eye_world = {}) const;
    /// The box along the world's axes round every body, as the broad phase compares them.
    void add_box_lines(LineList& lines, const std::optional<Vec3>& eye_world = {}) const;

protected:
    explicit WorldQueries(WorldState& world) : world_(world) {}

private:
    WorldState& world_;
};

/// What the latest step left, and totals. Spans are overwritten by the next step; totals walk all
/// bodies.
class WorldReport {
public:
    /// Touching pairs, in a reproducible order. Those that sleep are listed as they fell asleep.
    std::span<const ContactEvent> contacts() const;
    /// Every touching pair whether or not a body asked for events, for state files; not free.
    std::vector<ContactEvent> all_contacts() const;
    const StepCost& cost() const;
    const FeatureUse& feature_use() const;
    /// Islands that were solved, in the order of their first bodies. small_step only.
    std::span<const IslandReport> islands() const;
    /// Bodies taken out for a non-finite state, in the order it happened.
    std::span<const BodyId> quarantined() const;

    Energy energy() const;
    Vec3d momentum_kgmps() const;
    Vec3d angular_momentum_kgm2ps() const;  ///< about the world's origin
    double max_penetration_m() const;       ///< deepest contact point of the latest step; 0 if none

protected:
    explicit WorldReport(WorldState& world) : world_(world) {}

private:
    WorldState& world_;
};

/// Holds what the parts of a world's face share: its first base.
class WorldOwner {
protected:
    explicit WorldOwner(const WorldDef& def);
    ~WorldOwner();

    std::unique_ptr<WorldState> state_;
};

class PhysicsWorld : private WorldOwner,
                     public WorldBodies,
                     public WorldJoints,
                     public WorldQueries,
                     public WorldReport {
public:
    explicit PhysicsWorld(const WorldDef& def);
    ~PhysicsWorld();
    PhysicsWorld(const PhysicsWorld&) = delete;
    PhysicsWorld& operator=(const PhysicsWorld&) = delete;

    using WorldBodies::contains;
    using WorldJoints::contains;

    /// Shared by any number of bodies, kept until the world goes. Refuses sizes outside limits.h,
    /// non-finite numbers, bad triangle indices, empty compounds and meshes within compounds.
    /// Warnings (thin hulls and so on) go to `notes` when given.
    Result<ShapeId> create_shape(const ShapeDef& def, std::vector<std::string>* notes = nullptr);

    /// One fixed step. Bodies whose state is not finite are taken out first, counted and left
    /// where they last were finite; the rest goes on as if they had not been there.
    void step();
    void set_features(const WorldFeatures& features);
    const WorldDef& def() const;
    /// Another solver, rate or gravity from the next step on. Ids, bodies, shapes, joints and what is
    /// frozen or taken out stay. From small_step to small_step and from any bullet_* to any other,
    /// contacts and joints go on carrying what they did, and what sleeps sleeps on unless gravity
    /// changed. Between small_step and bullet_* contact points are found anew and everything wakes:
    /// what follows is, bit for bit, what a new world made from the present states would do.
    void reconfigure(const WorldDef& def);

    /// Everything that decides how it goes on, to the bit. When read: into a world that holds bodies of
    /// the same ids and shapes; its joints are replaced, and what fails leaves it fit only to be thrown
    /// away.
    /// When written with `keeps`: only the bodies that it keeps and what is between them, for a world
    /// that has just these.
    void serialize(Archive& archive, const std::function<bool(BodyId)>& keeps = {});
};

/// The most sub-steps that any island got in the latest step; what is asked for where none was.
int most_substeps(const PhysicsWorld& world);

}  // namespace plumbline::physics
