#include "engine/app/ui/menu_control.h"

#include "engine/input/modifier_keys.h"

#include <algorithm>
#include <iterator>

namespace plumbline::app::ui {

void MenuControl::show_start() {
    menu_.start([this] { return pages_.start(); }, true);
}

void MenuControl::take_event(const DeviceEvent& event, const input::Bindings& bindings) {
    if (help_alone_ && opens_help(event, bindings)) return menu_.close();
    if (event.kind == DeviceEventKind::MouseButton && !event.pressed) menu_.release_drag();
    for (const MenuPress press : MenuKeys::press_of(event, bindings)) menu_.press(press);
}

InputSnapshot MenuControl::take(const InputSnapshot& input, Requests& requests) {
    InputSnapshot rest = take(input);
    std::ranges::move(pages_.take_requests(), std::back_inserter(requests));
    return rest;
}

InputSnapshot MenuControl::take(const InputSnapshot& input) {
    const input::Bindings& bindings = pages_.bindings().current();
    pages_.set_pad_present(input.pad_present);
    InputSnapshot rest = input;
    rest.events.clear();
    const auto cursor_x = static_cast<float>(input.cursor_px[0]);
    const auto cursor_y = static_cast<float>(input.cursor_px[1]);
    menu_.point_at(cursor_x, cursor_y);
    const unsigned chords = input::kCtrl | input::kAlt | input::kSuper;
    const bool in_chord = (input::modifiers_down(input.keys) & chords) != 0;
    for (std::size_t i = 0; i < input.events.size(); ++i) {
        const DeviceEvent& event = input.events[i];
        if (pages_.waits_for_press()) {
            InputSnapshot from_here = input;
            from_here.events.erase(from_here.events.begin(),
                                   from_here.events.begin() + static_cast<std::ptrdiff_t>(i));
            pages_.take_press(from_here);
            return rest;
        }
        if (menu_.open()) {
            const bool is_key = event.kind == DeviceEventKind::Key;
            if (!is_key || !in_chord) take_event(event, bindings);
            continue;
        }
        rest.events.push_back(event);
        help_alone_ = opens_help(event, bindings);
        if (opens_menu(event, bindings)) {
            menu_.start([this] { return pages_.in_play(); }, true);
        } else if (help_alone_) {
            menu_.start([this] { return pages_.help(); }, true);
        }
        menu_.point_at(cursor_x, cursor_y);
    }
    if (pages_.waits_for_press()) {
        InputSnapshot axes_only = input;
        axes_only.events.clear();
        pages_.take_press(axes_only);
        return rest;
    }
    for (const MenuPress press : keys_.repeats(input)) menu_.press(press);
    if (input.lost_focus) menu_.release_drag();
    return rest;
}

}  // namespace plumbline::app::ui
