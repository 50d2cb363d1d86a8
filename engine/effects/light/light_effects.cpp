// Lights, their shadows and the sky: effects without a state of their own, which put what the scene says
// into the frame.
#include "engine/effects/callers.h"
#include "engine/effects/effect_table.h"
#include "engine/scene/environment/sun_path.h"

namespace plumbline::effects {
namespace {

constexpr std::array<std::uint32_t, 3> kShaftSamples{8, 16, 48};  // by fidelity

void show_sun_shadow(const scene::Simulation& simulation, render::RenderFrame& frame) {
    const scene::ShadowDescription& shadow = *simulation.description().sun->shadow;
    frame.sun_shadow =
        render::SunShadow{.size_px = static_cast<std::uint32_t>(shadow.size_px),
                          .distance_m = static_cast<float>(shadow.distance_m),
                          .cascades = static_cast<std::uint32_t>(shadow.cascades),
                          .angular_size_rad = radians_from_degrees(shadow.angular_size_deg)};
}

Callers callers_of_sun_shadow(const scene::Simulation& simulation) {
    const auto& sun = simulation.description().sun;
    if (!sun || !sun->shadow) return {};
    // In a scene that is only looked at they are there when asked for.
    if (!simulation.switches.is_on("sun_shadow", !simulation.description().viewer)) return {};
    return {setting("[sun] shadow", sun->shadow->location)};
}

void show_light_shadows(const scene::Simulation&, render::RenderFrame& frame) {
    frame.light_shadows = render::LightShadows{};
}

/// Lamps that ask for shadows.
Callers callers_of_light_shadows(const scene::Simulation& simulation) {
    if (!simulation.switches.is_on("light_shadows", true)) return {};
    EntityCallers callers(simulation);
    for (auto [entity, light] : simulation.registry.view<const scene::PointLight>()) {
        if (light.casts_shadow) callers.add(entity);
    }
    return callers.take();
}

/// The light in the hand, with its shadow.
class Flashlight final : public Effect {
public:
    void extract(const scene::Simulation& simulation,
                 const scene::ViewPoint& view,
                 render::RenderFrame& frame) override {
        const scene::FlashlightDescription& light = *simulation.description().flashlight;
        const Quatf orientation(view.world_from_hand.orientation);
        const Pose& place = light.at_eye ? view.world_from_camera : view.world_from_hand;
        frame.flashlight =
            render::Flashlight{.position_world = Vec3f(place.position),
                               .direction_world = orientation * Vec3f{0.0F, 0.0F, -1.0F},
                               .intensity = light.color * light.intensity,
                               .radius_m = light.radius_m,
                               .inner_rad = radians_from_degrees(light.inner_deg),
                               .outer_rad = radians_from_degrees(light.outer_deg)};
        ++work_.calls;
    }
};

Callers callers_of_flashlight(const scene::Simulation& simulation) {
    const auto& light = simulation.description().flashlight;
    if (!light || !simulation.switches.is_on("flashlight", light->on)) return {};
    return {"switch flashlight"};
}

/// Six images, or computed from where the sun stands.
void show_sky(const scene::Simulation& simulation, render::RenderFrame& frame) {
    const scene::SceneDescription& scene = simulation.description();
    frame.sky =
        render::Sky{.folder = scene.sky->folder, .brightness = simulation.switches.light_scale};
    if (!scene.sky->model) return;
    render::SkyModel& model = frame.sky->model.emplace();
    model.to_sun_world = frame.sun ? -frame.sun->direction_world : Vec3f{0, -1, 0};
    if (scene.time) model.pole_world = scene::sky_pole(*scene.time);
    model.haze = scene.sky->model->haze;
    model.visibility_m = scene.sky->model->visibility_m;
    model.clouds = scene.sky->model->clouds;
}

Callers callers_of_skybox(const scene::Simulation& simulation) {
    const auto& sky = simulation.description().sky;
    if (!sky) return {};
    return {setting(sky->model ? "[sky] model" : "[sky] skybox", sky->location)};
}

/// The sun's light below rippled water, as far as refraction shows what is there.
class Caustics final : public Effect {
public:
    void extract(const scene::Simulation&,
                 const scene::ViewPoint&,
                 render::RenderFrame& frame) override {
        if (!frame.refraction) return;
        frame.refraction->caustics = true;
        ++work_.calls;
    }
};

Callers callers_of_caustics(const scene::Simulation& simulation) {
    if (!simulation.switches.is_on("caustics", true)) return {};
    return wearers_of(simulation, [](const assets::MaterialData& material) {
        return material.caustics > 0.0F && material.attenuation_m > 0.0F;
    });
}

/// Air that the sun lights up between shadows.
void show_shafts(const scene::Simulation& simulation, render::RenderFrame& frame) {
    const scene::SceneDescription& scene = simulation.description();
    const scene::ShaftsDescription& shafts = *scene.sun->shafts;
    frame.shafts =
        render::SunShafts{.density_per_m = shafts.density_per_m,
                          .distance_m = shafts.distance_m,
                          .steps = by_fidelity(scene.screen_fidelity.shafts, kShaftSamples)};
}

Callers callers_of_shafts(const scene::Simulation& simulation) {
    const auto& sun = simulation.description().sun;
    if (!sun || !sun->shafts || !simulation.switches.is_on("sun_shafts", true)) return {};
    return {setting("[sun] shafts", sun->shafts->location)};
}

}  // namespace

EffectRow sun_shadow() {
    return with_effect<FrameEffect<&show_sun_shadow>>({.called_for_by = &callers_of_sun_shadow,
                                                       .gpu_owner = "sun_shadow",
                                                       .passes = "shadow.sun"});
}

EffectRow light_shadows() {
    return with_effect<FrameEffect<&show_light_shadows>>(
        {.called_for_by = &callers_of_light_shadows,
         .gpu_owner = "light_shadows",
         .passes = "shadow.lights"});
}

EffectRow flashlight() {
    return with_effect<Flashlight>({.called_for_by = &callers_of_flashlight,
                                    .gpu_owner = "flashlight",
                                    .passes = "shadow.flashlight"});
}

EffectRow skybox() {
    return with_effect<FrameEffect<&show_sky>>(
        {.called_for_by = &callers_of_skybox, .gpu_owner = "sky", .passes = "sky"});
}

EffectRow caustics() {
    return with_effect<Caustics>({.called_for_by = &callers_of_caustics});
}

EffectRow sun_shafts() {
    return with_effect<FrameEffect<&show_shafts>>(
        {.called_for_by = &callers_of_shafts, .gpu_owner = "sun_shafts", .passes = "shafts"});
}

}  // namespace plumbline::effects
