// Scene files: TOML to SceneDescription, every key checked, every fault with its place.
#pragma once

#include "engine/core/result.h"
#include "engine/core/text/diagnostics.h"
#include "engine/scene/paths/scene_list.h"
#include "engine/scene/scene_description.h"

#include <filesystem>

namespace plumbline::scene {

/// Loads a Plumbline scene (.toml) with its includes, a JSON scene (.json) with its meshes, or a model
/// (.glb .gltf .obj .ply .stl .dae .fbx), which gets a ground plane, a sun and a camera. Faults go to `faults`; the result is an error (exit code 4,
/// first fault in the message) when any of them is one. Of a .toml it reads no model, image or sound: it checks
/// only that they exist and lie inside `assets_folder` or the scene's own folder.
Result<SceneDescription> read_description(const std::filesystem::path& file,
                                          const std::filesystem::path& assets_folder,
                                          Diagnostics& faults);

/// Imports the models of a loaded scene and tells what is wrong with them (errors, each once, at the
/// entity that shows it).
void check_models(const SceneDescription& scene, Diagnostics& faults);

/// SCENE as people name it: a path, or a name below the person's own scenes or assets/scenes, in that
/// order, with or without ".toml".
Result<std::filesystem::path> find_scene(const std::string& name, const SceneFolders& folders);

}  // namespace plumbline::scene
