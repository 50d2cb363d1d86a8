#include "engine/assets/asset_library.h"

#include "engine/assets/asset_images_impl.h"
#include "engine/assets/foreign/decoder.h"
#include "engine/assets/model/model_bodies.h"
#include "engine/assets/model_import.h"
#include "engine/assets/sound_import.h"
#include "engine/core/limits.h"
#include "engine/core/log.h"

#include <algorithm>
#include <mutex>
#include <new>
#include <optional>
#include <set>
#include <stop_token>
#include <string_view>
#include <thread>

namespace plumbline::assets {
namespace {

namespace fs = std::filesystem;

std::uint32_t id_after(std::size_t index) {
    return static_cast<std::uint32_t>(index + 1);
}

/// When a file was saved last, and how long it is.
struct FileStamp {
    fs::path file;
    fs::file_time_type saved{};
    std::uintmax_t bytes{0};

    static FileStamp of(const fs::path& file) {
        std::error_code failed;
        FileStamp stamp{.file = file, .saved = fs::last_write_time(file, failed)};
        stamp.bytes = fs::file_size(file, failed);
        return stamp;
    }
    friend bool operator==(const FileStamp&, const FileStamp&) = default;
};

Result<SoundData> sound_of(const fs::path& file, const fs::path& installed) {
    if (!is_foreign(file, installed)) return import_sound(file);
    const Result<std::string> bytes = read_sound_file(file);
    if (!bytes) return bytes.error();
    return decode_sound_apart(*bytes, file.string());
}

}  // namespace

struct AssetLibrary::ModelEntry {
    Model model;
    std::optional<MovingModel> moving;
    std::vector<FileStamp> stamps;
    bool in_doubt{false};

    bool is_current() const {
        return std::all_of(stamps.begin(), stamps.end(), [](const FileStamp& stamp) {
            return FileStamp::of(stamp.file) == stamp;
        });
    }
};

/// Sounds that a thread has decoded before anybody asked. A file that cannot be read is none of them:
/// who asks for it hears why.
struct AssetLibrary::SoundsAhead {
    std::mutex mutex;
    std::map<fs::path, SoundData> ready;
    std::jthread worker;  // last: it ends first

    void decode(const std::stop_token& closing,
                const std::vector<fs::path>& files,
                const fs::path& installed) {
        for (const fs::path& file : files) {
            if (closing.stop_requested()) return;
            const fs::path key = file.lexically_normal();
            try {
                Result<SoundData> sound = sound_of(file, installed);
                const std::lock_guard lock(mutex);
                if (sound) ready.emplace(key, std::move(*sound));
            } catch (const std::bad_alloc&) {
                return;
            }
        }
    }
    std::optional<SoundData> take(const fs::path& key) {
        const std::lock_guard lock(mutex);
        const auto found = ready.find(key);
        if (found == ready.end()) return {};
        return std::move(ready.extract(found).mapped());
    }
};

AssetLibrary::AssetLibrary(const fs::path& installed) : images_(std::make_unique<Images>()) {
    images_->installed = installed;
}
AssetLibrary::~AssetLibrary() = default;

Result<Model> AssetLibrary::model(const fs::path& file, const fs::path& root) {
    const auto key = std::make_pair(file.lexically_normal(), root.lexically_normal());
    const auto known = models_by_file_.find(key);
    if (known == models_by_file_.end()) {
        auto entry = std::make_unique<ModelEntry>();
        if (const Result<Done> read = import(*entry, file, root); !read) return read.error();
        models_.push_back(std::move(entry));
        models_.back()->model.id = {id_after(models_.size() - 1)};
        models_by_file_.emplace(key, models_.back()->model.id);
        return models_.back()->model;
    }
    ModelEntry& entry = *models_[known->second.value - 1];
    if (entry.in_doubt && !entry.is_current()) {
        if (const Result<Done> read = import(entry, file, root); !read) return read.error();
    }
    entry.in_doubt = false;
    return entry.model;
}

Result<Done> AssetLibrary::import(ModelEntry& entry, const fs::path& file, const fs::path& root) {
    // Looked at before the reading: a save meanwhile is then seen as one.
    const FileStamp stamp = FileStamp::of(file);
    Result<ModelData> imported = import_model(file, root);
    if (!imported) return imported.error();
    // What a file does not say about its surfaces' back sides, those of a stranger's model are drawn.
    const bool is_silent = is_foreign(file, images_->installed) && !says_sides(file);
    entry.model.materials.clear();
    for (MaterialData& material : imported->materials) {
        if (is_silent && !material.two_sided) {
            material.two_sided = true;
            material.thin = false;
        }
        entry.model.materials.push_back(add_material(material));
    }
    entry.stamps.clear();
    for (const fs::path& read : imported->files) entry.stamps.push_back(FileStamp::of(read));
    entry.stamps.front() = stamp;
    {
        const std::lock_guard lock(images_->mutex);
        for (EmbeddedImage& image : imported->images) {
            images_->embedded.insert_or_assign(
                image.name.lexically_normal(),
                std::make_shared<const std::string>(std::move(image.bytes)));
        }
    }
    imported->images.clear();
    const auto put = [&](MeshId& id, MeshData mesh) {
        if (id == MeshId{}) {
            meshes_.emplace_back();
            id = {id_after(meshes_.size() - 1)};
        }
        mesh.version = meshes_[id.value - 1].version + 1;
        meshes_[id.value - 1] = std::move(mesh);
    };
    put(entry.model.mesh, std::exchange(imported->mesh, {}));
    if (!imported->physics.is_empty()) {
        std::vector<MeshData> bodies = body_meshes(*imported, file.string());
        entry.model.bodies.resize(bodies.size());
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            if (!bodies[i].indices.empty()) put(entry.model.bodies[i], std::move(bodies[i]));
        }
    }
    entry.moving.reset();
    if (imported->animations.empty()) return Done{};
    ModelParts parts = parts_of(*imported);
    const ModelPose rest = rest_pose(*imported);
    MovingModel moving{.data = std::move(*imported)};
    if (!parts.still.empty()) put(moving.still, still_mesh(moving.data, parts, file.string()));
    for (const ModelPart& part : parts.moving) {
        moving.part_meshes.emplace_back();
        if (!part.deforms) put(moving.part_meshes.back(), part_mesh(moving.data, part, rest));
    }
    moving.parts = std::move(parts.moving);
    entry.moving = std::move(moving);
    return Done{};
}

