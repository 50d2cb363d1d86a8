// An effect whose bodies deform: has them stepped, among what flows round them, and draws them.
#pragma once

#include "engine/effects/effect.h"

#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>

namespace plumbline::effects {

class Air;

/// While it does not live, they stay as they are.
class DeformableEffect : public Effect {
public:
    using List = std::span<scene::SceneDeformable> (scene::Simulation::*)();
    DeformableEffect(scene::Simulation& simulation,
                     std::string_view name,
                     List list,
                     scene::Fidelity fidelity);
    ~DeformableEffect() override;
    DeformableEffect(const DeformableEffect&) = delete;
    DeformableEffect& operator=(const DeformableEffect&) = delete;

    void before_step(scene::Simulation& simulation) override;
    void after_step(scene::Simulation& simulation, const scene::Game& game) override;
    void extract(const scene::Simulation& simulation,
                 const scene::ViewPoint& view,
                 render::RenderFrame& frame) override;

private:
    struct Drawn {
        std::uint64_t step{~std::uint64_t{0}};
        Real blend{0};
        bool rests{false};
    };
    std::span<scene::SceneDeformable> all() const { return (simulation_.*list_)(); }
    void set_fluids();
    void set_fluids(scene::SceneDeformable& each, const Air* air, bool has_water);
    void displace_water(scene::SceneDeformable& each);
    void warn_of_softness();
    void draw(const scene::SceneDeformable& each, double blend);

    scene::Simulation& simulation_;
    std::string name_;
    List list_;
    scene::Fidelity fidelity_;
    std::map<ecs::Entity, Drawn> drawn_;
    std::set<ecs::Entity> said_;  ///< that it is softer than asked
};

}  // namespace plumbline::effects
