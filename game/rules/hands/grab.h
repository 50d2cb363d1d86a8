// Holding a thing, cloth or a soft body at a distance in front of the eye, by a spring that is critically damped and no
// stronger than a person.
#pragma once

#include "engine/scene/simulation.h"
#include "game/rules/hands/aim.h"
#include "game/rules/hands/pinch.h"

#include <optional>
#include <string>

namespace plumbline::game {

struct Looked {
    ecs::Entity entity{};
    physics::BodyId body{};
    Vec3 point_m{0, 0, 0};
    Real distance_m{0};
};

/// How far one sees: to what is looked at, else as far as with an arm of that length.
inline Real sight_m(const std::optional<Looked>& looked, const Aim& aim, Real arm_m) {
    return looked ? looked->distance_m : aim.reach_m(arm_m);
}

class Grab {
public:
    static constexpr Real kReach_m = 3;
    static constexpr Real kMostForce_N = 700;
    static constexpr Real kMostMass_kg = 60;  ///< heavier things are refused
    static constexpr Real kNearest_m = 0.6_r;
    static constexpr Real kFarthest_m = 4;

    /// Takes hold of what is looked at, by its middle; by a free pointer where that is, as far off as it
    /// is. Returns why not, or nothing.
    std::optional<std::string> take(scene::Simulation& simulation, const Aim& aim);
    void release(scene::Simulation& simulation);
    /// Opens the hand when what it holds left the world; else entity() and body() are alive.
    void forget_gone(scene::Simulation& simulation);
    bool holding() const { return holds_thing() || pinch_.holding(); }
    ecs::Entity entity() const { return pinch_.holding() ? pinch_.entity() : entity_; }
    /// Null where it is cloth or a soft body.
    physics::BodyId body() const { return body_; }

    /// One step of the spring. Opens the hand when the thing is frozen, out of reach or too heavy; returns what is to be said of
    /// that, or nothing.
    std::optional<std::string> pull(scene::Simulation& simulation, const Aim& aim);
    void change_distance(Real by_m);
    void rotate(Real yaw_rad, Real pitch_rad);

    /// Lets go with a velocity. False, and still in the hand, when it sticks behind or in a wall.
    bool throw_it(scene::Simulation& simulation, const Aim& aim, const Vec3& velocity_mps);
    /// For saved games; when read, with the simulation's entities already there.
    void serialize(Archive& archive, scene::Simulation& simulation);

private:
    /// What rolls on wheels is pushed and pulled by the place where it was taken.
    struct Handle {
        Vec3 point_body{0, 0, 0};
        Vec3 axle_body{0, 0, 0};  ///< unit; zero: on several wheels, it stands by itself
        void serialize(auto& archive) { archive(point_body, axle_body); }
    };
    bool holds_thing() const { return entity_.generation != 0; }
    void pull_thing(scene::Simulation& simulation, const Aim& aim);
    static std::optional<Handle> handle_of(const scene::Simulation& simulation,
                                           const Looked& looked);
    Vec3 target_of(const scene::Simulation& simulation, const Aim& aim) const;
    Vec3 next_velocity(const Vec3& velocity, const Vec3& point, const Vec3& target, Real dt) const;
    void pull_straight(scene::Simulation& simulation, const Aim& aim, const Vec3& target);
    void pull_round(scene::Simulation& simulation, const Aim& aim);
    void pull_handle(scene::Simulation& simulation, const Vec3& target);
    void keep_level(scene::Simulation& simulation, const Aim& aim);

    Pinch pinch_;
    ecs::Entity entity_{};
    physics::BodyId body_{};
    Real mass_kg_{0};
    Real radius_m_{0};
    Real distance_m_{2};
    Vec3 middle_from_point_{0, 0, 0};  ///< where it is held, seen from its middle; view's yaw
    std::optional<Handle> handle_{};
    bool by_pointer_{false};            ///< it follows as fast as a pointer goes
    Quat view_from_body_{kNoRotation};  ///< turn against the view's yaw
    std::optional<Vec3> last_target_{};
    Real stuck_s_{0};
};

/// The entity with a body that is looked at within an arm's length, or anywhere by a free pointer, if
/// any; its body and distance.
std::optional<Looked> looked_at(const scene::Simulation& simulation, const Aim& aim, Real arm_m);

}  // namespace plumbline::game
