// A walking person: our own collide-and-slide controller over PhysicsWorld's sweeps and overlaps.
//
// Fixed-step like everything else: call update() once a step, before PhysicsWorld::step().
// Between steps callers blend feet and eye positions themselves.
#pragma once

#include "engine/physics/physics_world.h"

namespace plumbline::physics {

struct CharacterDef {
    Vec3 feet_position_m{0, 0, 0};
    Real radius_m{0.3_r};
    Real height_m{1.8_r};
    Real crouched_height_m{1.1_r};
    Real eye_below_top_m{0.15_r};
    Real step_up_m{0.35_r};
    Real max_slope_rad{radians_from_degrees(45.0_r)};
    Real mass_kg{80};      ///< for pushing and for weight on what it stands on
    Real max_push_N{550};  ///< what soles hold: 0.7 of the weight
    Real walk_speed_mps{1.8_r};
    Real run_speed_mps{4.5_r};
    Real crouch_speed_mps{0.9_r};
    Real jump_height_m{1.0_r};
    std::uint32_t group{1};
    std::uint32_t collides_with{~0U};
};

/// What the person wants in one step.
struct CharacterInput {
    Vec3 direction_world{0, 0, 0};  ///< level; length 0…1 is the share of full speed
    Real pace{1};                   ///< factor on the speeds of CharacterDef
    bool run{false};
    bool crouch{false};
    bool jump{false};       ///< pressed since the last step
    Vec3 borne_N{0, 0, 0};  ///< by what is no rigid body: cloth, soft bodies
};

enum class Footing : std::uint8_t { Ground, SteepSlope, Air };

struct CharacterState {
    Vec3 feet_position_m{0, 0, 0};
    Vec3 eye_position_m{0, 0, 0};  ///< smooth on stairs and while crouching
    Vec3 velocity_mps{0, 0, 0};    ///< world, includes what it rides on
    Vec3 walking_mps{0, 0, 0};     ///< level, against the ground; 0 in the air
    Footing footing{Footing::Air};
    BodyId ground_body{};  ///< what it stands on, when Footing::Ground
    Vec3 ground_normal_world{0, 1, 0};
    bool crouched{false};
    bool crouch_wanted{false};  ///< else it crouches because there is no room to stand
    Real landing_speed_mps{0};  ///< > 0 in the step in which it touched down
    /// How far a platform turned it in this step, about +Y: what moves along a path, and a flat face of
    /// something at least as heavy as the person that does not tumble. Balls and crates turn nobody.
    Real ridden_yaw_rad{0};
    bool squeezed{false};  ///< something moving leaves it no room at the moment

    void serialize(auto& archive) {
        archive(feet_position_m, eye_position_m, velocity_mps, walking_mps, footing, ground_body);
        archive(ground_normal_world, crouched, crouch_wanted, landing_speed_mps, ridden_yaw_rad);
        archive(squeezed);
    }
};

/// The user mark of every character's capsule, so that hits tell a person from a thing.
inline constexpr std::uint64_t kCharacterMark = 0xFFFF'FFFFULL;

class Character {
public:
    /// Adds a kinematic capsule to the world so that other things feel it. A blocked start is moved
    /// as teleport() does.
    Character(PhysicsWorld& world, const CharacterDef& def);
    /// Takes the capsule out again. The world must still live.
    ~Character();
    Character(const Character&) = delete;
    Character& operator=(const Character&) = delete;

    void update(const CharacterInput& input);
    const CharacterState& state() const;
    const CharacterDef& def() const;
    BodyId body() const;  ///< the capsule; crouching and standing up give it a new id

    /// Puts it elsewhere at once, at rest; moves up to the nearest free spot when that is blocked.
    void teleport(const Vec3& feet_position_m);

    /// For saved games. When read, its capsule gets its old id; PhysicsWorld::serialize() comes later.
    void serialize(Archive& archive);

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace plumbline::physics
