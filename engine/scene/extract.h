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
                            std::uint32_t width_px,
                            std::uint32_t height_px);

/// Whether it shines now, by itself or by hand.
bool is_lit(const Simulation& simulation, const PointLight& light);

/// Where an image of that instant shows the entity: between its last two poses if it can move.
Pose drawn_pose(const Simulation& simulation,
                ecs::Entity entity,
                const Transform& transform,
                Real blend);

}  // namespace plumbline::scene
