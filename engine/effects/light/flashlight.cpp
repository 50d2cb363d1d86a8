// The light in the hand, with its shadow.
#include "engine/effects/effect_table.h"

namespace plumbline::effects {
namespace {

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
    std::uint64_t bytes_cpu() const override { return sizeof(*this); }
};

Callers callers_of_flashlight(const scene::Simulation& simulation) {
    const auto& light = simulation.description().flashlight;
    if (!light || !simulation.switches.is_on("flashlight", light->on)) return {};
    return {"switch flashlight"};
}

std::unique_ptr<Effect> make_flashlight(scene::Simulation&) {
    return std::make_unique<Flashlight>();
}

}  // namespace

EffectRow flashlight() {
    return {.name = "flashlight",
            .domain = Domain::Frame,
            .called_for_by = &callers_of_flashlight,
            .make = &make_flashlight,
            .gpu_owner = "flashlight",
            .passes = "shadow.flashlight"};
}

}  // namespace plumbline::effects
