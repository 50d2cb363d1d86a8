// Devices to intent: what the menu and the panels take, what frames do at once, and what the latch keeps
// for the steps.
#pragma once

#include "engine/app/frame/view_phase.h"
#include "engine/app/frame/world_phase.h"
#include "engine/app/ui/menu_control.h"

#include <string>

namespace plumbline::app {

class InputPhase {
public:
    /// All must outlive it.
    InputPhase(FrameState& state, platform::Window& window, WorldPhase& world, ViewPhase& view);

    /// Of one frame; adds what was asked for. Settings that were saved hold from here on.
    void take(const InputSnapshot& devices, Requests& requests);
    void change_bindings(const input::Bindings& wanted);
    void change_config(const AppConfig& wanted);
    /// For the overlay of the same frame.
    FrameInput shown() const;

    input::ActionLatch latch;
    ui::MenuControl menu;

private:
    void read_saved_settings();
    void say_not_stored(const Result<Done>& stored);
    /// The menu's share; the rest is for playing.
    InputSnapshot take_menu(Requests& requests);
    void capture_pointer_if_playing();

    FrameState& state_;
    platform::Window& window_;
    WorldPhase& world_;
    ViewPhase& view_;
    InputSnapshot devices_;       ///< of this frame
    std::string bindings_fault_;  ///< of the latest save, for the screen; empty: it has none
    std::string config_fault_;
    bool wants_pointer_{true};
    bool said_not_stored_{false};
};

/// What the menu's pages show.
ui::MenuWorld menu_world(const Play& play, const WorldPhase& world);

}  // namespace plumbline::app
