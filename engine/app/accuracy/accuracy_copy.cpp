// "Adopt": the panel's setting in a copy of the scene file. The copy is the file's own text with the
// values under [accuracy] replaced where the parser found them, so that comments, order and layout
// stay; it is loaded before it is kept.
#include "engine/app/accuracy/accuracy_control.h"
#include "engine/core/io/files.h"
#include "engine/core/limits.h"
#include "engine/scene/paths/scene_paths.h"
#include "engine/scene/scene_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

// The library's exceptions stay inside the one function that parses.
#include <toml++/toml.h>

namespace plumbline::app {
namespace {

namespace fs = std::filesystem;

/// A part of the text, in bytes, and what comes in its place.
struct Edit {
    std::size_t begin{0};
    std::size_t end{0};
    std::string text;
};

/// Bytes of the parser's lines and columns: those count code points, from 1, behind a byte order
/// mark.
class Places {
public:
    explicit Places(std::string_view text) : text_(text) {
        lines_.push_back(text.starts_with("\xEF\xBB\xBF") ? 3 : 0);
        for (std::size_t i = 0; i < text.size(); ++i) {
            if (text[i] == '\n') lines_.push_back(i + 1);
        }
    }
    std::size_t byte_of(const toml::source_position& place) const {
        const std::size_t line = std::clamp<std::size_t>(place.line, 1, lines_.size());
        std::size_t at = lines_[line - 1];
        for (toml::source_index column = 1; column < place.column && at < text_.size(); ++column) {
            ++at;
            while (at < text_.size() && (static_cast<unsigned char>(text_[at]) & 0xC0U) == 0x80U)
                ++at;
        }
        return at;
    }
    std::size_t end_of_line(std::size_t at) const {
        const std::size_t end = text_.find('\n', at);
        return end == std::string_view::npos ? text_.size() : end + 1;
    }
    std::size_t start_of_line(std::size_t at) const {
        return *std::prev(std::ranges::upper_bound(lines_, at));
    }
    Edit in_place_of(const toml::node& node, std::string text) const {
        return {byte_of(node.source().begin), byte_of(node.source().end), std::move(text)};
    }

private:
    std::string_view text_;
    std::vector<std::size_t> lines_;
};

/// What [accuracy] is to say, key by key.
std::map<std::string, std::string> wanted_keys(const study::Setting& setting) {
    std::map<std::string, std::string> keys;
    const std::string lines = study::accuracy_lines(setting);
    for (std::size_t at = 0; at < lines.size();) {
        const std::size_t end = lines.find('\n', at);
        const std::string line = lines.substr(at, end - at);
        const std::size_t equals = line.find(" = ");
        keys[line.substr(0, equals)] = line.substr(equals + 3);
        at = end + 1;
    }
    return keys;
}

/// Values that are there are replaced; the others are put in as the table is written: under its
/// header, inside its braces, or as dotted keys.
void set_accuracy(const toml::table& root,
                  const study::Setting& setting,
                  std::string_view text,
                  std::vector<Edit>& edits) {
    const Places places(text);
    std::map<std::string, std::string> keys = wanted_keys(setting);
    const toml::table* table = root["accuracy"].as_table();
    if (table == nullptr) {
        std::string lines = text.empty() || text.back() == '\n' ? "" : "\n";
        lines += "\n[accuracy]\n";
        for (const auto& [key, value] : keys) lines += fmt::format("{} = {}\n", key, value);
        edits.push_back({text.size(), text.size(), lines});
        return;
    }
    // The most that an island may get must not stay behind from another choice.
    const bool fixed = !keys.contains("substeps_max");
    if (fixed) keys["substeps_max"] = keys.at("substeps");
    // All that a preset stands for is said now; "auto" would still look for more.
    keys["preset"] = "\"balanced\"";
    for (const auto& [key, node] : *table) {
        const auto wanted = keys.find(std::string(key.str()));
        if (wanted == keys.end()) continue;
        edits.push_back(places.in_place_of(node, wanted->second));
        keys.erase(wanted);
    }
    keys.erase("preset");
    if (fixed) keys.erase("substeps_max");

    const std::size_t begin = places.byte_of(table->source().begin);
    std::string added;
    if (text.substr(begin).starts_with('[')) {
        const std::size_t below = places.end_of_line(begin);
        if (below == text.size() && !text.ends_with('\n')) added += '\n';
        for (const auto& [key, value] : keys) added += fmt::format("{} = {}\n", key, value);
        edits.push_back({below, below, added});
    } else if (text.substr(begin).starts_with('{')) {
        for (const auto& [key, value] : keys)
            added += fmt::format("{}{} = {}", added.empty() ? " " : ", ", key, value);
        if (!added.empty() && !table->empty()) added += ',';
        edits.push_back({begin + 1, begin + 1, added});
    } else {
        const std::size_t line = places.start_of_line(begin);
        for (const auto& [key, value] : keys)
            added += fmt::format("accuracy.{} = {}\n", key, value);
        edits.push_back({line, line, added});
    }
}

/// Files that the scene names from where it lies: the copy names them from the assets folder.
void keep_references(const toml::node& node,
                     const fs::path& scene,
                     const scene::SceneFolders& folders,
                     const Places& places,
                     std::vector<Edit>& edits) {
    if (const toml::table* table = node.as_table()) {
        for (const auto& [key, each] : *table) keep_references(each, scene, folders, places, edits);
        return;
    }
    if (const toml::array* array = node.as_array()) {
        for (const toml::node& each : *array) keep_references(each, scene, folders, places, edits);
        return;
    }
    const std::optional<std::string> name = node.value_exact<std::string>();
    if (!name || name->find_first_of("./") == std::string::npos || name->size() > 4096) return;
    const Result<scene::Reference> there = scene::find_reference(scene, folders.assets, *name);
    if (!there || !there->exists) return;
    std::error_code failed;
    const fs::path from_assets = fs::relative(there->file, folders.assets, failed);
    if (failed || from_assets.empty() || *from_assets.begin() == "..") return;
    edits.push_back(places.in_place_of(node, fmt::format("\"{}\"", from_assets.generic_string())));
}

std::string edited(std::string text, std::vector<Edit> edits) {
    // From the back, so that the places in front of an edit stay where they are.
    std::ranges::stable_sort(edits, std::ranges::greater{}, &Edit::begin);
    for (const Edit& edit : edits) text.replace(edit.begin, edit.end - edit.begin, edit.text);
    return text;
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

/// Empty where the copy is the scene at the setting.
std::string what_is_wrong(const fs::path& copy,
                          const fs::path& scene,
                          const study::Setting& setting,
                          const scene::SceneFolders& folders) {
    Diagnostics faults;
    const Result<scene::SceneDescription> made =
        scene::read_description(copy, folders.assets, faults);
    if (!made) return made.error().message;
    Diagnostics known;
    const Result<scene::SceneDescription> own =
        scene::read_description(scene, folders.assets, known);
    if (!own) return own.error().message;
    const bool whole = made->entities.size() == own->entities.size() &&
                       made->arrays.size() == own->arrays.size() &&
                       made->joints.size() == own->joints.size() &&
                       made->materials.size() == own->materials.size() &&
                       faults.list().size() <= known.list().size();
    if (!whole) return "the copy is not the same scene";
    scene::Accuracy wanted = own->accuracy;
    put_over(study::overrides(setting), wanted);
    const scene::Accuracy& got = made->accuracy;
    const bool right = got.solver == wanted.solver && got.step_hz == wanted.step_hz &&
                       got.substeps == wanted.substeps && got.iterations == wanted.iterations &&
                       got.joints == wanted.joints &&
                       got.substeps_max.value_or(*got.substeps) == *wanted.substeps_max;
    return right ? std::string() : "the copy is not at that setting";
}

}  // namespace

Result<fs::path> write_adopted_copy(const fs::path& scene,
                                    const study::Setting& setting,
                                    const scene::SceneFolders& folders) {
    if (scene.extension() != ".toml")
        return Error{.message = fmt::format("{} is no scene file: there is no [accuracy] to write",
                                            scene.filename().string())};
    const Result<std::string> text = read_file(scene, limits::kSceneFileBytes);
    if (!text) return text.error();
    const bool ours = !folders.assets.empty() && is_inside(folders.assets, scene);
    const fs::path folder = ours ? folders.user_scenes : scene.parent_path();
    if (ours && folder.empty())
        return Error{.message = "no folder for scenes: neither XDG_DATA_HOME nor HOME is set"};
    std::vector<Edit> edits;
    try {
        const toml::table root = toml::parse(*text);
        set_accuracy(root, setting, *text, edits);
        if (ours) keep_references(root, scene, folders, Places(*text), edits);
    } catch (const toml::parse_error& fault) {
        return Error{.message = fmt::format("{}: {}", scene.string(), fault.description())};
    }
    const fs::path copy = unused_copy(folder, scene.stem().string());
    const Result<Done> written = write_file_and_folder(copy, edited(*text, std::move(edits)));
    if (!written) return written.error();
    const std::string wrong = what_is_wrong(copy, scene, setting, folders);
    if (wrong.empty()) return copy;
    std::error_code ignored;
    fs::remove(copy, ignored);
    return Error{.message = fmt::format("{} cannot be adopted by itself ({}); write these lines "
                                        "under [accuracy]: {}",
                                        scene.filename().string(),
                                        wrong,
                                        study::accuracy_lines(setting))};
}

}  // namespace plumbline::app
