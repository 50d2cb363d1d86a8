// The sky's cube map, or the sky that is computed, and the light that comes from it. Exists while a
// frame asks for a sky.
#pragma once

#include "engine/assets/asset_library.h"
#include "engine/render/gl/texture.h"
#include "engine/render/sky/computed_sky.h"
#include "engine/render/sky/gpu_sky_dome.h"
#include "engine/render/sky/sky_light.h"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace plumbline::render {

class GpuSky {
public:
    /// Faces larger than `largest_px` on a side are made smaller.
    GpuSky(assets::AssetLibrary& library, std::uint32_t largest_px)
        : library_(library), largest_px_(largest_px) {}

    /// Loads when the folder differs from the last; a missing face is grey, with one warning. Computes
    /// when a model's sun has moved. Null frees everything.
    void want(const Sky* sky, const std::optional<DirectionalLight>& sun);

    /// The background holds sRGB code values (8-bit faces), not radiance.
    bool is_srgb() const { return is_srgb_; }
    bool ready() const { return computed() != nullptr || static_cast<bool>(background_); }
    /// Null: the sky is an image.
    const ComputedSky* computed() const { return dome_ ? &dome_->sky : nullptr; }
    const GpuSkyDome& dome() const { return dome_->gpu; }
    const gl::Texture& background() const { return background_; }
    /// Small, with mip levels as ever rougher reflections.
    const gl::Texture& reflection() const { return reflection_; }
    std::uint32_t reflection_levels() const { return reflection_levels_; }
    /// Scaled so that its average over all directions is 1 in each channel: the sky says where light
    /// comes from, the scene's ambient colour how much.
    /// A computed sky: as it is, in the scene's own radiance.
    const SkyCoefficients& light() const { return light_; }
    /// What brings the background's radiance, whose unit files do not state, to that of the scene;
    /// 1 for 8-bit faces, which are shown as they are.
    float exposure() const { return exposure_; }
    std::size_t bytes() const {
        return background_.bytes() + reflection_.bytes() + (dome_ ? dome_->gpu.bytes() : 0);
    }

private:
    struct Dome {
        ComputedSky sky;
        GpuSkyDome gpu;
    };
    void load_clouds();
    void compute(const SkyModel& model, const std::optional<DirectionalLight>& sun);
    void load(const std::filesystem::path& folder);
    /// With its mip levels.
    void set_reflection(std::vector<RadianceImage> level);

    assets::AssetLibrary& library_;
    std::uint32_t largest_px_;
    std::filesystem::path folder_;
    gl::Texture background_;
    gl::Texture reflection_;
    std::uint32_t reflection_levels_{0};
    bool is_srgb_{false};
    float exposure_{1.0F};
    SkyCoefficients light_{};
    std::unique_ptr<Dome> dome_;
};

}  // namespace plumbline::render
