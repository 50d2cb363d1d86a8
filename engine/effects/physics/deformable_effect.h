// An effect whose bodies deform: steps them, in the sub-steps of the bodies that they touch, and draws them.
#pragma once

#include "engine/core/time/stopwatch.h"
#include "engine/effects/effect.h"
#include "engine/physics/force_field.h"

#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::effects {

class Air;

/// While it does not live, they stay as they are.
class DeformableEffect : public Effect, public physics::ForceField {
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

    bool acts_on(physics::BodyId body) const override;
    void act(std::span<physics::BodyInField* const> bodies,
             const physics::FieldTime& time) override;
    void list_pairs(std::vector<Pair>& pairs) const override;
    int substeps() const override;
    double added_mass_kg(physics::BodyId body) const override;
    bool carries() const override { return true; }

private:
    struct Drawn {
        std::uint64_t step{~std::uint64_t{0}};
        Real blend{0};
        bool rests{false};
    };
    std::span<scene::SceneDeformable> all() const { return (simulation_.*list_)(); }
    void set_fluids();
    void set_fluids(physics::Deformable& body, const Air* air, bool has_water);
    void warn_of_softness();
    void draw(const scene::SceneDeformable& each, double blend);

    scene::Simulation& simulation_;
    std::string name_;
    List list_;
    scene::Fidelity fidelity_;
    std::vector<physics::BodyId> pushed_;  ///< bodies that they push in this step, by id
    std::map<ecs::Entity, Drawn> drawn_;
    std::set<ecs::Entity> said_;  ///< that it is softer than asked
    LapTimer lap_;
};

}  // namespace plumbline::effects
