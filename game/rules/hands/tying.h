// Ropes that a person ties: the first place is chosen, then the second; one that is there is cut.
#pragma once

#include "engine/core/io/archive.h"
#include "engine/scene/simulation.h"
#include "game/rules/hands/aim.h"
#include "game/rules/hands/grab.h"

#include <optional>
#include <string>

namespace plumbline::game {

/// Where a line of sight passes a rope.
struct RopeInSight {
    physics::JointId joint{};  ///< the nearest that still holds
    Vec3 point_m{0, 0, 0};
};

/// The nearest rope that the line of sight passes within a hand's breadth, before it meets anything else.
std::optional<RopeInSight> rope_at(const scene::Simulation& simulation, const Aim& aim);

class Tying {
public:
    static constexpr Real kReach_m = 12;
    static constexpr std::size_t kMost = 30;  ///< ropes that play tied, at one time

    /// Cuts the rope looked at; else takes a rope's first end to the place looked at, then its second. Returns
    /// what the person is told.
    std::string press(scene::Simulation& simulation, const Aim& aim);
    /// Puts the rope in hand away when what its first end was tied to left the world.
    void forget_gone(const scene::Simulation& simulation);
    /// Where the first end is, while the second is still in the hand. None: what it was tied to is gone.
    std::optional<Vec3> first_end_m(const scene::Simulation& simulation) const;
    void serialize(Archive& archive) { archive(begun_, first_); }

private:
    /// In the frame of a body that can move; null: the world's.
    struct Place {
        physics::BodyId body{};
        ecs::Entity entity{};
        Vec3 anchor_m{0, 0, 0};
        Vec3 world_m(const scene::Simulation& simulation) const;
        bool is_there(const scene::Simulation& simulation) const;
        void serialize(Archive& archive) { archive(body, entity, anchor_m); }
    };
    static Place place_of(const scene::Simulation& simulation, const Looked& looked);
    std::string finish(scene::Simulation& simulation, const Place& second);

    bool begun_{false};
    Place first_;
};

}  // namespace plumbline::game
