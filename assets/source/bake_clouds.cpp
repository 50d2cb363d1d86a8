// Bakes fair-weather clouds into the six faces of a cube map that a computed sky lights by itself.
//
//   c++ -std=c++20 -O2 -pthread -o bake_clouds bake_clouds.cpp -lpng
//   ./bake_clouds FOLDER [SIDE]
//
// A slab of heaped noise is marched along each pixel's ray, once for each of five lights: from above
// and from four sides. What is kept of them is linear in the light's direction:
// r: how much of its light the cloud sends to the eye, on average; g, b: 0.5 + how much more per unit
// of x and z of the way to the light; a: how much of the sky it covers.
#include <png.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <thread>
#include <vector>

namespace {

struct Vec {
    float x, y, z;
};
Vec operator+(Vec a, Vec b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
Vec operator*(Vec a, float s) {
    return {a.x * s, a.y * s, a.z * s};
}
Vec unit(Vec a) {
    return a * (1 / std::sqrt(a.x * a.x + a.y * a.y + a.z * a.z));
}

float corner(int x, int y, int z, std::uint32_t seed) {
    std::uint32_t h = static_cast<std::uint32_t>(x) * 0x8da6b343U ^
                      static_cast<std::uint32_t>(y) * 0xd8163841U ^
                      static_cast<std::uint32_t>(z) * 0xcb1ab31fU ^ seed * 0x9e3779b9U;
    h = (h ^ (h >> 15U)) * 0x2c1b3c6dU;
    h = (h ^ (h >> 12U)) * 0x297a2d39U;
    return static_cast<float>((h ^ (h >> 15U)) >> 8U) / 16777216.0F;
}

/// Smooth noise from 0 to 1, cells of 1.
float noise(Vec p, std::uint32_t seed) {
    const float fx = std::floor(p.x), fy = std::floor(p.y), fz = std::floor(p.z);
    const int x = static_cast<int>(fx), y = static_cast<int>(fy), z = static_cast<int>(fz);
    const auto smooth = [](float t) { return t * t * t * (t * (6 * t - 15) + 10); };
    const float u = smooth(p.x - fx), v = smooth(p.y - fy), w = smooth(p.z - fz);
    const auto edge = [&](int dy, int dz) {
        return corner(x, y + dy, z + dz, seed) * (1 - u) + corner(x + 1, y + dy, z + dz, seed) * u;
    };
    const float low = edge(0, 0) * (1 - v) + edge(1, 0) * v;
    return low * (1 - w) + (edge(0, 1) * (1 - v) + edge(1, 1) * v) * w;
}

float heaped(Vec p, int octaves, std::uint32_t seed) {
    float sum = 0, share = 0.5F;
    for (int i = 0; i < octaves; ++i, p = p * 2.03F + Vec{17.1F, 5.3F, 9.7F}, share *= 0.5F) {
        sum += share * (1 - std::abs(2 * noise(p, seed + static_cast<std::uint32_t>(i)) - 1));
    }
    return sum;
}

constexpr float kBase_km = 1.25F, kTop_km = 2.6F, kLost_perkm = 26.0F;

/// How thick the cloud is at a place, km from the eye: 0 to 1.
float density(Vec p, int octaves) {
    // A stretch with a clear zenith, far from the noise's origin, where its cells look alike.
    p = p + Vec{402.1F, 0, 120.8F};
    const float height = (p.y - kBase_km) / (kTop_km - kBase_km);
    if (height <= 0 || height >= 1) return 0;
    const Vec flat{p.x, 0, p.z};
    const float fields = 0.55F * noise(flat * 0.23F, 90) + 0.45F * noise(flat * 0.55F, 93);
    const float grown =
        std::clamp((fields - 0.47F) * 4.5F, 0.0F, 1.0F);  // how high the heap here grows
    if (grown <= 0) return 0;
    const float low = std::min(height * 9, 1.0F);
    const float high = 1 - height / (0.25F + 0.75F * grown);
    if (high <= 0) return 0;
    const float shape = heaped(p * 0.75F, octaves, 3);
    return std::clamp((shape - (0.82F - 0.62F * grown * std::sqrt(high) * low)) * 4.0F, 0.0F, 1.0F);
}

/// Of a light from there: how much arrives, softened by what is scattered onwards.
float arriving(Vec p, Vec to_light) {
    float depth = 0, at = 0.05F, step = 0.09F;
    for (int i = 0; i < 5; ++i, at += step, step *= 1.6F)
        depth += density(p + to_light * at, 3) * step;
    depth *= kLost_perkm;
    return 0.55F * std::exp(-depth) + 0.30F * std::exp(-0.28F * depth) +
           0.15F * std::exp(-0.07F * depth);
}

const std::array<Vec, 5> kLights{
    Vec{0, 1, 0}, unit({1, 0.5F, 0}), unit({-1, 0.5F, 0}), unit({0, 0.5F, 1}), unit({0, 0.5F, -1})};

std::array<std::uint8_t, 4> baked(Vec direction, float jitter) {
    if (direction.y < 0.012F) return {0, 128, 128, 0};
    constexpr float kEarth_km = 6360;
    const auto reaches = [&](float h) {
        const float b = kEarth_km * direction.y;
        return -b + std::sqrt(b * b + 2 * kEarth_km * h + h * h);
    };
    const float from = reaches(kBase_km), to = reaches(kTop_km);
    const int steps = 72;
    const float step = std::min((to - from) / steps, 0.5F);
    float through = 1;
    std::array<float, 5> light{};
    for (int i = 0; i < steps && through > 0.01F; ++i) {
        const float way = from + step * (static_cast<float>(i) + jitter);
        Vec p = direction * way;
        p.y += (p.x * p.x + p.z * p.z) / (2 * kEarth_km);
        const float here = density(p, 5);
        if (here <= 0) continue;
        const float share = 1 - std::exp(-here * kLost_perkm * std::min(step, 0.08F));
        // Dark where little can have been scattered towards the eye: edges of powder.
        const float powder = 1 - 0.35F * std::exp(-9 * here);
        for (std::size_t k = 0; k < light.size(); ++k)
            light[k] += through * share * powder * arriving(p, kLights[k]);
        through *= 1 - share;
    }
    const float cover = 1 - through;
    if (cover < 0.004F) return {0, 128, 128, 0};
    for (float& each : light) each /= cover;
    const float mean = 0.2F * (light[0] + light[1] + light[2] + light[3] + light[4]);
    const float far = std::exp(-from / 30) * std::clamp((direction.y - 0.012F) / 0.05F, 0.0F, 1.0F);
    const float flat = 2 * kLights[1].x;
    const auto code = [](float v) {
        return static_cast<std::uint8_t>(std::lround(255 * std::clamp(v, 0.0F, 1.0F)));
    };
    return {code(mean),
            code(0.5F + (light[1] - light[2]) / flat),
            code(0.5F + (light[3] - light[4]) / flat),
            code(cover * far)};
}

/// OpenGL's table of cube faces.
Vec cube_direction(int face, float s, float t) {
    switch (face) {
        case 0:
            return unit({1, -t, -s});
        case 1:
            return unit({-1, -t, s});
        case 2:
            return unit({s, 1, t});
        case 3:
            return unit({s, -1, -t});
        case 4:
            return unit({s, -t, 1});
        default:
            return unit({-s, -t, -1});
    }
}

}  // namespace

int main(int count, char** words) {
    if (count < 2) return std::fprintf(stderr, "bake_clouds FOLDER [SIDE]\n"), 2;
    const int side = count > 2 ? std::stoi(words[2]) : 512;
    const char* const names[]{"px", "nx", "py", "ny", "pz", "nz"};
    for (int face = 0; face < 6; ++face) {
        std::vector<std::uint8_t> pixels(static_cast<std::size_t>(side) * side * 4);
        const auto rows = [&](int first) {
            for (int y = first; y < side; y += 2) {
                for (int x = 0; x < side; ++x) {
                    const Vec d =
                        cube_direction(face, 2 * (x + 0.5F) / side - 1, 2 * (y + 0.5F) / side - 1);
                    const auto texel = baked(d, corner(x, y, face, 5));
                    std::copy(texel.begin(),
                              texel.end(),
                              pixels.begin() + (static_cast<std::ptrdiff_t>(y) * side + x) * 4);
                }
            }
        };
        std::thread odd(rows, 1);
        rows(0);
        odd.join();
        png_image image{};
        image.version = PNG_IMAGE_VERSION;
        image.width = image.height = static_cast<png_uint_32>(side);
        image.format = PNG_FORMAT_RGBA;
        const std::string file = std::string(words[1]) + "/" + names[face] + ".png";
        if (png_image_write_to_file(&image, file.c_str(), 0, pixels.data(), 0, nullptr) == 0)
            return 1;
    }
    return 0;
}
