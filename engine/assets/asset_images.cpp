#include "engine/assets/asset_images_impl.h"
#include "engine/assets/foreign/decoder.h"
#include "engine/assets/image/image_import.h"
#include "engine/assets/skybox_files.h"
#include "engine/core/limits.h"
#include "engine/core/log.h"
#include "engine/core/threads/team.h"

#include <algorithm>
#include <iterator>
#include <new>
#include <system_error>

namespace plumbline::assets {
namespace {

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

}  // namespace

AssetLibrary::Images::Pixels AssetLibrary::Images::decode(const fs::path& file) {
    std::shared_ptr<const std::string> bytes;
    {
        const std::lock_guard lock(mutex);
        const auto found = embedded.find(file);
        if (found != embedded.end()) bytes = found->second;
    }
    const auto fits = [&](std::size_t decoded) { return count_bytes(file, decoded); };
    Result<ImageData> image = out_of_memory("image", file);
    const auto decode_bytes = [&](const std::string& content) {
        return is_foreign(file, installed) ? decode_image_apart(content, file.string(), fits)
                                           : decode_image(content, file.string(), fits);
    };
    try {
        if (bytes) {
            image = decode_bytes(*bytes);
        } else {
            const Result<std::string> read = read_image_file(file);
            image = read ? decode_bytes(*read) : Result<ImageData>(read.error());
        }
    } catch (const std::bad_alloc&) {  // says so already
    }
    if (!image) count_bytes(file, 0);
    return std::make_shared<const Result<ImageData>>(std::move(image));
}

std::string AssetLibrary::encoded_image(const fs::path& file) const {
    {
        const std::lock_guard lock(images_->mutex);
        const auto found = images_->embedded.find(file.lexically_normal());
        if (found != images_->embedded.end()) return *found->second;
    }
    Result<std::string> read = read_image_file(file);
    return read ? std::move(*read) : std::string{};
}

void AssetLibrary::prefetch_images(const fs::path& sky) {
    std::vector<fs::path> wished;
    if (!sky.empty()) std::ranges::copy(skybox_files(sky), std::back_inserter(wished));
    for (const MaterialData& material : materials_) wished.push_back(material.base_color_map);
    prefetch_images(wished);
}

void AssetLibrary::prefetch_images(const std::vector<fs::path>& files) {
    std::size_t pending = 0;
    {
        const std::lock_guard lock(images_->mutex);
        for (const fs::path& each : files) {
            const fs::path file = each.lexically_normal();
            if (!file.empty() && images_->prefetched.insert(file).second) {
                images_->waiting.push_back(file);
            }
        }
        pending = images_->waiting.size();
    }
    images_->work_added.notify_all();
    const std::size_t wanted = std::min(pending, static_cast<std::size_t>(usable_cores()));
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
