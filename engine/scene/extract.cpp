#include "engine/scene/extract.h"

#include "engine/core/limits.h"

#include <algorithm>
#include <utility>

namespace plumbline::scene {

namespace {

constexpr float kLit = 0.05F;  // a lamp with less of its light looks as it does when it is off

/// How far lamps that wait for the dark are up: they come on while the sun's last five degrees sink,
/// and where light is turned down by hand.
float dark_lamps(const Simulation& simulation) {
    const LiveSwitches& switches = simulation.switches;
    if (switches.effects.contains("lamps")) return switches.is_on("lamps", true) ? 1.0F : 0.0F;
    if (!simulation.description().sun || switches.light_scale < 0.25F) return 1.0F;
    const float sun_height = -normalize_or(switches.sun_direction, Vec3f{0.0F, -1.0F, 0.0F}).y;
    return 1.0F - glm::smoothstep(0.0F, 0.0872F, sun_height);
}

float lamp_share(LampOn on, float dark) {
    if (on == LampOn::Dark) return dark;
    return on == LampOn::Always ? 1.0F : 0.0F;
}

void add_items(const Simulation& simulation,
               Real blend_share,
               float dark,
               render::RenderFrame& frame) {
    for (auto [entity, visual, transform] :
         simulation.registry.view<const Visual, const Transform>()) {
        if (simulation.registry.has<PlayingModel>(entity)) continue;  // an effect draws its parts
        const Pose pose = drawn_pose(simulation, entity, transform, blend_share);
        const LampAppearance* lamp = simulation.registry.find<LampAppearance>(entity);
        const bool is_off = lamp != nullptr &&
                            lamp_share(simulation.registry.get<PointLight>(entity).on, dark) < kLit;
        render::add_item(frame,
                         {.mesh = visual.mesh,
                          .world_from_body = matrix_of(pose, transform.scale),
                          .tint = visual.tint,
                          .casts_shadow = visual.casts_shadow,
                          .is_static = visual.is_static},
                         is_off ? lamp->off : visual.materials);
    }
}

void add_lights(const Simulation& simulation,
                Real blend_share,
                float dark,
                render::RenderFrame& frame) {
    for (auto [entity, light, transform] :
         simulation.registry.view<const PointLight, const Transform>()) {
        const float share = lamp_share(light.on, dark);
        if (share <= 0.0F) continue;
        const Pose pose = drawn_pose(simulation, entity, transform, blend_share);
        const Quatf orientation(pose.orientation);
        frame.lights.push_back(
            {.position_world = Vec3f(pose.position) + orientation * light.offset_body,
             .intensity = light.intensity * share,
             .radius_m = light.radius_m,
             .is_spot = light.is_spot,
             .direction_world = orientation * light.direction_body,
             .inner_cos = portable_cos(light.inner_rad),
             .outer_cos = portable_cos(light.outer_rad),
             .casts_shadow = light.casts_shadow});
    }
    if (frame.lights.size() <= limits::kLights) return;
    const Vec3f eye = frame.camera.position_world;
    const auto nearer = [&](const render::LocalLight& a, const render::LocalLight& b) {
        return glm::distance(a.position_world, eye) < glm::distance(b.position_world, eye);
    };
    std::stable_sort(frame.lights.begin(), frame.lights.end(), nearer);
    frame.lights.resize(limits::kLights);
}

}  // namespace

bool is_lit(const Simulation& simulation, const PointLight& light) {
    return lamp_share(light.on, dark_lamps(simulation)) >= kLit;
}

Pose drawn_pose(const Simulation& simulation,
                ecs::Entity entity,
                const Transform& transform,
                Real blend_share) {
    const auto* previous = simulation.registry.find<PreviousTransform>(entity);
    if (previous == nullptr) return transform.world_from_body;
    const Pose& from = previous->world_from_body;
    const Pose& to = transform.world_from_body;
    // Most bodies rest most of the time; they need no interpolation.
    if (from.position == to.position && from.orientation == to.orientation) return to;
    return blend(from, to, blend_share);
}

render::RenderFrame extract(const Simulation& simulation,
                            const ViewPoint& view,
                            std::uint32_t width_px,
                            std::uint32_t height_px) {
    const SceneDescription& scene = simulation.description();
    render::RenderFrame frame;
    frame.width_px = width_px;
    frame.height_px = height_px;
    frame.camera = {.position_world = Vec3f(view.world_from_camera.position),
                    .orientation = Quatf(view.world_from_camera.orientation),
                    .fov_y_rad = static_cast<float>(view.fov_y_rad),
                    .near_m = static_cast<float>(scene.camera.near_m),
                    .far_m = static_cast<float>(scene.camera.far_m)};
    // Repeats so late that nobody notices, and early enough for the float's last bits.
    constexpr double kRepeat_s = 3600;
    const double between_s = (static_cast<double>(view.blend) - 1.0) * simulation.step_s();
    frame.time_s =
        static_cast<float>(std::fmod(std::max(simulation.time_s() + between_s, 0.0), kRepeat_s));
    frame.shading = simulation.switches.shading;
    frame.textures = simulation.switches.textures;
    // Dusk dims sun and sky; lamps shine on.
    const float daylight = simulation.switches.light_scale;
    frame.clear_color = scene.camera.clear_color * daylight;
    frame.ambient = scene.ambient.color * daylight;
    if (scene.sun) {
        frame.sun = render::DirectionalLight{
            .direction_world =
                normalize_or(simulation.switches.sun_direction, Vec3f{0.0F, -1.0F, 0.0F}),
            .radiance = scene.sun->color * scene.sun->intensity * daylight};
    }
    const float dark = dark_lamps(simulation);
    add_items(simulation, view.blend, dark, frame);
    add_lights(simulation, view.blend, dark, frame);
    return frame;
}

}  // namespace plumbline::scene
