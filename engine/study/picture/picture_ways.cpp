#include "engine/study/picture/picture_ways.h"

#include <fmt/format.h>

#include <utility>

namespace plumbline::study {
namespace {

using render::AntiAliasing;
using render::PictureLevel;
using render::Quality;
using render::RenderFrame;

PictureWay quality_way(std::string name, void (*change)(Quality&)) {
    return {.name = std::move(name),
            .apply = [change](RenderFrame& frame) { change(frame.quality); }};
}

PictureWay level_way(PictureLevel level) {
    return {.name = fmt::format("level {}", render::name_of(level)),
            .apply = [level](RenderFrame& frame) { frame.quality = render::quality_of(level); }};
}

void add_shadow_ways(std::vector<PictureWay>& ways, const RenderFrame& frame) {
    ways.push_back({"no shadow of the sun", [](RenderFrame& f) { f.sun_shadow.reset(); }});
    for (std::uint32_t count = 1; count <= 4; ++count) {
        if (count == frame.sun_shadow->cascades) continue;
        ways.push_back({fmt::format("{} cascade{}", count, count == 1 ? "" : "s"),
                        [count](RenderFrame& f) { f.sun_shadow->cascades = count; }});
    }
    ways.push_back(quality_way("shadow maps half as wide",
                               [](Quality& quality) { quality.shadow_detail = 0.5F; }));
    ways.push_back(quality_way("shadow maps a quarter as wide",
                               [](Quality& quality) { quality.shadow_detail = 0.25F; }));
    ways.push_back(quality_way("one lookup in shadow maps",
                               [](Quality& quality) { quality.shadow_filter = false; }));
    if (frame.sun_shadow->angular_size_rad > 0.0F) {
        ways.push_back(quality_way("edges of shadows of one width", [](Quality& quality) {
            quality.contact_hardening = render::Drawn::Never;
        }));
        ways.push_back(quality_way("edges as wide as the sun's disc", [](Quality& quality) {
            quality.contact_hardening = render::Drawn::Always;
        }));
    }
    ways.push_back(quality_way("shadows to the scene's distance only",
                               [](Quality& quality) { quality.far_shadows = false; }));
}

void add_edge_ways(std::vector<PictureWay>& ways) {
    ways.push_back(quality_way(
        "edges not smoothed", [](Quality& quality) { quality.anti_aliasing = AntiAliasing::Off; }));
    ways.push_back(quality_way("edges of 4 samples", [](Quality& quality) {
        quality.anti_aliasing = AntiAliasing::Msaa4;
    }));
    ways.push_back(quality_way("4 samples a pixel", [](Quality& quality) {
        quality.anti_aliasing = AntiAliasing::Ssaa4;
    }));
}

}  // namespace

std::vector<PictureWay> picture_ways(const RenderFrame& frame) {
    std::vector<PictureWay> ways{level_way(PictureLevel::High),
                                 level_way(PictureLevel::Medium),
                                 level_way(PictureLevel::Low)};
    if (frame.sun && frame.sun_shadow) add_shadow_ways(ways, frame);
    if (frame.light_shadows) {
        ways.push_back({"no shadows of lamps", [](RenderFrame& f) { f.light_shadows.reset(); }});
    }
    if (frame.occlusion) {
        ways.push_back(quality_way("no ambient occlusion", [](Quality& quality) {
            quality.ambient_occlusion = render::Drawn::Never;
        }));
        ways.push_back(quality_way("ambient occlusion", [](Quality& quality) {
            quality.ambient_occlusion = render::Drawn::Always;
        }));
    }
    if (frame.refraction) {
        ways.push_back(quality_way("no sight into water", [](Quality& quality) {
            quality.refraction = render::Drawn::Never;
        }));
    }
    if (frame.refraction && frame.refraction->caustics) {
        ways.push_back(
            {"even light in water", [](RenderFrame& f) { f.refraction->caustics = false; }});
    }
    ways.push_back(
        quality_way("no surface maps", [](Quality& quality) { quality.surface_maps = false; }));
    add_edge_ways(ways);
    ways.push_back(
        quality_way("render scale 70 %", [](Quality& quality) { quality.render_scale = 0.7F; }));
    ways.push_back(
        quality_way("render scale 50 %", [](Quality& quality) { quality.render_scale = 0.5F; }));
    ways.push_back(
        quality_way("full meshes", [](Quality& quality) { quality.lod_error_px = 0.0F; }));
    ways.push_back(quality_way("meshes coarser by 3 px",
                               [](Quality& quality) { quality.lod_error_px = 3.0F; }));
    return ways;
}

}  // namespace plumbline::study
