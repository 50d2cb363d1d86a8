#include "game/commands/scenes_command.h"

#include "engine/core/io/files.h"
#include "engine/core/text/printable.h"
#include "engine/scene/formats/json_text.h"
#include "engine/scene/paths/scene_list.h"
#include "game/command_line/refuse.h"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>

namespace plumbline::game {
namespace {

void print_json(const std::vector<scene::ListedScene>& scenes) {
    scene::JsonText json(scene::JsonLayout::Readable);
    json.begin_array();
    for (const scene::ListedScene& scene : scenes) {
        json.begin_object();
        json.key("name").text(scene.name);
        json.key("title").text(scene.title);
        json.key("description").text(scene.description);
        json.key("file").text(scene.file.string());
        json.end_object();
    }
    json.end_array();
    std::cout << json.str() << '\n';
}

void print_lines(const std::vector<scene::ListedScene>& scenes) {
    std::size_t width = 0;
    for (const scene::ListedScene& scene : scenes) width = std::max(width, scene.name.size());
    for (const scene::ListedScene& scene : scenes) {
        const char* between = scene.title.empty() || scene.description.empty() ? "" : ": ";
        std::cout << fmt::format("{:<{}}  {}{}{}\n",
                                 printable(scene.name),
                                 width,
                                 printable(scene.title),
                                 between,
                                 printable(scene.description));
    }
}

}  // namespace

ExitCode run_scenes(bool as_json) {
    const Result<DataFolders> folders = find_data_folders();
    if (!folders) return refuse(folders.error());
    const std::vector<scene::ListedScene> scenes =
        scene::list_scenes(scene::scene_folders(folders->assets));
    if (as_json)
        print_json(scenes);
    else
        print_lines(scenes);
    return ExitCode::Good;
}

}  // namespace plumbline::game
