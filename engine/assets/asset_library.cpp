#include "engine/assets/asset_library.h"

#include "engine/assets/image/image_import.h"
#include "engine/assets/model/model_import.h"
#include "engine/assets/skybox_files.h"
#include "engine/assets/sound_import.h"
#include "engine/core/limits.h"
#include "engine/core/log.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <iterator>
#include <mutex>
#include <new>
#include <optional>
#include <set>
#include <string_view>
#include <system_error>
#include <thread>

namespace plumbline::assets {
namespace {

namespace fs = std::filesystem;

/// What stands in for an image that could not be read: hard to overlook, harmless to draw.
ImageData checkerboard() {
    constexpr std::uint32_t kSide = 64;
    constexpr std::uint32_t kField = 8;
    ImageData image{.width = kSide, .height = kSide, .format = PixelFormat::Rgb8, .bytes = {}};
    image.bytes.reserve(std::size_t{kSide} * kSide * 3);
    for (std::uint32_t y = 0; y < kSide; ++y) {
        for (std::uint32_t x = 0; x < kSide; ++x) {
            const bool light = ((x / kField) + (y / kField)) % 2 == 0;
            const std::uint8_t value = light ? 200 : 60;
            image.bytes.insert(image.bytes.end(), {value, value, value});
        }
    }
    return image;
}

Error out_of_memory(std::string_view kind, const fs::path& file) {
    return {.message = fmt::format("there is not enough memory for {} {}", kind, file.string()),
            .exit_code = ExitCode::Refused};
}

std::uint32_t id_after(std::size_t index) {
    return static_cast<std::uint32_t>(index + 1);
}

}  // namespace

/// Images being decoded, and the threads that do it. What stands before `workers` is guarded by
/// `mutex`; the rest belongs to the library's own thread.
struct AssetLibrary::Images {
    using Pixels = std::shared_ptr<const Result<ImageData>>;

    std::mutex mutex;
    std::condition_variable work_added;
    std::condition_variable image_ready;
    std::deque<fs::path> waiting;
    std::set<fs::path> in_work;
    std::map<fs::path, Pixels> ready;
    std::map<fs::path, std::shared_ptr<const std::string>> embedded;  // by EmbeddedImage::name
    std::set<fs::path> warned;
    bool closing{false};

    std::map<fs::path, std::size_t> decoded_bytes;  // of every image decoded so far
    std::size_t decoded_sum{0};

    std::vector<std::thread> workers;
    std::set<fs::path> prefetched;  // ever, so that a second call does not decode again

    ~Images() {
        {
            const std::lock_guard lock(mutex);
            closing = true;
        }
        work_added.notify_all();
        for (std::thread& worker : workers) worker.join();
    }

    void work() {
        std::unique_lock lock(mutex);
        while (true) {
            work_added.wait(lock, [this] { return closing || !waiting.empty(); });
            if (closing) return;
            const fs::path file = std::move(waiting.front());
            waiting.pop_front();
            in_work.insert(file);
            lock.unlock();
            Pixels pixels = decode(file);
            lock.lock();
            in_work.erase(file);
            ready.emplace(file, std::move(pixels));
            image_ready.notify_all();
        }
    }

    /// Counts the image's bytes among the scene's; once, however often it is decoded. False when
    /// there is no room for it.
    bool count_bytes(const fs::path& file, std::size_t bytes) {
        const std::lock_guard lock(mutex);
        std::size_t& counted = decoded_bytes[file];
        const std::size_t others = decoded_sum - counted;
        const bool fits = bytes <= limits::kSceneImageBytes - others;
        counted = fits ? bytes : 0;
        decoded_sum = others + counted;
        return fits;
    }

    /// From the model file that holds it, or from its own; without the lock.
    Pixels decode(const fs::path& file) {
        std::shared_ptr<const std::string> bytes;
        {
            const std::lock_guard lock(mutex);
            const auto found = embedded.find(file);
            if (found != embedded.end()) bytes = found->second;
        }
        const auto fits = [&](std::size_t decoded) { return count_bytes(file, decoded); };
        Result<ImageData> image = out_of_memory("image", file);
        try {
            image = bytes ? decode_image(*bytes, file.string(), fits) : import_image(file, fits);
        } catch (const std::bad_alloc&) {  // says so already
        }
        if (!image) count_bytes(file, 0);
        return std::make_shared<const Result<ImageData>>(std::move(image));
    }

    /// The result if it is ready or being made; null if nobody has begun.
    Pixels claim(const fs::path& file) {
        std::unique_lock lock(mutex);
        const auto place = std::find(waiting.begin(), waiting.end(), file);
        if (place != waiting.end()) {
            waiting.erase(place);  // whoever asks has time to decode it himself
            return nullptr;
        }
        image_ready.wait(lock, [&] { return !in_work.contains(file); });
        const auto found = ready.find(file);
        if (found == ready.end()) return nullptr;
        Pixels pixels = std::move(found->second);
        ready.erase(found);
        return pixels;
    }
};

namespace {

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
    std::atomic<bool> closing{false};
    std::thread worker;

    ~SoundsAhead() {
        closing = true;
        if (worker.joinable()) worker.join();
    }
    void decode(const std::vector<fs::path>& files) {
        for (const fs::path& file : files) {
            if (closing) return;
            const fs::path key = file.lexically_normal();
            try {
                Result<SoundData> sound = import_sound(file);
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

AssetLibrary::AssetLibrary() : images_(std::make_unique<Images>()) {}
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
    entry.model.materials.clear();
    for (const MaterialData& material : imported->materials) {
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
            return import_sound(file);
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
        sounds_ahead_->worker = std::thread(
            [ahead = sounds_ahead_.get(), files = std::move(files)] { ahead->decode(files); });
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

void AssetLibrary::prefetch_images(const fs::path& sky) {
    std::vector<fs::path> wished;
    if (!sky.empty()) std::ranges::copy(skybox_files(sky), std::back_inserter(wished));
    for (const MaterialData& material : materials_) {
        wished.insert(wished.end(),
                      {material.base_color_map, material.normal_map, material.orm_map});
    }
    std::size_t pending = 0;
    {
        const std::lock_guard lock(images_->mutex);
        for (const fs::path& map : wished) {
            const fs::path file = map.lexically_normal();
            if (!file.empty() && images_->prefetched.insert(file).second) {
                images_->waiting.push_back(file);
            }
        }
        pending = images_->waiting.size();
    }
    images_->work_added.notify_all();
    const std::size_t wanted =
        std::min<std::size_t>(pending, std::max(1U, std::thread::hardware_concurrency()));
    try {
        while (images_->workers.size() < wanted) {
            images_->workers.emplace_back([images = images_.get()] { images->work(); });
        }
    } catch (const std::system_error& fault) {
        // What no worker has begun, take_image() decodes.
        log_note("images are decoded with {} threads: {}", images_->workers.size(), fault.what());
    }
}

std::shared_ptr<const ImageData> AssetLibrary::take_image(const fs::path& file) {
    const fs::path key = file.lexically_normal();
    Images::Pixels decoded = images_->claim(key);
    if (decoded == nullptr) {
        decoded = images_->decode(key);
    }
    if (decoded->ok()) return {decoded, &decoded->value()};  // shares ownership of the result
    const bool is_new = [&] {
        const std::lock_guard lock(images_->mutex);
        return images_->warned.insert(key).second;
    }();
    if (is_new) log_warning("{}; a checkerboard is shown instead", decoded->error().message);
    return std::make_shared<const ImageData>(checkerboard());
}

}  // namespace plumbline::assets
