// The things that a person may put into the world, and the order in which they came.
#pragma once

#include "engine/assets/material_data.h"
#include "engine/core/result.h"
#include "engine/scene/simulation.h"
#include "game/rules/hands/aim.h"
#include "game/rules/hands/placement.h"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::game {

inline constexpr std::size_t kThingCount = 7;
/// crate ball barrel brick plank stone domino
extern const std::array<std::string_view, kThingCount> kThingNames;

/// What each name stands for: the scene's prefab, else the one of assets/scenes/things.toml, else a
/// plain shape of our own.
struct Thing {
    scene::EntityDescription description;
    std::optional<assets::MaterialData> material{};  ///< of a plain shape
    std::optional<Vec3> size_m{};                    ///< world box at rest, where it is known
};

/// A box of its size in the world.
struct Placed {
    Pose world_from_box{};
    Vec3 size_m{1, 1, 1};
};

class Things {
public:
    static constexpr std::size_t kMost = 500;
    /// How far in front things appear, plus their radius: what is thrown, and what is dropped where nothing
    /// is looked at nearer than kDropReach_m.
    static constexpr Real kReach_m = 1.6_r;
    static constexpr Real kDropReach_m = 8;

    /// Lends the simulation the materials of things that its scene does not know.
    Things(scene::Simulation& simulation, const std::filesystem::path& assets_folder);

    void choose(std::size_t index);  ///< others than 0…kThingCount-1 are ignored
    void choose_next(int steps);
    std::size_t chosen() const { return chosen_; }
    std::string_view chosen_name() const { return kThingNames[chosen_]; }
    const Thing& thing(std::size_t index) const { return things_[index]; }

    /// As put(), of what the right button of the book's profile shoots: the scene's prefab "shot",
    /// else a box of 1 kg.
    Result<ecs::Entity> put_shot(scene::Simulation& simulation,
                                 const Aim& aim,
                                 const Vec3& velocity) {
        return put(simulation, aim, velocity, kShot);
    }
    /// Puts one of the chosen things where the person looks, in the nearest free place; never
    /// behind or into a wall. The error is a message for the person.
    Result<ecs::Entity> put(scene::Simulation& simulation, const Aim& aim, const Vec3& velocity) {
        return put(simulation, aim, velocity, chosen_);
    }
    /// The box round the chosen thing where it would come to lie if it were dropped now and fell straight
    /// down. None: there is no room for it, or its size is not known before the first one is made.
    std::optional<Placed> preview(const scene::Simulation& simulation, const Aim& aim) const;
    /// A rope that was tied now: the latest one.
    void number(scene::Simulation& simulation, const scene::Rope& rope);
    /// Takes the latest one, or all of its parts, away; false when there is none.
    bool undo(scene::Simulation& simulation);
    /// Takes the oldest away while there are too many; true when told for the first time.
    bool keep_limit(scene::Simulation& simulation);

    /// Makes again what a saved game had. Null where there is no such thing.
    ecs::Entity make_again(scene::Simulation& simulation,
                           const std::string& kind,
                           const std::string& name);
    void serialize(Archive& archive) {
        archive.within(chosen_, std::size_t{0}, kThingCount - 1);
        archive(serial_, limit_told_);
    }

private:
    static constexpr std::size_t kShot = kThingCount;
    static constexpr std::size_t kKinds = kThingCount + 1;

    Result<ecs::Entity> put(scene::Simulation& simulation,
                            const Aim& aim,
                            const Vec3& velocity,
                            std::size_t kind);
    std::optional<Vec3> place_for(const physics::PhysicsWorld& world,
                                  const Aim& aim,
                                  const Room& room,
                                  bool is_dropped) const;
    void measure(scene::Simulation& simulation, std::size_t kind);
    void set_size(scene::Simulation& simulation, std::size_t kind, const Vec3& size_m);
    void dress(scene::Simulation& simulation, ecs::Entity entity, const Thing& thing) const;

    std::array<Thing, kKinds> things_;
    std::size_t chosen_{0};
    std::uint64_t serial_{0};
    bool limit_told_{false};
    std::array<physics::ShapeId, kKinds> boxes_{};
};

/// Takes an entity out of the world at once.
void destroy(scene::Simulation& simulation, ecs::Entity entity);

}  // namespace plumbline::game
