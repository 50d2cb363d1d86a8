#include "engine/app/accuracy/accuracy_copy.h"

#include "engine/core/io/files.h"
#include "engine/scene/scene_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>

namespace plumbline::app {
namespace {

namespace fs = std::filesystem;

/// As TOML writes it between quotation marks.
std::string toml_text(std::string_view text) {
    std::string written;
    for (const char letter : text) {
        if (letter == '"' || letter == '\\')
            written += fmt::format("\\{}", letter);
        else if (static_cast<unsigned char>(letter) < 0x20 || letter == 0x7F)
            written += fmt::format("\\u{:04x}", static_cast<unsigned>(letter));
        else
            written += letter;
    }
    return fmt::format("\"{}\"", written);
}

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

fs::path unused_copy(const fs::path& folder, const std::string& stem) {
    std::error_code ignored;
    for (int number = 1;; ++number) {
        fs::path file =
            folder /
            fmt::format("{}-adopted{}.toml", stem, number == 1 ? "" : fmt::format("-{}", number));
        if (!fs::exists(file, ignored)) return file;
    }
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
    if (scene.extension() != ".toml")
        return Error{.message = fmt::format("{} is no scene file: there is no [accuracy] to write",
                                            scene.filename().string())};
    Diagnostics faults;
    const Result<scene::SceneDescription> own =
        scene::read_description(scene, folders.assets, faults);
    if (!own) return own.error();
    const bool ours = !folders.assets.empty() && is_inside(folders.assets, scene);
    const fs::path folder = ours ? folders.user_scenes : scene.parent_path();
    if (ours && folder.empty())
        return Error{.message = "no folder for scenes: neither XDG_DATA_HOME nor HOME is set"};
    const fs::path base = ours ? fs::proximate(scene, folders.assets) : scene.filename();
    const fs::path copy = unused_copy(folder, scene.stem().string());
    const std::string text = text_of(base.generic_string(), own->accuracy, setting);
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
