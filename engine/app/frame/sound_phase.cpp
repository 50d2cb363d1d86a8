#include "engine/app/frame/sound_phase.h"

namespace plumbline::app {

SoundPhase::SoundPhase(FrameState& state)
    : state_(state),
      menu_sounds_(state.play.session.folders().assets / "sounds", state.play.session.library) {
    if (!state.play.def.sound) return;
    mixer_ = std::make_unique<audio::Mixer>(
        audio::MixerDef{.device = state.play.def.audio_device, .voices = state.config().voices},
        state.play.session.library);
}

void SoundPhase::play(const scene::ViewPoint& view, const ui::Menu& menu, double now_s) {
    if (!mixer_) return;
    const AppConfig& config = state_.config();
    const Session& session = state_.play.session;
    const bool stands_still = state_.clock.stands_still();
    effects::SoundFrame sound = session.effects->sound(*session.simulation, view);
    const audio::Listener listener{.position_world = Vec3f(view.world_from_camera.position),
                                   .orientation = Quatf(view.world_from_camera.orientation),
                                   .velocity_mps = Vec3f(view.velocity_mps),
                                   .room = sound.room};
    if (!config.captions)
        captions_.clear();
    else if (!stands_still)
        captions_.add(sound, listener, now_s);
    for (audio::SoundCue& cue : sound.cues) cue.gain *= config.effects_gain;
    for (audio::LoopCue& loop : sound.loops) loop.gain *= config.ambience_gain;
    menu_sounds_.add(menu.use(), config.ui_gain, sound.cues);
    if (in_force_ != config) {
        in_force_ = config;
        mixer_->set_master_gain(config.mute ? 0.0F : config.master_gain);
        mixer_->set_mono(config.mono);
        mixer_->set_doppler(config.doppler);
    }
    mixer_->set_paused(stands_still);
    mixer_->play(sound.cues, sound.loops, listener, now_s);
    // The start page is not written over.
    if (menu.open() || mixer_->silent() == was_silent_) return;
    was_silent_ = !was_silent_;
    state_.messages.say(was_silent_ ? "no sound device: sound is off" : "sound is back");
}

}  // namespace plumbline::app
