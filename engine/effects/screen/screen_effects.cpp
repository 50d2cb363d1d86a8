// Fog, water and the lens: effects without a state of their own, which put what the scene says into the
// frame.
#include "engine/effects/callers.h"
#include "engine/effects/effect_table.h"
#include "engine/scene/environment/live_light.h"

namespace plumbline::effects {
namespace {

// By fidelity.
constexpr std::array<std::uint32_t, 3> kOcclusionSlices{1, 2, 3};
constexpr std::array<std::uint32_t, 3> kOcclusionSteps{2, 3, 4};
constexpr std::array<std::uint32_t, 3> kLensSamples{24, 48, 128};

/// The scene's own, or a plain one where play switches it on.
void show_fog(const scene::Simulation& simulation, render::RenderFrame& frame) {
    const scene::FogDescription fog =
        simulation.description().fog.value_or(scene::FogDescription{});
    const scene::LiveSwitches& switches = simulation.switches;
    const Vec3f color =
        switches.fog_color == 0 ? fog.color : scene::kFogColors[switches.fog_color].color;
    frame.fog = render::Fog{.color = color * switches.light_scale,
                            .density_per_m = fog.density_per_m * switches.fog_density_scale};
}

Callers callers_of_fog(const scene::Simulation& simulation) {
    const auto& fog = simulation.description().fog;
    if (!simulation.switches.is_on("fog", fog && fog->on)) return {};
    return {fog ? setting("[fog]", fog->location) : "switch fog"};
}

/// Water that shows what lies below it.
void show_refraction(const scene::Simulation&, render::RenderFrame& frame) {
    frame.refraction = render::Refraction{};
}

Callers callers_of_refraction(const scene::Simulation& simulation) {
    if (!simulation.switches.is_on("refraction", true)) return {};
    return wearers_of(simulation, [](const assets::MaterialData& material) {
        return material.attenuation_m > 0.0F;
    });
}

/// Less ambient light in corners and narrow places.
void show_occlusion(const scene::Simulation& simulation, render::RenderFrame& frame) {
    const scene::SceneDescription& scene = simulation.description();
    const scene::Fidelity fidelity = scene.screen_fidelity.occlusion;
    frame.occlusion = render::AmbientOcclusion{.radius_m = scene.ambient.occlusion->radius_m,
                                               .strength = scene.ambient.occlusion->strength,
                                               .slices = by_fidelity(fidelity, kOcclusionSlices),
                                               .steps = by_fidelity(fidelity, kOcclusionSteps)};
}

Callers callers_of_occlusion(const scene::Simulation& simulation) {
    const auto& occlusion = simulation.description().ambient.occlusion;
    if (!occlusion || !simulation.switches.is_on("ambient_occlusion", true)) return {};
    return {setting("[ambient] occlusion", occlusion->location)};
}

/// Light that comes in by windows and goes from wall to wall.
void show_indirect_light(const scene::Simulation& simulation, render::RenderFrame& frame) {
    const scene::IndirectLightDescription& indirect = *simulation.description().ambient.indirect;
    frame.indirect = render::IndirectLight{.min_world = Vec3f(indirect.min_m),
                                           .max_world = Vec3f(indirect.max_m),
                                           .spacing_m = indirect.spacing_m,
                                           .gain = indirect.gain};
}

Callers callers_of_indirect_light(const scene::Simulation& simulation) {
    const auto& indirect = simulation.description().ambient.indirect;
    if (!indirect || !simulation.switches.is_on("indirect_light", true)) return {};
    return {setting("[ambient] indirect", indirect->location)};
}

/// A lens that is sharp at one distance.
void show_focus(const scene::Simulation& simulation, render::RenderFrame& frame) {
    const scene::SceneDescription& scene = simulation.description();
    const scene::FocusDescription& focus = *scene.camera.focus;
    frame.depth_of_field =
        render::DepthOfField{.focus_m = focus.distance_m,
                             .aperture_m = focus.aperture_m,
                             .samples = by_fidelity(scene.screen_fidelity.focus, kLensSamples)};
}

Callers callers_of_focus(const scene::Simulation& simulation) {
    const auto& focus = simulation.description().camera.focus;
    if (!focus || !simulation.switches.is_on("depth_of_field", true)) return {};
    return {setting("[camera] focus", focus->location)};
}

/// Exposure and bloom.
void show_post(const scene::Simulation& simulation, render::RenderFrame& frame) {
    const scene::PostDescription& post = *simulation.description().post;
    frame.post =
        render::Post{.exposure = post.exposure, .bloom = post.bloom, .adapts = post.adapts};
}

Callers callers_of_post(const scene::Simulation& simulation) {
    const auto& post = simulation.description().post;
    if (!post) return {};
    return {setting("[post]", post->location)};
}

}  // namespace

EffectRow fog() {
    return with_effect<FrameEffect<&show_fog>>({.called_for_by = &callers_of_fog});
}

EffectRow refraction() {
    return with_effect<FrameEffect<&show_refraction>>({.called_for_by = &callers_of_refraction,
                                                       .gpu_owner = "refraction",
                                                       .passes = "refraction"});
}

EffectRow ambient_occlusion() {
    return with_effect<FrameEffect<&show_occlusion>>({.called_for_by = &callers_of_occlusion,
                                                      .gpu_owner = "ambient_occlusion",
                                                      .passes = "occlusion"});
}

EffectRow indirect_light() {
    return with_effect<FrameEffect<&show_indirect_light>>(
        {.called_for_by = &callers_of_indirect_light, .gpu_owner = "indirect_light"});
}

EffectRow depth_of_field() {
    return with_effect<FrameEffect<&show_focus>>(
        {.called_for_by = &callers_of_focus, .gpu_owner = "depth_of_field", .passes = "focus"});
}

EffectRow post() {
    return with_effect<FrameEffect<&show_post>>(
        {.called_for_by = &callers_of_post, .gpu_owner = "post", .passes = "post."});
}

}  // namespace plumbline::effects
