// Turns a Radiance .hdr face of the sky (what bl_sky.py writes) into a half-float OpenEXR file with
// DWAB compression: 768 x 768 pixels in 100 to 250 KB instead of 800.
//
//   g++ -std=c++20 -O2 sky_to_exr.cpp -o sky_to_exr $(pkg-config --cflags --libs OpenEXR)
//   ./sky_to_exr sky_px.hdr ../skies/garden/px.exr
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfRgbaFile.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace {

struct Image {
    int width{0};
    int height{0};
    std::vector<Imf::Rgba> pixels;
};

/// One scan line of new-style run-length encoding (Ward, "Real Pixels", Graphics Gems II): four
/// planes, each of runs (count > 128) and literals.
bool read_line(const std::vector<std::uint8_t>& bytes,
               std::size_t& at,
               int width,
               Imf::Rgba* line) {
    if (at + 4 > bytes.size() || bytes[at] != 2 || bytes[at + 1] != 2) return false;
    at += 4;
    std::vector<std::uint8_t> planes(static_cast<std::size_t>(width) * 4);
    for (std::size_t done = 0; done < planes.size();) {
        if (at + 1 >= bytes.size()) return false;
        const int count = bytes[at++];
        if (count > 128) {
            for (int i = 0; i < count - 128; ++i) planes.at(done++) = bytes[at];
            ++at;
        } else {
            for (int i = 0; i < count; ++i) planes.at(done++) = bytes.at(at++);
        }
    }
    for (int x = 0; x < width; ++x) {
        const auto plane = [&](int k) { return planes[static_cast<std::size_t>(k * width + x)]; };
        const float scale = std::ldexp(1.0F, plane(3) - 136);
        line[x] = Imf::Rgba(static_cast<float>(plane(0)) * scale,
                            static_cast<float>(plane(1)) * scale,
                            static_cast<float>(plane(2)) * scale,
                            1.0F);
    }
    return true;
}

bool read_radiance(const std::string& path, Image& image) {
    std::ifstream file(path, std::ios::binary);
    const std::vector<std::uint8_t> bytes((std::istreambuf_iterator<char>(file)), {});
    const std::string text(bytes.begin(), bytes.end());
    const std::size_t size_line = text.find("\n-Y ");
    if (size_line == std::string::npos) return false;
    if (std::sscanf(text.c_str() + size_line, "\n-Y %d +X %d", &image.height, &image.width) != 2) {
        return false;
    }
    std::size_t at = text.find('\n', size_line + 1) + 1;
    image.pixels.resize(static_cast<std::size_t>(image.width) * image.height);
    for (int y = 0; y < image.height; ++y) {
        if (!read_line(
                bytes, at, image.width, &image.pixels[static_cast<std::size_t>(y) * image.width])) {
            return false;
        }
    }
    return true;
}

}  // namespace

int main(int argc, char** argv) {
    Image image;
    if (argc != 3 || !read_radiance(argv[1], image)) {
        std::fprintf(stderr, "usage: sky_to_exr IN.hdr OUT.exr\n");
        return 2;
    }
    Imf::Header header(image.width, image.height);
    header.compression() = Imf::DWAB_COMPRESSION;
    Imf::RgbaOutputFile out(argv[2], header, Imf::WRITE_RGB);
    out.setFrameBuffer(image.pixels.data(), 1, static_cast<std::size_t>(image.width));
    out.writePixels(image.height);
    return 0;
}
