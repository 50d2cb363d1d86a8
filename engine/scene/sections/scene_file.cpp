#include "engine/scene/scene_file.h"

#include "engine/assets/model_import.h"
#include "engine/core/hash.h"
#include "engine/core/io/files.h"
#include "engine/core/limits.h"
#include "engine/scene/formats/renamed_keys.h"
#include "engine/scene/paths/scene_list.h"
#include "engine/scene/sections/scene_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <set>

namespace plumbline::scene {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kIncludeDepth = 16;
// Everything that a scene may hold beside materials and prefabs.
constexpr std::array<std::string_view, 24> kSceneOnly{
    "world",      "accuracy", "player", "camera", "sun",   "sky",   "ambient", "fog",
    "flashlight", "post",     "goal",   "entity", "array", "joint", "effects", "view",
    "hard_case",  "fountain", "wind",   "grass",  "flock", "time",  "sound",   "change"};

/// One file of the load.
struct SourceFile {
    std::shared_ptr<const std::string> name;  ///< as messages show it; what is said in it shares it
    TomlNode root;
};

/// What a file is named for by another one.
enum class PartUse : std::uint8_t {
    Include,  ///< its materials and prefabs
    Base,     ///< all of it
};
struct Part {
    const SourceFile* source{nullptr};   ///< null: it could not be had
    std::set<const std::string*> files;  ///< that took part, by name
};

/// Loads a scene and what it includes; one object a load.
class Loader {
public:
    Loader(const fs::path& assets_folder, Diagnostics& out) : faults_(out) {
        context_.assets_folder = assets_folder;
    }

    /// Nothing when there is an error among the faults.
    /// `tables`: where the file's own go, over those that it starts from.
    std::optional<SceneDescription> load(const fs::path& file, TomlNode* tables = nullptr) {
        scene_.file = file;
        const SourceFile* source = open(file, SourceLocation{}, {});
        if (source == nullptr) return {};
        context_.scene_location = SourceLocation{.file = source->name};
        collect(*source, file);
        const TomlNode whole = with_base(*source);
        if (tables != nullptr) *tables = whole;
        TableReader root(whole, {}, faults_);
        read_sections(root, scene_, context_);
        read_prefabs(scene_, context_);
        read_entities(root, scene_, context_);
        read_arrays(root, scene_, context_);
        read_changes(root, scene_, context_);
        read_joints(root, scene_, context_);
        read_ropes(root, scene_, context_);
        read_cloths(root, scene_, context_);
        read_softs(root, scene_, context_);
        read_vehicles(root, scene_, context_);
        read_views(root, scene_);
        read_hard_case(root, scene_, context_);
        read_goal(root, scene_, context_);
        read_nature(root, scene_, context_);
        root.find("material");
        root.find("prefab");
        root.finish();
        check_whole_scene(scene_, context_);
        scene_.content_hash = hasher_.digest();
        if (faults_.any_error()) return {};
        return std::move(scene_);
    }

private:
    /// Reads and parses one file; faults are reported at `asked_by` unless they lie in the text.
    const SourceFile* open(const fs::path& file,
                           const SourceLocation& asked_by,
                           const std::string& key) {
        auto source = std::make_unique<SourceFile>();
        source->name = std::make_shared<const std::string>(file.string());
        const SourceLocation whole{.file = source->name};
        const SourceLocation& blamed = asked_by.file != nullptr ? asked_by : whole;
        const Result<std::string> text = read_file(file, limits::kSceneFileBytes);
        if (!text) {
            faults_.error(blamed, key, text.error().message);
            return nullptr;
        }
        hasher_.add(text->data(), text->size());
        scene_.source_files.push_back(file);
        auto parsed = parse_toml(*text, source->name);
        if (const auto* fault = std::get_if<TextFault>(&parsed)) {
            faults_.error({source->name, fault->line, fault->column}, {}, fault->message);
            return nullptr;
        }
        source->root = std::move(*std::get_if<TomlNode>(&parsed));
        rename_keys(source->root, faults_);
        sources_.push_back(std::move(source));
        return sources_.back().get();
    }

    /// Takes materials and prefabs, of included files first. Returns the files that took part.
    std::set<const std::string*> collect(const SourceFile& source, const fs::path& file) {
        chain_.push_back(file);
        std::set<const std::string*> below;
        TableReader root(source.root, {}, faults_);
        if (auto table = root.table("scene")) {
            if (const std::string base = table->text("base"); !base.empty()) {
                const Part part =
                    bring(base, table->find("base")->location, "scene.base", file, PartUse::Base);
                bases_[&source] = part.source;
                below = part.files;
            } else if (table->has("without")) {
                table->error("without",
                             "is about the scene that base names; expected base as well");
            }
            const std::vector<std::string> names = table->texts("include");
            const TomlNode* node = table->find("include");
            for (std::size_t i = 0; i < names.size(); ++i) {
                const Part part =
                    bring(names[i],
                          (*node->array())[std::min(i, node->array()->size() - 1)].location,
                          fmt::format("scene.include[{}]", i),
                          file,
                          PartUse::Include);
                below.insert(part.files.begin(), part.files.end());
            }
        }
        take_materials(root, below);
        take_prefabs(root, below);
        chain_.pop_back();
        below.insert(source.name.get());
        return below;
    }

