// Cameras as the command line gives them.
#pragma once

#include "engine/scene/game.h"

#include <optional>
#include <string>

namespace plumbline::game {

/// "x,y,z,yaw,pitch": metres and degrees; yaw 0 looks down -Z and grows to the left, pitch up.
std::optional<scene::ViewPoint> parse_camera(const std::string& text, Real fov_y_rad);

/// An eye somewhere; the hand with the flashlight is a little below.
scene::ViewPoint view_at(const Pose& world_from_camera, Real fov_y_rad);
/// The same, looking somewhere else.
scene::ViewPoint view_from(const Vec3& eye_m, const Vec3& target_m, Real fov_y_rad);

/// The scene's [camera], else its player's eyes, else the default camera.
scene::ViewPoint first_view(const scene::SceneDescription& scene);

}  // namespace plumbline::game
