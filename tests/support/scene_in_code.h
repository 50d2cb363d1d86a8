// Small scenes made in code, for tests that need no file.
#pragma once

#include "engine/effects/advance.h"
#include "engine/scene/simulation.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace plumbline::test {

/// One silent surface, 1000 kg/m3.
inline scene::SurfaceTable plain_surfaces() {
    scene::SurfaceTable table;
    table.surfaces.push_back({.name = "default", .density_kgpm3 = 1000});
    return table;
}

inline scene::EntityDescription box(const std::string& name,
                                    const Vec3& position_m,
                                    const Vec3& size_m,
                                    physics::BodyKind kind = physics::BodyKind::Dynamic) {
    scene::EntityDescription entity;
    entity.name = name;
    entity.world_from_body.position = position_m;
    entity.visual = scene::Primitive{physics::BoxShape{.size_m = size_m}};
    entity.body = scene::BodyDescription{.kind = kind};
    entity.location = in_file("test.toml", 10);
    return entity;
}

inline scene::EntityDescription cube(const std::string& name, const Vec3& position_m) {
    return box(name, position_m, {1, 1, 1});
}

inline scene::EntityDescription ball(const std::string& name,
                                     const Vec3& position_m,
                                     Real radius_m) {
    scene::EntityDescription entity = cube(name, position_m);
    entity.visual = scene::Primitive{physics::SphereShape{.radius_m = radius_m}};
    return entity;
}

/// 40 m square, top at y = 0.
inline scene::EntityDescription ground() {
    return box("ground", {0, -0.5_r, 0}, {40, 1, 40}, physics::BodyKind::Static);
}

inline scene::SceneDescription scene_of(std::vector<scene::EntityDescription> entities) {
    scene::SceneDescription description;
    description.file = "test.toml";
    description.entities = std::move(entities);
    return description;
}

/// A simulation with what it needs to live.
struct Running {
    assets::AssetLibrary library;
    std::unique_ptr<scene::Simulation> simulation;
    scene::NoGame game{scene::CameraDescription{}};

    explicit Running(const scene::SceneDescription& description,
                     const scene::SurfaceTable& surfaces = plain_surfaces(),
                     const scene::SimulationOverrides& overrides = {}) {
        Result<std::unique_ptr<scene::Simulation>> built =
            scene::build_simulation(description, overrides, library, surfaces);
        EXPECT_TRUE(built.ok()) << (built.ok() ? "" : built.error().message);
        if (built) simulation = std::move(*built);
    }

    scene::Simulation& operator*() { return *simulation; }
    scene::Simulation* operator->() { return simulation.get(); }

    /// Without effects.
    void step(int count) {
        for (int i = 0; i < count; ++i) {
            simulation->remember_poses();
            simulation->step();
            simulation->destroy_marked();
        }
    }
    void step(int count, effects::EffectRuntime& effects) {
        for (int i = 0; i < count; ++i) effects::advance(*simulation, effects, game, {});
    }

    physics::BodyId body(const std::string& name) {
        return simulation->registry.get<scene::BodyRef>(simulation->find(name)).body;
    }
    physics::BodyState state(const std::string& name) {
        return simulation->physics.state(body(name));
    }
};

}  // namespace plumbline::test
