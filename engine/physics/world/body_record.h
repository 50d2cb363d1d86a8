// A body as the world keeps it.
#pragma once

#include "engine/core/pose.h"
#include "engine/physics/body.h"
#include "engine/physics/collision/body_geometry.h"
#include "engine/physics/collision/pair.h"
#include "engine/physics/dynamics/body_motion.h"
#include "engine/physics/joint.h"
#include "engine/physics/transform.h"
#include "engine/physics/world/island_sleep.h"

#include <algorithm>
#include <compare>
#include <memory>
#include <vector>

namespace plumbline::physics {

struct RigidBody;

/// Faster is never simulated: a wall at 60 Hz would be 170 m away at its next step.
inline constexpr Real kMaxSpeed_mps = 1e4_r;
inline constexpr Real kMaxSpin_radps = 1e4_r;
/// Beyond it a body is taken out: float32 places it no better than to 6 cm there.
inline constexpr Real kMaxDistance_m = 1e6_r;

/// What its definition and the world's rate make of a body; steps only read it. "Mass frame": at the
/// centre of mass, along the principal axes.
struct BodyTraits {
    std::shared_ptr<const BodyGeometry> geometry;
    ConvexShape
        primitive{};  ///< the geometry's only shape, if that stands in the mass frame; else of kind None
    Material material{};
    /// Of a belt or a turntable, body frame and about its origin; see BodyDef.
    Vec3 surface_velocity_mps{0, 0, 0};
    Vec3 surface_spin_radps{0, 0, 0};
    Pose body_from_mass{};
    bool mass_frame_is_body{true};
    double mass_kg{0};
    Vec3d inertia_kgm2{0, 0, 0};
    bool isotropic_inertia{true};  ///< all three moments equal: no gyroscopic torque
    double linear_damping_per_s{0};
    double angular_damping_per_s{0};
    Vec3 linear_factor{1, 1, 1};   ///< 0 along world axes that the body does not move along
    Vec3 gravity_factor{1, 1, 1};  ///< along world axes: times the world's gravity
    Vec3 weight_N{0, 0, 0};
    Real linear_damping_factor{1};  ///< share of speed left after a substep
    Real angular_damping_factor{1};
    Real radius_m{0};          ///< of the farthest point from the centre of mass
    Real contact_margin_m{0};  ///< points count as near up to this distance

    bool held_along_axes() const { return linear_factor != Vec3{1, 1, 1}; }
    bool is_belt() const {
        return surface_velocity_mps != Vec3{0, 0, 0} || surface_spin_radps != Vec3{0, 0, 0};
    }
};

/// A body's motion as the latest substep found it.
struct MotionBefore {
    Transform at{};
    Vec3 velocity_mps{0, 0, 0};
    Vec3 spin_radps{0, 0, 0};
};

/// What acts on a body in the next step, its weight included from when the step prepares it.
struct AppliedForces {
    Vec3 force_N{0, 0, 0};
    Vec3 torque_Nm{0, 0, 0};
    bool by_caller{false};  ///< not the weight alone
};

/// Where callers lead a kinematic body.
struct KinematicDrive {
    Transform target{};      ///< mass frame
    bool has_target{false};  ///< move_kinematic was called for the next step
    bool driven{false};      ///< its velocity is that of the last move_kinematic
};

/// What continuous collision knows of a body.
struct SweptBody {
    ContinuousCollision ccd{ContinuousCollision::Auto};
    Real inner_radius_m{0};  ///< of the largest ball inside its thinnest part; 0: never swept
    Real until{1};           ///< the share of the latest step in which it moved
    Real since{0};           ///< the share at which its latest impact left it at `from`
    Transform from{};        ///< only where `since` is not 0
    Vec3 came_mps{0, 0, 0};  ///< likewise: the velocity before that impact
    Vec3 came_radps{0, 0, 0};
    std::uint32_t group{0};  ///< bodies that stop together share it; 0: stops alone
};

/// What small_step keeps of a body.
struct SmallStepBody {
    bool awake{false};                 ///< steps move it
    bool box_stale{false};             ///< somebody changed its motion since the last step
    std::uint32_t sleeping_island{0};  ///< bodies that fell asleep together share it; 0: awake
    Rest rest{};
    int substeps{0};              ///< of its island in the latest step
    int substeps_held{0};         ///< steps since its island really asked for as many
    std::uint32_t row{0};         ///< among the awake bodies, while islands are built
    std::uint32_t fields{0};      ///< that act on it in this step, a bit each
    std::uint32_t island{0};      ///< of the latest step; none: not a number of one
    PredictedChange predicted{};  ///< within a step
    std::vector<PairLink> pairs;  ///< by the other body's id
};

/// Orders the bodies near another one by the distance to their bounding sphere, so that large ones
/// come first, then by id.
struct NearRank {
    Real distance_m{0};
    BodyId id{};

