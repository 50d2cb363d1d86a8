// Holding cloth or a soft body by the place that is looked at.
#pragma once

#include "engine/scene/simulation.h"
#include "game/rules/hands/aim.h"

#include <cstdint>
#include <optional>

namespace plumbline::game {

class Pinch {
public:
    /// Takes hold of what is looked at within `reach_m`, if that is cloth or a soft body.
    bool take(scene::Simulation& simulation, const Aim& aim, Real reach_m);
    void release(scene::Simulation& simulation);
    /// Lets go; all of it gets the velocity.
    void throw_it(scene::Simulation& simulation, const Vec3& velocity_mps);
    bool holding() const { return of_ != Of::Nothing; }
    void change_distance(Real by_m);
    /// One step. False, and the hand opens: it is too heavy, or holds on to something.
    bool pull(scene::Simulation& simulation, const Aim& aim);
    /// For saved games; the simulation knows the points that are held.
    void serialize(Archive& archive, scene::Simulation& simulation);

private:
    enum class Of : std::uint8_t { Nothing, Cloth, Soft };
    friend constexpr Of last_of(Of) { return Of::Soft; }
    static std::span<scene::SceneDeformable> all_of(scene::Simulation& simulation, Of of);
    /// Null: nothing is held, or it is gone.
    physics::Deformable* held(scene::Simulation& simulation) const;

    Of of_{Of::Nothing};
    std::uint32_t number_{0};  ///< among all of its kind
    Vec3d place_m_{0, 0, 0};   ///< where the hand is
    Real distance_m_{1};       ///< of that from the eye
    Real strained_s_{0};       ///< for so long it has pulled harder than a person can
};

}  // namespace plumbline::game
