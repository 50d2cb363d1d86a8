#include "engine/effects/advance.h"

namespace plumbline::effects {

void advance(scene::Simulation& simulation,
             EffectRuntime& effects,
             scene::Game& game,
             const Actions& actions) {
    simulation.remember_poses();           // so that drawing can blend
    game.act(simulation, actions);         // intent becomes forces
    effects.refresh(simulation);           // made or destroyed as callers come and go
    effects.before_step(simulation);       // so do wind, water, magnets
    simulation.step();                     // contacts, then new poses
    effects.after_step(simulation, game);  // breaking, sparks, sounds
    game.judge(simulation);                // goals and spawning
    simulation.destroy_marked();
}

}  // namespace plumbline::effects
