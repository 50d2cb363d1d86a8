// Every effect's maker, for the table. What an effect is like inside is in its own source.
#pragma once

#include "engine/effects/effect.h"

#include <memory>

namespace plumbline::effects {

// picture_effects.cpp: each fills its optional part of the frame.
std::unique_ptr<Effect> make_sun_shadow(scene::Simulation&);
std::unique_ptr<Effect> make_flashlight(scene::Simulation&);
std::unique_ptr<Effect> make_fog(scene::Simulation&);
std::unique_ptr<Effect> make_skybox(scene::Simulation&);
std::unique_ptr<Effect> make_post(scene::Simulation&);

std::unique_ptr<Effect> make_model_animation(scene::Simulation&);  // model_animation.cpp
std::unique_ptr<Effect> make_viewer_aids(scene::Simulation&);      // viewer_aids.cpp

std::unique_ptr<Effect> make_impact_sounds(scene::Simulation&);   // impact_sounds.cpp
std::unique_ptr<Effect> make_ambient_sounds(scene::Simulation&);  // ambient_sounds.cpp
std::unique_ptr<Effect> make_footsteps(scene::Simulation&);       // footsteps.cpp

// physics_effects.cpp: each switches an optional part of the physics on while it lives.
std::unique_ptr<Effect> make_continuous_collision(scene::Simulation&);
std::unique_ptr<Effect> make_gyroscopic_torque(scene::Simulation&);
std::unique_ptr<Effect> make_contact_events(scene::Simulation&);

}  // namespace plumbline::effects
