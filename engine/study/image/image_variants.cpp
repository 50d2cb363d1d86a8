#include "engine/study/image/image_variants.h"

#include <fmt/format.h>

#include <utility>

namespace plumbline::study {
namespace {

using render::AntiAliasing;
using render::Quality;
using render::QualityLevel;
using render::RenderFrame;

ImageVariant quality_variant(std::string name, void (*change)(Quality&)) {
    return {.name = std::move(name),
            .apply = [change](RenderFrame& frame) { change(frame.quality); }};
}

ImageVariant level_variant(QualityLevel level) {
    return {.name = fmt::format("level {}", render::name_of(level)),
            .apply = [level](RenderFrame& frame) { frame.quality = render::quality_of(level); }};
}

void add_shadow_variants(std::vector<ImageVariant>& variants, const RenderFrame& frame) {
    variants.push_back({"no shadow of the sun", [](RenderFrame& f) { f.sun_shadow.reset(); }});
    for (std::uint32_t count = 1; count <= 4; ++count) {
        if (count == frame.sun_shadow->cascades) continue;
        variants.push_back({fmt::format("{} cascade{}", count, count == 1 ? "" : "s"),
                            [count](RenderFrame& f) { f.sun_shadow->cascades = count; }});
    }
    variants.push_back(quality_variant("shadow maps half as wide",
                                       [](Quality& quality) { quality.shadow_detail = 0.5F; }));
    variants.push_back(quality_variant("shadow maps a quarter as wide",
                                       [](Quality& quality) { quality.shadow_detail = 0.25F; }));
    variants.push_back(quality_variant("one lookup in shadow maps",
                                       [](Quality& quality) { quality.shadow_filter = false; }));
    if (frame.sun_shadow->angular_size_rad > 0.0F) {
        variants.push_back(quality_variant("edges of shadows of one width", [](Quality& quality) {
            quality.contact_hardening = render::Drawn::Never;
        }));
        variants.push_back(quality_variant("edges as wide as the sun's disc", [](Quality& quality) {
            quality.contact_hardening = render::Drawn::Always;
        }));
    }
    variants.push_back(quality_variant("shadows to the scene's distance only",
                                       [](Quality& quality) { quality.far_shadows = false; }));
}

void add_edge_variants(std::vector<ImageVariant>& variants) {
    variants.push_back(quality_variant(
        "edges not smoothed", [](Quality& quality) { quality.anti_aliasing = AntiAliasing::Off; }));
    variants.push_back(quality_variant("edges of 4 samples", [](Quality& quality) {
        quality.anti_aliasing = AntiAliasing::Msaa4;
    }));
    variants.push_back(quality_variant("4 samples a pixel", [](Quality& quality) {
        quality.anti_aliasing = AntiAliasing::Ssaa4;
    }));
}

}  // namespace

std::vector<ImageVariant> image_variants(const RenderFrame& frame) {
    std::vector<ImageVariant> variants{level_variant(QualityLevel::High),
                                       level_variant(QualityLevel::Medium),
                                       level_variant(QualityLevel::Low)};
    if (frame.sun && frame.sun_shadow) add_shadow_variants(variants, frame);
    if (frame.light_shadows) {
        variants.push_back(
            {"no shadows of lamps", [](RenderFrame& f) { f.light_shadows.reset(); }});
    }
    if (frame.occlusion) {
        variants.push_back(quality_variant("no ambient occlusion", [](Quality& quality) {
            quality.ambient_occlusion = render::Drawn::Never;
        }));
        variants.push_back(quality_variant("ambient occlusion", [](Quality& quality) {
            quality.ambient_occlusion = render::Drawn::Always;
        }));
    }
    if (frame.refraction) {
        variants.push_back(quality_variant("no sight into water", [](Quality& quality) {
            quality.refraction = render::Drawn::Never;
        }));
    }
    if (frame.refraction && frame.refraction->caustics) {
        variants.push_back(
            {"even light in water", [](RenderFrame& f) { f.refraction->caustics = false; }});
    }
    variants.push_back(
        quality_variant("no surface maps", [](Quality& quality) { quality.surface_maps = false; }));
    add_edge_variants(variants);
    variants.push_back(quality_variant("render scale 70 %",
                                       [](Quality& quality) { quality.render_scale = 0.7F; }));
    variants.push_back(quality_variant("render scale 50 %",
                                       [](Quality& quality) { quality.render_scale = 0.5F; }));
    variants.push_back(
        quality_variant("full meshes", [](Quality& quality) { quality.lod_error_px = 0.0F; }));
    variants.push_back(quality_variant("meshes coarser by 3 px",
                                       [](Quality& quality) { quality.lod_error_px = 3.0F; }));
    return variants;
}

}  // namespace plumbline::study
