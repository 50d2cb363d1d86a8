#include "engine/render/sky/gpu_sky.h"

#include "engine/assets/skybox_files.h"
#include "engine/core/log.h"
#include "engine/render/resources/mip_chain.h"
#include "engine/render/sky/sky_reflection.h"

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
// Of the sun that a night without one is lit by: moon and stars go by it.
constexpr Vec3f kNoSunsIrradiance{3.0F};

assets::ImageData gray_face() {
    return {.width = 1, .height = 1, .format = assets::PixelFormat::Rgb8, .bytes = {128, 128, 128}};
}

/// As it is, or small enough for the driver. A sky has no alpha.
assets::ImageData fitted(assets::ImageData face, std::uint32_t largest_px) {
    if (face.format == assets::PixelFormat::Rgba16F) face = half_floats_of(radiance_of(face));
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

void halve(std::vector<RadianceImage>& faces) {
    for (RadianceImage& face : faces) face = halved(face);
}

/// Each channel divided by its average over all directions.
SkyCoefficients with_unit_mean(SkyCoefficients sky) {
    // The first harmonic is 0.282095 everywhere.
    const Vec3f mean = glm::max(sky[0] * 0.282095F, Vec3f{1e-6F});
    for (Vec3f& coefficient : sky) coefficient /= mean;
    return sky;
}

/// What the clouds' faces hold on average over each direction that a ComputedSky knows.
std::vector<CloudTexel> averaged_clouds(const std::vector<assets::ImageData>& faces) {
    constexpr std::uint32_t kSide = ComputedSky::kSide;
    std::vector<CloudTexel> texels;
    for (const assets::ImageData& face : faces) {
        const std::uint32_t block = face.width / kSide;
        for (std::uint32_t i = 0; i < kSide * kSide; ++i) {
            Vec4f sum{0.0F};
            for (std::uint32_t k = 0; k < block * block; ++k) {
                const std::size_t x = i % kSide * block + k % block;
                const std::size_t y = i / kSide * block + k / block;
                const std::uint8_t* codes = face.bytes.data() + (y * face.width + x) * 4;
                sum += Vec4f{codes[0], codes[1], codes[2], codes[3]};
            }
            sum /= 255.0F * static_cast<float>(block * block);
            texels.push_back({.cover = sum.w, .lit = sum.x, .toward = Vec2f{sum.y, sum.z} - 0.5F});
        }
    }
    return texels;
}

}  // namespace

void GpuSky::want(const Sky* sky, const std::optional<DirectionalLight>& sun) {
    const bool is_computed = sky != nullptr && sky->model;
    const std::filesystem::path folder = sky != nullptr ? sky->folder : std::filesystem::path{};
    if (folder != folder_ || is_computed != static_cast<bool>(dome_)) {
        folder_ = folder;
        background_ = {};
        reflection_ = {};
        light_ = {};
        dome_.reset();
        if (is_computed) {
            dome_ = std::make_unique<Dome>();
            if (!folder.empty()) load_clouds();
        } else if (!folder.empty()) {
            load(folder);
        }
    }
    if (is_computed) compute(*sky->model, sun);
}

void GpuSky::load_clouds() {
    std::vector<assets::ImageData> faces;
    for (const std::filesystem::path& file : assets::skybox_files(folder_)) {
        const std::shared_ptr<const assets::ImageData> face = library_.take_image(file);
        if (face->format != assets::PixelFormat::Rgba8 || face->width != face->height ||
            face->width < ComputedSky::kSide || face->width > largest_px_ ||
            (!faces.empty() && face->width != faces[0].width)) {
            log_warning(
                "sky {}: clouds are six equal squares with alpha, {} px at least; there are none",
                folder_.string(),
                ComputedSky::kSide);
            return;
        }
        faces.push_back(*face);
    }
    dome_->sky.set_clouds(averaged_clouds(faces));
    background_ = gl::Texture::cube(faces, 1);
}

void GpuSky::compute(const SkyModel& model, const std::optional<DirectionalLight>& sun) {
    if (!dome_->sky.want(model, sun ? sun->radiance : kNoSunsIrradiance)) return;
    dome_->gpu.update(dome_->sky);
    std::vector<RadianceImage> level = dome_->sky.faces();
    light_ = project_sky(level);
    exposure_ = 1.0F;
    set_reflection(std::move(level));
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

    std::vector<RadianceImage> small = level;
    while (small[0].width > kLightSide) halve(small);
    light_ = with_unit_mean(project_sky(small));
    exposure_ = kShownRadiance / std::max(typical_radiance(small), 1e-6F);
    set_reflection(std::move(level));
    is_srgb_ = faces[0].format != assets::PixelFormat::Rgb16F;
    if (is_srgb_) exposure_ = 1.0F;
    background_ = gl::Texture::cube(faces, 1);
}

void GpuSky::set_reflection(std::vector<RadianceImage> sky) {
    const auto levels = render::reflection_levels(std::move(sky));
    std::vector<assets::ImageData> faces;
    for (const auto& level : levels)
        for (const RadianceImage& face : level) faces.push_back(half_floats_of(face));
    reflection_levels_ = static_cast<std::uint32_t>(levels.size());
    reflection_ = gl::Texture::cube(faces, reflection_levels_);
}

}  // namespace plumbline::render
