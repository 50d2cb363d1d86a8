#include "engine/app/frame/input_phase.h"

#include "engine/core/log.h"
#include "engine/scene/simulation/sun_hour.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace plumbline::app {
namespace {

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

InputSnapshot without_keys(InputSnapshot input) {
    std::erase_if(input.events,
                  [](const DeviceEvent& event) { return event.kind == DeviceEventKind::Key; });
    return input;
}

}  // namespace

ui::MenuWorld menu_world(const Play& play, const WorldPhase& world) {
    const Session& session = play.session;
    const scene::SceneDescription& scene = session.description();
    return {.bindings = &play.bindings,
            .scenes = &world.scenes,
            .config = play.config.current(),
            .config_below = play.config.below(),
            .scene_title = scene.title.empty() ? scene_name(session) : scene.title,
            .replaying = world.stepper.replaying(),
            .looks_at_model = looks_at_model(session),
            .accuracy = session.accuracy(),
            .switches = session.simulation->switches,
            .fog = scene.fog.value_or(scene::FogDescription{.on = false}),
            .hour = hour_of(*session.simulation),
            .saves = world.saves.slots(),
            .results = &world.results};
}

InputPhase::InputPhase(FrameState& state,
                       platform::Window& window,
                       WorldPhase& world,
                       ViewPhase& view)
    : latch(state.play.bindings.current()),
      menu(menu_world(state.play, world)),
      state_(state),
      window_(window),
      world_(world),
      view_(view) {
    latch.set_label_lookup(platform::printed_key_name);
    if (state.play.def.start_page) menu.show_start();
}

FrameInput InputPhase::shown() const {
    FrameInput shown{.devices = devices_, .latch = latch, .menu = menu, .faults = {}};
    for (const std::string& fault : {bindings_fault_, config_fault_})
        if (!fault.empty()) shown.faults.push_back(fault);
    return shown;
}

void InputPhase::say_not_stored(const Result<Done>& stored) {
    if (stored || std::exchange(said_not_stored_, true)) return;
    state_.messages.say(stored.error().message);
}

void InputPhase::change_config(const AppConfig& wanted) {
    say_not_stored(state_.play.config.change(wanted));
}

void InputPhase::change_bindings(const input::Bindings& wanted) {
    say_not_stored(state_.play.bindings.change(wanted));
    latch.set_bindings(state_.play.bindings.current());
    bindings_fault_ = lines_of(state_.play.bindings.faults());
}

void InputPhase::read_saved_settings() {
    if (state_.play.bindings.reload_if_changed(devices_.now_s)) {
        latch.set_bindings(state_.play.bindings.current());
        state_.messages.say("controls reloaded");
        log_faults(state_.play.bindings.faults());
        bindings_fault_ = lines_of(state_.play.bindings.faults());
    }
    if (state_.play.config.reload_if_changed(devices_.now_s)) {
        state_.messages.say("settings reloaded");
        log_faults(state_.play.config.faults());
        config_fault_ = lines_of(state_.play.config.faults());
    }
}

InputSnapshot InputPhase::take_menu(Requests& requests) {
    const bool was_open = menu.open();
    menu.show(menu_world(state_.play, world_));
    view_.overlay.follow_window(state_.config().ui_scale, menu);
    InputSnapshot rest = menu.take(devices_, requests);
    if (!was_open && menu.open()) {
        state_.report.note_menu_opened();
        world_.saves.refresh();
    }
    return rest;
}

void InputPhase::take(const InputSnapshot& devices, Requests& requests) {
    devices_ = devices;
    read_saved_settings();
    // The world stands still from the frame after the one that opened a menu: what was pressed
    // before it still reaches a step.
    const bool menu_was_open = menu.open();
    state_.clock.hold(menu_was_open || world_.waits_for_ghost());
    const bool panel_takes_keys = view_.overlay.takes_keys();
    const InputSnapshot for_play = panel_takes_keys ? without_keys(devices) : take_menu(requests);
    const bool on_panel = !window_.pointer_captured() &&
                          view_.overlay.takes_pointer(devices.cursor_px[0], devices.cursor_px[1]);
    latch.update(for_play,
                 {.menu_open = menu_was_open && menu.open(),
                  .ui_keyboard = panel_takes_keys,
                  .ui_mouse = on_panel,
                  .pointer = view_.pointer_of(devices, latch)});
    apply_frame_actions(latch, view_.settings, state_.clock, requests, [this](std::string line) {
        state_.messages.say(std::move(line));
    });
    view_.camera_path.apply(latch, devices.now_s);
    if (!state_.play.def.unattended) view_.hints.see(latch.presses_seen());
    if (devices.close_requested) requests.push_back(Quit{});
    if (!devices.dropped_files.empty())
        requests.push_back(OpenScene{devices.dropped_files.front()});
    if (devices.lost_focus && state_.config().pause_on_focus_loss) state_.clock.set_paused(true);
    capture_pointer_if_playing();
}

void InputPhase::capture_pointer_if_playing() {
    // The pointer is the person's while a menu or the accuracy panel is open or another window has
    // the keyboard; a click into the image gives it back to the game.
    if (menu.open() || view_.settings.parts.accuracy || state_.play.session.game->frees_pointer() ||
        view_.pointer_is_free(latch) || !devices_.focused || devices_.lost_focus) {
        window_.capture_pointer(false);
        wants_pointer_ = !devices_.lost_focus || wants_pointer_;
        return;
    }
    if (!window_.pointer_captured() && wants_pointer_) window_.capture_pointer(true);
}

}  // namespace plumbline::app
