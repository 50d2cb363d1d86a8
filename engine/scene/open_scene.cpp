#include "engine/scene/open_scene.h"

#include "engine/core/hash.h"
#include "engine/core/limits.h"
#include "engine/core/process/interrupt.h"
#include "engine/scene/scene_file.h"

#include <algorithm>
#include <variant>

namespace plumbline::scene {
namespace fs = std::filesystem;
namespace {

/// Collects files, each once, in the order in which they are named.
class FileList {
public:
    void add(const fs::path& file, FileUse use) {
        if (file.empty()) return;
        const auto same = [&](const FileStamp& known) { return known.path == file; };
        if (std::ranges::none_of(files_, same)) files_.push_back(stamp_of(file, use));
    }
    void add_material(const assets::MaterialData& material) {
        for (const fs::path& map :
             {material.base_color_map, material.normal_map, material.orm_map, material.height_map})
            add(map, FileUse::Image);
    }
    void add_entity(const EntityDescription& entity) {
        if (const auto* model = std::get_if<ModelVisual>(&entity.visual))
            add(model->file, FileUse::Model);
        if (entity.sound) add(entity.sound->file, FileUse::Sound);
    }
    void add_folder(const fs::path& folder, FileUse use) {
        std::vector<fs::path> inside;
        std::error_code failed;
        for (fs::directory_iterator entry(folder, failed), end; !failed && entry != end;
             entry.increment(failed))
            inside.push_back(entry->path());
        std::ranges::sort(inside);
        for (const fs::path& file : inside) add(file, use);
    }
    std::vector<FileStamp> take() { return std::move(files_); }

private:
    std::vector<FileStamp> files_;
};

std::vector<FileStamp> files_of(const SceneDescription& scene, const fs::path& surfaces) {
    FileList list;
    for (const fs::path& file : scene.source_files) list.add(file, FileUse::Scene);
    list.add(surfaces, FileUse::Surfaces);
    for (const EntityDescription& entity : scene.entities) list.add_entity(entity);
    for (const ArrayDescription& array : scene.arrays) list.add_entity(array.prefab);
    for (const auto& [name, prefab] : scene.prefabs) list.add_entity(prefab);
    for (const auto& [name, material] : scene.materials) list.add_material(material);
    if (scene.sky) list.add_folder(scene.sky->folder, FileUse::Image);
    return list.take();
}

}  // namespace

FileStamp stamp_of(const fs::path& path, FileUse use) {
    FileStamp stamp{.path = path, .use = use};
    std::error_code failed;
    if (!fs::is_regular_file(path, failed)) return stamp;
    stamp.bytes = fs::file_size(path, failed);
    if (failed) stamp.bytes = 0;
    stamp.written = fs::last_write_time(path, failed);
    return stamp;
}

bool unchanged(std::span<const FileStamp> files) {
    return std::ranges::all_of(
        files, [](const FileStamp& file) { return stamp_of(file.path, file.use) == file; });
}

Result<std::unique_ptr<Simulation>> OpenedScene::build(assets::AssetLibrary& library) const {
    const IgnoresInterrupts loading;
    Result<std::unique_ptr<Simulation>> built =
        build_simulation(description, overrides, library, surfaces);
    if (!built) return built;
    for (const std::string& warning : warnings) (*built)->warnings.push_back(warning);
    return built;
}

std::uint64_t OpenedScene::motion_hash() const {
    Hasher hasher;
    hasher.add(&description.content_hash, sizeof(description.content_hash));
    for (const FileStamp& file : files) {
        if (file.use != FileUse::Surfaces && file.use != FileUse::Model) continue;
        // What cannot be read plays no part in the world either; its name still tells the two apart.
        const Result<std::string> bytes = read_file(file.path, limits::kModelFileBytes);
        const std::string name = file.path.filename().string();
        hasher.add(name.data(), name.size());
        if (bytes) hasher.add(bytes->data(), bytes->size());
    }
    return hasher.digest();
}

Result<OpenedScene> open_scene(const fs::path& file,
                               const OpenOptions& options,
                               Diagnostics& faults) {
    const IgnoresInterrupts loading;
    const std::size_t known = faults.list().size();
    const fs::path surfaces = options.folders.config / "surfaces.toml";
    SurfaceTable table = load_surfaces(surfaces, options.folders.assets, faults);
    Result<SceneDescription> description = read_description(file, options.folders.assets, faults);
    if (!description) return description.error();
    OpenedScene opened{.description = std::move(*description),
                       .surfaces = std::move(table),
                       .overrides = options.overrides};
    for (std::size_t i = known; i < faults.list().size(); ++i)
        opened.warnings.push_back(to_string(faults.list()[i]));
    opened.files = files_of(opened.description, surfaces);
    put_over(options.overrides, opened.description.accuracy);
    return opened;
}

}  // namespace plumbline::scene