    friend auto operator<=>(const NearRank&, const NearRank&) = default;
};

/// What NearestPairs keeps of a body that has more than kNearestPairs pairs: it chooses which of the
/// pairs with other such bodies take part in collision.
struct Crowd {
    NearRank last{};             ///< of the nearest
    std::uint32_t ranked{0};     ///< the step that `last` is of
    std::uint32_t completed{0};  ///< the step in which its pairs were completed last
};

/// A body: who it is, and its parts. What the inner loops of a step move is apart, in `motion`.
struct BodyRecord {
    BodyRecord();
    ~BodyRecord();
    BodyRecord(const BodyRecord&) = delete;
    BodyRecord& operator=(const BodyRecord&) = delete;

    BodyId id{};
    BodyKind kind{BodyKind::Static};
    std::uint64_t user{0};
    CollisionFilter filter{};
    bool can_sleep{true};
    bool contact_events{false};
    bool frozen{false};
    bool in_world{false};  ///< false once isolated
    bool invalid{false};   ///< got a number that is not finite: isolated before the next step

    BodyMotion* motion{nullptr};  ///< one of the world's BodyMotions
    BodyTraits traits{};
    MotionBefore before{};
    AppliedForces applied{};
    KinematicDrive drive{};
    SweptBody sweep{};
    SmallStepBody small{};
    std::unique_ptr<Crowd> crowd;  ///< none: not crowded
    std::vector<JointId> joints;   ///< that hold it, broken ones included, in order of creation
    /// Bodies that joints keep it from touching, once for each such joint.
    std::vector<const BodyRecord*> excluded;
    std::unique_ptr<RigidBody> rigid;  ///< Bullet's side: bullet/body.h
};

/// Whether forces can move the body now.
inline bool pushable(const BodyRecord& record) {
    return record.kind == BodyKind::Dynamic && record.in_world && !record.frozen;
}

/// small_step: whether forces could move the body and steps do not.
inline bool sleeps(const BodyRecord& record) {
    return pushable(record) && !record.small.awake;
}

inline bool stands_still(const BodyRecord& record) {
    return record.motion->velocity_mps == Vec3{0, 0, 0} &&
           record.motion->spin_radps == Vec3{0, 0, 0};
}

inline void stand_still(BodyRecord& record) {
    BodyMotion& motion = *record.motion;
    motion.velocity_mps = motion.spin_radps = {0, 0, 0};
    motion.ballistic.velocity_mps = motion.ballistic.spin_radps = {0, 0, 0};
}

/// A step or substep starts.
inline void note_before(BodyRecord& record) {
    const BodyMotion& motion = *record.motion;
    record.before = {motion.at, motion.velocity_mps, motion.spin_radps};
    record.small.predicted = {};
    record.sweep.until = 1;
    record.sweep.since = 0;
}

inline void add_force(BodyRecord& record, const Vec3& force_N) {
    record.applied.force_N += force_N * record.traits.linear_factor;
}

inline void clear_forces(BodyRecord& record) {
    record.applied = {};
}

inline bool by_id(const BodyRecord* a, const BodyRecord* b) {
    return a->id < b->id;
}

/// Whether a joint keeps the two from touching.
inline bool collision_excluded(const BodyRecord& a, const BodyRecord& b) {
    const bool a_has_fewer = a.excluded.size() < b.excluded.size();
    const auto& list = a_has_fewer ? a.excluded : b.excluded;
    return std::find(list.begin(), list.end(), a_has_fewer ? &b : &a) != list.end();
}

}  // namespace plumbline::physics
