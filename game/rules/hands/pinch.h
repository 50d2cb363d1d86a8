// Holding cloth or a soft body by the place that is looked at.
#pragma once

#include "engine/scene/simulation.h"
#include "game/rules/hands/aim.h"

#include <array>
#include <cstdint>
#include <optional>

namespace plumbline::game {

/// Cloth or a soft body that is looked at.
struct SoftLooked {
    ecs::Entity entity{};
    double distance_m{0};
    double mass_kg{0};                        ///< of all of it
    std::array<std::uint32_t, 3> triangle{};  ///< of its points
};
/// The nearest within `reach_m`, through bodies.
std::optional<SoftLooked> soft_looked_at(const scene::Simulation& simulation,
                                         const Aim& aim,
                                         double reach_m);
/// Null: the entity is none, or gone.
physics::Deformable* deformable_of(scene::Simulation& simulation, ecs::Entity entity);

class Pinch {
public:
    /// Takes hold of what is looked at within `reach_m`, if that is cloth or a soft body.
    bool take(scene::Simulation& simulation, const Aim& aim, Real reach_m);
    void release(scene::Simulation& simulation);
    /// Lets go; all of it gets the velocity.
    void throw_it(scene::Simulation& simulation, const Vec3& velocity_mps);
    bool holding() const { return entity_.generation != 0; }
    ecs::Entity entity() const { return entity_; }
    void change_distance(Real by_m);
    /// One step. False, and the hand opens: it is too heavy, or holds on to something.
    bool pull(scene::Simulation& simulation, const Aim& aim);
    /// For saved games; the simulation knows the points that are held.
    void serialize(Archive& archive, scene::Simulation& simulation);

private:
    ecs::Entity entity_{};
    Vec3d place_m_{0, 0, 0};  ///< where the hand is
    Real distance_m_{1};      ///< of that from the eye
    Real strained_s_{0};      ///< for so long it has pulled harder than a person can
};

}  // namespace plumbline::game
