// What a frame shows and sounds like: the world read, the overlay over it, the cues of its steps.
#include "engine/app/frame_parts_impl.h"
#include "engine/scene/extract.h"

namespace plumbline::app {

scene::ViewPoint FrameParts::view(Real blend) const {
    return session_.game->view(
        *session_.simulation, blend, latch.pending_yaw_rad(), latch.pending_pitch_rad());
}

render::RenderFrame FrameParts::extract(const scene::ViewPoint& view, Real blend) {
    const platform::PixelSize size = window_.framebuffer_size();
    render::RenderFrame frame = scene::extract(*session_.simulation,
                                               view,
                                               blend,
                                               static_cast<std::uint32_t>(size.width),
                                               static_cast<std::uint32_t>(size.height));
    frame.fill_mode = controls_.fill_mode;
    session_.effects->refresh(*session_.simulation);
    session_.effects->extract(*session_.simulation, view, frame);
    accuracy_.take_answers();
    accuracy_.add_ghost_lines(frame.lines);
    if (controls_.collision_shapes) session_.simulation->physics.add_debug_lines(frame.lines);
    return frame;
}

void FrameParts::draw_overlay(const render::RenderFrame& frame) {
    if (frame.width_px == 0 || frame.height_px == 0) return;
    const scene::HudContent hud = session_.game->hud(*session_.simulation);
    const double now_s = window_.now_s();
    for (const std::string& message : hud.messages) overlay_.say(message, now_s);
    if (controls_.parts.stats) ledger_ = session_.effects->ledger();
    const OverlayAnswer answer = overlay_.draw({.parts = controls_.parts,
                                                .hud = hud,
                                                .simulation = *session_.simulation,
                                                .report = report,
                                                .clock = clock,
                                                .bindings = latch.bindings(),
                                                .device = latch.last_device(),
                                                .ledger = ledger_,
                                                .accuracy = accuracy_,
                                                .judge = session_.judge.get(),
                                                .sound_silent = mixer_ && mixer_->silent(),
                                                .show_hints = def_.config.hints,
                                                .lines_not_shown = frame.lines.not_shown,
                                                .now_s = now_s});
    apply_menu_choice(answer.menu, controls_);
    const std::string said = accuracy_.apply(answer.accuracy, clock);
    if (!said.empty()) overlay_.say(said, now_s);
}

void FrameParts::play_sound(const scene::ViewPoint& view, double now_s) {
    if (!mixer_) return;
    const effects::SoundFrame sound = session_.effects->sound(*session_.simulation, view);
    mixer_->set_paused(clock.paused());
    mixer_->play(sound.cues,
                 sound.loops,
                 {.position_world = Vec3f(view.world_from_camera.position),
                  .orientation = Quatf(view.world_from_camera.orientation),
                  .velocity_mps = Vec3f(view.velocity_mps)},
                 now_s);
}

}  // namespace plumbline::app
