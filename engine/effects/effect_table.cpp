#include "engine/effects/effect_table.h"

#include "engine/effects/effects.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace plumbline::effects {

namespace {

using scene::Simulation;

/// Beyond this many, callers are counted, not named.
constexpr std::size_t kCallersNamed = 8;

std::string setting(std::string_view name, const scene::Origin& origin) {
    if (origin.line <= 0) return std::string(name);
    return fmt::format("{} ({})", name, scene::to_string(origin));
}

/// Collects entities; names the first few.
class EntityCallers {
public:
    explicit EntityCallers(const Simulation& simulation) : simulation_(simulation) {}
    void add(ecs::Entity entity) {
        if (++count_ <= kCallersNamed) callers_.push_back(simulation_.describe(entity));
    }
    Callers take() {
        if (count_ > kCallersNamed) {
            callers_.push_back(fmt::format("and {} more", count_ - kCallersNamed));
        }
        return std::move(callers_);
    }

private:
    const Simulation& simulation_;
    Callers callers_;
    std::size_t count_{0};
};

Callers sun_shadow_callers(const Simulation& simulation) {
    const auto& sun = simulation.description().sun;
    if (!sun || !sun->shadow) return {};
    return {setting("[sun] shadow", sun->shadow->origin)};
}

Callers flashlight_callers(const Simulation& simulation) {
    if (!simulation.description().flashlight || !simulation.switches.flashlight) return {};
    return {"switch flashlight"};
}

Callers fog_callers(const Simulation& simulation) {
    const auto& fog = simulation.description().fog;
    if (fog && simulation.switches.fog) return {setting("[fog]", fog->origin)};
    if (!fog && simulation.switches.fog_added) return {"switch fog"};
    return {};
}

Callers skybox_callers(const Simulation& simulation) {
    const auto& sky = simulation.description().sky;
    if (!sky) return {};
    return {setting("[sky] skybox", sky->origin)};
}

Callers post_callers(const Simulation& simulation) {
    const auto& post = simulation.description().post;
    if (!post) return {};
    return {setting("[post]", post->origin)};
}

Callers model_animation_callers(const Simulation& simulation) {
    EntityCallers callers(simulation);
    for (auto [entity, playing] : simulation.registry.view<const scene::PlayingModel>()) {
        callers.add(entity);
    }
    return callers.take();
}

Callers viewer_aids_callers(const Simulation& simulation) {
    if (!simulation.description().shows_model) return {};
    return {"a model by itself"};
}

Callers impact_sounds_callers(const Simulation& simulation) {
    EntityCallers callers(simulation);
    for (const scene::MovingBody& moving : simulation.moving_bodies()) {
        if (moving.kind != physics::BodyKind::Dynamic) continue;
        if (!simulation.registry.alive(moving.entity)) continue;
        const auto& surface = simulation.registry.get<scene::SurfaceRef>(moving.entity);
        if (simulation.is_heard(surface.surface)) callers.add(moving.entity);
    }
    return callers.take();
}

Callers ambient_sounds_callers(const Simulation& simulation) {
    EntityCallers callers(simulation);
    for (auto [entity, ambient] : simulation.registry.view<const scene::AmbientSound>()) {
        callers.add(entity);
    }
    return callers.take();
}

Callers footsteps_callers(const Simulation& simulation) {
    const auto& player = simulation.description().player;
    const auto& surfaces = simulation.surfaces().surfaces;
    const bool any_sound = std::any_of(surfaces.begin(), surfaces.end(), [](const auto& surface) {
        return !surface.step_sounds.empty();
    });
    if (!player || !any_sound) return {};
    return {setting("[player]", player->origin)};
}

Callers continuous_collision_callers(const Simulation& simulation) {
    const ecs::Entity swept = simulation.motion_demand().swept;
    if (!simulation.registry.alive(swept)) return {};
    return {simulation.describe(swept)};
}

Callers gyroscopic_torque_callers(const Simulation& simulation) {
    const ecs::Entity spinning = simulation.motion_demand().spinning;
    if (!simulation.registry.alive(spinning)) return {};
    return {simulation.describe(spinning)};
}

Callers contact_events_callers(const Simulation& simulation) {
    return simulation.contact_listeners();
}

// A row may call for rows below it: impact sounds ask for contact events.
constexpr std::array<EffectRow, 13> kTable{{
    {.name = "sun_shadow",
     .domain = Domain::Picture,
     .called_for_by = &sun_shadow_callers,
     .make = &make_sun_shadow,
     .gpu_owner = "sun_shadow",
     .passes = "shadow.sun"},
    {.name = "flashlight",
     .domain = Domain::Picture,
     .called_for_by = &flashlight_callers,
     .make = &make_flashlight,
     .gpu_owner = "flashlight",
     .passes = "shadow.flashlight"},
    {.name = "fog",
     .domain = Domain::Picture,
     .called_for_by = &fog_callers,
     .make = &make_fog,
     .gpu_owner = {},
     .passes = {}},
    {.name = "skybox",
     .domain = Domain::Picture,
     .called_for_by = &skybox_callers,
     .make = &make_skybox,
     .gpu_owner = "sky",
     .passes = "sky"},
    {.name = "post",
     .domain = Domain::Picture,
     .called_for_by = &post_callers,
     .make = &make_post,
     .gpu_owner = "post",
     .passes = "post."},
    {.name = "model_animation",
     .domain = Domain::Picture,
     .called_for_by = &model_animation_callers,
     .make = &make_model_animation,
     .gpu_owner = {},
     .passes = {}},
    {.name = "viewer_aids",
     .domain = Domain::Picture,
     .called_for_by = &viewer_aids_callers,
     .make = &make_viewer_aids,
     .gpu_owner = {},
     .passes = {}},
    {.name = "impact_sounds",
     .domain = Domain::Sound,
     .called_for_by = &impact_sounds_callers,
     .make = &make_impact_sounds,
     .gpu_owner = {},
     .passes = {}},
    {.name = "ambient_sounds",
     .domain = Domain::Sound,
     .called_for_by = &ambient_sounds_callers,
     .make = &make_ambient_sounds,
     .gpu_owner = {},
     .passes = {}},
    {.name = "footsteps",
     .domain = Domain::Sound,
     .called_for_by = &footsteps_callers,
     .make = &make_footsteps,
     .gpu_owner = {},
     .passes = {}},
    {.name = "continuous_collision",
     .domain = Domain::Step,
     .called_for_by = &continuous_collision_callers,
     .make = &make_continuous_collision,
     .gpu_owner = {},
     .passes = {}},
    {.name = "gyroscopic_torque",
     .domain = Domain::Step,
     .called_for_by = &gyroscopic_torque_callers,
     .make = &make_gyroscopic_torque,
     .gpu_owner = {},
     .passes = {}},
    {.name = "contact_events",
     .domain = Domain::Step,
     .called_for_by = &contact_events_callers,
     .make = &make_contact_events,
     .gpu_owner = {},
     .passes = {}},
}};

}  // namespace

std::span<const EffectRow> effect_table() {
    return kTable;
}

}  // namespace plumbline::effects
