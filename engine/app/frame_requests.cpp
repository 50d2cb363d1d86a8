// What a person asked for beside playing, done between frames' steps, one function a request.
#include "engine/app/capture/screenshot.h"
#include "engine/app/frame_parts_impl.h"
#include "engine/core/io/files.h"
#include "engine/core/log.h"
#include "engine/core/time/stopwatch.h"

#include <chrono>

namespace plumbline::app {
void FrameParts::do_requests() {
    accuracy_.watch(controls_.parts.accuracy);
    reload_what_was_saved(window_.now_s());
    if (controls_.reset) reset_scene();
    if (controls_.reload) reload_files();
    if (controls_.save_slot) save_game(*controls_.save_slot);
    if (controls_.load_slot) load_game(*controls_.load_slot);
    if (controls_.screenshot) save_image();
    if (controls_.save_recording) save_recording_so_far();
    if (controls_.film) start_or_end_film();
    if (!controls_.open_scene.empty()) begin_opening();
    take_opened();
    if (controls_.quit) closing_ = true;
    controls_.clear_requests();
}

void FrameParts::say(std::string line) {
    overlay_.say(std::move(line), window_.now_s());
}

void FrameParts::begin_opening() {
    if (opening_.valid()) return;  // one after the other
    chosen_s_ = wall_s();
    opening_ =
        std::async(std::launch::async | std::launch::deferred,
                   [open = def_.open_scene, file = controls_.open_scene] { return open(file); });
}

void FrameParts::take_opened() {
    if (!opening_.valid() ||
        opening_.wait_for(std::chrono::seconds(0)) == std::future_status::timeout)
        return;
    Result<std::unique_ptr<Session>> opened = opening_.get();
    if (opened) {
        next_ = std::move(*opened);
        return;
    }
    // What runs goes on.
    log_error("{}", opened.error().message);
    say(opened.error().message);
}

void FrameParts::reset_scene() {
    stepper.reset();
    accuracy_.after_rebuild(clock);
    say("scene reset");
}

void FrameParts::reload_files() {
    reload_scene();
    reload_shaders();
}

void FrameParts::reload_shaders() {
    // The fault itself stands on the screen until it is mended.
    if (const Result<Done> shaders = renderer->reload_shaders(); !shaders)
        log_error("{}", shaders.error().message);
}

void FrameParts::reload_scene() {
    if (stepper.replaying()) {
        say("not available during a replay");
        return;
    }
    const Result<Done> reloaded = within_memory([this] { return session_.reload(); });
    scene_watch_.watch(session_.files());
    scene_fault_ = reloaded ? std::string() : reloaded.error().message;
    if (!reloaded) return;
    stepper.begin_anew();
    renderer->forget_scene();
    accuracy_.after_rebuild(clock);
    say("scene reloaded");
}

void FrameParts::reload_what_was_saved(double now_s) {
    if (scene_watch_.saved(now_s)) reload_scene();
    if (shader_watch_.take_changed(now_s).empty()) return;
    reload_shaders();
    if (renderer->shader_fault().empty()) say("shaders reloaded");
}

void FrameParts::save_image() {
    const auto saved = save_screenshot(*renderer, def_.user_data_folder / "shots", scene_name());
    say(saved ? "screenshot saved: " + saved->string() : saved.error().message);
}

void FrameParts::save_recording_so_far() {
    if (accuracy_.changed()) {
        say("cannot save an input recording: the accuracy settings were changed during play");
        return;
    }
    const std::filesystem::path folder = def_.user_data_folder / "recordings";
    if (const Result<Done> made = make_folder(folder); !made) {
        say(made.error().message);
        return;
    }
    const std::filesystem::path file = unused_file(folder, scene_name(), ".tape");
    const Result<Done> saved = stepper.save_recording(file);
    say(saved ? "input recording saved: " + file.string() : saved.error().message);
}

std::string FrameParts::scene_name() const {
    return session_.description().file.stem().string();
}

}  // namespace plumbline::app
