#include "engine/app/scene_copies.h"

#include "engine/core/io/files.h"
#include "engine/scene/level/level_text.h"
#include "engine/scene/scene_file.h"

#include <fmt/format.h>

#include <utility>

namespace plumbline::app {
namespace fs = std::filesystem;

Result<CopyPlace> place_of_copy(const fs::path& scene,
                                std::string_view kind,
                                const scene::SceneFolders& folders) {
    if (scene.extension() != ".toml")
        return Error{.message = fmt::format("{} is no scene file that another one can start from",
                                            scene.filename().string())};
    CopyPlace place;
    place.base_is_shipped = !folders.assets.empty() && is_inside(folders.assets, scene);
    const fs::path folder = place.base_is_shipped ? folders.user_scenes : scene.parent_path();
    if (place.base_is_shipped && folder.empty())
        return Error{.message = "no folder for scenes: neither XDG_DATA_HOME nor HOME is set"};
    const fs::path base =
        place.base_is_shipped ? fs::proximate(scene, folders.assets) : scene.filename();
    place.base = base.generic_string();
    std::error_code ignored;
    for (int number = 1;; ++number) {
        const std::string ending = number == 1 ? "" : fmt::format("-{}", number);
        place.file = folder / fmt::format("{}-{}{}.toml", scene.stem().string(), kind, ending);
        if (!fs::exists(place.file, ignored)) return place;
    }
}

Result<WrittenLevel> write_level(const scene::Simulation& simulation,
                                 const scene::SceneFolders& folders) {
    const scene::SceneDescription& description = simulation.description();
    Result<CopyPlace> place = place_of_copy(description.file, "level", folders);
    if (!place) return place.error();
    const std::string title =
        description.title.empty() ? description.file.stem().string() : description.title;
    scene::LevelText level = scene::level_text(simulation, title + ", a level", place->base);
    if (const Result<Done> written = write_file_and_folder(place->file, level.toml); !written)
        return written.error();
    Diagnostics faults;
    const Result<scene::SceneDescription> made =
        scene::read_description(place->file, folders.assets, faults);
    if (!made) {
        std::error_code ignored;
        fs::remove(place->file, ignored);
        return Error{.message = fmt::format("the level would not load: {}", made.error().message)};
    }
    if (!place->base_is_shipped)
        level.notes.push_back(fmt::format("it needs {} beside it", place->base));
    return WrittenLevel{.file = std::move(place->file), .notes = std::move(level.notes)};
}

}  // namespace plumbline::app
