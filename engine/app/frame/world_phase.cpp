#include "engine/app/frame/world_phase.h"

#include "engine/app/accuracy/accuracy_copy.h"
#include "engine/app/capture/screenshot.h"
#include "engine/app/controls/frame_controls.h"
#include "engine/app/controls/key_labels.h"
#include "engine/app/scene_copies.h"
#include "engine/core/io/files.h"
#include "engine/core/log.h"
#include "engine/core/time/stopwatch.h"

#include <fmt/format.h>

#include <new>
#include <optional>
#include <utility>

namespace plumbline::app {
namespace {

/// A scene that needs more memory than there is costs a line, not the one that runs.
template <class Build>
Result<Done> within_memory(const Build& build) {
    try {
        return build();
    } catch (const std::bad_alloc&) {
        return Error{.message = "not enough memory for this scene; the current scene stays open"};
    }
}

/// What is said of a request that was done; empty: it shows by itself.
std::string words_of(const WorldRequest& request, bool is_hard_case) {
    if (std::holds_alternative<StartAgain>(request)) return "scene reset";
    if (const auto* asked = std::get_if<SetAccuracy>(&request))
        return study::setting_text(asked->setting) + (is_hard_case ? "; hard case restarted" : "");
    return {};
}

}  // namespace

WorldPhase::WorldPhase(FrameState& state, Stepper stepper_made)
    : stepper(std::move(stepper_made)),
      accuracy(state.play.session),
      saves(state.play.session, state.play.def.user_data_folder),
      results(in_user_data(state.play.def, "best_results")),
      state_(state),
      session_(state.play.session),
      scene_watch_(state.play.session.files()) {
    stepper.after_step = [this] { accuracy.after_step(); };
}

bool WorldPhase::refuses_in_replay() {
    if (stepper.replaying()) state_.messages.say("not available during a replay");
    return stepper.replaying();
}

void WorldPhase::apply(const WorldRequest& request) {
    if (refuses_in_replay()) return;
    const Result<Done> done = within_memory([&] { return stepper.apply(request); });
    if (!done) return state_.say_failed(done.error());
    std::string words = words_of(request, session_.judge != nullptr);
    if (!words.empty()) state_.messages.say(std::move(words));
}

bool WorldPhase::reload_scene() {
    if (refuses_in_replay()) return false;
    const std::optional<study::Setting> chosen = session_.chosen_accuracy();
    const Result<Done> reloaded = within_memory([this] { return session_.reload(); });
    scene_watch_.watch(session_.files());
    scene_fault = reloaded ? std::string() : reloaded.error().message;
    if (!reloaded) {
        log_error("{}", scene_fault);
        return false;
    }
    stepper.begin_anew();
    // The recording begins at the scene's own accuracy.
    if (chosen) apply(SetAccuracy{*chosen});
    state_.messages.say("scene reloaded");
    return true;
}

void WorldPhase::save_game(int slot) {
    const std::filesystem::path file = saves.choose(slot);
    if (!saves.has_folder())
        return state_.messages.say(
            "cannot save: no user data folder (XDG_DATA_HOME and HOME are not set)");
    const Result<Done> saved = session_.save(file, stepper.steps());
    saves.refresh();
    if (saved)
        return state_.messages.say(
            fmt::format("saved to slot {}: {}", saves.chosen(), file.string()));
    state_.say_failed(saved.error());
}

void WorldPhase::load_game(int slot) {
    if (refuses_in_replay()) return;
    const std::filesystem::path file = saves.choose(slot);
    saves.refresh();
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored))
        return state_.messages.say(fmt::format("slot {} is empty", saves.chosen()));
    std::uint64_t steps = 0;
    const Result<Done> loaded = within_memory([&]() -> Result<Done> {
        const Result<std::uint64_t> done = session_.load(file);
        if (!done) return done.error();
        steps = *done;
        return Done{};
    });
    if (!loaded) {
        log_error("{}", loaded.error().message);
        return state_.messages.say(loaded.error().message + saves.others());
    }
    stepper.begin_anew(steps);
    resumes_toggles_ = true;
    state_.messages.say(fmt::format(
        "slot {} loaded ({:.1f} s into the scene)", saves.chosen(), session_.simulation->time_s()));
}

