// Explosions, what breaks, and ropes that part.
#include "engine/effects/callers.h"
#include "engine/effects/effect_table.h"
#include "engine/effects/sound/sound_bank.h"
#include "engine/scene/simulation/entity_lookup.h"

#include <algorithm>
#include <cmath>

namespace plumbline::effects {
namespace {

using scene::Burst;

constexpr double kFullExplosion_Ns = 400;
constexpr double kFullBreak_kg = 10;
constexpr std::size_t kMostAtOnce = 16;

class BurstSounds final : public Effect {
public:
    void after_step(scene::Simulation& simulation, const scene::Game&) override {
        for (const Burst& burst : simulation.bursts) add(simulation, burst);
        for (const physics::JointId id : simulation.physics.report().broken_joints) {
            const physics::JointDef& def = simulation.physics.joint(id).def;
            if (def.kind != physics::JointKind::Elastic) continue;
            const Vec3 there = simulation.physics.state(def.a).world_from_body.position;
            add(simulation, {.kind = Burst::Kind::Snap, .point_world = there});
        }
    }

    void sound(const scene::Simulation&, const scene::ViewPoint&, SoundFrame& frame) override {
        frame.cues.insert(frame.cues.end(), cues_.begin(), cues_.end());
        cues_.clear();
    }

    void serialize(Archive& archive) override { archive(random_); }
    std::uint64_t bytes_held() const override {
        return bank_.bytes() + cues_.capacity() * sizeof(audio::SoundCue);
    }

private:
    void add(scene::Simulation& simulation, const Burst& burst) {
        if (cues_.size() >= kMostAtOnce) return;
        audio::SoundCue cue{.position_world = Vec3f(burst.point_world)};
        switch (burst.kind) {
            case Burst::Kind::Explosion:
                cue.sound = pick(simulation, simulation.surfaces().find("explosion"));
                cue.gain = loudness(burst.strength / kFullExplosion_Ns, 0.35);
                cue.radius_m = 60 + 240 * cue.gain;
                cue.caption = "explosion";
                break;
            case Burst::Kind::Break:
                cue.sound = pick(simulation, burst.surface);
                cue.gain = loudness(burst.strength / kFullBreak_kg, 0.4);
                cue.radius_m = 20 + 40 * cue.gain;
                cue.caption = simulation.surfaces().get(burst.surface).name + " breaks";
                break;
            case Burst::Kind::Snap:
                cue.sound = pick(simulation, simulation.surfaces().find("rope_end"));
                cue.gain = 0.6F;
                cue.caption = "rope parts";
                break;
            case Burst::Kind::Trigger:
                cue.sound = bank_.get(simulation, burst.sound);
                cue.radius_m = 60;
                break;
        }
        if (cue.sound == assets::SoundId{}) return;
        if (burst.kind != Burst::Kind::Trigger) cue.pitch = random_.uniform(0.9F, 1.1F);
        cue.importance = 2;
        cues_.push_back(cue);
        ++work_.calls;
    }

    /// Index 0: the table of surfaces knows no such sound.
    assets::SoundId pick(scene::Simulation& simulation, std::uint16_t surface) {
        if (surface == 0) return {};
        return bank_.pick(simulation, simulation.surfaces().get(surface).impact_sounds, random_);
    }

    static float loudness(double share, double least) {
        return static_cast<float>(std::clamp(std::sqrt(std::max(share, 0.0)), least, 1.0));
    }

    SoundBank bank_;
    Random random_{11};  ///< its own: what is heard must not change what happens
    std::vector<audio::SoundCue> cues_;
};

/// Who plays may set charges off and cut ropes anywhere.
Callers callers_of_burst_sounds(const scene::Simulation& simulation) {
    Callers callers;
    const scene::SceneDescription& scene = simulation.description();
    for (const scene::ExplosionDescription& charge : scene.forces.explosions)
        callers.push_back(setting("[[explosion]]", charge.location));
    if (scene.player) callers.push_back(setting("[player]", scene.player->location));
    for (auto [entity, volume] : simulation.registry.view<const scene::TriggerVolume>()) {
        if (!volume.says.sound.empty()) callers.push_back(describe(simulation, entity));
    }
    for (std::string& caller : entities_with<scene::Fragile>(simulation))
        callers.push_back(std::move(caller));
    return callers;
}

}  // namespace

EffectRow burst_sounds() {
    return with_effect<BurstSounds>({.called_for_by = &callers_of_burst_sounds});
}

}  // namespace plumbline::effects
