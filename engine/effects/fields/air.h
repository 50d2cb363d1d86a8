// How the air moves, for what it pushes.
#pragma once

#include "engine/scene/simulation.h"

namespace plumbline::effects {

/// For one step.
class Air {
public:
    Air() = default;
    /// Looks at the simulation's description for as long as it lives.
    explicit Air(const scene::Simulation& simulation);
    bool blows() const { return scene_ != nullptr; }
    /// m/s. `in_wind`: the share of the wind that reaches the place.
    Vec3d at(const Vec3d& place, double time_s, double in_wind = 1) const;

private:
    const scene::SceneDescription* scene_{nullptr};  ///< null: it stands still
};

}  // namespace plumbline::effects
