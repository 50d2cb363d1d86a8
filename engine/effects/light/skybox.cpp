// The sky behind everything: six images, or computed from where the sun stands.
#include "engine/effects/callers.h"
#include "engine/effects/effect_table.h"
#include "engine/scene/environment/sun_path.h"

namespace plumbline::effects {
namespace {

class Skybox final : public Effect {
public:
    void extract(const scene::Simulation& simulation,
                 const scene::ViewPoint&,
                 render::RenderFrame& frame) override {
        const scene::SceneDescription& scene = simulation.description();
        frame.sky =
            render::Sky{.folder = scene.sky->folder, .brightness = simulation.switches.light_scale};
        if (scene.sky->model) {
            render::SkyModel& model = frame.sky->model.emplace();
            model.to_sun_world = frame.sun ? -frame.sun->direction_world : Vec3f{0, -1, 0};
            if (scene.time) model.pole_world = scene::sky_pole(*scene.time);
            model.haze = scene.sky->model->haze;
            model.visibility_m = scene.sky->model->visibility_m;
            model.clouds = scene.sky->model->clouds;
        }
        ++work_.calls;
    }
    std::uint64_t bytes_cpu() const override { return sizeof(*this); }
};

Callers callers_of_skybox(const scene::Simulation& simulation) {
    const auto& sky = simulation.description().sky;
    if (!sky) return {};
    return {setting(sky->model ? "[sky] model" : "[sky] skybox", sky->location)};
}

std::unique_ptr<Effect> make_skybox(scene::Simulation&) {
    return std::make_unique<Skybox>();
}

}  // namespace

EffectRow skybox() {
    return {.name = "skybox",
            .domain = Domain::Frame,
            .called_for_by = &callers_of_skybox,
            .make = &make_skybox,
            .gpu_owner = "sky",
            .passes = "sky"};
}

}  // namespace plumbline::effects
