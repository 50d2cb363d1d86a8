// The shadows of the sun.
#include "engine/effects/callers.h"
#include "engine/effects/effect_table.h"

namespace plumbline::effects {
namespace {

class SunShadow final : public Effect {
public:
    void extract(const scene::Simulation& simulation,
                 const scene::ViewPoint&,
                 render::RenderFrame& frame) override {
        const scene::ShadowDescription& shadow = *simulation.description().sun->shadow;
        frame.sun_shadow =
            render::SunShadow{.size_px = static_cast<std::uint32_t>(shadow.size_px),
                              .distance_m = static_cast<float>(shadow.distance_m),
                              .cascades = static_cast<std::uint32_t>(shadow.cascades),
                              .angular_size_rad = radians_from_degrees(shadow.angular_size_deg)};
        ++work_.calls;
    }
    std::uint64_t bytes_cpu() const override { return sizeof(*this); }
};

Callers callers_of_sun_shadow(const scene::Simulation& simulation) {
    const auto& sun = simulation.description().sun;
    if (!sun || !sun->shadow) return {};
    // In a scene that is only looked at they are there when asked for.
    if (!simulation.switches.is_on("sun_shadow", !simulation.description().viewer)) return {};
    return {setting("[sun] shadow", sun->shadow->location)};
}

std::unique_ptr<Effect> make_sun_shadow(scene::Simulation&) {
    return std::make_unique<SunShadow>();
}

}  // namespace

EffectRow sun_shadow() {
    return {.name = "sun_shadow",
            .domain = Domain::Frame,
            .called_for_by = &callers_of_sun_shadow,
            .make = &make_sun_shadow,
            .gpu_owner = "sun_shadow",
            .passes = "shadow.sun"};
}

}  // namespace plumbline::effects
