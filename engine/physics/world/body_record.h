// A body as the world keeps it.
#pragma once

#include "engine/core/pose.h"
#include "engine/physics/body.h"
#include "engine/physics/collision/pair.h"
#include "engine/physics/dynamics/body_motion.h"
#include "engine/physics/dynamics/transform.h"
#include "engine/physics/joint.h"
#include "engine/physics/world/island_sleep.h"

#include <algorithm>
#include <memory>
#include <vector>

class btCompoundShape;
class btRigidBody;

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

struct BodyRecord {
    BodyRecord();
    ~BodyRecord();
    BodyRecord(const BodyRecord&) = delete;
    BodyRecord& operator=(const BodyRecord&) = delete;

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
    Vec3 weight_N{0, 0, 0};
    Real linear_keep{1};  ///< share of speed left after a substep
    Real angular_keep{1};
    std::vector<Core> cores;  ///< mass frame; empty: never swept
    Real smallest_core_m{0};
    Transform target{};  ///< kinematic, mass frame

    // Bullet's side: bullet/body.h.
    std::unique_ptr<btCompoundShape> wrapper;  ///< when the mass frame is not the shape's own
    std::unique_ptr<btRigidBody> rigid;

    bool held_along_axes() const { return linear_factor != Vec3{1, 1, 1}; }

    // As the latest substep found it.
    Transform before{};
    Vec3 velocity_before{0, 0, 0};
    Vec3 spin_before{0, 0, 0};
    Flight flight{};
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

}  // namespace plumbline::physics
