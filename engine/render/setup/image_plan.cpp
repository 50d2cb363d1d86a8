#include "engine/render/setup/image_plan.h"

#include "engine/render/culling/draw_list.h"

#include <algorithm>
#include <cmath>

namespace plumbline::render {
namespace {

std::uint32_t scaled_px(std::uint32_t side_px, float scale, std::uint32_t largest_px) {
    const float scaled = std::round(static_cast<float>(side_px) * scale);
    return std::clamp(static_cast<std::uint32_t>(scaled), 1U, largest_px);
}

/// An image of the renderer's own cannot be larger than the driver allows; a window can.
PixelSize present_size(const RenderFrame& frame, const Device& device) {
    PixelSize size_px{frame.width_px, frame.height_px};
    if (device.is_offscreen) {
        size_px.width = std::min(size_px.width, device.limits.texture_px);
        size_px.height = std::min(size_px.height, device.limits.texture_px);
    }
    return size_px;
}

}  // namespace

Quality quality_in_force(const RenderFrame& frame, const Device& device, int failed_tries) {
    Quality quality = device.is_software_gl ? without_gpu(frame.quality) : frame.quality;
    if (failed_tries >= 1 && quality.anti_aliasing != AntiAliasing::Fxaa)
        quality.anti_aliasing = AntiAliasing::Off;
    if (failed_tries == 1) quality.render_scale *= 0.5F;
    if (failed_tries < 2) return quality;
    quality = quality_of(QualityLevel::Low);
    quality.render_scale = kSmallestRenderScale;
    return quality;
}

ImagePlan plan_image(const RenderFrame& frame,
                     const Quality& quality,
                     const Device& device,
                     const assets::AssetLibrary& library) {
    const GpuLimits& limits = device.limits;
    const PixelSize present_px = present_size(frame, device);
    if (present_px.width == 0 || present_px.height == 0) return {.present_px = present_px};
    // Both sides by one factor: an image too wide for the driver keeps its shape.
    const auto longer_px = static_cast<float>(std::max(present_px.width, present_px.height));
    const float scale = std::min(std::clamp(quality.render_scale, 0.1F, 1.0F),
                                 static_cast<float>(limits.texture_px) / longer_px);
    const PixelSize image_px{scaled_px(present_px.width, scale, limits.texture_px),
                             scaled_px(present_px.height, scale, limits.texture_px)};
    const std::uint32_t each_side =
        std::clamp(limits.texture_px / std::max(image_px.width, image_px.height),
                   1U,
                   quality.anti_aliasing == AntiAliasing::Ssaa4 ? 2U : 1U);
    const bool has_light = limits.half_float_targets;
    ImagePlan plan{
        .quality = quality,
        .scene_px = {image_px.width * each_side, image_px.height * each_side},
        .image_px = image_px,
        .present_px = present_px,
        .samples = samples_of(quality.anti_aliasing),
        .bloom = has_light && frame.post && frame.post->bloom > 0.0F,
        .tone_curve = frame.post.has_value(),
        .fxaa = quality.anti_aliasing == AntiAliasing::Fxaa,
        .keeps_depth = !frame.lines.vertices.empty(),
        .occlusion = has_light && frame.occlusion && quality.ambient_occlusion != Drawn::Never,
        .shafts = has_light && frame.sun && frame.shafts && quality.sun_shafts != Drawn::Never,
        .refraction = has_light && frame.refraction && quality.refraction != Drawn::Never,
        .focus = has_light && frame.depth_of_field,
        .motion_blur = has_light && frame.motion_blur};
    plan.writes_codes = device.is_offscreen && plan.only_encodes() && !mixes_colors(frame, library);
    return plan;
}

}  // namespace plumbline::render
