// A running scene as a glTF file that other programs read: what is seen of it, and KHR_physics_rigid_bodies with
// KHR_implicit_shapes for what moves.
#pragma once

#include "engine/core/result.h"
#include "engine/scene/simulation.h"

#include <filesystem>
#include <string>
#include <vector>

namespace plumbline::scene {

struct GltfExport {
    std::string glb;                 ///< the file's bytes
    std::vector<std::string> notes;  ///< what it lacks, for a person
};

/// As it is now. `surroundings`: see surroundings_of(); empty for none.
GltfExport gltf_of(Simulation& simulation, const std::string& surroundings);

/// What a scene file says of world, accuracy, player, camera, light and air, as JSON: the exporter keeps it as
/// `extras.plumbline`, for our reader alone. Empty for a file without any. The error is the file's.
Result<std::string> surroundings_of(const std::filesystem::path& file,
                                    const std::filesystem::path& assets_folder);

}  // namespace plumbline::scene
