#include "engine/app/menu_sounds.h"

#include "engine/core/log.h"

#include <utility>

namespace plumbline::app {

assets::SoundId MenuSounds::sound(const char* name, assets::SoundId& known, bool& tried) {
    if (std::exchange(tried, true)) return known;
    const Result<assets::SoundId> loaded = library_.sound(folder_ / name);
    if (loaded)
        known = *loaded;
    else
        log_warning("{}", loaded.error().message);
    return known;
}

void MenuSounds::add(const ui::MenuUse& use, float gain, std::vector<audio::SoundCue>& cues) {
    const bool moved = use.moves != heard_.moves;
    const bool chose = use.choices != heard_.choices;
    heard_ = use;
    if ((!moved && !chose) || gain <= 0.0F) return;
    audio::SoundCue cue;
    cue.sound = chose ? sound("ui_choose.ogg", choose_, tried_choose_)
                      : sound("ui_move.ogg", move_, tried_move_);
    cue.gain = gain;
    cue.importance = 100.0F;
    cue.in_head = true;
    if (cue.sound != assets::SoundId{}) cues.push_back(cue);
}

}  // namespace plumbline::app
