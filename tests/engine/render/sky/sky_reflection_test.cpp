// The sky that rough mirrors see, against sums over the whole sphere.
#include "engine/render/sky/sky_reflection.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::render {
namespace {

constexpr std::uint32_t kSide = 32;

template <class Fn>
std::vector<RadianceImage> faces_of(Fn&& radiance) {
    std::vector<RadianceImage> faces(6);
    for (std::size_t face = 0; face < 6; ++face) {
        faces[face] = {.width = kSide, .height = kSide, .pixels = {}};
        for (std::uint32_t i = 0; i < kSide * kSide; ++i) {
            const float u = (static_cast<float>(i % kSide) + 0.5F) / kSide;
            const float v = (static_cast<float>(i / kSide) + 0.5F) / kSide;
            faces[face].pixels.push_back(radiance(cube_direction(face, u, v)));
        }
    }
    return faces;
}

/// The same mean by a sum over rings of half vectors: what is sampled is the definition itself.
template <class Fn>
float summed(Fn&& radiance, const Vec3f& normal, float roughness) {
    const float alpha = roughness * roughness;
    const Vec3f helper = std::abs(normal.y) < 0.9F ? Vec3f{0, 1, 0} : Vec3f{1, 0, 0};
    const Vec3f x = glm::normalize(glm::cross(helper, normal));
    const Vec3f y = glm::cross(normal, x);
    double sum = 0.0;
    double weight = 0.0;
    constexpr int kRings = 600;
    constexpr int kTurns = 96;
    for (int i = 0; i < kRings; ++i) {
        const float angle = (static_cast<float>(i) + 0.5F) / kRings * glm::half_pi<float>();
        const float c = std::cos(angle);
        const float d = c * c * (alpha * alpha - 1.0F) + 1.0F;
        const float density = alpha * alpha / (d * d) * c * std::sin(angle);
        for (int k = 0; k < kTurns; ++k) {
            const float turn = static_cast<float>(k) / kTurns * glm::two_pi<float>();
            const Vec3f half =
                normal * c + (x * std::cos(turn) + y * std::sin(turn)) * std::sin(angle);
            const Vec3f light = 2.0F * c * half - normal;
            const float facing = glm::dot(light, normal);
            if (facing <= 0.0F) continue;
            sum += static_cast<double>(density * facing * radiance(light).x);
            weight += static_cast<double>(density * facing);
        }
    }
    return static_cast<float>(sum / weight);
}

TEST(SkyReflection, AnEvenSkyStaysEvenAtEveryRoughness) {
    for (const auto& level : reflection_levels(faces_of([](const Vec3f&) {
             return Vec3f{0.25F, 0.5F, 1.0F};
         }))) {
        for (const RadianceImage& face : level) {
            for (const Vec3f& pixel : face.pixels) {
                EXPECT_NEAR(pixel.x, 0.25F, 1e-5F);
                EXPECT_NEAR(pixel.z, 1.0F, 1e-5F);
            }
        }
    }
}

TEST(SkyReflection, ALevelIsWhatAMirrorOfItsRoughnessSees) {
    const auto half_dark = [](const Vec3f& d) { return Vec3f{glm::smoothstep(0.0F, 0.4F, d.y)}; };
    const auto smooth = [](const Vec3f& d) { return Vec3f{1.0F + d.y + 0.5F * d.x * d.z}; };
    const auto levels_dark = reflection_levels(faces_of(half_dark));
    const auto levels_smooth = reflection_levels(faces_of(smooth));
    ASSERT_EQ(levels_dark.size(), 6U);
    EXPECT_EQ(levels_dark[0][2].pixels, faces_of(half_dark)[2].pixels);
    for (std::size_t i = 1; i < 4; ++i) {
        const float roughness = static_cast<float>(i) / 5.0F;
        const std::uint32_t side = kSide >> i;
        for (const std::size_t face : {0U, 2U, 4U}) {
            for (std::uint32_t y = 0; y < side; ++y) {
                const float v = (static_cast<float>(y) + 0.5F) / static_cast<float>(side);
                const Vec3f way = cube_direction(face, 0.5F + 0.5F / static_cast<float>(side), v);
                const std::size_t at = y * side + side / 2;
                EXPECT_NEAR(
                    levels_dark[i][face].pixels[at].x, summed(half_dark, way, roughness), 0.03F)
                    << "level " << i << " face " << face << " row " << y;
                EXPECT_NEAR(
                    levels_smooth[i][face].pixels[at].x, summed(smooth, way, roughness), 0.02F)
                    << "level " << i << " face " << face << " row " << y;
            }
        }
    }
}

}  // namespace
}  // namespace plumbline::render