const MovingModel* AssetLibrary::moving(ModelId id) const {
    if (id.value < 1 || id.value > models_.size()) return nullptr;
    const std::optional<MovingModel>& moving = models_[id.value - 1]->moving;
    return moving ? &*moving : nullptr;
}

void AssetLibrary::doubt_models() {
    for (const auto& entry : models_) entry->in_doubt = true;
}

std::vector<fs::path> AssetLibrary::model_files() const {
    std::vector<fs::path> files;
    for (const auto& entry : models_) {
        for (const FileStamp& stamp : entry->stamps) files.push_back(stamp.file);
    }
    return files;
}

Result<SoundId> AssetLibrary::sound(const fs::path& file) {
    const fs::path key = file.lexically_normal();
    const auto known = sounds_by_file_.find(key);
    if (known != sounds_by_file_.end()) return known->second;
    Result<SoundData> imported = [&]() -> Result<SoundData> {
        if (sounds_ahead_) {
            if (std::optional<SoundData> sound = sounds_ahead_->take(key)) return std::move(*sound);
        }
        try {
            return sound_of(file, images_->installed);
        } catch (const std::bad_alloc&) {
            return out_of_memory("sound", file);
        }
    }();
    if (!imported) return imported.error();
    sounds_.push_back(std::move(*imported));
    const SoundId id{id_after(sounds_.size() - 1)};
    sounds_by_file_.emplace(key, id);
    return id;
}

void AssetLibrary::prefetch_sounds(std::vector<fs::path> files) {
    if (sounds_ahead_) return;
    sounds_ahead_ = std::make_unique<SoundsAhead>();
    try {
        sounds_ahead_->worker = std::jthread(
            [ahead = sounds_ahead_.get(), files = std::move(files), installed = images_->installed](
                const std::stop_token& closing) { ahead->decode(closing, files, installed); });
    } catch (const std::system_error& fault) {
        log_note("sounds are decoded when they are first heard: {}", fault.what());
    }
}

MeshId AssetLibrary::add_mesh(const std::string& name, MeshData mesh) {
    const auto known = meshes_by_name_.find(name);
    if (known != meshes_by_name_.end()) return known->second;
    meshes_.push_back(std::move(mesh));
    const MeshId id{id_after(meshes_.size() - 1)};
    meshes_by_name_.emplace(name, id);
    return id;
}

MeshData& AssetLibrary::change_mesh(MeshId id) {
    PL_ASSERT(id.value >= 1 && id.value <= meshes_.size(), "a mesh of this library");
    MeshData& mesh = meshes_[id.value - 1];
    ++mesh.version;
    return mesh;
}

MaterialId AssetLibrary::add_material(MaterialData material) {
    const auto [first, last] = materials_by_name_.equal_range(material.name);
    for (auto known = first; known != last; ++known) {
        if (materials_[known->second.value - 1] == material) return known->second;
    }
    materials_.push_back(std::move(material));
    const MaterialId id{id_after(materials_.size() - 1)};
    materials_by_name_.emplace(materials_.back().name, id);
    return id;
}

const MeshData& AssetLibrary::mesh(MeshId id) const {
    PL_ASSERT(id.value >= 1 && id.value <= meshes_.size(), "a mesh of this library");
    return meshes_[id.value - 1];
}

const MaterialData& AssetLibrary::material(MaterialId id) const {
    PL_ASSERT(id.value >= 1 && id.value <= materials_.size(), "a material of this library");
    return materials_[id.value - 1];
}

const SoundData& AssetLibrary::sound(SoundId id) const {
    PL_ASSERT(id.value >= 1 && id.value <= sounds_.size(), "a sound of this library");
    return sounds_[id.value - 1];
}

}  // namespace plumbline::assets
