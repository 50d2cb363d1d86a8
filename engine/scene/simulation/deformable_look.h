// What is drawn of cloths and soft bodies.
#pragma once

#include "engine/scene/simulation.h"

namespace plumbline::scene {

/// Gives its entity a mesh of its own, in the shape that the points have.
void show(Simulation& simulation, const SceneDeformable& each, assets::MeshData mesh);

}  // namespace plumbline::scene
