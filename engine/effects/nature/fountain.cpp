// The drops of fountains, as the image shows them.
#include "engine/effects/callers.h"
#include "engine/effects/effect_table.h"
#include "engine/effects/nature/drops.h"
#include "engine/physics/query.h"
#include "engine/scene/environment/wind_field.h"

#include <algorithm>
#include <cmath>

namespace plumbline::effects {
namespace {

/// A fountain has been running for so long when it is first seen.
constexpr float kRunning_s = 2.0F;
/// An image sees drops drawn out over the time for which an eye holds them.
constexpr float kExposure_s = 1.0F / 40.0F;
/// From here on fewer drops are drawn, as many as would fill the same share of the image.
constexpr float kFewerFrom_m = 7.0F;
constexpr float kUnseenFrom_m = 110.0F;
constexpr float kRingSpeed_mps = 0.35F;

class Fountain final : public Effect {
public:
    explicit Fountain(const scene::Simulation& simulation)
        : drops_(simulation.description().fountains,
                 simulation.description().fountain_fidelity,
                 Vec3f(simulation.description().gravity_mps2)) {
        const auto step_s = static_cast<float>(simulation.step_s());
        for (float s = kRunning_s; s > 0.0F; s -= step_s)
            drops_.step(step_s, {}, wind_at(simulation, simulation.time_s()));
    }

    void after_step(scene::Simulation& simulation, const scene::Game&) override {
        const auto free_share = [&](const Vec3f& from, const Vec3f& to) -> std::optional<float> {
            const auto hit = cast_ray(simulation.physics, Vec3(from), Vec3(to));
            if (!hit) return {};
            return std::min(1.0F, static_cast<float>(hit->distance_m) / glm::distance(from, to));
        };
        step_s_ = static_cast<float>(simulation.step_s());
        drops_.step(step_s_, free_share, wind_at(simulation, simulation.time_s()));
        ++work_.calls;
    }

    void extract(const scene::Simulation&,
                 const scene::ViewPoint& view,
                 render::RenderFrame& frame) override {
        const float behind_s = (1.0F - static_cast<float>(view.blend)) * step_s_;
        const Vec3f eye = frame.camera.position_world;
        for (const Drop& drop : drops_.drops()) {
            const float distance_m = glm::distance(drop.position_world, eye);
            if (distance_m > kUnseenFrom_m) continue;
            const float share = std::min(1.0F, kFewerFrom_m / std::max(distance_m, 1e-3F));
            if (drop.rank > share) continue;
            const float life = drop.ends_at_s < kLife_s ? 1.0F - drop.age_s / drop.ends_at_s : 1.0F;
            frame.drops.push_back(
                {.position_world = drop.position_world - drop.velocity_mps * behind_s,
                 // What is left out is made up for.
                 .radius_m = drop.radius_m * std::sqrt(1.0F / share),
                 .trail_m = drop.velocity_mps * kExposure_s,
                 .opacity = drop.held_l > 0.0F ? 1.0F : std::max(life, 0.0F)});
        }
        for (const WaterRing& ring : drops_.rings()) {
            const float age_s = std::max(ring.age_s - behind_s, 0.0F);
            const float share = age_s / Drops::kRingLife_s;
            frame.water_rings.push_back(
                {.center_world = ring.center_world,
                 .radius_m = std::min(0.02F + kRingSpeed_mps * age_s, ring.reach_m),
                 .opacity = ring.strength * (1.0F - share) * (1.0F - share)});
        }
        ++work_.calls;
    }

    void serialize(Archive& archive) override { archive(drops_); }
    std::uint64_t bytes_held() const override { return drops_.bytes(); }

private:
    /// At the first nozzle: gusts are larger than fountains.
    static Vec3f wind_at(const scene::Simulation& simulation, double time_s) {
        const scene::SceneDescription& scene = simulation.description();
        if (!scene.wind || !simulation.switches.is_on("wind", true)) return Vec3f{0.0F};
        const Vec3 wind = scene::wind_at(*scene.wind, scene.fountains.front().position_m, time_s);
        return Vec3f(wind);
    }

    static constexpr float kLife_s = Drops::kLongestFlight_s;
    Drops drops_;
    float step_s_{1.0F / 60.0F};
};

Callers callers_of_fountain(const scene::Simulation& simulation) {
    const auto& fountains = simulation.description().fountains;
    if (fountains.empty() || !simulation.switches.is_on("fountain", true)) return {};
    Callers callers;
    for (const scene::FountainDescription& fountain : fountains)
        callers.push_back(setting("[[fountain]]", fountain.location));
    return callers;
}

}  // namespace

EffectRow fountain() {
    return with_effect<Fountain>(
        {.called_for_by = &callers_of_fountain, .gpu_owner = "drops", .passes = "drops"});
}

}  // namespace plumbline::effects
