#include "engine/effects/callers.h"
#include "engine/effects/effect_table.h"
#include "engine/effects/sound/sound_bank.h"
#include "engine/scene/simulation/entity_lookup.h"

#include <algorithm>
#include <map>
#include <utility>

namespace plumbline::effects {

namespace {

constexpr float kFullGainImpulse_Ns = 30.0F;  ///< a 5 kg crate that lands at 6 m/s
constexpr float kLeastGain = 0.02F;           ///< quieter than this nobody hears beside the rest
constexpr Real kLeastClosingSpeed_mps = 0.2_r;
/// A pair that stays in touch sounds again only when it is hit this hard.
constexpr Real kAgainClosingSpeed_mps = Real{1};
constexpr double kLeastPairInterval_s = 0.1;
constexpr std::size_t kImpactsKept = 64;
constexpr std::size_t kPairsKept = 2'048;

using Pair = std::pair<std::uint64_t, std::uint64_t>;

/// Hits between the same materials within the same cubic metre are one sound.
std::uint64_t merge_key_of(std::uint16_t surface, const Vec3& point) {
    const auto cell = [](Real value) {
        return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(value))) & 0xFFFFU;
    };
    return ((std::uint64_t{surface} + 1U) << 48U) | (cell(point.x) << 32U) |
           (cell(point.y) << 16U) | cell(point.z);
}

class ImpactSounds final : public Effect {
public:
    explicit ImpactSounds(scene::Simulation& simulation)
        : listener_(simulation, "effect impact_sounds") {}

    void after_step(scene::Simulation& simulation, const scene::Game&) override {
        for (const physics::ContactEvent& contact : simulation.physics.report().contacts) {
            if (!is_audible(contact) || sounded_lately(contact, simulation.time_s())) continue;
            add_cue(simulation, contact);
        }
        if (sounded_at_s_.size() > kPairsKept) {
            std::erase_if(sounded_at_s_, [&](const auto& pair) {
                return simulation.time_s() - pair.second > kLeastPairInterval_s;
            });
        }
    }

    void sound(const scene::Simulation&, const scene::ViewPoint&, SoundFrame& frame) override {
        frame.cues.insert(frame.cues.end(), cues_.begin(), cues_.end());
        cues_.clear();
    }

    void serialize(Archive& archive) override { archive(random_, sounded_at_s_); }
    std::uint64_t bytes_held() const override {
        return bank_.bytes() + cues_.capacity() * sizeof(audio::SoundCue) +
               sounded_at_s_.size() * sizeof(std::pair<Pair, double>);
    }

private:
    static bool is_audible(const physics::ContactEvent& contact) {
        return contact.closing_speed_mps >
               (contact.began ? kLeastClosingSpeed_mps : kAgainClosingSpeed_mps);
    }

    bool sounded_lately(const physics::ContactEvent& contact, double now_s) {
        const Pair pair = std::minmax(contact.user_a, contact.user_b);
        const auto [known, is_new] = sounded_at_s_.try_emplace(pair, now_s);
        if (is_new) return false;
        if (now_s - known->second < kLeastPairInterval_s) return true;
        known->second = now_s;
        return false;
    }

    void add_cue(scene::Simulation& simulation, const physics::ContactEvent& contact) {
        std::uint16_t louder = surface_of_mark(simulation, contact.user_a);
        std::uint16_t softer = surface_of_mark(simulation, contact.user_b);
        const scene::SurfaceTable& table = simulation.surfaces();
        const auto loudness = [&](std::uint16_t index) {
            return simulation.surfaces().is_heard(index) ? table.get(index).loudness : 0.0F;
        };
        if (loudness(softer) > loudness(louder)) std::swap(louder, softer);
        if (loudness(louder) <= 0.0F) return;

        // What is heard is the livelier of the two, dulled by the other: a crate on grass thuds.
        const float dulled = std::sqrt(loudness(louder) * table.get(softer).loudness);
        const float strength = static_cast<float>(contact.impulse_Ns) / kFullGainImpulse_Ns;
        const float gain = std::clamp(dulled * std::pow(strength, 0.6F), 0.0F, 1.0F);
        if (!(gain >= kLeastGain)) return;
        const assets::SoundId sound =
            bank_.pick(simulation, table.get(louder).impact_sounds, random_);
        if (sound == assets::SoundId{}) return;
        // Slow hits excite little of what is bright in a sound.
        const float speed_mps = static_cast<float>(contact.closing_speed_mps);
        keep({.sound = sound,
              .position_world = Vec3f(contact.point_world),
              .gain = gain,
              .pitch = random_.uniform(0.92F, 1.08F),
              .radius_m = 15.0F + 35.0F * gain,
              .low_pass = std::clamp(0.25F + speed_mps * 0.25F, 0.25F, 1.0F),
              .merge_key = merge_key_of(louder, contact.point_world),
              .made_by = {maker_of(simulation, contact.a, contact.user_a),
                          maker_of(simulation, contact.b, contact.user_b)},
              .caption = caption_of(table.get(louder), table.get(softer))});
        ++work_.calls;
    }

    /// What stands still, a wall or the ground, is in the way of what strikes its other side.
    static std::uint64_t maker_of(const scene::Simulation& simulation,
                                  physics::BodyId body,
                                  std::uint64_t user) {
        const physics::PhysicsWorld& world = simulation.physics;
        const bool moves =
            world.contains(body) && world.state(body).kind != physics::BodyKind::Static;
        return moves ? user : 0;
    }

    static std::string caption_of(const scene::Surface& louder, const scene::Surface& softer) {
        if (!louder.caption.empty()) return louder.caption;
        return louder.name + " hits " + softer.name;
    }

    /// When nobody listens for a while, or a heap comes down, the loudest are worth keeping.
    void keep(const audio::SoundCue& cue) {
        if (cues_.size() < kImpactsKept) {
            cues_.push_back(cue);
            return;
        }
        const auto quietest =
            std::min_element(cues_.begin(), cues_.end(), [](const auto& a, const auto& b) {
                return a.gain < b.gain;
            });
        if (quietest->gain < cue.gain) *quietest = cue;
    }

    ContactListener listener_;
    SoundBank bank_;
    Random random_{7};  ///< its own: what is heard must not change what happens
    std::vector<audio::SoundCue> cues_;
    std::map<Pair, double> sounded_at_s_;
};

Callers callers_of_impact_sounds(const scene::Simulation& simulation) {
    return dynamic_bodies_of(simulation, [](const scene::SurfaceTable& surfaces, std::uint16_t i) {
        return surfaces.is_heard(i);
    });
}

}  // namespace

EffectRow impact_sounds() {
    return with_effect<ImpactSounds>({.called_for_by = &callers_of_impact_sounds});
}

}  // namespace plumbline::effects
