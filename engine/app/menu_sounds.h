// The menu's own sounds: a tick as the mark moves, two notes as something is chosen.
#pragma once

#include "engine/app/ui/menu.h"
#include "engine/audio/sound_cue.h"

#include <filesystem>
#include <vector>

namespace plumbline::app {

class MenuSounds {
public:
    /// `folder` has ui_move.ogg and ui_choose.ogg; the library must outlive it. A file that cannot be
    /// read is silent, and said in the log once.
    MenuSounds(std::filesystem::path folder, assets::AssetLibrary& library)
        : folder_(std::move(folder)), library_(library) {}

    /// Of what was done since the last call.
    void add(const ui::MenuUse& use, float gain, std::vector<audio::SoundCue>& cues);

private:
    assets::SoundId sound(const char* name, assets::SoundId& known, bool& tried);

    std::filesystem::path folder_;
    assets::AssetLibrary& library_;
    ui::MenuUse heard_{};
    assets::SoundId move_{};
    assets::SoundId choose_{};
    bool tried_move_{false};
    bool tried_choose_{false};
};

}  // namespace plumbline::app
