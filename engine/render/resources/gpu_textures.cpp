#include "engine/render/resources/gpu_textures.h"

#include <algorithm>
#include <deque>
#include <future>
#include <memory>
#include <span>

namespace plumbline::render {
namespace {

// Colour changes visibly from level to level and is blended between two; normals and roughness are
// not worth a second lookup on software GL.
gl::Filter filter_for(MipContent content) {
    return content == MipContent::Color ? gl::Filter::Trilinear : gl::Filter::LinearMipNearest;
}

// Finished chains waiting for upload hold memory; so few are kept under way.
constexpr std::size_t kChainsUnderWay = 4;

}  // namespace

const gl::Texture& GpuTextures::add(const TextureRequest& request,
                                    const assets::ImageData& image,
                                    const std::vector<assets::ImageData>& smaller) {
    std::vector<const assets::ImageData*> levels{&image};
    for (const assets::ImageData& level : smaller) levels.push_back(&level);
    const auto fits = std::ranges::find_if(levels, [&](const assets::ImageData* level) {
        return std::max(level->width, level->height) <= largest_px_;
    });
    gl::Texture texture =
        gl::Texture::tiling(std::span{fits, levels.end()}, filter_for(request.content));
    bytes_ += texture.bytes();
    return textures_.insert_or_assign(Key{request.file, request.content}, std::move(texture))
        .first->second;
}

const gl::Texture& GpuTextures::get(const TextureRequest& request) {
    const auto found = textures_.find(Key{request.file, request.content});
    if (found != textures_.end()) return found->second;
    const auto image = in_bytes(library_.take_image(request.file), request.content);
    return add(request, *image, mip_chain(*image, request.content, request.alpha_cutoff));
}

void GpuTextures::decode_ahead(const std::vector<TextureRequest>& requests) {
    std::vector<std::filesystem::path> files;
    for (const TextureRequest& request : requests) {
        if (!textures_.contains(Key{request.file, request.content})) files.push_back(request.file);
    }
    library_.prefetch_images(files);
}

void GpuTextures::load(const std::vector<TextureRequest>& requests,
                       const std::function<void()>& on_each) {
    struct UnderWay {
        TextureRequest request;
        std::shared_ptr<const assets::ImageData> image;
        std::future<std::vector<assets::ImageData>> smaller;
    };
    std::deque<UnderWay> under_way;
    const auto finish_oldest = [&] {
        UnderWay& oldest = under_way.front();
        add(oldest.request, *oldest.image, oldest.smaller.get());
        under_way.pop_front();
    };
    std::map<Key, bool> asked;
    for (const TextureRequest& request : requests) {
        on_each();
        const Key key{request.file, request.content};
        if (textures_.contains(key) || !asked.emplace(key, true).second) continue;
        // Deferred to whoever asks where no thread can be made; given as a copy, for a failed start
        // of a thread takes along what it was given.
        const auto image = in_bytes(library_.take_image(request.file), request.content);
        const auto chain = [image, request] {
            return mip_chain(*image, request.content, request.alpha_cutoff);
        };
        under_way.push_back(
            {request, image, std::async(std::launch::async | std::launch::deferred, chain)});
        if (under_way.size() >= kChainsUnderWay) finish_oldest();
    }
    while (!under_way.empty()) finish_oldest();
}

void GpuTextures::clear() {
    textures_.clear();
    bytes_ = 0;
}

}  // namespace plumbline::render
