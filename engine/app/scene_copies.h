// Scenes that play writes: they start from the one that runs, and overwrite nothing.
#pragma once

#include "engine/core/result.h"
#include "engine/scene/paths/scene_list.h"
#include "engine/scene/simulation.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::app {

/// Where a scene that starts from another one goes, and how it names that.
struct CopyPlace {
    std::filesystem::path file;  ///< not there yet: NAME-KIND.toml, or with the next free number
    std::string base;
    bool base_is_shipped{false};  ///< everybody has it
};
/// Beside the scene, or among the user's where the scene is the program's. The error: it is no scene file, or there is no
/// folder.
Result<CopyPlace> place_of_copy(const std::filesystem::path& scene,
                                std::string_view kind,
                                const scene::SceneFolders& folders);

/// A level that was written.
struct WrittenLevel {
    std::filesystem::path file;
    std::vector<std::string> notes;  ///< what it lacks or needs, for a person
};
/// The running scene as it is now, as NAME-level.toml. Nothing is left where it would not load.
Result<WrittenLevel> write_level(const scene::Simulation& simulation,
                                 const scene::SceneFolders& folders);

}  // namespace plumbline::app
