// Which decoder an image goes to, and how large it may be.
#include "engine/assets/image/image_import.h"

#include "engine/assets/image/image_codecs_impl.h"
#include "engine/core/limits.h"
#include "tests/engine/assets/image/image_files.h"

namespace plumbline::assets::test {
namespace {

TEST(ImageImport, tells_the_kind_by_the_first_bytes_alone) {
    const auto error_of = [](std::string_view bytes) {
        const Result<ImageData> image = decode_image(bytes, "a.png");
        return image.ok() ? std::string("read") : image.error().message;
    };
    const std::string unknown =
        "image a.png is refused: its content is none of PNG, JPEG, OpenEXR and TGA";
    EXPECT_EQ(error_of(""), unknown);
    EXPECT_EQ(error_of("\x89PNG"), unknown) << "its sign is longer";
    for (const char* sign : {"\x89PNG\r\n\x1a\n", "\xff\xd8\xff", "\x76\x2f\x31\x01"}) {
        EXPECT_TRUE(contains(error_of(sign), "image a.png is refused: "));
        EXPECT_NE(error_of(sign), unknown) << "known, and broken";
    }
}

TEST(ImageImport, refuses_sizes_that_are_empty_too_wide_too_large_or_over_the_scenes_share) {
    constexpr std::uint64_t kSide = limits::kImageSide;
    std::size_t asked = 0;
    const auto allowed = [&](std::size_t bytes) {
        asked = bytes;
        return bytes <= 600;
    };
    EXPECT_EQ(size_fault(0, 5, PixelFormat::R8, allowed), "its size is 0 x 5");
    EXPECT_EQ(size_fault(5, 0, PixelFormat::R8, allowed), "its size is 5 x 0");
    EXPECT_EQ(size_fault(1, kSide + 1, PixelFormat::R8, allowed),
              "its size is 1 x 16385; a side has at most 16384 pixels");
    EXPECT_EQ(size_fault(kSide, kSide, PixelFormat::Rgb8, allowed),
              "decoded it takes 805306368 bytes; at most 268435456 are allowed");
    EXPECT_EQ(asked, 0U) << "refused by itself: the scene is not charged";
    EXPECT_EQ(size_fault(10, 10, PixelFormat::Rgb16F, allowed), "");
    EXPECT_EQ(asked, 600U);
    EXPECT_EQ(size_fault(151, 1, PixelFormat::Rgba8, allowed),
              "it takes 604 bytes; all images of a scene may take 1073741824");
    EXPECT_EQ(size_fault(kSide, kSide, PixelFormat::R8, any_image_bytes), "") << "exactly the most";
}

}  // namespace
}  // namespace plumbline::assets::test
