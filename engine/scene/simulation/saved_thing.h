// What a saved game keeps of a thing that play made.
#pragma once

#include "engine/scene/simulation.h"

#include <string>
#include <vector>

namespace plumbline::scene {

/// An entity and its body: of a thing, or of a part of a playing model.
struct Made {
    ecs::Entity entity{};
    physics::BodyId body{};

    void serialize(Archive& archive) { archive(entity, body); }
};

/// From a description, or a part of a whole that broke.
struct SavedThing {
    std::vector<Made> made;
    std::string description;  ///< of a part: its whole's
    std::string name;
    bool is_dropped{false};
    std::string whole;                  ///< of a part: its name
    std::vector<std::uint32_t> pieces;  ///< of a part

    void serialize(Archive& archive) {
        archive(made, description, name, is_dropped, whole, pieces);
    }
};

/// One that play tied. Of pieces that went, the entity is null.
struct SavedRope {
    std::string name;
    RopeEnds ends;
    std::vector<Made> pieces;

    void serialize(Archive& archive) { archive(name, ends, pieces); }
};

/// `rope`: in simulation.ropes(), tied in play.
SavedRope saved_rope(const Simulation& simulation, std::size_t rope);

/// A piece of a rope that play tied.
bool is_of_tied_rope(const Simulation& simulation, ecs::Entity entity);

/// The entity has Spawned.
SavedThing saved_thing(const Simulation& simulation, ecs::Entity entity);

/// The whole first, as the builder makes them.
std::vector<Made> all_of(const ecs::Registry& registry, ecs::Entity entity);

/// What is made next gets these ids. False where others have their places.
bool reserve(Simulation& simulation, const std::vector<Made>& made);

}  // namespace plumbline::scene
