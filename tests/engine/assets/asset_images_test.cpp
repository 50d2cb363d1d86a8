// Images of a scene: decoded ahead, counted, taken once, and what stands in for broken ones.
#include "engine/assets/asset_library.h"
#include "engine/core/limits.h"
#include "tests/engine/assets/image/image_files.h"

#include <pthread.h>

namespace plumbline::assets::test {
namespace {

fs::path write_image(const TempFolder& folder, const std::string& name, std::uint8_t value) {
    const fs::path file = folder.path() / name;
    const ImageData image{.width = 1, .height = 1, .format = PixelFormat::R8, .bytes = {value}};
    EXPECT_TRUE(write_png(file, image).ok());
    return file;
}

TEST(AssetImages, decodes_images_that_a_model_holds) {
    const TempFolder folder;
    const fs::path image = write_image(folder, "a.png", 77);
    std::ifstream stream(image, std::ios::binary);
    const std::string png{std::istreambuf_iterator<char>(stream), {}};
    TriangleFile content;
    content.json["images"] = {{{"bufferView", content.add_view(png)}}};
    content.json["textures"] = {{{"source", 0}}};
    content.json["materials"] = {
        {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
    content.primitive()["material"] = 0;
    const fs::path file = folder.write("m.glb", content.glb());
    AssetLibrary library;
    const Result<Model> model = library.model(file, folder.path());
    ASSERT_TRUE(model.ok()) << model.error().message;
    const fs::path map = library.material(model->materials[0]).base_color_map;
    EXPECT_EQ(library.take_image(map)->bytes, (std::vector<std::uint8_t>{77}));
    library.prefetch_images();
    EXPECT_EQ(library.take_image(map)->bytes, (std::vector<std::uint8_t>{77}));
}

TEST(AssetImages, hands_over_images_prefetched_or_not) {
    const TempFolder folder;
    AssetLibrary library;
    std::vector<fs::path> files;
    for (int i = 0; i < 50; ++i) {
        files.push_back(
            write_image(folder, fmt::format("{}.png", i), static_cast<std::uint8_t>(i)));
        MaterialData material;
        if (i % 3 == 0) material.base_color_map = files.back();
        if (i % 3 == 1) material.normal_map = files.back();
        if (i % 3 == 2) material.orm_map = files.back();
        library.add_material(material);
    }
    library.prefetch_images();
    library.prefetch_images(std::vector<fs::path>(files.begin(), files.begin() + 20));
    library.prefetch_images({files[0], fs::path()});
    for (std::size_t i = files.size(); i-- > 0;) {
        const auto image = library.take_image(files[i]);
        ASSERT_EQ(image->bytes, (std::vector<std::uint8_t>{static_cast<std::uint8_t>(i)}));
    }
    // Forgotten once taken: the file is read again.
    write_image(folder, "7.png", 99);
    EXPECT_EQ(library.take_image(files[7])->bytes[0], 99);
}

TEST(AssetImages, gives_a_checkerboard_and_one_warning_for_a_broken_image) {
    const TempFolder folder;
    const fs::path broken = folder.write("broken.png", "not an image");
    AssetLibrary library;
    library.add_material({.base_color_map = broken});
    library.prefetch_images();
    ::testing::internal::CaptureStderr();
    const auto image = library.take_image(broken);
    const auto again = library.take_image(broken);
    const std::string log = ::testing::internal::GetCapturedStderr();
    EXPECT_EQ(image->width, 64U);
    EXPECT_EQ(image->bytes, again->bytes);
    EXPECT_NE(image->bytes[0], image->bytes[8 * 3]);
    const std::size_t warning = log.find("a checkerboard is shown instead");
    ASSERT_NE(warning, std::string::npos) << log;
    EXPECT_EQ(log.find("a checkerboard is shown instead", warning + 1), std::string::npos) << log;
}

// EXPERIENCE I14
TEST(AssetImages, decodes_without_threads_where_none_can_be_made) {
    const TempFolder folder;
    const fs::path file = write_image(folder, "a.png", 7);
    pthread_attr_t attributes;
    ASSERT_EQ(::pthread_attr_init(&attributes), 0);
    std::size_t usual_bytes = 0;
    ASSERT_EQ(::pthread_attr_getstacksize(&attributes, &usual_bytes), 0);
    // More than there are addresses: no thread can have it.
    ASSERT_EQ(::pthread_attr_setstacksize(&attributes, std::size_t{1} << 48), 0);
    ASSERT_EQ(::pthread_setattr_default_np(&attributes), 0);
    {
        AssetLibrary library;
        library.add_material({.base_color_map = file});
        library.prefetch_images();
        EXPECT_EQ(library.take_image(file)->bytes, (std::vector<std::uint8_t>{7}));
    }
    ASSERT_EQ(::pthread_attr_setstacksize(&attributes, usual_bytes), 0);
    ASSERT_EQ(::pthread_setattr_default_np(&attributes), 0);
    ::pthread_attr_destroy(&attributes);
}

TEST(AssetImages, ends_while_images_are_still_waiting) {
    const TempFolder folder;
    const fs::path file = write_image(folder, "a.png", 1);
    for (int round = 0; round < 20; ++round) {
        AssetLibrary library;
        for (int i = 0; i < 20; ++i) {
            library.add_material({.base_color_map = folder.path() / fmt::format("{}.png", i)});
        }
        library.prefetch_images();
    }
    EXPECT_TRUE(fs::exists(file));
}

/// 256 MiB decoded, in a file of 32 kB.
std::string largest_grey_png() {
    constexpr std::uint32_t kSide = limits::kImageSide;
    return PngFile(kSide, kSide, 1, 0)
        .pixels(std::string(std::size_t{kSide} * (kSide / 8 + 1), '\0'))
        .done();
}

// EXPERIENCE G19
TEST(AssetImages, take_a_gibibyte_and_no_byte_more) {
    const TempFolder folder;
    const std::string large = largest_grey_png();
    ASSERT_LT(large.size(), 50'000U);
    static_assert(limits::kSceneImageBytes == 4 * limits::kImageBytes);
    AssetLibrary library;
    for (const char* name : {"0.png", "1.png", "2.png"})
        EXPECT_EQ(library.take_image(folder.write(name, large))->width, limits::kImageSide);
    library.take_image(folder.path() / "2.png");  // counts once, however often
    library.take_image(folder.write("broken.png", large.substr(0, large.size() / 2)));
    EXPECT_EQ(library.take_image(folder.write("3.png", large))->width, limits::kImageSide);
    const fs::path one_more = folder.write("4.png", PngFile(1, 1, 8, 0).pixels({0, 1}).done());
    ::testing::internal::CaptureStderr();
    EXPECT_EQ(library.take_image(one_more)->width, 64U) << "the checkerboard";
    const std::string log = ::testing::internal::GetCapturedStderr();
    EXPECT_TRUE(contains(log,
                         "4.png is refused: it takes 1 bytes; all images of a scene may take "
                         "1073741824; a checkerboard is shown instead"))
        << log;
}

}  // namespace
}  // namespace plumbline::assets::test
