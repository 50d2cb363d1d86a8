// What stands between a sound and the ear muffles it, and far events are heard late.
#include "engine/effects/callers.h"
#include "engine/effects/effect_table.h"
#include "engine/effects/sound/sound_obstacles.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace plumbline::effects {

namespace {

constexpr std::size_t kLoopsTraced = 12;  ///< the loudest; the others are heard as if in the open
constexpr std::size_t kCuesTraced = 6;    ///< of a frame
constexpr std::size_t kLoopsTracedAFrame = 3;
constexpr double kTracedAgain_s = 0.15;
constexpr double kPathSmoothing_s = 0.12;  ///< a wall's edge is no switch
constexpr double kForgotten_s = 5.0;

class SoundPaths final : public Effect {
public:
    void sound(const scene::Simulation& simulation,
               const scene::ViewPoint& view,
               SoundFrame& frame) override {
        const Vec3& ear = view.world_from_camera.position;
        for (audio::SoundCue& cue : frame.cues) {
            const float distance_m = glm::distance(Vec3f(ear), cue.position_world);
            cue.delay_s = distance_m / audio::kSpeedOfSound_mps;
        }
        for (const std::size_t i : loudest(frame.cues, ear, kCuesTraced))
            muffle(frame.cues[i], trace(simulation, frame.cues[i], ear));
        follow_loops(simulation, ear, frame.loops);
    }

    std::uint64_t bytes_held() const override { return traced_.size() * sizeof(*traced_.begin()); }

private:
    struct Traced {
        SoundPath wanted;
        SoundPath now;
        double traced_s{-1e9};
        double named_s{0};
        bool is_new{true};
    };

    template <class Cue>
    SoundPath trace(const scene::Simulation& simulation, const Cue& cue, const Vec3& ear) {
        ++work_.calls;
        return path_between(simulation, Vec3(cue.position_world), ear, cue.made_by);
    }

    template <class Cue>
    static void muffle(Cue& cue, const SoundPath& path) {
        cue.gain *= path.low;
        // The filter takes the square of it off the high frequencies.
        cue.low_pass *= std::sqrt(path.high / std::max(path.low, 1e-6F));
    }

    /// Indices, the loudest at the ear first.
    template <class Cue>
    static std::vector<std::size_t> loudest(const std::vector<Cue>& cues,
                                            const Vec3& ear,
                                            std::size_t most) {
        std::vector<std::pair<float, std::size_t>> heard;
        for (std::size_t i = 0; i < cues.size(); ++i) {
            const float distance_m = glm::distance(Vec3f(ear), cues[i].position_world);
            if (!(distance_m < cues[i].radius_m) || !(cues[i].gain > 0.0F)) continue;
            heard.emplace_back(cues[i].gain / std::max(distance_m, 1.0F), i);
        }
        most = std::min(most, heard.size());
        std::partial_sort(heard.begin(),
                          heard.begin() + static_cast<std::ptrdiff_t>(most),
                          heard.end(),
                          std::greater{});
        std::vector<std::size_t> indices;
        for (std::size_t i = 0; i < most; ++i) indices.push_back(heard[i].second);
        return indices;
    }

    void follow_loops(const scene::Simulation& simulation,
                      const Vec3& ear,
                      std::vector<audio::LoopCue>& loops) {
        const double now_s = simulation.time_s();
        const double elapsed_s = std::clamp(now_s - latest_s_, 0.0, 1.0);
        latest_s_ = now_s;
        std::size_t left = kLoopsTracedAFrame;
        for (const std::size_t i : loudest(loops, ear, kLoopsTraced)) {
            Traced& traced = traced_[loops[i].key];
            traced.named_s = now_s;
            if (left == 0 || std::abs(now_s - traced.traced_s) < kTracedAgain_s) continue;
            --left;
            traced.wanted = trace(simulation, loops[i], ear);
            traced.traced_s = now_s;
            if (std::exchange(traced.is_new, false)) traced.now = traced.wanted;
        }
        const auto share = static_cast<float>(1.0 - std::exp(-elapsed_s / kPathSmoothing_s));
        for (auto& [key, traced] : traced_) {
            traced.now.low += share * (traced.wanted.low - traced.now.low);
            traced.now.high += share * (traced.wanted.high - traced.now.high);
        }
        std::erase_if(traced_, [&](const auto& entry) {
            return std::abs(now_s - entry.second.named_s) > kForgotten_s;
        });
        for (audio::LoopCue& loop : loops) {
            const auto known = traced_.find(loop.key);
            if (known != traced_.end()) muffle(loop, known->second.now);
        }
    }

    std::map<std::uint64_t, Traced> traced_;
    double latest_s_{0};
};

Callers callers_of_sound_paths(const scene::Simulation& simulation) {
    const auto& acoustics = simulation.description().acoustics;
    if (!acoustics || !simulation.switches.is_on("sound_paths", acoustics->paths)) return {};
    return {setting("[sound] paths", acoustics->location)};
}

}  // namespace

EffectRow sound_paths() {
    return with_effect<SoundPaths>({.called_for_by = &callers_of_sound_paths});
}

}  // namespace plumbline::effects
