// Small cubes that show where the sun and the flashlight shine from. They are seen, and nothing else:
// they cast no shadow.
#include "engine/assets/primitives.h"
#include "engine/effects/callers.h"
#include "engine/effects/effect_table.h"
#include "engine/scene/extract.h"

namespace plumbline::effects {
namespace {

/// Along the beam, away from the eye: there it is seen at the image's rim.
constexpr float kBeforeHand_m = 0.8F;

bool shows_flashlight(const scene::Simulation& simulation) {
    const auto& light = simulation.description().flashlight;
    return light && light->cube_m > 0.0F && simulation.switches.is_on("flashlight", light->on);
}

class LightCubes final : public Effect {
public:
    explicit LightCubes(scene::Simulation& simulation)
        : mesh_(simulation.library().add_mesh("light cube", assets::box_mesh(Vec3f{1.0F}))),
          material_(simulation.library().add_material(
              {.name = "light cube", .shading = assets::Shading::Unlit})) {}

    void extract(const scene::Simulation& simulation,
                 const scene::ViewPoint& view,
                 render::RenderFrame& frame) override {
        const scene::SceneDescription& scene = simulation.description();
        if (frame.sun && scene.sun->cube_m > 0.0F) {
            const Vec3f center = -frame.sun->direction_world * scene.sun->cube_distance_m;
            add({.position = Vec3(center)}, scene.sun->cube_m, frame.sun->radiance, frame);
        }
        if (shows_flashlight(simulation)) {
            Pose pose = view.world_from_hand;
            pose.position += pose.orientation * Vec3{0, 0, -Real{kBeforeHand_m}};
            add(pose, scene.flashlight->cube_m, scene.flashlight->color, frame);
        }
        ++work_.calls;
    }

private:
    void add(const Pose& pose, float edge_m, const Vec3f& color, render::RenderFrame& frame) const {
        render::add_item(frame,
                         {.mesh = mesh_,
                          .world_from_body = matrix_of(pose, Vec3{Real{edge_m}}),
                          .tint = color,
                          .casts_shadow = false},
                         {&material_, 1});
    }

    assets::MeshId mesh_;
    assets::MaterialId material_;
};

Callers callers_of_light_cubes(const scene::Simulation& simulation) {
    Callers callers;
    const auto& sun = simulation.description().sun;
    if (sun && sun->cube_m > 0.0F) callers.push_back(setting("[sun] cube_m", sun->location));
    if (shows_flashlight(simulation)) {
        callers.push_back(
            setting("[flashlight] cube_m", simulation.description().flashlight->location));
    }
    return callers;
}

std::uint64_t key_of_light_cubes(const scene::Simulation& simulation) {
    return shows_flashlight(simulation) ? 1 : 0;
}

}  // namespace

EffectRow light_cubes() {
    return with_effect<LightCubes>(
        {.called_for_by = &callers_of_light_cubes, .key = &key_of_light_cubes});
}

}  // namespace plumbline::effects
