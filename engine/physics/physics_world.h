// Rigid bodies and joints, stepped at a fixed rate.
//
// Questions about where bodies are: query.h. Sums over all of them: totals.h. Outlines: debug_lines.h.
// Knows nothing of entities, drawing or sound: callers copy states out after a step.
// Does not interpolate and has no clock: see core/time/frame_clock.h for who does.
// Not thread-safe. One PhysicsWorld per scene. How two materials combine is set for the whole
// process (Bullet keeps it in global pointers) and is the same for every world. Same calls in the
// same order give the same bits.
#pragma once

#include "engine/core/result.h"
#include "engine/core/text/diagnostics.h"
#include "engine/physics/body.h"
#include "engine/physics/force_field.h"
#include "engine/physics/joint.h"
#include "engine/physics/step_report.h"

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
    /// small_step: threads that share a step, the caller's among them; >= 1. Results do not depend on it.
    int threads{1};
    /// Outlives the world, which keeps those that it began with. None: filters and combined() of materials decide.
    const PairRules* pair_rules{nullptr};
};

/// Optional behaviour of the world. Each costs nothing while off (effects decide).
struct WorldFeatures {
    bool continuous_collision{true};
    bool gyroscopic_torque{true};
    /// A step that begins with no body turning so that the torque shows goes without it.
    bool gyro_waits_for_spin{false};
    bool contact_events{true};
    bool belts{true};  ///< surfaces move along themselves as their bodies say
};

/// In a crowd so many dynamic bodies are near a dynamic one. Spheres of one size touch 12.
inline constexpr std::uint32_t kNearestPairs = 100;

struct WorldState;

class PhysicsWorld {
public:
    explicit PhysicsWorld(const WorldDef& def);
    ~PhysicsWorld();
    PhysicsWorld(const PhysicsWorld&) = delete;
    PhysicsWorld& operator=(const PhysicsWorld&) = delete;

    /// Shared by any number of bodies, kept until the world goes. Refuses sizes outside limits.h,
    /// non-finite numbers, bad triangle indices, empty compounds and meshes within compounds.
    /// Warnings (thin hulls and so on) go to `notes` when given.
    Result<ShapeId> create_shape(const ShapeDef& def, std::vector<std::string>* notes = nullptr);

    // --- bodies. Numbers that are not finite are taken as they come: a dynamic body that gets one is
    // isolated before the next step, others do not obey the call.

    BodyId create_body(const BodyDef& def);
    /// The next body made gets this id. False where another body has its place.
    bool reserve_body(BodyId id);
    void destroy_body(BodyId id);  ///< its joints go too; what rested on it wakes
    bool contains(BodyId id) const;
    BodyState state(BodyId id) const;

    /// Puts a body somewhere else at once; velocities stay. Wakes it.
    void set_pose(BodyId id, const Pose& world_from_body);
    /// Where a kinematic body is to be at the end of the next step; it gets the velocity for it.
    void move_kinematic(BodyId id, const Pose& world_from_body);
    /// Of the body's origin. A kinematic body keeps it until told otherwise. Speeds end at 10^4 m/s.
    void set_velocity(BodyId id, const Vec3& velocity_mps, const Vec3& angular_velocity_radps);
    /// For the next step only. No point: at the centre of mass.
    void apply_force(BodyId id, const Vec3& force_N, const std::optional<Vec3>& point_world = {});
    void apply_torque(BodyId id, const Vec3& torque_Nm);  ///< for the next step only
    void apply_impulse(BodyId id,
                       const Vec3& impulse_Ns,
                       const std::optional<Vec3>& point_world = {});
    /// A frozen body stands as if static and keeps its mass for later.
    void set_frozen(BodyId id, bool frozen);
    void set_contact_events(BodyId id, bool listed);
    void wake(BodyId id);

    // --- joints. They go with either body, also when it is isolated.

    /// Holds two bodies, or one and the world, as they are now. Both wake. Refused: no body that
    /// could ever move, a body and itself, an axis without direction, limits that cross, numbers
    /// that are not finite or of the wrong sign.
    Result<JointId> create_joint(const JointDef& def);
    bool contains(JointId id) const;
    JointView joint(JointId id) const;
    /// Hinge and slider: drives it, or with none lets it go. Both bodies wake. Other kinds, and
    /// numbers that are not finite or a negative maximum, change nothing.
    void set_joint_motor(JointId id, const std::optional<JointMotor>& motor);

    // --- the world

    /// One fixed step, in which `fields` push bodies: all the same for as long as a body sleeps on them, in one order.
    /// Bodies whose state is not finite are taken out first, counted and left
    /// where they last were finite; the rest goes on as if they had not been there.
    void step(std::span<ForceField* const> fields = {});
    const StepReport& report() const;  ///< of the latest step
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

private:
    friend const WorldState& internals(const PhysicsWorld& world);
    friend void destroy_joint(PhysicsWorld& world, JointId id);

    std::unique_ptr<WorldState> state_;
};

/// Ends a joint, broken or not, and gives its id back; both its ends wake.
void destroy_joint(PhysicsWorld& world, JointId id);

}  // namespace plumbline::physics
