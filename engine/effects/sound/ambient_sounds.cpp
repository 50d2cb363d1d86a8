#include "engine/effects/callers.h"
#include "engine/effects/effect_table.h"
#include "engine/effects/sound/acoustics.h"
#include "engine/effects/sound/sound_bank.h"
#include "engine/scene/environment/wind_field.h"

#include <algorithm>
#include <cmath>
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
            simulation.registry.view<const scene::AmbientSound, const scene::Transform>();
        for (auto [entity, ambient, transform] : view) {
            const auto known = sounds_.find(ambient.file);
            if (known == sounds_.end() || known->second == assets::SoundId{}) continue;
            const Vec3f position(transform.world_from_body.position);
            const std::uint64_t key = scene::mark_of(entity);
            if (ambient.loop) {
                frame.loops.push_back(
                    {.key = key,
                     .sound = known->second,
                     .position_world = position,
                     .gain = ambient.gain * share_of_wind(simulation, ambient, transform) *
                             share_of_water(simulation, ambient, transform),
                     .radius_m = ambient.radius_m,
                     .velocity_mps = velocity_of(simulation, entity),
                     .made_by = {key, 0}});
            } else if (played_once_.insert(key).second) {
                frame.cues.push_back({.sound = known->second,
                                      .position_world = position,
                                      .gain = ambient.gain,
                                      .radius_m = ambient.radius_m,
                                      .made_by = {key, 0}});
            }
        }
        ++work_.calls;
    }

    void serialize(Archive& archive) override { archive(played_once_); }
    std::uint64_t bytes_held() const override { return bank_.bytes(); }

private:
    /// What rustles does so as the square of the wind, up to four times as loud as in the mean of it.
    static float share_of_wind(const scene::Simulation& simulation,
                               const scene::AmbientSound& ambient,
                               const scene::Transform& transform) {
        if (!ambient.by_wind) return 1.0F;
        const auto& wind = simulation.description().wind;
        if (!wind || wind->speed_mps <= 0) return 0.0F;
        const Vec3 air =
            scene::wind_at(*wind, transform.world_from_body.position, simulation.time_s());
        const Real share = glm::length(air) / wind->speed_mps;
        const Real loudness = std::min(share * share, Real{4});
        return static_cast<float>(loudness);
    }

    /// Water that lands sounds as the root of its power: 5 W are a garden's fountain.
    static float share_of_water(const scene::Simulation& simulation,
                                const scene::AmbientSound& ambient,
                                const scene::Transform& transform) {
        if (!ambient.by_flow) return 1.0F;
        constexpr float kUsual_W = 5.0F;
        constexpr float kLoudest = 2.0F;
        if (!simulation.switches.is_on("fountain", true)) return 0.0F;
        const scene::SceneDescription& scene = simulation.description();
        float power_W = 0.0F;
        for (const scene::FountainDescription& fountain : scene.fountains) {
            const Vec3& nozzle = fountain.position_m;
            const Vec3& here = transform.world_from_body.position;
            if (glm::distance(nozzle, here) > Real{ambient.radius_m}) continue;
            power_W += power_of(fountain, scene);
        }
        return std::min(std::sqrt(power_W / kUsual_W), kLoudest);
    }

    /// Into the highest pool below its nozzle, of any fountain's; 1 m down where there is none.
    static float power_of(const scene::FountainDescription& fountain,
                          const scene::SceneDescription& scene) {
        const Vec3& nozzle = fountain.position_m;
        const Real ring_m = fountain.ring ? fountain.ring->radius_m : Real{0};
        const Real gravity_mps2 = glm::length(scene.gravity_mps2);
        float fall_m = 1.0F;
        bool is_first = true;
        for (const scene::FountainDescription& other : scene.fountains) {
            for (const scene::PoolDescription& pool : other.pools) {
                const Real across_m =
                    std::hypot(pool.center_m.x - nozzle.x, pool.center_m.z - nozzle.z) + ring_m;
                const Real below_m = nozzle.y - pool.center_m.y;
                const auto drop_m = static_cast<float>(below_m);
                if (drop_m < 0.0F || across_m > pool.radius_m) continue;
                fall_m = is_first ? drop_m : std::min(fall_m, drop_m);
                is_first = false;
            }
        }
        return water_power_W(static_cast<float>(fountain.flow_lps),
                             static_cast<float>(fountain.speed_mps),
                             fall_m,
                             static_cast<float>(gravity_mps2));
    }

    static Vec3f velocity_of(const scene::Simulation& simulation, ecs::Entity entity) {
        const auto* body = simulation.registry.find<scene::BodyRef>(entity);
        if (body == nullptr || !simulation.physics.contains(body->body)) return Vec3f{0.0F};
        const physics::BodyState state = simulation.physics.state(body->body);
        return Vec3f(state.velocity_mps);
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

}  // namespace

EffectRow ambient_sounds() {
    return with_effect<AmbientSounds>({.called_for_by = &entities_with<scene::AmbientSound>});
}

}  // namespace plumbline::effects
