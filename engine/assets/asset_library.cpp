#include "engine/assets/asset_library.h"

#include "engine/assets/image_import.h"
#include "engine/assets/model_import.h"
#include "engine/assets/sound_import.h"
#include "engine/core/log.h"

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <set>
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
    bool closing{false};

    std::vector<std::thread> workers;
    std::set<fs::path> prefetched;  // ever, so that a second call does not decode again
    std::set<fs::path> warned;

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
            auto pixels = std::make_shared<const Result<ImageData>>(import_image(file));
            lock.lock();
            in_work.erase(file);
            ready.emplace(file, std::move(pixels));
            image_ready.notify_all();
        }
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

AssetLibrary::AssetLibrary() : images_(std::make_unique<Images>()) {}
AssetLibrary::~AssetLibrary() = default;

Result<Model> AssetLibrary::model(const fs::path& file, const fs::path& root) {
    const auto key = std::make_pair(file.lexically_normal(), root.lexically_normal());
    const auto known = models_by_file_.find(key);
    if (known != models_by_file_.end()) return known->second;
    Result<ModelData> imported = import_model(file, root);
    if (!imported) return imported.error();
    Model model;
    for (MaterialData& material : imported->materials) {
        model.materials.push_back(add_material(std::move(material)));
    }
    meshes_.push_back(std::move(imported->mesh));
    model.mesh = {id_after(meshes_.size() - 1)};
    models_by_file_.emplace(key, model);
    return model;
}

Result<SoundId> AssetLibrary::sound(const fs::path& file) {
    const fs::path key = file.lexically_normal();
    const auto known = sounds_by_file_.find(key);
    if (known != sounds_by_file_.end()) return known->second;
    Result<SoundData> imported = import_sound(file);
    if (!imported) return imported.error();
    sounds_.push_back(std::move(*imported));
    const SoundId id{id_after(sounds_.size() - 1)};
    sounds_by_file_.emplace(key, id);
    return id;
}

MeshId AssetLibrary::add_mesh(const std::string& name, MeshData mesh) {
    const auto known = meshes_by_name_.find(name);
    if (known != meshes_by_name_.end()) return known->second;
    meshes_.push_back(std::move(mesh));
    const MeshId id{id_after(meshes_.size() - 1)};
    meshes_by_name_.emplace(name, id);
    return id;
}

MaterialId AssetLibrary::add_material(MaterialData material) {
    materials_.push_back(std::move(material));
    return {id_after(materials_.size() - 1)};
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

void AssetLibrary::prefetch_images() {
    std::size_t pending = 0;
    {
        const std::lock_guard lock(images_->mutex);
        for (const MaterialData& material : materials_) {
            for (const fs::path* map :
                 {&material.base_color_map, &material.normal_map, &material.orm_map}) {
                const fs::path file = map->lexically_normal();
                if (!file.empty() && images_->prefetched.insert(file).second) {
                    images_->waiting.push_back(file);
                }
            }
        }
        pending = images_->waiting.size();
    }
    images_->work_added.notify_all();
    const std::size_t wanted =
        std::min<std::size_t>(pending, std::max(1U, std::thread::hardware_concurrency()));
    while (images_->workers.size() < wanted) {
        images_->workers.emplace_back([images = images_.get()] { images->work(); });
    }
}

std::shared_ptr<const ImageData> AssetLibrary::take_image(const fs::path& file) {
    const fs::path key = file.lexically_normal();
    Images::Pixels decoded = images_->claim(key);
    if (decoded == nullptr) {
        decoded = std::make_shared<const Result<ImageData>>(import_image(key));
    }
    if (decoded->ok()) return {decoded, &decoded->value()};  // shares ownership of the result
    if (images_->warned.insert(key).second) {
        log_warning("{}; a checkerboard is shown instead", decoded->error().message);
    }
    return std::make_shared<const ImageData>(checkerboard());
}

}  // namespace plumbline::assets
