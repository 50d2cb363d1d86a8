// Images: PNG, JPEG, OpenEXR and TGA, as a material's maps use them.
#include "engine/assets/image/image_import.h"
#include "tests/engine/assets/image/uniform_images.h"
#include "tests/fuzz/fuzz_target.h"

#include <cstdlib>

namespace plumbline::fuzz {

std::vector<std::string> seeds() {
    std::vector<std::string> files;
    for (assets::test::UniformImage& image : assets::test::uniform_images(186, 0.5F))
        files.push_back(std::move(image.bytes));
    return files;
}

}  // namespace plumbline::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace plumbline::assets;
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes as libFuzzer gives them
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    // What is larger costs time and memory, and no other code.
    const auto small = [](std::size_t pixels) { return pixels < 4'000'000; };
    const plumbline::Result<ImageData> image = decode_image(bytes, "mutant", small);
    if (!image) return image.error().message.empty() ? 1 : 0;
    plumbline::fuzz::note_taken();
    if (image->bytes.size() !=
        std::size_t{image->width} * image->height * bytes_per_pixel(image->format))
        std::abort();
    return 0;
}
