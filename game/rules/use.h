// What the use key does to what a person looks at: a door, shutter or gate swings open or shut, a lamp goes
// on or off, a seat is sat on.
#pragma once

#include "engine/scene/simulation.h"
#include "game/rules/hands/aim.h"
#include "game/rules/hands/grab.h"

#include <optional>
#include <vector>

namespace plumbline::game {

/// A hinge that a hand turns, and where to.
struct Swing {
    physics::JointId hinge{};
    Real angle_rad{0};
    Real left_s{0};    ///< until the hand gives up
    bool opens{true};  ///< else it shuts

    void serialize(auto& archive) { archive(hinge, angle_rad, left_s, opens); }
};

/// The leaf that is looked at as what would swing it: its hinge has limits and hangs on something that
/// stands still. A shut one opens, away from the person where it opens both ways; any other one shuts.
std::optional<Swing> door_at(const scene::Simulation& simulation,
                             const Looked& looked,
                             const Vec3& eye_m);

/// Doors on their way, each turned about its hinge as fast as a walker opens it and no harder than a hand
/// can.
class Doors {
public:
    static constexpr Real kMostTorque_Nm = 60;

    void swing(const Swing& swing);
    /// One step. What is in the hand goes where the hand takes it.
    void push(scene::Simulation& simulation, physics::BodyId held);
    void forget_gone(const scene::Simulation& simulation);
    void serialize(Archive& archive) { archive(swings_); }

private:
    std::vector<Swing> swings_;
};

/// The lamp that is looked at: the body of one, or a bulb without a body on the line of sight.
ecs::Entity lamp_at(const scene::Simulation& simulation,
                    const Aim& aim,
                    const std::optional<Looked>& looked);
bool is_lit(const scene::Simulation& simulation, ecs::Entity lamp);
/// Switches it, and the lights without anything to see that are nearer to it than to other lamps: what it
/// lights up around it.
void switch_lamp(scene::Simulation& simulation, ecs::Entity lamp, bool on);

}  // namespace plumbline::game
