// The parts of the character controller. Internal to the physics module.
//
// Every query uses a capsule that is kSkin_m smaller all round than the person: sweeps start with
// that much air around them, which keeps them well-conditioned, and the person's own surface ends
// exactly where the skin does. A *gap* is always measured from the person's own surface.
#pragma once

#include "engine/core/io/pose_archive.h"
#include "engine/physics/character.h"
#include "engine/physics/query.h"

#include <array>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace plumbline::physics {

inline constexpr Real kSkin_m = 0.004_r;
/// The felt capsule ends above the feet: what a person stands on carries a weight, not a ram.
inline constexpr Real kBodyAboveFeet_m = 0.1_r;
/// Closer than this counts as touching.
inline constexpr Real kTouch_m = 0.002_r;
/// Surfaces that one move slides along at most.
inline constexpr int kSlides = 5;
inline const Vec3 kUp{0, 1, 0};

constexpr Footing last_of(Footing) {
    return Footing::Air;
}

inline Vec3 level(const Vec3& v) {
    return {v.x, 0, v.z};
}

/// Limits a displacement: dot(displacement, normal) >= -room_m.
struct LimitPlane {
    Vec3 normal{0, 1, 0};
    Real room_m{0};
};

/// At most five planes hit in one motion; nearly equal ones are merged.
class PlaneSet {
public:
    void add(const LimitPlane& plane);
    /// The wish, moved onto the planes it breaks: one plane, else the crease of two, else nothing.
    Vec3 limited(const Vec3& wish) const;
    /// Room used up by a displacement.
    void consume(const Vec3& displacement);
    std::size_t size() const { return count_; }

private:
    bool allows(const Vec3& wish) const;

    std::array<LimitPlane, 5> planes_{};
    std::size_t count_{0};
};

/// Something near or in the way of the capsule.
struct CapsuleContact {
    BodyId body{};
    std::uint64_t user{0};
    Vec3 point{0, 0, 0};   ///< on the other body
    Vec3 normal{0, 1, 0};  ///< towards the person
    Real gap_m{0};         ///< touches(): from the person's surface; negative: penetrating
    Real travel_m{0};      ///< sweep(): way to go before the gap closes
    Real raw_travel_m{0};  ///< sweep(): way the smaller query capsule may go
};

/// What a lower contact offers to stand on.
struct Support {
    bool walkable{false};
    bool edge{false};           ///< the contact is on an edge of the face, not in it
    Vec3 face_normal{0, 1, 0};  ///< of the face that carries
    Vec3 contact_normal{0, 1, 0};
    Vec3 point{0, 0, 0};
    BodyId body{};

    void serialize(Archive& archive) {
        archive(walkable, edge, face_normal, contact_normal, point, body);
    }
};

/// Questions to the world about the person's capsule. Positions are of the feet, in double, so that
/// slow walks far from the origin do not round to nothing.
class CapsuleProbe {
public:
    CapsuleProbe(PhysicsWorld& world, const CharacterDef& def);

    void set_crouched(bool crouched) { crouched_ = crouched; }
    void set_own_body(BodyId body) { own_ = body; }
    /// One body that no query sees; null: none.
    void set_unseen(BodyId body) { unseen_ = body; }
    Real height_m() const { return crouched_ ? def_.crouched_height_m : def_.height_m; }

    /// The first thing in the way of a displacement; none: the way is free.
    std::optional<CapsuleContact> sweep(const Vec3d& feet,
                                        const Vec3& displacement,
                                        BodyId also_ignored = {}) const;
    /// Everything nearer than reach_m to the person's surface, deepest first.
    std::vector<CapsuleContact> touches(const Vec3d& feet,
                                        Real reach_m,
                                        BodyId also_ignored = {}) const;
    bool is_free(const Vec3d& feet) const;
    std::optional<RayHit> ray(const Vec3& from, const Vec3& to) const;
    Support support_of(const CapsuleContact& contact, const Vec3d& feet) const;
    /// Whether the face has one normal all around the point that carries; a ball's has another everywhere.
    bool is_flat(const Support& support) const;

private:
    Pose pose_at(const Vec3d& feet) const;
    QueryFilter filter(BodyId also_ignored) const;

    PhysicsWorld& world_;
    CharacterDef def_;
    std::array<ShapeId, 2> shapes_{};  ///< standing, crouched
    BodyId own_{};
    BodyId unseen_{};
    bool crouched_{false};
};

