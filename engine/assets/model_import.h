// Model files to ModelData: glTF 2 (.gltf, .glb), OBJ (.obj with its .mtl), PLY and STL by readers of our
// own; Collada (.dae) and FBX through assimp in a process of its own.
#pragma once

#include "engine/assets/model_data.h"
#include "engine/core/result.h"

#include <array>
#include <filesystem>
#include <string_view>

namespace plumbline::assets {

/// `root`: the file, and the files that it names, must lie inside it (links followed); what it
/// names must also lie in its own folder or below. Faults of single meshes (NaN, indices out of
/// range) or animations drop those with a warning; a file that is unsafe or not what its name says
/// is refused as a whole.
///
/// Material names are kept: scenes replace materials by name. +Y is up: PLY and STL, whose +Z is by
/// custom, are turned; a Collada or FBX file says what it means. FBX lengths become metres.
Result<ModelData> import_model(const std::filesystem::path& file,
                               const std::filesystem::path& root);

inline constexpr std::array<std::string_view, 7> kModelExtensions{
    ".glb", ".gltf", ".obj", ".ply", ".stl", ".dae", ".fbx"};
/// Whether files of its kind say which surfaces have a back side, as glTF does.
bool says_sides(const std::filesystem::path& file);
/// By the name's ending, in capitals or not.
bool is_model_file(const std::filesystem::path& file);

}  // namespace plumbline::assets
