// TGA files, which have no sign of their own.
#include "engine/assets/image/image_codecs_impl.h"
#include "tests/engine/assets/image/image_files.h"

namespace plumbline::assets::test {
namespace {

/// A TGA header: kind 2 true colour, 3 grey, 8 more where runs are packed; order 0x20 from the top.
std::string tga_header(int kind, int width, int height, int bits, int order) {
    std::string bytes(18, '\0');
    bytes[2] = static_cast<char>(kind);
    bytes[12] = static_cast<char>(width);
    bytes[14] = static_cast<char>(height);
    bytes[16] = static_cast<char>(bits);
    bytes[17] = static_cast<char>(order);
    return bytes;
}

TEST(TgaImport, reads_rows_from_either_end_and_blue_first) {
    // Two pixels: red below or left, half-seen blue above or right.
    const std::string red("\0\0\xFF\xFF", 4);
    const std::string blue("\xFF\0\0\x80", 4);
    const Bytes from_above{0, 0, 255, 128, 255, 0, 0, 255};
    const auto up = import_image_bytes(tga_header(2, 1, 2, 32, 8) + red + blue);
    ASSERT_TRUE(up.ok()) << up.error().message;
    EXPECT_EQ(up->format, PixelFormat::Rgba8);
    EXPECT_EQ(up->bytes, from_above);
    EXPECT_EQ(import_image_bytes(tga_header(2, 1, 2, 32, 0x28) + blue + red)->bytes, from_above);
    EXPECT_EQ(import_image_bytes(tga_header(2, 2, 1, 32, 0x18) + red + blue)->bytes, from_above);
    EXPECT_EQ(import_image_bytes(tga_header(3, 2, 1, 8, 0) + "\x05\x09")->bytes, (Bytes{5, 9}));
}

TEST(TgaImport, unpacks_runs_that_go_on_over_a_rows_end) {
    // Three equal pixels, then two of their own, then one more: 3 x 2.
    const std::string packed = "\x82" + std::string("\1\2\3") + "\1" + "\4\5\6\7\10\11" +
                               std::string(1, '\0') + "\12\13\14";
    const auto image = import_image_bytes(tga_header(10, 3, 2, 24, 0x20) + packed);
    ASSERT_TRUE(image.ok()) << image.error().message;
    EXPECT_EQ(image->bytes, (Bytes{3, 2, 1, 3, 2, 1, 3, 2, 1, 6, 5, 4, 9, 8, 7, 12, 11, 10}));
    for (std::size_t size = 18; size < 18 + packed.size(); ++size) {
        const auto cut =
            import_image_bytes((tga_header(10, 3, 2, 24, 0x20) + packed).substr(0, size));
        ASSERT_FALSE(cut.ok()) << size;
        EXPECT_TRUE(contains(cut.error().message, "it breaks off"));
    }
    std::string huge = tga_header(10, 0, 0, 24, 0);
    for (const std::size_t i : {12U, 13U, 14U, 15U}) huge[i] = '\xFF';
    EXPECT_TRUE(contains(import_image_bytes(huge).error().message, "a side has at most"));
}

TEST(TgaImport, skips_the_name_before_the_pixels_and_knows_no_palettes) {
    std::string named = tga_header(3, 1, 1, 8, 0x20);
    named[0] = 4;  // bytes of a name
    EXPECT_EQ(import_image_bytes(named + "name\x07")->bytes, Bytes{7});
    std::string palette = tga_header(1, 1, 1, 8, 0);
    palette[1] = 1;
    EXPECT_FALSE(looks_like_tga(palette));
    EXPECT_EQ(decode_tga({palette, "i", any_image_bytes}).error().message,
              "image i is refused: its header is none of a TGA that is read");
    EXPECT_FALSE(looks_like_tga(tga_header(2, 1, 1, 16, 0))) << "five bits a channel";
    EXPECT_TRUE(looks_like_tga(tga_header(10, 1, 1, 32, 0)));
    EXPECT_FALSE(looks_like_tga(tga_header(10, 1, 1, 32, 0).substr(0, 17)));
}

TEST(TgaImport, turns_rows_round_where_the_header_says_so) {
    // Bits 0x10 from the right, 0x20 from the top: 2 x 2 grey pixels 1 2 3 4 as the file has them.
    const auto bytes_of_order = [](int order) {
        return import_image_bytes(tga_header(3, 2, 2, 8, order) + "\1\2\3\4")->bytes;
    };
    EXPECT_EQ(bytes_of_order(0x00), (Bytes{3, 4, 1, 2}));
    EXPECT_EQ(bytes_of_order(0x10), (Bytes{4, 3, 2, 1}));
    EXPECT_EQ(bytes_of_order(0x20), (Bytes{1, 2, 3, 4}));
    EXPECT_EQ(bytes_of_order(0x30), (Bytes{2, 1, 4, 3}));
}

}  // namespace
}  // namespace plumbline::assets::test
