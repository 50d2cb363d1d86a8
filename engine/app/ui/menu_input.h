// What devices mean to an open menu: every press in order, however few frames are drawn.
#pragma once

#include "engine/core/input_snapshot.h"
#include "engine/input/bindings.h"

#include <vector>

namespace plumbline::app::ui {

enum class MenuPress : std::uint8_t {
    Up,
    Down,
    Left,
    Right,
    PageUp,
    PageDown,
    Accept,
    Back,
    Remove,
    Click,
    WheelUp,
    WheelDown
};

/// Turns device events into presses and repeats arrows that are kept down. The arrows, Enter,
/// Space, Escape, Delete, the direction pad and the left stick always work; what `accept`,
/// `back_out` and `menu` are bound to works as well.
class MenuKeys {
public:
    /// The meaning of one event; nothing for a release or a key without one.
    static std::vector<MenuPress> press_of(const DeviceEvent& event,
                                           const input::Bindings& bindings);

    /// Repeats due now, and the stick's own presses. Once a frame while the menu is open.
    std::vector<MenuPress> repeats(const InputSnapshot& input);

private:
    double held_since_s_{-1.0};
    int repeated_{0};
    MenuPress held_{MenuPress::Up};
    bool stick_was_out_{false};
};

/// True for a press that opens the menu, or the help alone.
bool opens_menu(const DeviceEvent& event, const input::Bindings& bindings);
bool opens_help(const DeviceEvent& event, const input::Bindings& bindings);

}  // namespace plumbline::app::ui
