#include "engine/scene/paths/scene_list.h"

#include "engine/core/io/files.h"
#include "engine/core/limits.h"
#include "engine/core/text/nearest_name.h"
#include "engine/scene/formats/toml_tree.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <tuple>

namespace plumbline::scene {
namespace fs = std::filesystem;
namespace {

/// All of a file that is there to be included.
constexpr std::array<std::string_view, 3> kIncludedOnly{"scene", "material", "prefab"};

/// Adds every scene below the folder, named but not read; of two with one name the earlier stays, in one folder by kSceneEndings.
void add_scene_files(const fs::path& root, bool is_users_own, std::vector<ListedScene>& files) {
    const auto place_of_ending = [](const ListedScene& scene) {
        return std::ranges::find(kSceneEndings, scene.file.extension().string()) -
               kSceneEndings.begin();
    };
    std::vector<ListedScene> found;
    std::error_code failed;
    for (fs::recursive_directory_iterator entry(root, failed), end; !failed && entry != end;
         entry.increment(failed)) {
        if (std::ranges::find(kSceneEndings, entry->path().extension().string()) ==
            kSceneEndings.end())
            continue;
        fs::path name = entry->path().lexically_relative(root);
        name.replace_extension();
        found.push_back(
            {.name = name.string(), .file = entry->path(), .is_users_own = is_users_own});
    }
    std::ranges::sort(found, std::ranges::less{}, place_of_ending);
    for (ListedScene& scene : found) {
        if (std::ranges::find(files, scene.name, &ListedScene::name) == files.end())
            files.push_back(std::move(scene));
    }
}

std::vector<ListedScene> scene_files(const SceneFolders& folders) {
    std::vector<ListedScene> files;
    if (!folders.user_scenes.empty()) add_scene_files(folders.user_scenes, true, files);
    add_scene_files(folders.assets / "scenes", false, files);
    const auto place_of = [](const ListedScene& scene) {
        const bool in_folder = scene.name.find('/') != std::string::npos;
        return std::tuple(scene.name != kFirstScene, in_folder, std::string_view(scene.name));
    };
    std::ranges::sort(files, std::ranges::less{}, place_of);
    return files;
}

std::string text_under(const TomlTable& table, std::string_view key) {
    const TomlNode* node = find_key(table, key);
    const std::string* text = node != nullptr ? node->text() : nullptr;
    return text != nullptr ? *text : "";
}

bool is_included_only(std::string_view key) {
    return std::ranges::find(kIncludedOnly, key) != kIncludedOnly.end();
}

/// Up to the end of [scene], which is all that a list shows; all of the text where no table of
/// another name shows that it is a scene. Guesses by the starts of lines: what is cut within a text
/// or an array does not parse.
std::string_view start_of(std::string_view text) {
    constexpr auto kNowhere = std::string_view::npos;
    std::size_t end = kNowhere;
    bool in_heading = false;
    bool is_scene = false;
    for (std::size_t at = 0; at != kNowhere && !(is_scene && end != kNowhere);) {
        const std::size_t line_end = text.find('\n', at);
        std::string_view key = text.substr(at, line_end - at);
        if (key.starts_with('[')) {
            key.remove_prefix(std::min(key.find_first_not_of("[ "), key.size()));
            key = key.substr(0, key.find_first_of(" .]"));
            if (in_heading && end == kNowhere) end = at;
            in_heading = in_heading || key == "scene";
            is_scene = is_scene || !is_included_only(key);
        }
        at = line_end == kNowhere ? kNowhere : line_end + 1;
    }
    return is_scene ? text.substr(0, end) : text;
}

constexpr std::string_view kBelowALine = "\n[goal]";
constexpr std::string_view kGoalTable = kBelowALine.substr(1);

/// Without physics it is a model, which a scene beside it may show.
bool has_bodies(const fs::path& gltf) {
    const Result<std::string> bytes = read_file(gltf, limits::kModelFileBytes);
    return bytes && bytes->find("_rigid_bodies") != std::string::npos;  // with KHR_, KHR_physics
}

/// Fills in what the file says of itself. False when it is there to be included.
bool read_heading(ListedScene& scene) {
    if (scene.file.extension() != ".toml") {
        const bool is_json = scene.file.extension() == ".json";
        scene.title = scene.file.stem().string();
        scene.description = is_json ? "a JSON scene" : "a glTF scene with physics";
        return is_json || has_bodies(scene.file);
    }
    const Result<std::string> text = read_file(scene.file, limits::kSceneFileBytes);
    if (!text) return true;
    scene.is_game = text->starts_with(kGoalTable) || text->find(kBelowALine) != std::string::npos;
    const auto name = std::make_shared<const std::string>(scene.file.string());
    const std::string_view start = start_of(*text);
    bool is_scene = start.size() < text->size();
    auto parsed = parse_toml(start, name);
    if (is_scene && std::holds_alternative<TextFault>(parsed)) parsed = parse_toml(*text, name);
    const auto* root = std::get_if<TomlNode>(&parsed);
    if (root == nullptr || root->table() == nullptr) return true;
    const TomlNode* heading = find_key(*root->table(), "scene");
    if (heading != nullptr && heading->table() != nullptr) {
        scene.title = text_under(*heading->table(), "title");
        scene.description = text_under(*heading->table(), "description");
        if (!text_under(*heading->table(), "base").empty()) return true;
    }
    for (const TomlEntry& entry : *root->table())
        is_scene = is_scene || !is_included_only(entry.key);
    return is_scene;
}

}  // namespace

SceneFolders scene_folders(const fs::path& assets_folder) {
    const fs::path data = user_data_folder();
    return {.assets = assets_folder, .user_scenes = data.empty() ? data : data / "scenes"};
}

std::vector<ListedScene> list_scenes(const SceneFolders& folders) {
    std::vector<ListedScene> scenes = scene_files(folders);
    std::erase_if(scenes, [](ListedScene& scene) { return !read_heading(scene); });
    return scenes;
}

std::string nearest_scene(const std::string& name, const SceneFolders& folders) {
    const std::vector<ListedScene> scenes = scene_files(folders);
    std::vector<std::string_view> known;
    for (const ListedScene& scene : scenes) known.emplace_back(scene.name);
    const std::string_view whole = nearest_name(name, known);
    if (!whole.empty()) return std::string(whole);
    // "scenes/gardn.toml", or "H5" for "hard/H05": the last part may tell.
    const std::string last = fs::path(name).stem().string();
    std::vector<std::string> stems;
    for (const ListedScene& scene : scenes) stems.push_back(fs::path(scene.name).filename());
    const std::vector<std::string_view> views(stems.begin(), stems.end());
    const std::string_view stem = nearest_name(last, views);
    const auto place = std::ranges::find(views, stem);
    if (stem.empty() || place == views.end()) return {};
    return scenes[static_cast<std::size_t>(place - views.begin())].name;
}

}  // namespace plumbline::scene
