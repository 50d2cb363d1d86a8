// The world, blended between two steps and copied into plain data for the renderer and the mixer.
#pragma once

#include "engine/audio/sound_cue.h"
#include "engine/render/render_frame.h"
#include "engine/scene/game.h"
#include "engine/scene/simulation.h"

namespace plumbline::scene {

/// Entities, camera, sun, ambient and local lights. Optional parts (shadows, fog, sky, flashlight,
/// post) are left empty: their effects fill them in.
render::RenderFrame extract(const Simulation& simulation,
                            const ViewPoint& view,
                            Real blend,
                            std::uint32_t width_px,
                            std::uint32_t height_px);

}  // namespace plumbline::scene
