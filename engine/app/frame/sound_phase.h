// What a frame sounds like: cues of its steps, loops of its effects, the menu's own sounds; in words as
// well, where captions are on.
#pragma once

#include "engine/app/frame/frame_state.h"
#include "engine/app/menu_sounds.h"
#include "engine/app/overlay/captions.h"
#include "engine/audio/mixer.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace plumbline::app {

class SoundPhase {
public:
    /// The state must outlive it.
    explicit SoundPhase(FrameState& state);

    /// Once a frame, heard from where it is seen.
    void play(const scene::ViewPoint& view, const ui::Menu& menu, double now_s);
    std::vector<std::string> captions(double now_s) const { return captions_.lines(now_s); }

private:
    FrameState& state_;
    MenuSounds menu_sounds_;
    Captions captions_;
    std::unique_ptr<audio::Mixer> mixer_;  ///< null with --no-sound
    std::optional<AppConfig> in_force_;    ///< as the mixer has it
    bool was_silent_{false};               ///< for want of a device
};

}  // namespace plumbline::app
