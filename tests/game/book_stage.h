// A stage as in the book: a camera that goes about it, and a pointer on its things.
#pragma once

#include "tests/game/rules/playground.h"

#include <array>
#include <cmath>
#include <initializer_list>
#include <string>

namespace plumbline::game {

/// The stage that the camera goes about, 15 m away and 20 degrees above, on the side of -Z.
inline scene::SceneDescription stage() {
    scene::SceneDescription scene;
    const Real pitch = radians_from_degrees(20.0_r);
    scene.gravity_mps2 = {0, -10, 0};
    scene.camera.position_m = Vec3{0, std::sin(pitch), -std::cos(pitch)} * Real{15};
    scene.camera.target_m = {0, 0, 0};
    scene.camera.fov_y_rad = kPi / 2;
    scene.camera.orbit.emplace();
    return scene;
}

inline scene::SceneDescription stage_with(
    std::initializer_list<scene::EntityDescription> entities) {
    scene::SceneDescription scene = stage();
    scene.entities = entities;
    return scene;
}

inline scene::EntityDescription loose(const std::string& name, const Vec3& position_m) {
    return block(name, {2, 2, 2}, position_m, physics::BodyKind::Dynamic, 1);
}

inline scene::EntityDescription floor_at(Real top_m) {
    return block("ground", {100, 2, 100}, {0, top_m - 1, 0});
}

inline Pose camera(const Playground& play) {
    return play.game->view(*play.simulation, 1, 0, 0).world_from_camera;
}

/// With the pointer on a point of the world, as the camera sees it.
inline Actions at(const Playground& play, const Vec3& point_m, Actions actions = {}) {
    const Vec3 seen = transform_point(invert(camera(play)), point_m);
    actions.pointer = std::array{seen.x / -seen.z, seen.y / -seen.z};
    return actions;
}

}  // namespace plumbline::game