/// Rigid motion of what the person stands on.
struct Ride {
    BodyId body{};
    Pose now{};              ///< of the body, at this update
    Pose next{};             ///< expected after the coming step
    Vec3 anchor_body{0};     ///< where the feet are on it
    Vec3 velocity{0, 0, 0};  ///< of the body's point at the feet

    void serialize(Archive& archive) { archive(body, now, next, anchor_body, velocity); }
};

/// How high the eye is above the feet.
struct Eye {
    Real height_m{0};  ///< by the posture
    Real offset_m{0};  ///< what stairs still have to give back
    Real offset_mps{0};

    void serialize(Archive& archive) { archive(height_m, offset_m, offset_mps); }
};

struct Character::Impl {
    Impl(PhysicsWorld& world, const CharacterDef& def);
    ~Impl();

    void update(const CharacterInput& input);
    void teleport(const Vec3& feet);
    void serialize(Archive& archive);

    PhysicsWorld& world;
    CharacterDef def;
    CapsuleProbe probe;
    Real dt;
    Real gravity_mps2;  ///< downwards
    Real cos_limit;

    Vec3d feet{0};
    Vec3 velocity{0, 0, 0};  ///< on the ground: level, against what it stands on; else of the world
    Footing footing{Footing::Air};
    Support ground{};
    std::optional<Ride> ride;
    BodyId body{};
    std::array<ShapeId, 2> body_shapes{};
    bool crouched{false};
    bool pinned{false};  ///< still deep in something that the probe does not see in this step
    Real since_ground_s{1};
    Real wedged_s{0};
    Eye eye{};
    CharacterState state{};

private:
    // --- character_walk.cpp
    void walk(const Vec3& wish_velocity);
    void slide_on_ground(Vec3 displacement);
    bool step_up(const Vec3& displacement);
    bool try_step(const Vec3& displacement);
    std::optional<Support> find_ground(Vec3d& from, Real reach_m, BodyId ignored = {}) const;
    bool rolls_up(const Support& found) const;
    bool drop_to_ground();
    void stand_on(const Support& support);
    void leave_ground(const Vec3& velocity);

    // --- character_air.cpp
    /// What gives way bears the person: one can jump from it.
    void lie_on(const Vec3& borne_N);
    void fly(const Vec3& wish_velocity);
    bool try_land(const CapsuleContact& hit, const Vec3& velocity);
    /// The velocity to leave the ground with; none: there is nothing to jump from.
    std::optional<Vec3> jump_velocity() const;

    // --- character_contacts.cpp
    void stop_at_legs(std::span<const CapsuleContact> touches) const;
    std::pair<Real, Real> need_of(const CapsuleContact& touch) const;
    /// Whether what presses leaves no room.
    bool give_way();
    /// What the person still is deep in.
    std::optional<BodyId> pinning_body() const;
    /// The least way out of all that is too close.
    Vec3 way_to_gaps() const;
    bool escape();
    Real push(const CapsuleContact& hit, const Vec3& velocity) const;
    /// Which body the hands push, and where.
    struct Hands {
        BodyId body{};
        Vec3 point{0};
    };
    Hands hands_on(const CapsuleContact& hit, const Vec3& into) const;
    bool gives_way_to_us(BodyId body) const;
    bool may_step_on(BodyId body, Real height_m) const;
    Vec3 slide_freely(const Vec3& displacement, BodyId ignored);
    Real move_swept(const Vec3& displacement, BodyId ignored);
    Vec3 point_velocity(BodyId body, const Vec3& point) const;

    // --- character_ride.cpp
    /// Goes where what carries the person has gone. How far that turned, about +Y.
    Real follow_ride();
    /// On what is stood on, if that can move.
    std::optional<Ride> ride_on_ground() const;
    /// Goes where what carries the person will go in the coming step. How far that turns, about +Y.
    Real carry();
    bool slips_away(const BodyState& below) const;
    /// What it rides turns it: see CharacterState::ridden_yaw_rad.
    bool is_on_a_platform() const;
    void press_down() const;
    void push(BodyId pushed, const Vec3& impulse_Ns, const Vec3& point_world) const;

    // --- character.cpp
    void change_posture(bool crouch);
    void make_body();
    Pose body_pose(Real raised_m) const;
    CharacterState seen() const;
    Vec3 wish_velocity(const CharacterInput& input) const;
    void find_free_place(const Vec3& feet);
};

}  // namespace plumbline::physics
