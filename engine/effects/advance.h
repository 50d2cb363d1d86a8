// One fixed step. The window, the tests, the replays and `simulate` all come through here.
#pragma once

#include "engine/effects/effect_runtime.h"
#include "engine/scene/game.h"
#include "engine/scene/simulation.h"

namespace plumbline::effects {

void advance(scene::Simulation& simulation,
             EffectRuntime& effects,
             scene::Game& game,
             const Actions& actions);

}  // namespace plumbline::effects
