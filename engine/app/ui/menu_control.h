// The menu with its pages and its share of the input.
#pragma once

#include "engine/app/ui/menu.h"
#include "engine/app/ui/menu_input.h"
#include "engine/app/ui/pages.h"

#include <utility>

namespace plumbline::app::ui {

class MenuControl {
public:
    explicit MenuControl(MenuWorld world) : pages_(menu_, std::move(world)) {}

    bool open() const { return menu_.open(); }
    const Menu& menu() const { return menu_; }
    void show_start();

    /// What the pages show from now on; once a frame, before lay_out().
    void show(MenuWorld world) { pages_.show(std::move(world)); }
    /// As the window and its letters are now; before take() and before drawing.
    void lay_out(float width_px, float height_px, float font_px, const TextSize& text) {
        menu_.lay_out(width_px, height_px, font_px, text);
    }

    /// Takes this frame's events one by one, in order: the one that opens the menu, and from there
    /// on what is the menu's. Returns what is left for playing, and adds what was chosen.
    InputSnapshot take(const InputSnapshot& input, Requests& requests);

private:
    InputSnapshot take(const InputSnapshot& input);
    void take_event(const DeviceEvent& event, const input::Bindings& bindings);

    Menu menu_;
    MenuPages pages_;
    MenuKeys keys_;
    bool help_alone_{false};  ///< opened by the help's key, which closes it as well
};

}  // namespace plumbline::app::ui