void WorldPhase::save_recording() {
    const std::filesystem::path folder = state_.play.def.user_data_folder / "recordings";
    if (const Result<Done> made = make_folder(folder); !made)
        return state_.messages.say(made.error().message);
    const std::filesystem::path file = unused_file(folder, scene_name(session_), ".tape");
    const Result<Done> saved = stepper.save_recording(file);
    state_.messages.say(saved ? "input recording saved: " + file.string() : saved.error().message);
}

void WorldPhase::adopt_accuracy() {
    const scene::SceneFolders folders = scene::scene_folders(session_.folders().assets);
    const Result<std::filesystem::path> written =
        write_adopted_copy(session_.description().file, session_.accuracy(), folders);
    if (!written) return state_.messages.say(written.error().message);
    state_.messages.say(fmt::format("accuracy saved to {}", written->string()));
    scenes = scene::list_scenes(folders);
}

void WorldPhase::save_level() {
    const scene::SceneFolders folders = scene::scene_folders(session_.folders().assets);
    const Result<WrittenLevel> level = write_level(*session_.simulation, folders);
    if (!level) return state_.messages.say(level.error().message);
    std::string said = fmt::format("level saved to {}", level->file.string());
    for (const std::string& note : level->notes) said += "; " + note;
    state_.messages.say(said);
    scenes = scene::list_scenes(folders);
}

void WorldPhase::start_ghost(const StartGhost& asked) {
    if (asked.from == GhostFrom::Start) apply(StartAgain{});
    const Result<Done> started = accuracy.start_ghost(asked.setting);
    state_.messages.say(started
                            ? fmt::format("ghost started: {}", study::setting_text(asked.setting))
                            : started.error().message);
}

void WorldPhase::start_picture_study() {
    const scene::ViewPoint view = session_.game->view(*session_.simulation, Real{1}, 0.0F, 0.0F);
    accuracy.picture.start(session_.description().file, view.world_from_camera);
}

bool WorldPhase::waits_for_ghost() const {
    const study::Ghost* ghost = accuracy.ghost();
    return ghost != nullptr && ghost->failure().empty() && !ghost->ready();
}

void WorldPhase::note_saved_files(double now_s, Requests& requests) {
    if (scene_watch_.saved(now_s)) requests.push_back(ReloadScene{});
}

void WorldPhase::run_steps(const FrameTime& time, input::ActionLatch& latch) {
    if (time.steps > 0 && std::exchange(resumes_toggles_, false))
        resume_toggles(*session_.game, latch);
    const int run = stepper.run(time.steps, time.budget_s, latch, state_.report);
    if (!stepper.ended()) state_.clock.drop(time.steps - run);
    // Requests and replays change the length of a step.
    state_.clock.set_step(session_.simulation->step_s());
    accuracy.take_answers();
    const std::optional<double> won_in_s = session_.game->won_in_s();
    if (won_in_s && !stepper.replaying()) results.note(scene_name(session_), *won_in_s);
    watch_slow_motion(latch);
}

void WorldPhase::watch_slow_motion(const input::ActionLatch& latch) {
    const std::optional<double> share = slow_motion_.look(wall_s(), state_.clock.too_slow_s());
    if (!share) return;
    state_.messages.say(
        fmt::format("slow motion: physics is slower than real time ({:.0f} % dropped). Lower the "
                    "step rate or the sub-steps in the accuracy panel ({}), set preset = "
                    "\"draft\" in the scene, or remove objects",
                    100.0 * *share,
                    hint_for(latch.bindings(), Action::AccuracyPanel, latch.last_device())));
}

}  // namespace plumbline::app
