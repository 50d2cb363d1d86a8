#include "engine/effects/callers.h"
#include "engine/effects/effect_table.h"
#include "engine/effects/sound/sound_bank.h"

#include <algorithm>

namespace plumbline::effects {

namespace {

constexpr float kFullGainSpeed_mps = 6.0F;  ///< a hard landing; running is about 0.75 of it
constexpr std::size_t kStepsKept = 8;

class Footsteps final : public Effect {
public:
    void after_step(scene::Simulation& simulation, const scene::Game& game) override {
        for (const scene::FootstepEvent& step : game.footsteps()) {
            const scene::Surface& surface = simulation.surfaces().get(step.surface);
            const assets::SoundId sound = bank_.pick(simulation, surface.step_sounds, random_);
            if (sound == assets::SoundId{} || cues_.size() >= kStepsKept) continue;
            const float speed_mps = static_cast<float>(step.speed_mps);
            cues_.push_back({.sound = sound,
                             .position_world = Vec3f(step.position_m),
                             .gain = std::clamp(speed_mps / kFullGainSpeed_mps, 0.1F, 1.0F),
                             .pitch = random_.uniform(0.95F, 1.05F)});
            ++work_.calls;
        }
    }

    void sound(const scene::Simulation&, const scene::ViewPoint&, SoundFrame& frame) override {
        frame.cues.insert(frame.cues.end(), cues_.begin(), cues_.end());
        cues_.clear();
    }

    void serialize(Archive& archive) override { archive(random_); }
    std::uint64_t bytes_held() const override { return bank_.bytes(); }

private:
    SoundBank bank_;
    Random random_{11};  ///< its own: what is heard must not change what happens
    std::vector<audio::SoundCue> cues_;
};

Callers callers_of_footsteps(const scene::Simulation& simulation) {
    const auto& player = simulation.description().player;
    const auto& surfaces = simulation.surfaces().surfaces;
    const bool any_sound = std::any_of(surfaces.begin(), surfaces.end(), [](const auto& surface) {
        return !surface.step_sounds.empty();
    });
    if (!player || !any_sound) return {};
    return {setting("[player]", player->location)};
}

}  // namespace

EffectRow footsteps() {
    return with_effect<Footsteps>({.called_for_by = &callers_of_footsteps});
}

}  // namespace plumbline::effects