    /// The file's tree, laid over that of the scene that it starts from.
    TomlNode with_base(const SourceFile& source) {
        const auto base = bases_.find(&source);
        if (base == bases_.end() || base->second == nullptr) return source.root;
        TomlNode below = with_base(*base->second);
        TableReader root(source.root, {}, faults_);
        auto table = root.table("scene");
        for (const std::string& section : table->texts("without")) {
            if (std::ranges::find(kSceneOnly, section) == kSceneOnly.end()) {
                const std::string hint = suggestion(section, kSceneOnly);
                table->error("without", "no table is called \"{}\"{}", shown(section), hint);
            }
            std::erase_if(std::get<TomlTable>(below.value),
                          [&](const TomlEntry& entry) { return entry.key == section; });
        }
        return laid_over(std::move(below), source.root);
    }

    /// A file that another one names, with the materials and prefabs of its own and its parts'.
    Part bring(const std::string& name,
               const SourceLocation& location,
               const std::string& key,
               const fs::path& including,
               PartUse use) {
        Result<Reference> reference = find_reference(including, context_.assets_folder, name);
        if (!reference) {
            faults_.error(location, key, reference.error().message);
            return {};
        }
        if (!reference->exists)  // what is shipped is at hand by its bare name
            reference = find_reference(including, context_.assets_folder, "scenes/" + name);
        if (!reference || !reference->exists) {
            faults_.error(location,
                          key,
                          "\"{}\" does not exist beside this file, in assets or in assets/scenes",
                          shown(name));
            return {};
        }
        const fs::path file = reference->file.lexically_normal();
        std::error_code failed;
        const fs::path real = fs::weakly_canonical(file, failed);
        const auto same = [&](const fs::path& other) {
            std::error_code ignored;
            return fs::weakly_canonical(other, ignored) == real;
        };
        if (std::ranges::any_of(chain_, same)) {
            std::string chain;
            for (const fs::path& link : chain_) chain += link.filename().string() + " -> ";
            chain += file.filename().string();
            faults_.error(location, key, "includes itself: {}", chain);
            return {};
        }
        // Two ways to the same file bring it once.
        if (const auto known = included_.find(real); known != included_.end()) return known->second;
        if (chain_.size() >= kIncludeDepth || sources_.size() >= limits::kReferencedFiles) {
            faults_.error(location,
                          key,
                          "too many files include one another; at most {} deep, {} in all",
                          kIncludeDepth,
                          limits::kReferencedFiles);
            return {};
        }
        const SourceFile* source = open(file, location, key);
        if (source == nullptr) return {};
        if (use == PartUse::Include) warn_of_scene_keys(*source);
        return included_.emplace(real, Part{source, collect(*source, file)}).first->second;
    }

    void warn_of_scene_keys(const SourceFile& source) {
        TableReader root(source.root, {}, faults_);
        for (const std::string_view key : kSceneOnly) {
            if (root.has(key))
                root.warning(key, "only materials and prefabs are taken from an included file");
        }
        for (const std::string_view key : {"scene", "material", "prefab"}) root.find(key);
        if (auto table = root.table("scene")) {
            for (const std::string_view key :
                 {"title", "description", "controls", "base", "without", "include"})
                table->find(key);
            table->finish();
        }
        root.finish();
    }

    /// True when the name may be given here: it is new, or only an included file has it.
    bool may_define(TableReader& table,
                    std::string_view what,
                    const std::string& name,
                    const SourceLocation* earlier,
                    const std::set<const std::string*>& below) {
        if (earlier == nullptr || below.contains(earlier->file.get())) return true;
        table.error("name",
                    "\"{}\" is the name of the {} at {} already",
                    shown(name),
                    what,
                    to_string(*earlier));
        return false;
    }

    void take_materials(TableReader& root, const std::set<const std::string*>& below) {
        const auto nodes = root.tables("material");
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            TableReader table = root.item("material", nodes, i);
            const std::string name = read_name(table);
            table.require("name", "the material's name");
            assets::MaterialData material = read_material(table, context_);
            if (name.empty()) continue;
            const auto earlier = context_.material_locations.find(name);
            const SourceLocation* location =
                earlier == context_.material_locations.end() ? nullptr : &earlier->second;
            if (!may_define(table, "material", name, location, below)) continue;
            context_.material_locations[name] = table.location();
            scene_.materials[name] = std::move(material);
        }
    }

    void take_prefabs(TableReader& root, const std::set<const std::string*>& below) {
        const auto nodes = root.tables("prefab");
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            TableReader table = root.item("prefab", nodes, i);
            const std::string name = read_name(table);
            table.require("name", "the prefab's name");
            if (name.empty()) continue;
            const auto earlier = context_.prefabs.find(name);
            const SourceLocation* location =
                earlier == context_.prefabs.end() ? nullptr : &earlier->second.node->location;
            if (!may_define(table, "prefab", name, location, below)) continue;
            context_.prefabs[name] = PrefabSource{&nodes[i], table.path()};
        }
    }

    FaultList faults_;
    LoadContext context_{.assets_folder = {}, .faults = faults_};
    SceneDescription scene_;
    Hasher hasher_;
    std::vector<std::unique_ptr<SourceFile>> sources_;
    std::vector<fs::path> chain_;
    std::map<fs::path, Part> included_;
    std::map<const SourceFile*, const SourceFile*> bases_;
};

