// The scenes that a person can ask for by name: those below assets/scenes, and their own.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::scene {

/// What somebody sees first who asked for nothing.
inline constexpr std::string_view kFirstScene = "garden";

/// Where scenes with names are.
struct SceneFolders {
    std::filesystem::path assets;       ///< the program's own: nothing is written below it
    std::filesystem::path user_scenes;  ///< the person's; empty where there is no home
};
SceneFolders scene_folders(const std::filesystem::path& assets_folder);

/// Of the files that a name stands for in a folder, the first of these that is there. glTF: with rigid bodies only, where scenes
/// are listed.
inline constexpr std::array<std::string_view, 4> kSceneEndings{".toml", ".json", ".glb", ".gltf"};

/// A scene as play takes it by name.
struct ListedScene {
    std::string name;  ///< below its folder of scenes, without its ending: "garden", "hard/H05"
    std::string title;
    std::string description;
    std::filesystem::path file;
    bool is_game{false};       ///< it has a [goal]
    bool is_users_own{false};  ///< below folders.user_scenes; stands for a shipped one of its name
};

/// kFirstScene, then by name, those in folders last. Files that hold nothing but materials and
/// prefabs are no scenes; one that cannot be read is listed without a title.
std::vector<ListedScene> list_scenes(const SceneFolders& folders);

/// The name of the scene that `name` may have been meant to be; empty when none is near.
std::string nearest_scene(const std::string& name, const SceneFolders& folders);

}  // namespace plumbline::scene
