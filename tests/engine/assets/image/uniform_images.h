// One colour in every format that is read.
#pragma once

#include "tests/engine/assets/image/image_files.h"

#include <ImfHeader.h>
#include <ImfRgbaFile.h>
#include <jpeglib.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace plumbline::assets::test {

/// `side` x `side` pixels of one value each, JPEG quality 100.
inline std::string jpeg_of(int side, const Bytes& pixel, J_COLOR_SPACE space) {
    jpeg_compress_struct jpeg{};
    jpeg_error_mgr errors{};
    jpeg.err = jpeg_std_error(&errors);
    jpeg_create_compress(&jpeg);
    unsigned char* bytes = nullptr;
    unsigned long size = 0;
    jpeg_mem_dest(&jpeg, &bytes, &size);
    jpeg.image_width = static_cast<JDIMENSION>(side);
    jpeg.image_height = static_cast<JDIMENSION>(side);
    jpeg.input_components = static_cast<int>(pixel.size());
    jpeg.in_color_space = space;
    jpeg_set_defaults(&jpeg);
    jpeg_set_quality(&jpeg, 100, TRUE);
    jpeg_start_compress(&jpeg, TRUE);
    Bytes row;
    for (int i = 0; i < side; ++i) row.insert(row.end(), pixel.begin(), pixel.end());
    while (jpeg.next_scanline < jpeg.image_height) {
        JSAMPROW rows[]{row.data()};
        jpeg_write_scanlines(&jpeg, rows, 1);
    }
    jpeg_finish_compress(&jpeg);
    jpeg_destroy_compress(&jpeg);
    std::string file(reinterpret_cast<const char*>(bytes), size);
    std::free(bytes);
    return file;
}

/// 2 x 2 pixels of one colour and alpha, as OpenEXR keeps them: linear, multiplied by alpha.
inline std::string exr_of(float light, float alpha, Imf::RgbaChannels channels) {
    const TempFolder folder;
    const fs::path file = folder.path() / "a.exr";
    std::array<Imf::Rgba, 4> pixels;
    pixels.fill(Imf::Rgba(light * alpha, light * alpha, light * alpha, alpha));
    {
        Imf::RgbaOutputFile out(file.c_str(), 2, 2, channels);
        out.setFrameBuffer(pixels.data(), 1, 2);
        out.writePixels(2);
    }
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

struct UniformImage {
    std::string name;  ///< its ending tells the format
    std::string bytes;
};

/// Grey of this 8-bit code, in every format and kind of pixel; an EXR holds `light` for it.
inline std::vector<UniformImage> uniform_images(std::uint8_t code, float light) {
    const auto letter = static_cast<char>(code);
    const auto rows = [](const std::string& pixel) {
        return ('\0' + pixel + pixel) + ('\0' + pixel + pixel);
    };
    const auto tga = [](char kind, char bits) {
        return std::string(2, '\0') + kind + std::string(9, '\0') +
               std::string{2, 0, 2, 0, bits, '\x20'};
    };
    const std::string one(1, letter);
    const std::string three(3, letter);
    const std::string clear("\x80", 1);
    const Bytes grey{code};
    const Bytes color{code, code, code};
    return {
        {"grey8.png", PngFile(2, 2, 8, 0).pixels(rows(one)).done()},
        {"grey16.png", PngFile(2, 2, 16, 0).pixels(rows(one + one)).done()},
        {"grey_alpha8.png", PngFile(2, 2, 8, 4).pixels(rows(one + clear)).done()},
        {"rgb8.png", PngFile(2, 2, 8, 2).pixels(rows(three)).done()},
        {"rgb16.png", PngFile(2, 2, 16, 2).pixels(rows(three + three)).done()},
        {"rgba8.png", PngFile(2, 2, 8, 6).pixels(rows(three + clear)).done()},
        {"palette.png",
         PngFile(2, 2, 8, 3).chunk("PLTE", three).pixels(rows(std::string(1, '\0'))).done()},
        {"grey.jpg", jpeg_of(2, grey, JCS_GRAYSCALE)},
        {"rgb.jpg", jpeg_of(2, color, JCS_RGB)},
        {"grey.tga", tga(3, 8) + one + one + one + one},
        {"rgb.tga", tga(2, 24) + three + three + three + three},
        {"rgba.tga", tga(2, 32) + three + clear + three + clear + three + clear + three + clear},
        {"rgb.exr", exr_of(light, 1.0F, Imf::WRITE_RGB)},
        {"rgba.exr", exr_of(light, 0.5F, Imf::WRITE_RGBA)},
        {"grey.exr", exr_of(light, 1.0F, Imf::WRITE_Y)},
    };
}

}  // namespace plumbline::assets::test
