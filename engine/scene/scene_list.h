// The scenes below assets/scenes: what a person can ask for by name.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace plumbline::scene {

/// A scene as play takes it by name.
struct ListedScene {
    std::string name;  ///< below assets/scenes, without ".toml": "garden", "hard/H05"
    std::string title;
    std::string description;
    std::filesystem::path file;
};

/// By name, those in folders last. Files that hold nothing but materials and prefabs are no scenes;
/// one that cannot be read is listed without a title.
std::vector<ListedScene> list_scenes(const std::filesystem::path& assets_folder);

/// The name of the scene that `name` may have been meant to be; empty when none is near.
std::string nearest_scene(const std::string& name, const std::filesystem::path& assets_folder);

}  // namespace plumbline::scene
