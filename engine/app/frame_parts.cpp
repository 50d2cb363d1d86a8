#include "engine/app/frame_parts_impl.h"
#include "engine/app/screenshot.h"
#include "engine/core/files.h"
#include "engine/core/hash.h"
#include "engine/core/interrupt.h"
#include "engine/core/log.h"
#include "engine/core/stopwatch.h"
#include "engine/scene/extract.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <thread>

namespace plumbline::app {

Result<std::unique_ptr<FrameParts>> FrameParts::create(platform::Window& window,
                                                       Session& session,
                                                       LiveBindings& bindings,
                                                       const PlayDef& def) {
    Result<std::unique_ptr<render::Renderer>> renderer = render::Renderer::create(
        window.gl_loader(), render::PresentTarget::Window, def.shader_folder, session.library);
    if (!renderer) return renderer.error();
    Result<Stepper> stepper = Stepper::create(session, def.steps);
    if (!stepper) return stepper.error();
    std::unique_ptr<FrameParts> parts(
        new FrameParts(window, session, bindings, def, std::move(*stepper), std::move(*renderer)));
    parts->renderer->prepare(parts->extract(parts->view(Real{1}), Real{1}));
    parts->say_faults();
    return parts;
}

FrameParts::FrameParts(platform::Window& window,
                       Session& session,
                       LiveBindings& bindings,
                       const PlayDef& def,
                       Stepper stepper_made,
                       std::unique_ptr<render::Renderer> renderer_made)
    : clock(session.simulation->step_s(), def.config.max_steps_per_frame),
      latch(bindings.current()),
      stepper(std::move(stepper_made)),
      renderer(std::move(renderer_made)),
      window_(window),
      session_(session),
      bindings_(bindings),
      def_(def),
      accuracy_(session, !def.record.empty() || stepper.replaying()),
      overlay_(window, def.config.ui_scale),
      start_s_(window.now_s()) {
    stepper.after_step = [this] { accuracy_.after_step(); };
    latch.set_label_lookup(platform::printed_key_name);
    if (def.sound) {
        mixer_ =
            std::make_unique<audio::Mixer>(audio::MixerDef{.device = def.audio_device,
                                                           .master_gain = def.config.master_gain,
                                                           .voices = def.config.voices},
                                           session.library);
    }
    if (renderer->gl().renderer.find("llvmpipe") != std::string::npos) {
        overlay_.say("drawing on the CPU (no GPU driver): expect few frames a second", start_s_);
    }
}

bool FrameParts::ended(double now_s) const {
    return closing_ || interrupted() || stepper.ended() ||
           (def_.seconds && now_s - start_s_ >= *def_.seconds);
}

void FrameParts::say_faults() {
    for (const Diagnostic& fault : bindings_.faults().list()) {
        log_line(fault.severity == Severity::Error ? LogLevel::Error : LogLevel::Warning,
                 to_string(fault));
        overlay_.say(to_string(fault), window_.now_s());
    }
}

void FrameParts::take_input(const InputSnapshot& input) {
    overlay_.take_input(input);
    if (bindings_.reload_if_changed(input.now_s)) {
        latch.set_bindings(bindings_.current());
        overlay_.say("controls read again", input.now_s);
        say_faults();
    }
    const input::InputFocus focus{
        .menu_open = controls_.parts.menu,
        .ui_keyboard = overlay_.wants_keyboard(),
        .ui_mouse = !window_.pointer_captured() && overlay_.wants_mouse()};
    latch.update(input, focus);
    apply_frame_actions(latch, controls_, clock, window_, [&](std::string line) {
        overlay_.say(std::move(line), input.now_s);
    });
    if (input.close_requested) controls_.quit = true;
    if (input.lost_focus && def_.config.pause_on_focus_loss) clock.set_paused(true);
    capture_pointer_if_playing(input);
}

void FrameParts::capture_pointer_if_playing(const InputSnapshot& input) {
    // The pointer is the person's while a menu or the accuracy panel is open or another window has the keyboard; a click
    // into the picture gives it back to the game.
    if (controls_.parts.menu || controls_.parts.accuracy || !input.focused || input.lost_focus) {
        window_.capture_pointer(false);
        wants_pointer_ = !input.lost_focus || wants_pointer_;
        return;
    }
    if (!window_.pointer_captured() && wants_pointer_) window_.capture_pointer(true);
}

void FrameParts::do_requests() {
    accuracy_.watch(controls_.parts.accuracy);
    const double now_s = window_.now_s();
    const std::string scene = session_.description.file.stem().string();
    if (controls_.reset) {
        stepper.reset();
        accuracy_.after_rebuild(clock);
        overlay_.say("the scene from its start", now_s);
    }
    if (controls_.reload) {
        const Result<Done> reloaded = session_.reload();
        const Result<Done> shaders = renderer->reload_shaders();
        if (reloaded) {
            renderer->forget_scene();
            accuracy_.after_rebuild(clock);
        }
        overlay_.say(reloaded ? "scene read again" : reloaded.error().message, now_s);
        if (!shaders) overlay_.say(shaders.error().message, now_s);
    }
    if (controls_.screenshot) {
        const auto saved = save_screenshot(*renderer, def_.user_data_folder / "shots", scene);
        overlay_.say(saved ? "picture saved: " + saved->string() : saved.error().message, now_s);
    }
    if (controls_.save_recording && accuracy_.changed()) {
        overlay_.say("the accuracy was changed: this play cannot be recorded", now_s);
    } else if (controls_.save_recording) {
        const std::filesystem::path folder = def_.user_data_folder / "recordings";
        std::error_code ignored;  // the save says what is wrong
        std::filesystem::create_directories(folder, ignored);
        const std::filesystem::path file = unused_file(folder, scene, "tape");
        const Result<Done> saved = stepper.save_recording(file);
        overlay_.say(saved ? "actions so far saved: " + file.string() : saved.error().message,
                     now_s);
    }
    if (controls_.quit) closing_ = true;
    controls_.clear_requests();
}

void FrameParts::let_go_of_nothing() {
    if (!session_.game->holds()) latch.release(Action::Grab);
}

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

void FrameParts::finish_frame(double frame_start_s) {
    session_.effects->add_render_stats(renderer->stats(), renderer->gpu_bytes());
    report.add_frame((wall_s() - frame_start_s) * 1e3, renderer->stats());
    // Hidden windows do not block in present(); without vsync nothing does.
    const double least_s = window_.iconified() ? 0.1 : 1.0 / def_.config.max_fps;
    const double left_s = least_s - (wall_s() - frame_start_s);
    if (left_s > 0.0) std::this_thread::sleep_for(std::chrono::duration<double>(left_s));
}

std::array<std::uint64_t, kActionCount> FrameParts::actions_seen() const {
    std::array<std::uint64_t, kActionCount> seen = latch.presses_seen();
    // Replays and monkeys press no keys: what their steps were told counts.
    for (std::size_t i = 0; i < kActionCount; ++i)
        seen[i] = std::max(seen[i], stepper.presses()[i]);
    return seen;
}

ExitCode FrameParts::close() {
    window_.capture_pointer(false);
    ExitCode code = interrupted() ? ExitCode::Interrupted : ExitCode::Good;
    const auto failed = [&](const Result<Done>& written) {
        if (written) return;
        log_error("{}", written.error().message);
        code = ExitCode::RunFailed;
    };
    if (!def_.record.empty()) failed(stepper.save_recording(def_.record));
    if (!def_.report.empty()) {
        failed(write_file_atomically(def_.report,
                                     report.json(*session_.simulation,
                                                 session_.effects->ledger(),
                                                 renderer->gl(),
                                                 clock.lost_s(),
                                                 actions_seen())));
    }
    const std::string hash = hex_of(session_.simulation->state_hash());
    if (!stepper.divergence().empty()) code = ExitCode::Differs;
    if (def_.expect_hash && *def_.expect_hash != hash) {
        log_error("the state at the end is {}, expected {}", hash, *def_.expect_hash);
        code = ExitCode::Differs;
    }
    log_note("{} steps, state {}", stepper.steps(), hash);
    return code;
}

}  // namespace plumbline::app
