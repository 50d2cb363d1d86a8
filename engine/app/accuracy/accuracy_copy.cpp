#include "engine/app/accuracy/accuracy_copy.h"

#include "engine/app/scene_copies.h"
#include "engine/core/io/files.h"
#include "engine/core/text/toml_text.h"
#include "engine/scene/scene_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace plumbline::app {
namespace {

namespace fs = std::filesystem;

/// All of the scene but its [accuracy], of which only what a setting does not say is kept.
std::string text_of(const std::string& base,
                    const scene::Accuracy& own,
                    const study::Setting& setting) {
    const bool iterative = own.joints == physics::JointMethod::Iterative;
    return fmt::format(
        "# {}, at an accuracy that was chosen in play.\n"
        "[scene]\nbase = {}\nwithout = [\"accuracy\"]\n\n[accuracy]\n{}{}",
        toml_text(base),
        toml_text(base),
        study::accuracy_lines(setting),
        iterative ? "joints = \"iterative\"\n" : "");
}

bool is_at(const scene::Accuracy& got, const study::Setting& setting) {
    const physics::WorldDef wanted = study::world_def(setting);
    return got.solver == wanted.solver && got.step_hz == setting.step_hz &&
           got.substeps == wanted.substeps && got.iterations == wanted.iterations &&
           got.substeps_max.value_or(*got.substeps) == wanted.substeps_max;
}

}  // namespace

Result<fs::path> write_adopted_copy(const fs::path& scene,
                                    const study::Setting& setting,
                                    const scene::SceneFolders& folders) {
    const Result<CopyPlace> place = place_of_copy(scene, "adopted", folders);
    if (!place) return place.error();
    Diagnostics faults;
    const Result<scene::SceneDescription> own =
        scene::read_description(scene, folders.assets, faults);
    if (!own) return own.error();
    const fs::path& copy = place->file;
    const std::string text = text_of(place->base, own->accuracy, setting);
    if (const Result<Done> written = write_file_and_folder(copy, text); !written)
        return written.error();
    const Result<scene::SceneDescription> made =
        scene::read_description(copy, folders.assets, faults);
    if (made && made->entities.size() == own->entities.size() && is_at(made->accuracy, setting))
        return copy;
    std::error_code ignored;
    fs::remove(copy, ignored);
    return Error{.message = fmt::format(
                     "{} cannot be adopted by itself ({}); write these lines under [accuracy]: {}",
                     scene.filename().string(),
                     made ? "another scene is in its place" : made.error().message,
                     study::accuracy_lines(setting))};
}

}  // namespace plumbline::app
