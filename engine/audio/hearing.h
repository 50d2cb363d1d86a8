// What can be heard of a cue, and which cues of a frame are worth a voice. Plain arithmetic: no
// device.
#pragma once

#include "engine/audio/sound_cue.h"

#include <cstddef>
#include <map>
#include <span>
#include <vector>

namespace plumbline::audio {

/// How much of a sound is left at a distance: 1 up to 1 m, then as 1/distance, bent to reach 0 at
/// `radius_m` and stay there. Distances and radii of small things scale along.
float attenuation(float distance_m, float radius_m);

/// Beyond 60 m/s the Doppler shift is only a nuisance; 0 for what is no number.
Vec3f with_bounded_speed(const Vec3f& velocity_mps);

/// Where a source stands and how it moves for who hears all from ahead: as fast towards the ear.
struct MonoPlace {
    Vec3f position_world{0.0F};
    Vec3f velocity_mps{0.0F};
};
MonoPlace place_in_mono(const Vec3f& position_world,
                        const Vec3f& velocity_mps,
                        const Listener& listener);

/// True for a cue that may go to a device: finite everywhere, some gain, some radius, a sound.
bool is_playable(const SoundCue& cue);
bool is_playable(const LoopCue& cue);

/// A cue that won, brought into range.
struct ChosenCue {
    SoundCue cue;
    float loudness{0.0F};  ///< gain at the listener
    float worth() const { return loudness * cue.importance; }
};

/// Picks the cues that are worth most, by loudness and importance, and remembers merge keys for 50 ms.
class CueChoice {
public:
    static constexpr double kMerge_s = 0.05;
    static constexpr float kInaudible = 1e-3F;

    /// At most `limit` cues, loudest first; a cue whose merge key was chosen less than 50 ms ago is
    /// left out unless it is louder.
    std::vector<ChosenCue> choose(std::span<const SoundCue> cues,
                                  const Vec3f& listener_world,
                                  double now_s,
                                  std::size_t limit);

private:
    struct Remembered {
        double time_s{0.0};
        float loudness{0.0F};
    };
    std::map<std::uint64_t, Remembered> recent_;
};

}  // namespace plumbline::audio
