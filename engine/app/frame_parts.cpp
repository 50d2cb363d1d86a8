#include "engine/app/controls/key_labels.h"
#include "engine/app/frame_parts_impl.h"
#include "engine/app/overlay/loading_screen.h"
#include "engine/core/hash.h"
#include "engine/core/log.h"
#include "engine/core/process/interrupt.h"
#include "engine/core/time/stopwatch.h"
#include "engine/scene/environment/sun_hour.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <future>
#include <thread>
#include <utility>

namespace plumbline::app {

namespace {

std::vector<std::filesystem::path> files_below(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    std::error_code failed;
    for (std::filesystem::recursive_directory_iterator entry(folder, failed), end;
         !failed && entry != end;
         entry.increment(failed))
        if (entry->is_regular_file(failed)) files.push_back(entry->path());
    return files;
}

/// For the screen: the first few.
std::string lines_of(const Diagnostics& faults) {
    constexpr std::size_t kShown = 3;
    std::string lines;
    for (std::size_t i = 0; i < std::min(kShown, faults.list().size()); ++i)
        lines += (i > 0 ? "\n" : "") + to_string(faults.list()[i]);
    if (faults.list().size() > kShown)
        lines += fmt::format("\n… and {} more; run `plumbline check` to list all",
                             faults.list().size() - kShown);
    return lines;
}

}  // namespace

Result<std::unique_ptr<FrameParts>> FrameParts::create(platform::Window& window,
                                                       Session& session,
                                                       LiveBindings& bindings,
                                                       LiveConfig& config,
                                                       const PlayDef& def) {
    // Reads a hundred files; meanwhile the first frame is made ready.
    auto scenes = std::async(std::launch::async | std::launch::deferred,
                             [folders = scene::scene_folders(session.folders().assets)] {
                                 return scene::list_scenes(folders);
                             });
    Result<std::unique_ptr<render::Renderer>> renderer = render::Renderer::create(
        window.gl_loader(), render::PresentTarget::Window, def.shader_folder, session.library);
    if (!renderer) return renderer.error();
    StepperDef steps = def.steps;
    steps.record = def.record;
    Result<Stepper> stepper = Stepper::create(session, steps);
    if (!stepper) return stepper.error();
    std::unique_ptr<FrameParts> parts(new FrameParts(
        window, session, bindings, config, def, std::move(*stepper), std::move(*renderer)));
    LoadingScreen screen(window);
    screen.show(0.0F);
    parts->renderer->prepare(parts->extract(parts->view(Real{1})),
                             [&](float share) { screen.show(share); });
    if (const std::string& fault = parts->renderer->shader_fault(); !fault.empty())
        return Error{.message = fault, .exit_code = ExitCode::NoDisplay};
    parts->scenes_ = scenes.get();
    if (def.start_page) parts->menu_.show_start();
    parts->pause_under_menu();
    parts->say_faults();
    return parts;
}

FrameParts::FrameParts(platform::Window& window,
                       Session& session,
                       LiveBindings& bindings,
                       LiveConfig& config,
                       const PlayDef& def,
                       Stepper stepper_made,
                       std::unique_ptr<render::Renderer> renderer_made)
    : clock(session.simulation->step_s()),
      latch(bindings.current()),
      report(def.chosen_s),
      stepper(std::move(stepper_made)),
      renderer(std::move(renderer_made)),
      window_(window),
      session_(session),
      bindings_(bindings),
      config_(config),
      def_(def),
      accuracy_(session, !def.record.empty() || stepper.replaying()),
      scene_watch_(session.files()),
      shader_watch_(files_below(def.shader_folder)),
      overlay_(window, def.thumbnails),
      camera_path_({.folder = def.user_data_folder.empty() ? std::filesystem::path()
                                                           : def.user_data_folder / "camera_paths",
                    .scene = scene_name(),
                    .file = def.camera_path},
                   [this](std::string line) {
                       log_note("{}", line);
                       say(std::move(line));
                   }),
      menu_sounds_(session.folders().assets / "sounds", session.library),
      menu_(menu_world()),
      first_minute_(def.user_data_folder.empty() ? std::filesystem::path()
                                                 : def.user_data_folder / "first_minute"),
      quality_request_(quality_request_of(config.current())),
      quality_control_(quality_request_, renderer->draws_in_software()),
      start_s_(window.now_s()) {
    stepper.after_step = [this] { accuracy_.after_step(); };
    latch.set_label_lookup(platform::printed_key_name);
    if (def.sound) {
        mixer_ = std::make_unique<audio::Mixer>(
            audio::MixerDef{.device = def.audio_device, .voices = config.current().voices},
            session.library);
    }
    apply_config();
    if (!def.first_message.empty()) say(def.first_message);
}

void FrameParts::say_not_stored(const Result<Done>& stored) {
    if (stored || std::exchange(said_not_stored_, true)) return;
    say(stored.error().message);
}

void FrameParts::change_config(const AppConfig& wanted) {
    say_not_stored(config_.change(wanted));
    apply_config();
}

void FrameParts::change_bindings(const input::Bindings& wanted) {
    say_not_stored(bindings_.change(wanted));
    latch.set_bindings(bindings_.current());
    bindings_fault_ = lines_of(bindings_.faults());
}

ui::MenuWorld FrameParts::menu_world() {
    const std::string& title = session_.description().title;
    return {
        .config = config_,
        .bindings = bindings_,
        .scenes = scenes_,
        .scene_title = title.empty() ? scene_name() : title,
        .accuracy = [this] { return accuracy_.setting(); },
        .accuracy_is_recorded = accuracy_.recorded(),
        .change_config = [this](const AppConfig& wanted) { change_config(wanted); },
        .change_bindings = [this](const input::Bindings& wanted) { change_bindings(wanted); },
        .change_accuracy =
            [this](const study::Setting& wanted) { do_accuracy({.setting = wanted}); },
        .adopt_accuracy = [this] { do_accuracy({.adopt = true}); },
        .looks_at_model = [this] { return looks_at_model(); },
        .open_scene = [this](const std::filesystem::path& file) { controls_.open_scene = file; },
        .switches = [this]() -> scene::LiveSwitches& { return session_.simulation->switches; },
        .scene_fog =
            [this] {
                const scene::FogDescription plain{.on = false};
                return session_.simulation->description().fog.value_or(plain);
            },
        .hour = [this] { return hour_of(*session_.simulation); },
        .set_hour = [this](double hour) { set_hour(*session_.simulation, hour); },
        .start_again = [this] { controls_.reset = true; },
        .save_slots = [this] { return save_slots(); },
        .save_game = [this](int slot) { controls_.save_slot = slot; },
        .load_game = [this](int slot) { controls_.load_slot = slot; },
        .quit = [this] { controls_.quit = true; },
        .forget_first_minute =
            [this] {
                first_minute_.forget();
                say("hints reset");
            }};
}

void FrameParts::apply_config() {
    const AppConfig& config = config_.current();
    window_.set_vsync(config.vsync);
    if (mixer_) {
        mixer_->set_master_gain(config.mute ? 0.0F : config.master_gain);
        mixer_->set_mono(config.mono);
        mixer_->set_doppler(config.doppler);
    }
    const QualityRequest wish = quality_request_of(config);
    if (wish == quality_request_) return;
    quality_request_ = wish;
    quality_control_ = QualityControl(wish, renderer->draws_in_software());
}

bool FrameParts::ended(double now_s) const {
    return closing_ || next_ || interrupted() || stepper.ended() ||
           (def_.seconds && now_s - start_s_ >= *def_.seconds);
}

void FrameParts::say_faults() {
    log_faults(bindings_.faults());
    for (const Diagnostics& faults : {bindings_.faults(), config_.faults()})
        for (const Diagnostic& fault : faults.list())
            overlay_.say(to_string(fault), window_.now_s());
}

void FrameParts::reload_settings(double now_s) {
    if (bindings_.reload_if_changed(now_s)) {
        latch.set_bindings(bindings_.current());
        overlay_.say("controls reloaded", now_s);
        log_faults(bindings_.faults());
        bindings_fault_ = lines_of(bindings_.faults());
    }
    if (config_.reload_if_changed(now_s)) {
        apply_config();
        overlay_.say("settings reloaded", now_s);
        log_faults(config_.faults());
        config_fault_ = lines_of(config_.faults());
    }
}

void FrameParts::take_input(const InputSnapshot& input) {
    devices_ = input;
    overlay_.follow_window(config_.current().ui_scale, menu_);
    reload_settings(input.now_s);
    pause_under_menu();
    const bool menu_was_open = menu_.open();
    const InputSnapshot for_play = menu_.take(input, bindings_.current());
    if (!menu_was_open && menu_.open()) report.note_menu_opened();
    const input::InputFocus focus{.menu_open = menu_was_open && menu_.open(),
                                  .ui_mouse = !window_.pointer_captured() && overlay_.wants_mouse(),
                                  .pointer = pointer_of(input)};
    latch.update(for_play, focus);
    apply_frame_actions(latch, controls_, clock, window_, [&](std::string line) {
        overlay_.say(std::move(line), input.now_s);
    });
    camera_path_.apply(latch, input.now_s);
    if (!def_.unattended) first_minute_.see(latch.presses_seen());
    if (input.close_requested) controls_.quit = true;
    if (!input.dropped_files.empty()) controls_.open_scene = input.dropped_files.front();
    if (input.lost_focus && config_.current().pause_on_focus_loss) clock.set_paused(true);
    capture_pointer_if_playing(input);
}

bool FrameParts::pointer_is_free() const {
    return latch.bindings().tuning.free_pointer && !session_.game->frees_pointer();
}

void FrameParts::pause_under_menu() {
    if (menu_.open() == menu_was_open_) return;
    menu_was_open_ = menu_.open();
    if (menu_was_open_) paused_before_menu_ = clock.paused();
    clock.set_paused(menu_was_open_ || paused_before_menu_);
}

void FrameParts::capture_pointer_if_playing(const InputSnapshot& input) {
    // The pointer is the person's while a menu or the accuracy panel is open or another window has
    // the keyboard; a click into the image gives it back to the game.
    if (menu_.open() || controls_.parts.accuracy || session_.game->frees_pointer() ||
        pointer_is_free() || !input.focused || input.lost_focus) {
        window_.capture_pointer(false);
        wants_pointer_ = !input.lost_focus || wants_pointer_;
        return;
    }
    if (!window_.pointer_captured() && wants_pointer_) window_.capture_pointer(true);
}

void FrameParts::run_steps(const FrameTime& time) {
    if (time.steps > 0 && std::exchange(resumes_toggles_, false))
        resume_toggles(*session_.game, latch);
    const int run = stepper.run(time.steps, time.budget_s, latch, report);
    if (!stepper.ended()) clock.drop(time.steps - run);
    say_slow_motion();
}

void FrameParts::say_slow_motion() {
    const std::optional<double> share = slow_motion_.look(window_.now_s(), clock.too_slow_s());
    if (!share) return;
    say(
        fmt::format("slow motion: physics is slower than real time ({:.0f} % dropped). Lower the "
                    "step rate or the sub-steps in the accuracy panel ({}), set preset = "
                    "\"draft\" in the scene, or remove objects",
                    100.0 * *share,
                    hint_for(latch.bindings(), Action::AccuracyPanel, latch.last_device())));
}

void FrameParts::end_with(ExitCode code, const std::string& why) {
    log_error("{}", why);
    code_ = code;
    closing_ = true;
}

void FrameParts::finish_frame(double frame_start_s, double present_s) {
    if (report.frames() == 0 && !renderer->shader_fault().empty())
        end_with(ExitCode::NoDisplay, renderer->shader_fault());
    if (renderer->device_lost())
        end_with(ExitCode::RunFailed, "the graphics device was reset; the session ends");
    session_.effects->add_render_stats(renderer->stats(), renderer->gpu_bytes());
    const double wall_ms = (wall_s() - frame_start_s) * 1e3;
    report.add_frame(wall_ms, renderer->stats());
    if (report.frames() == 1 && def_.after_first_frame)
        def_.after_first_frame(session_, renderer->gl());
    FrameCost cost{.wall_ms = wall_ms, .cpu_ms = (present_s - frame_start_s) * 1e3};
    for (const render::PassTiming& pass : renderer->stats().passes) {
        if (pass.gpu_ms >= 0.0) cost.gpu_ms = std::max(cost.gpu_ms, 0.0) + pass.gpu_ms;
    }
    if (!window_.iconified() && renderer->stats().new_programs == 0)
        quality_control_.add_frame(cost);
    report.set_image({.level = name_of(quality_control_.level()),
                      .is_automatic = quality_control_.is_automatic(),
                      .quality = quality_control_.quality()});
    // Hidden windows do not block in present(); without vsync nothing does.
    const double least_s = window_.iconified() ? 0.1 : 1.0 / config_.current().max_fps;
    const double left_s = least_s - (wall_s() - frame_start_s);
    if (left_s > 0.0) std::this_thread::sleep_for(std::chrono::duration<double>(left_s));
}

}  // namespace plumbline::app
