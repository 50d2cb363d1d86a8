// A small scene with a person in it, stepped as the program steps it, for tests of the rules.
#pragma once

#include "engine/scene/simulation.h"
#include "game/components.h"
#include "game/rules/rules.h"

#include <gtest/gtest.h>

#include <initializer_list>
#include <memory>
#include <string>
#include <vector>

namespace plumbline::game {

inline scene::EntityDescription block(const std::string& name,
                                      const Vec3& size_m,
                                      const Vec3& position_m,
                                      physics::BodyKind kind = physics::BodyKind::Static,
                                      Real mass_kg = 1) {
    scene::EntityDescription entity;
    entity.name = name;
    entity.world_from_body.position = position_m;
    entity.visual = scene::Primitive{physics::BoxShape{size_m}};
    entity.body.emplace();
    entity.body->kind = kind;
    entity.body->mass_kg = mass_kg;
    return entity;
}

/// Ground with its top at y = 0 and a person at the origin who looks down -Z.
inline scene::SceneDescription meadow() {
    scene::SceneDescription scene;
    scene.title = "meadow";
    scene.player.emplace();
    scene.entities.push_back(block("ground", {200, 1, 200}, {0, -0.5_r, 0}));
    return scene;
}

inline Actions press(std::initializer_list<Action> actions) {
    Actions pressed;
    for (const Action action : actions) {
        pressed.held.set(static_cast<std::size_t>(action));
        pressed.pressed[static_cast<std::size_t>(action)] = 1;
        pressed.amount[static_cast<std::size_t>(action)] = 1.0F;
    }
    return pressed;
}

inline Actions hold(std::initializer_list<Action> actions) {
    Actions held = press(actions);
    held.pressed = {};
    return held;
}

inline Actions look(float yaw_rad, float pitch_rad) {
    Actions actions;
    actions.look_yaw_rad = yaw_rad;
    actions.look_pitch_rad = pitch_rad;
    return actions;
}

class Playground {
public:
    assets::AssetLibrary library;  // outlives the simulation, which refers to it

    explicit Playground(const scene::SceneDescription& scene = meadow(),
                        int step_hz = 60,
                        const std::filesystem::path& assets = "no such folder") {
        scene::SurfaceTable surfaces;
        surfaces.surfaces.push_back({.name = "default"});
        auto built = scene::build_simulation(scene, {.step_hz = step_hz}, library, surfaces);
        EXPECT_TRUE(built.ok()) << (built.ok() ? "" : built.error().message);
        simulation = std::move(*built);
        game = std::make_unique<PlaygroundGame>(*simulation, assets);
        run(0.5);
        messages();
    }

    void step(const Actions& actions = {}) {
        simulation->remember_poses();
        game->act(*simulation, actions);
        simulation->step();
        game->judge(*simulation);
        simulation->destroy_marked();
        for (const auto& heard : game->footsteps()) footsteps.push_back(heard);
    }
    /// The same actions in every step: held keys.
    void run(double seconds, const Actions& actions = {}) {
        const auto count = static_cast<int>(seconds / simulation->step_s() + 0.5);
        for (int i = 0; i < count; ++i) step(actions);
    }
    /// What to do so that the view looks at a place.
    Actions turn_to(const Vec3& point_m) const {
        const Pose camera = game->view(*simulation, 1, 0, 0).world_from_camera;
        const Vec3 now = camera.orientation * Vec3{0, 0, -1};
        const Vec3 way = glm::normalize(point_m - camera.position);
        const auto yaw = [](const Vec3& d) { return std::atan2(-d.x, -d.z); };
        return look(yaw(way) - yaw(now), std::asin(way.y) - std::asin(now.y));
    }
    std::vector<std::string> messages() { return game->hud(*simulation).messages; }
    std::size_t thing_count() const {
        std::size_t count = 0;
        for (auto [entity, dropped] : simulation->registry.view<const scene::Dropped>()) {
            static_cast<void>(entity);
            static_cast<void>(dropped);
            ++count;
        }
        return count;
    }
    physics::BodyId body(const std::string& name) const {
        const ecs::Entity entity = simulation->find(name);
        EXPECT_TRUE(simulation->registry.alive(entity)) << name;
        return simulation->registry.get<scene::BodyRef>(entity).body;
    }
    physics::BodyState state(const std::string& name) const {
        return simulation->physics.state(body(name));
    }
    Vec3 feet() const { return game->player()->state().feet_position_m; }

    std::unique_ptr<scene::Simulation> simulation;
    std::unique_ptr<PlaygroundGame> game;  // destroyed before the simulation it knows
    std::vector<scene::FootstepEvent> footsteps;
};

}  // namespace plumbline::game