Result<SceneDescription> refuse(Diagnostics& faults, std::size_t first) {
    for (std::size_t i = first; i < faults.list().size(); ++i) {
        const Diagnostic& fault = faults.list()[i];
        if (fault.severity == Severity::Error)
            return Error{.message = to_string(fault), .exit_code = ExitCode::Refused};
    }
    return Error{.message = "the scene was refused", .exit_code = ExitCode::Refused};
}

Result<SceneDescription> load_model(const fs::path& file,
                                    const fs::path& assets_folder,
                                    Diagnostics& faults) {
    const std::size_t before = faults.list().size();
    const auto fail = [&](std::string message) {
        faults.add({Severity::Error, file.string(), 0, 0, {}, std::move(message)});
        return refuse(faults, before);
    };
    std::error_code failed;
    if (!fs::exists(file, failed)) return fail("does not exist");
    if (!fs::is_regular_file(file, failed)) return fail("is not a regular file");
    const bool is_ours = !assets_folder.empty() && is_inside(assets_folder, file);
    const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    const fs::path root = is_ours ? assets_folder : folder;
    const std::string extension = file.extension().string();
    if (extension != ".glb" && extension != ".gltf") return scene_of_model(file, root);
    std::optional<SceneDescription> scene;
    {
        FaultList list(faults);
        scene = read_gltf_scene(file, root, assets_folder, list);
    }  // hands the faults over
    if (!scene) return refuse(faults, before);
    return std::move(*scene);
}

}  // namespace

Result<SceneDescription> read_description(const fs::path& file,
                                          const fs::path& assets_folder,
                                          Diagnostics& faults) {
    const std::size_t before = faults.list().size();
    if (assets::is_model_file(file)) return load_model(file, assets_folder, faults);
    const std::string extension = file.extension().string();
    if (extension == ".json") {
        std::optional<SceneDescription> scene = read_json_scene(file, assets_folder, faults);
        return scene ? Result<SceneDescription>(std::move(*scene)) : refuse(faults, before);
    }
    if (extension != ".toml") {
        faults.add(
            {Severity::Error,
             file.string(),
             0,
             0,
             {},
             fmt::format(
                 "\"{}\" is no kind of scene that is read; expected .toml, .json or a model: "
                 "{} (convert others to glTF)",
                 shown(extension),
                 fmt::join(assets::kModelExtensions, " "))});
        return refuse(faults, before);
    }
    std::optional<SceneDescription> scene;
    {
        Loader loader(assets_folder, faults);
        scene = loader.load(file);
    }  // hands the faults over
    if (!scene) return refuse(faults, before);
    return std::move(*scene);
}

Result<TomlNode> tables_of_scene(const fs::path& file, const fs::path& assets_folder) {
    Diagnostics faults;
    TomlNode tables;
    std::optional<SceneDescription> scene;
    {
        Loader loader(assets_folder, faults);
        scene = loader.load(file, &tables);
    }  // hands the faults over
    if (!scene) return refuse(faults, 0).error();
    return tables;
}

Result<fs::path> find_scene(const std::string& name, const SceneFolders& folders) {
    const fs::path scenes = folders.assets / "scenes";
    std::vector<fs::path> candidates{fs::path(name)};
    for (const fs::path& folder : {folders.user_scenes, scenes}) {
        if (folder.empty()) continue;
        candidates.push_back(folder / name);
        for (const std::string_view ending : kSceneEndings)
            candidates.push_back(folder / (name + std::string(ending)));
    }
    candidates.emplace_back(name + ".toml");
    std::string oddity;  // what is there under that name, and is no scene
    for (const fs::path& candidate : candidates) {
        std::error_code failed;
        const fs::file_status status = fs::status(candidate, failed);
        // What is there but no file, a FIFO say, gets its own message from the reader.
        if (fs::exists(status) && !fs::is_directory(status)) return candidate;
        if (!oddity.empty()) continue;
        if (fs::is_directory(status)) oddity = "it is a folder";
        if (failed && status.type() != fs::file_type::not_found) oddity = failed.message();
    }
    std::string why = fmt::format("here or in {}", scenes.string());
    if (!folders.user_scenes.empty())
        why = fmt::format("here, in {} or in {}", folders.user_scenes.string(), scenes.string());
    if (!oddity.empty()) why += ": " + oddity;
    const std::string nearest = nearest_scene(name, folders);
    if (!nearest.empty()) why += fmt::format("; the nearest is \"{}\"", nearest);
    return Error{.message = fmt::format(
                     "there is no scene \"{}\" {}; plumbline scenes lists them", shown(name), why),
                 .exit_code = ExitCode::Refused};
}

}  // namespace plumbline::scene
