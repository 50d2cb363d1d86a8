// The room round the listener gives sounds back.
#include "engine/effects/callers.h"
#include "engine/effects/effect_table.h"
#include "engine/effects/sound/room_probe.h"

#include <algorithm>
#include <cmath>

namespace plumbline::effects {

namespace {

constexpr double kProbeEvery_s = 0.1;
constexpr std::size_t kRaysAProbe = 16;
constexpr std::size_t kRaysAtFirst = 128;
constexpr double kRoomSmoothing_s = 0.4;  ///< through a door no step is heard

class RoomReverb final : public Effect {
public:
    void sound(const scene::Simulation& simulation,
               const scene::ViewPoint& view,
               SoundFrame& frame) override {
        const Vec3& ear = view.world_from_camera.position;
        const double now_s = simulation.time_s();
        const double elapsed_s = std::clamp(now_s - latest_s_, 0.0, 1.0);
        latest_s_ = now_s;
        const bool is_first = probe_.bytes() == 0;
        if (is_first || std::abs(now_s - probed_s_) >= kProbeEvery_s) {
            probed_s_ = now_s;
            probe_.cast(simulation, ear, is_first ? kRaysAtFirst : kRaysAProbe);
            wanted_ = room_of(probe_.estimate(ear));
            if (is_first) now_ = wanted_;
            ++work_.calls;
        }
        const auto share = static_cast<float>(1.0 - std::exp(-elapsed_s / kRoomSmoothing_s));
        now_.gain += share * (wanted_.gain - now_.gain);
        if (wanted_.gain > 0.0F) {
            now_.decay_s *= std::pow(wanted_.decay_s / now_.decay_s, share);
            now_.size_m *= std::pow(wanted_.size_m / now_.size_m, share);
        } else if (now_.gain < 1e-3F) {
            now_.gain = 0.0F;
        }
        frame.room = now_;
    }

    std::uint64_t bytes_held() const override { return probe_.bytes(); }

private:
    RoomProbe probe_;
    audio::Room wanted_;
    audio::Room now_;
    double latest_s_{0};
    double probed_s_{0};
};

Callers callers_of_room_reverb(const scene::Simulation& simulation) {
    const auto& acoustics = simulation.description().acoustics;
    if (!acoustics || !simulation.switches.is_on("room_reverb", acoustics->reverb)) return {};
    return {setting("[sound] reverb", acoustics->location)};
}

}  // namespace

EffectRow room_reverb() {
    return with_effect<RoomReverb>({.called_for_by = &callers_of_room_reverb});
}

}  // namespace plumbline::effects
