#include "engine/study/image/image_variants.h"

#include <fmt/format.h>

#include <initializer_list>

namespace plumbline::study {
namespace {

using render::AntiAliasing;
using render::Drawn;
using render::Quality;
using render::QualityLevel;
using render::RenderFrame;

/// A variant that differs in the quality alone.
struct QualityChange {
    const char* name;
    void (*apply)(Quality&);
};

void add(std::vector<ImageVariant>& variants, std::initializer_list<QualityChange> changes) {
    for (const QualityChange& change : changes)
        variants.push_back(
            {change.name, [apply = change.apply](RenderFrame& frame) { apply(frame.quality); }});
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
    add(variants,
        {{"shadow maps half as wide", [](Quality& q) { q.shadow_detail = 0.5F; }},
         {"shadow maps a quarter as wide", [](Quality& q) { q.shadow_detail = 0.25F; }},
         {"one lookup in shadow maps", [](Quality& q) { q.shadow_filter = false; }}});
    if (frame.sun_shadow->angular_size_rad > 0.0F)
        add(variants,
            {{"edges of shadows of one width",
              [](Quality& q) { q.contact_hardening = Drawn::Never; }},
             {"edges as wide as the sun's disc",
              [](Quality& q) { q.contact_hardening = Drawn::Always; }}});
    add(variants,
        {{"shadows to the scene's distance only", [](Quality& q) { q.far_shadows = false; }}});
}

}  // namespace

std::vector<ImageVariant> image_variants(const RenderFrame& frame) {
    std::vector<ImageVariant> variants{level_variant(QualityLevel::High),
                                       level_variant(QualityLevel::Medium),
                                       level_variant(QualityLevel::Low)};
    if (frame.sun && frame.sun_shadow) add_shadow_variants(variants, frame);
    if (frame.light_shadows)
        variants.push_back(
            {"no shadows of lamps", [](RenderFrame& f) { f.light_shadows.reset(); }});
    if (frame.occlusion)
        add(variants,
            {{"no ambient occlusion", [](Quality& q) { q.ambient_occlusion = Drawn::Never; }},
             {"ambient occlusion", [](Quality& q) { q.ambient_occlusion = Drawn::Always; }}});
    if (frame.refraction)
        add(variants, {{"no sight into water", [](Quality& q) { q.refraction = Drawn::Never; }}});
    if (frame.refraction && frame.refraction->caustics)
        variants.push_back(
            {"even light in water", [](RenderFrame& f) { f.refraction->caustics = false; }});
    add(variants,
        {{"no surface maps", [](Quality& q) { q.surface_maps = false; }},
         {"edges not smoothed", [](Quality& q) { q.anti_aliasing = AntiAliasing::Off; }},
         {"edges of 4 samples", [](Quality& q) { q.anti_aliasing = AntiAliasing::Msaa4; }},
         {"4 samples a pixel", [](Quality& q) { q.anti_aliasing = AntiAliasing::Ssaa4; }},
         {"render scale 70 %", [](Quality& q) { q.render_scale = 0.7F; }},
         {"render scale 50 %", [](Quality& q) { q.render_scale = 0.5F; }},
         {"full meshes", [](Quality& q) { q.lod_error_px = 0.0F; }},
         {"meshes coarser by 3 px", [](Quality& q) { q.lod_error_px = 3.0F; }}});
    return variants;
}

}  // namespace plumbline::study
