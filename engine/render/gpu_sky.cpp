#include "engine/render/gpu_sky.h"

#include "engine/assets/skybox_files.h"
#include "engine/core/log.h"
#include "engine/render/mip_chain.h"

#include <algorithm>
#include <array>
#include <future>
#include <memory>
#include <vector>

namespace plumbline::render {
namespace {

// Enough for a mirror on a barrel; more would only cost memory.
constexpr std::uint32_t kReflectionSide = 128;
// Faces that have to be resized anyway are not made larger than this.
constexpr std::uint32_t kLargestSide = 1024;
// Light is gathered from faces no larger than this.
constexpr std::uint32_t kLightSide = 32;
// What a typical spot of an HDR sky is shown as: a third of a white wall in the sun.
constexpr float kShownRadiance = 0.4F;

assets::ImageData gray_face() {
    return {.width = 1, .height = 1, .format = assets::PixelFormat::Rgb8, .bytes = {128, 128, 128}};
}

/// As it is, or small enough for the driver.
assets::ImageData fitted(assets::ImageData face, std::uint32_t largest_px) {
    while (std::max(face.width, face.height) > largest_px) {
        face = face.format == assets::PixelFormat::Rgb16F
                   ? half_floats_of(resized(radiance_of(face), largest_px))
                   : mip_chain(face, MipContent::Color, 0.0F).front();
    }
    return face;
}

/// A cube map wants six squares of one size and kind: where they differ, all become half floats as
/// large as the largest.
void make_alike(std::vector<assets::ImageData>& faces) {
    const bool alike = std::ranges::all_of(faces, [&](const assets::ImageData& face) {
        return face.width == face.height && face.width == faces[0].width &&
               face.format == faces[0].format;
    });
    if (alike) return;
    std::uint32_t side = 1;
    for (const auto& face : faces) side = std::max({side, face.width, face.height});
    side = std::min(side, kLargestSide);
    for (auto& face : faces) {
        const bool fits =
            face.width == side && face.height == side && face.format == assets::PixelFormat::Rgb16F;
        if (!fits) face = half_floats_of(resized(radiance_of(face), side));
    }
}

/// Averaged down to about kReflectionSide.
RadianceImage small_face(const assets::ImageData& image) {
    return radiance_of(image, std::max(image.width / kReflectionSide, 1U));
}

/// Each channel divided by its average over all directions.
SkyCoefficients with_unit_mean(SkyCoefficients sky) {
    // The first harmonic is 0.282095 everywhere.
    const Vec3f mean = glm::max(sky[0] * 0.282095F, Vec3f{1e-6F});
    for (Vec3f& coefficient : sky) coefficient /= mean;
    return sky;
}

}  // namespace

void GpuSky::want(const std::filesystem::path& folder) {
    if (folder == folder_) return;
    folder_ = folder;
    background_ = {};
    reflection_ = {};
    light_ = {};
    if (!folder.empty()) load(folder);
}

void GpuSky::load(const std::filesystem::path& folder) {
    std::vector<std::future<assets::ImageData>> decoded;
    const std::array<std::filesystem::path, 6> files = assets::skybox_files(folder);
    for (std::size_t i = 0; i < files.size(); ++i) {
        const std::filesystem::path& file = files[i];
        if (file.empty()) {
            log_warning("sky {}: no face {} (.exr, .png or .jpg); it stays grey",
                        folder.string(),
                        assets::kSkyboxFaces[i]);
        }
        decoded.push_back(std::async(std::launch::async | std::launch::deferred, [this, file] {
            return file.empty() ? gray_face() : fitted(*library_.take_image(file), largest_px_);
        }));
    }
    std::vector<assets::ImageData> faces;
    for (auto& face : decoded) faces.push_back(face.get());
    make_alike(faces);

    std::vector<RadianceImage> level;
    std::vector<std::future<RadianceImage>> under_way;
    for (const auto& face : faces) {
        under_way.push_back(std::async(std::launch::async | std::launch::deferred,
                                       [&face] { return small_face(face); }));
    }
    for (auto& face : under_way) level.push_back(face.get());

    std::vector<assets::ImageData> reflection_faces;
    reflection_levels_ = 0;
    for (;;) {
        for (const RadianceImage& face : level) reflection_faces.push_back(half_floats_of(face));
        ++reflection_levels_;
        if (level[0].width <= kLightSide && light_[0] == Vec3f{0.0F}) {
            light_ = with_unit_mean(project_sky(level));
            exposure_ = kShownRadiance / std::max(typical_radiance(level), 1e-6F);
        }
        if (level[0].width == 1) break;
        for (RadianceImage& face : level) face = halved(face);
    }
    is_srgb_ = faces[0].format != assets::PixelFormat::Rgb16F;
    if (is_srgb_) exposure_ = 1.0F;
    background_ = gl::Texture::cube(faces, 1);
    reflection_ = gl::Texture::cube(reflection_faces, reflection_levels_);
}

}  // namespace plumbline::render
