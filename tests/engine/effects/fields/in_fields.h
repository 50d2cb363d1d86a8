// Bodies and scenes for tests of force fields.
#pragma once

#include "tests/engine/effects/drawn.h"

namespace plumbline::effects {

inline scene::EntityDescription kilogram(const std::string& name, const Vec3& position_m) {
    scene::EntityDescription ball = test::ball(name, position_m, 0.2_r);
    ball.body->mass_kg = 1;
    return ball;
}

inline scene::SceneDescription pond_with(std::vector<scene::EntityDescription> entities) {
    scene::SceneDescription scene = test::scene_of(std::move(entities));
    scene.forces.waters.push_back({.name = "pond", .min_m = {-9, -9, -9}, .max_m = {9, 0, 9}});
    return scene;
}

}  // namespace plumbline::effects
