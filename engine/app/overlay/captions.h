// Loud sounds in words, for who does not hear them: "< wood hits stone".
#pragma once

#include "engine/effects/effect.h"

#include <string>
#include <vector>

namespace plumbline::app {

/// Which events are worth words, and where they are as seen from the listener.
class Captions {
public:
    static constexpr float kLoud = 0.06F;      ///< gain at the listener from which words are made
    static constexpr float kLoudLoop = 0.15F;  ///< of what goes on
    static constexpr double kShown_s = 2.5;    ///< after it was last heard
    static constexpr double kLeastApart_s = 0.4;  ///< from one new line to the next
    static constexpr std::size_t kMostLines = 3;

    /// Of one frame, as they sound before anybody's volume settings.
    void add(const effects::SoundFrame& sound, const audio::Listener& listener, double now_s);
    /// Oldest first.
    std::vector<std::string> lines(double now_s) const;
    void clear() { heard_.clear(); }

private:
    struct Heard {
        std::string words;
        std::string line;  ///< with its arrow
        double from_s{0};  ///< sound takes its time
        double until_s{0};
    };
    void hear(const std::string& words,
              const Vec3f& position_world,
              double from_s,
              const audio::Listener& listener,
              double now_s);

    std::vector<Heard> heard_;
    double latest_s_{-1e9};
};

/// "< words" on the left, "words >" on the right, "words v" behind, "^ words" ahead, words alone where
/// it is at the ear.
std::string caption_line(const std::string& words,
                         const Vec3f& position_world,
                         const audio::Listener& listener);

}  // namespace plumbline::app
