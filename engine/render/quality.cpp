#include "engine/render/quality.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumbline::render {

Quality quality_of(QualityLevel level) {
    switch (level) {
        case QualityLevel::Low:
            return {.render_scale = 0.6F,
                    .anti_aliasing = AntiAliasing::Fxaa,
                    .surface_maps = false,
                    .shadow_filter = false,
                    .shadow_detail = 0.5F,
                    .shadowed_lights = 0,
                    .contact_hardening = Drawn::Never,
                    .parallax = Drawn::Never,
                    .ambient_occlusion = Drawn::Never,
                    .sun_shafts = Drawn::Never,
                    .lod_error_px = 2.0F,
                    .ground_cover = 0.5F,
                    .smallest_px = 4.0F};
        case QualityLevel::Medium:
            return {.render_scale = 0.8F,
                    .anti_aliasing = AntiAliasing::Fxaa,
                    .shadowed_lights = 2,
                    .contact_hardening = Drawn::Never,
                    .parallax = Drawn::Never,
                    .ambient_occlusion = Drawn::Never,
                    .sun_shafts = Drawn::OnGpu,
                    .lod_error_px = 1.2F,
                    .ground_cover = 0.75F,
                    .smallest_px = 2.0F};
        case QualityLevel::High:
            return {.anti_aliasing = AntiAliasing::Fxaa,
                    .far_shadows = true,
                    .shadowed_lights = 6,
                    .contact_hardening = Drawn::OnGpu,
                    .parallax = Drawn::OnGpu,
                    .ambient_occlusion = Drawn::OnGpu,
                    .sun_shafts = Drawn::OnGpu,
                    .lod_error_px = 1.0F,
                    .smallest_px = 1.0F};
    }
    return {};
}

Quality without_gpu(Quality quality) {
    for (Drawn* drawn : {&quality.contact_hardening,
                         &quality.parallax,
                         &quality.ambient_occlusion,
                         &quality.sun_shafts,
                         &quality.refraction}) {
        if (*drawn == Drawn::OnGpu) *drawn = Drawn::Never;
    }
    return quality;
}

std::uint32_t samples_of(AntiAliasing way) {
    constexpr std::array<std::uint32_t, 6> kSamples{1, 1, 2, 4, 8, 1};
    return kSamples[static_cast<std::size_t>(way)];
}

std::optional<QualityLevel> quality_level_named(std::string_view name) {
    const auto found = std::ranges::find(kImageLevelNames, name);
    if (found == kImageLevelNames.end()) return std::nullopt;
    return static_cast<QualityLevel>(found - kImageLevelNames.begin());
}

std::string what_gave_way(const Quality& quality) {
    std::string list;
    const auto add = [&](std::string_view what) {
        if (!list.empty()) list += ", ";
        list += what;
    };
    if (quality.render_scale < 1.0F) {
        add(fmt::format("render scale {:.0f} %", std::round(quality.render_scale * 100.0F)));
    }
    if (!quality.surface_maps) add("surface maps");
    if (!quality.shadow_filter) add("smooth shadows");
    if (quality.shadow_detail < 1.0F) add("fine shadows");
    if (quality.shadowed_lights == 0) add("shadows of lamps");
    if (quality.ambient_occlusion == Drawn::Never) add("ambient occlusion");
    if (quality.sun_shafts == Drawn::Never) add("sun shafts");
    if (quality.refraction == Drawn::Never) add("sight into water");
    if (quality.lod_error_px > 1.0F) add("detail far off");
    if (quality.ground_cover < 1.0F)
        add(fmt::format("grass {:.0f} %", std::round(quality.ground_cover * 100.0F)));
    if (quality.smallest_px > 1.0F) add(fmt::format("things below {:.0f} px", quality.smallest_px));
    return list;
}

}  // namespace plumbline::render
