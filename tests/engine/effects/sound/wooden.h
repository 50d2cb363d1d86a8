// Scenes whose things sound.
#pragma once

#include "tests/engine/effects/drawn.h"

#include <filesystem>
#include <string>
#include <vector>

namespace plumbline::effects {

using scene::EntityDescription;
using scene::SceneDescription;
using test::cube;
using test::ground;
using test::Running;
using test::scene_of;

inline constexpr ServedDomains kSilent{};
inline constexpr ServedDomains kWithSound{.frame = false, .sound = true};

inline std::filesystem::path sound_file(const char* name) {
    return std::filesystem::path(PL_SOURCE_DIR) / "assets/sounds" / name;
}

inline scene::SurfaceTable loud_surfaces() {
    scene::SurfaceTable table = test::plain_surfaces();
    table.surfaces[0].step_sounds = {sound_file("step_grass_1.ogg")};
    table.surfaces.push_back(
        {.name = "wood",
         .density_kgpm3 = 1,
         .impact_sounds = {sound_file("impact_wood_0.ogg"), sound_file("impact_wood_1.ogg")}});
    return table;
}

/// Everything in it that has a body is of wood.
inline SceneDescription wooden(std::vector<EntityDescription> entities) {
    SceneDescription scene = scene_of(std::move(entities));
    scene.materials["wood"] = {.name = "wood", .surface = "wood"};
    for (EntityDescription& entity : scene.entities) entity.material = "wood";
    return scene;
}

inline EntityDescription wooden_cube(const std::string& name, const Vec3& position_m) {
    EntityDescription entity = cube(name, position_m);
    entity.material = "wood";
    return entity;
}

}  // namespace plumbline::effects
