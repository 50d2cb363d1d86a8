#include "engine/effects/callers.h"
#include "engine/effects/effect_table.h"
#include "engine/effects/sound_bank.h"
#include "engine/scene/wind_field.h"

#include <algorithm>
#include <set>

namespace plumbline::effects {

namespace {

/// Loops where entities have them; sounds that do not loop are played once.
class AmbientSounds final : public Effect {
public:
    explicit AmbientSounds(scene::Simulation& simulation) { load(simulation); }

    void after_step(scene::Simulation& simulation, const scene::Game&) override {
        if (simulation.revision() != revision_) load(simulation);
    }

    void sound(const scene::Simulation& simulation,
               const scene::ViewPoint&,
               SoundFrame& frame) override {
        const auto view =
            simulation.registry.view<const scene::AmbientSound, const scene::Placement>();
        for (auto [entity, ambient, placement] : view) {
            const auto known = sounds_.find(ambient.file);
            if (known == sounds_.end() || known->second == assets::SoundId{}) continue;
            const Vec3f position(placement.world_from_body.position);
            const std::uint64_t key = scene::mark_of(entity);
            if (ambient.loop) {
                frame.loops.push_back(
                    {.key = key,
                     .sound = known->second,
                     .position_world = position,
                     .gain = ambient.gain * share_of_wind(simulation, ambient, placement),
                     .radius_m = ambient.radius_m});
            } else if (played_once_.insert(key).second) {
                frame.cues.push_back({.sound = known->second,
                                      .position_world = position,
                                      .gain = ambient.gain,
                                      .radius_m = ambient.radius_m});
            }
        }
        ++work_.calls;
    }

    std::uint64_t bytes_cpu() const override { return sizeof(*this) + bank_.bytes(); }

private:
    /// What rustles does so as the square of the wind, up to four times as loud as in the mean of it.
    static float share_of_wind(const scene::Simulation& simulation,
                               const scene::AmbientSound& ambient,
                               const scene::Placement& placement) {
        if (!ambient.by_wind) return 1.0F;
        const auto& wind = simulation.description().wind;
        if (!wind || wind->speed_mps <= 0) return 0.0F;
        const Vec3 air =
            scene::wind_at(*wind, placement.world_from_body.position, simulation.time_s());
        const Real share = glm::length(air) / wind->speed_mps;
        const Real loudness = std::min(share * share, Real{4});
        return static_cast<float>(loudness);
    }

    void load(scene::Simulation& simulation) {
        revision_ = simulation.revision();
        for (auto [entity, ambient] : simulation.registry.view<const scene::AmbientSound>()) {
            if (!sounds_.contains(ambient.file)) {
                sounds_.emplace(ambient.file, bank_.get(simulation, ambient.file));
            }
        }
    }

    SoundBank bank_;
    std::map<std::filesystem::path, assets::SoundId> sounds_;
    std::set<std::uint64_t> played_once_;
    std::uint64_t revision_{0};
};

Callers callers_of_ambient_sounds(const scene::Simulation& simulation) {
    EntityCallers callers(simulation);
    for (auto [entity, ambient] : simulation.registry.view<const scene::AmbientSound>()) {
        callers.add(entity);
    }
    return callers.take();
}

std::unique_ptr<Effect> make_ambient_sounds(scene::Simulation& simulation) {
    return std::make_unique<AmbientSounds>(simulation);
}

}  // namespace

EffectRow ambient_sounds() {
    return {.name = "ambient_sounds",
            .domain = Domain::Sound,
            .called_for_by = &callers_of_ambient_sounds,
            .make = &make_ambient_sounds};
}

}  // namespace plumbline::effects
