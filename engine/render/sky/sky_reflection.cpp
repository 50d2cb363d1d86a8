#include "engine/render/sky/sky_reflection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <future>

namespace plumbline::render {
namespace {

using Faces = std::vector<RadianceImage>;

constexpr std::uint32_t kLobeSamples = 64;
// Faces of less than eight pixels a side say too little of where light comes from.
constexpr int kCoarsest = 3;

struct CubePlace {
    std::size_t face{0};
    float u{0.0F};
    float v{0.0F};
};

/// The inverse of cube_direction.
CubePlace place_of(const Vec3f& d) {
    const Vec3f size = glm::abs(d);
    const auto at = [](std::size_t face, float s, float t, float most) {
        return CubePlace{face, 0.5F * (s / most + 1.0F), 0.5F * (t / most + 1.0F)};
    };
    if (size.x >= size.y && size.x >= size.z)
        return d.x > 0.0F ? at(0, -d.z, -d.y, size.x) : at(1, d.z, -d.y, size.x);
    if (size.y >= size.z) return d.y > 0.0F ? at(2, d.x, d.z, size.y) : at(3, d.x, -d.z, size.y);
    return d.z > 0.0F ? at(4, d.x, -d.y, size.z) : at(5, -d.x, -d.y, size.z);
}

/// Between the four pixels around; at the face's rim its outermost ones.
Vec3f looked_up(const Faces& faces, const Vec3f& direction) {
    const CubePlace place = place_of(direction);
    const RadianceImage& image = faces[place.face];
    const auto last = static_cast<float>(image.width - 1);
    const float x = std::clamp(place.u * static_cast<float>(image.width) - 0.5F, 0.0F, last);
    const float y = std::clamp(place.v * static_cast<float>(image.width) - 0.5F, 0.0F, last);
    const auto left = static_cast<std::uint32_t>(x);
    const auto top = static_cast<std::uint32_t>(y);
    const std::uint32_t right = std::min(left + 1, image.width - 1);
    const std::uint32_t bottom = std::min(top + 1, image.width - 1);
    const auto row = [&](std::uint32_t line) {
        const Vec3f* pixels = image.pixels.data() + std::size_t{line} * image.width;
        return glm::mix(pixels[left], pixels[right], x - static_cast<float>(left));
    };
    return glm::mix(row(top), row(bottom), y - static_cast<float>(top));
}

/// A way into the lobe, about +z, and the weight and level that go with it.
struct LobeSample {
    Vec3f way{0.0F, 0.0F, 1.0F};
    float weight{1.0F};
    float level{0.0F};  ///< counted from the one with a side of 1 pixel
};

std::array<LobeSample, kLobeSamples> lobe_of(float roughness) {
    std::array<LobeSample, kLobeSamples> samples;
    const float alpha2 = std::max(std::pow(roughness, 4.0F), 1e-6F);
    for (std::uint32_t i = 0; i < kLobeSamples; ++i) {
        const float share = (static_cast<float>(i) + 0.5F) / kLobeSamples;
        const float turn = static_cast<float>(i) * 2.3999632F;  // the golden angle
        const float cos2 = (1.0F - share) / (1.0F + (alpha2 - 1.0F) * share);
        const float cosine = std::sqrt(cos2);
        const float sine = std::sqrt(std::max(1.0F - cos2, 0.0F));
        const Vec3f halfway{sine * std::cos(turn), sine * std::sin(turn), cosine};
        LobeSample& sample = samples[i];
        sample.way = 2.0F * cosine * halfway - Vec3f{0.0F, 0.0F, 1.0F};
        sample.weight = std::max(sample.way.z, 0.0F);
        // As wide a pixel as the part of the sphere that this sample stands for.
        const float d = cos2 * (alpha2 - 1.0F) + 1.0F;
        const float density = alpha2 / (glm::pi<float>() * d * d) * 0.25F;
        const float angle = 1.0F / (kLobeSamples * density);
        sample.level = 0.5F * std::log2(angle * 6.0F / (4.0F * glm::pi<float>()));
    }
    return samples;
}

Vec3f mean_over(const std::vector<Faces>& levels,
                const std::array<LobeSample, kLobeSamples>& lobe,
                const Vec3f& direction) {
    const Vec3f helper =
        std::abs(direction.y) < 0.9F ? Vec3f{0.0F, 1.0F, 0.0F} : Vec3f{1.0F, 0.0F, 0.0F};
    const Vec3f x = glm::normalize(glm::cross(helper, direction));
    const Vec3f y = glm::cross(direction, x);
    const auto last = static_cast<int>(levels.size()) - 1;
    Vec3f sum{0.0F};
    float weight = 0.0F;
    for (const LobeSample& sample : lobe) {
        if (sample.weight <= 0.0F) continue;
        const Vec3f way = x * sample.way.x + y * sample.way.y + direction * sample.way.z;
        const int level =
            std::clamp(static_cast<int>(std::lround(static_cast<float>(last) + sample.level)),
                       0,
                       std::max(last - kCoarsest, 0));
        sum += looked_up(levels[static_cast<std::size_t>(level)], way) * sample.weight;
        weight += sample.weight;
    }
    return sum / weight;
}

RadianceImage mirrored_face(const std::vector<Faces>& levels,
                            std::size_t face,
                            std::uint32_t side,
                            float roughness) {
    const auto lobe = lobe_of(roughness);
    RadianceImage image{.width = side, .height = side, .pixels = {}};
    image.pixels.reserve(std::size_t{side} * side);
    const float pixel = 1.0F / static_cast<float>(side);
    for (std::uint32_t y = 0; y < side; ++y) {
        for (std::uint32_t x = 0; x < side; ++x) {
            const Vec3f direction = cube_direction(face,
                                                   (static_cast<float>(x) + 0.5F) * pixel,
                                                   (static_cast<float>(y) + 0.5F) * pixel);
            image.pixels.push_back(mean_over(levels, lobe, direction));
        }
    }
    return image;
}

}  // namespace

std::vector<Faces> reflection_levels(Faces faces) {
    std::vector<Faces> halves{std::move(faces)};
    while (halves.back()[0].width > 1) {
        Faces smaller;
        for (const RadianceImage& face : halves.back()) smaller.push_back(halved(face));
        halves.push_back(std::move(smaller));
    }
    std::vector<Faces> mirrored{halves.front()};
    for (std::size_t i = 1; i < halves.size(); ++i) {
        const float roughness = static_cast<float>(i) / static_cast<float>(halves.size() - 1);
        std::vector<std::future<RadianceImage>> under_way;
        for (std::size_t face = 0; face < 6; ++face) {
            under_way.push_back(
                std::async(std::launch::async | std::launch::deferred, [&, i, face, roughness] {
                    return mirrored_face(halves, face, halves[i][0].width, roughness);
                }));
        }
        Faces level;
        for (auto& face : under_way) level.push_back(face.get());
        mirrored.push_back(std::move(level));
    }
    return mirrored;
}

}  // namespace plumbline::render
