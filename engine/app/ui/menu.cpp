#include "engine/app/ui/menu.h"

#include <algorithm>
#include <utility>

namespace plumbline::app::ui {

void Menu::start(MakePage page, bool can_close) {
    pages_.clear();
    can_close_ = can_close;
    push(std::move(page));
}

void Menu::push(MakePage page) {
    pages_.push_back({.make = std::move(page)});
    dragging_ = false;
    make_page();
}

void Menu::back() {
    if (pages_.size() > 1 || (pages_.size() == 1 && can_close_)) pages_.pop_back();
    dragging_ = false;
    make_page();
}

void Menu::make_page() {
    if (pages_.empty() || text_ == nullptr) return;
    page_ = pages_.back().make();
    layout_ = layout_of(page_, window_width_px_, window_height_px_, font_px_, *text_);
    Shown& shown = pages_.back();
    const bool there = std::ranges::any_of(
        layout_.cells, [&](const PlacedCell& cell) { return cell.place == shown.focus; });
    if (!there && !layout_.cells.empty()) {
        // What was chosen is gone: the nearest that comes before it.
        const auto after = std::ranges::find_if(layout_.cells, [&](const PlacedCell& cell) {
            return std::pair(cell.place.line, cell.place.cell) >
                   std::pair(shown.focus.line, shown.focus.cell);
        });
        shown.focus =
            after == layout_.cells.begin() ? layout_.cells.front().place : std::prev(after)->place;
    }
    if (std::exchange(shown.fresh, false)) {
        for (const PlacedCell& cell : layout_.cells) {
            if (!page_.lines[cell.place.line].cells[cell.place.cell].marked) continue;
            shown.focus = cell.place;
            shown.scroll_px = scroll_to(layout_, shown.focus, 0.0F);
            break;
        }
    }
    shown.scroll_px = clamp_scroll(layout_, shown.scroll_px);
}

const MenuLayout& Menu::lay_out(float width_px,
                                float height_px,
                                float font_px,
                                const TextSize& text) {
    const bool resized = width_px != window_width_px_ || height_px != window_height_px_;
    window_width_px_ = width_px;
    window_height_px_ = height_px;
    font_px_ = font_px;
    text_ = &text;
    make_page();
    if (resized && open()) {
        Shown& shown = pages_.back();
        shown.scroll_px = scroll_to(layout_, shown.focus, shown.scroll_px);
    }
    return layout_;
}

const Cell* Menu::cell_at(CellPlace place) const {
    if (place.line >= page_.lines.size()) return nullptr;
    const std::vector<Cell>& cells = page_.lines[place.line].cells;
    return place.cell < cells.size() ? &cells[place.cell] : nullptr;
}

const PlacedCell* Menu::under(float x, float y) const {
    if (!open()) return nullptr;
    const auto found = std::ranges::find_if(layout_.cells, [&](const PlacedCell& cell) {
        return (cell.pinned || layout_.view.contains(x, y)) &&
               shown_box(cell, pages_.back().scroll_px).contains(x, y);
    });
    return found == layout_.cells.end() ? nullptr : &*found;
}

template <class... Args>
void Menu::call(const std::function<void(Args...)>& what, Args... args) {
    if (!what) return;
    ++use_.choices;
    // A copy: what is called makes pages anew, and with them itself.
    const std::function<void(Args...)> kept = what;
    kept(args...);
    make_page();
}

void Menu::scroll(float distance_px) {
    Shown& shown = pages_.back();
    shown.scroll_px = clamp_scroll(layout_, shown.scroll_px + distance_px);
}

void Menu::move(int dx, int dy) {
    Shown& shown = pages_.back();
    const Cell* cell = cell_at(shown.focus);
    if (dx != 0 && cell != nullptr && cell->adjust) return call(cell->adjust, dx);
    const CellPlace next = neighbour(layout_, shown.focus, dx, dy);
    // Nothing more to choose there: what else the page says is still to be read.
    if (next == shown.focus && dy != 0) return scroll(static_cast<float>(dy) * font_px_ * 3.0F);
    if (next != shown.focus) ++use_.moves;
    shown.focus = next;
    shown.scroll_px = scroll_to(layout_, next, shown.scroll_px);
}

void Menu::click() {
    const PlacedCell* at = under(pointer_x_, pointer_y_);
    if (at == nullptr) return;
    pages_.back().focus = at->place;
    const Cell* cell = cell_at(at->place);
    if (!cell->set_fraction) return call(cell->activate);
    dragging_ = true;
    drag_to(pointer_x_, pointer_y_);
}

void Menu::press(MenuPress press) {
    if (!open()) return;
    const Cell* cell = cell_at(focus());
    switch (press) {
        case MenuPress::Up:
            return move(0, -1);
        case MenuPress::Down:
            return move(0, 1);
        case MenuPress::Left:
            return move(-1, 0);
        case MenuPress::Right:
            return move(1, 0);
        case MenuPress::PageUp:
            return scroll(-layout_.view.height * 0.9F);
        case MenuPress::PageDown:
            return scroll(layout_.view.height * 0.9F);
        case MenuPress::WheelUp:
            return scroll(-font_px_ * 4.0F);
        case MenuPress::WheelDown:
            return scroll(font_px_ * 4.0F);
        case MenuPress::Accept:
            if (cell != nullptr) call(cell->activate);
            return;
        case MenuPress::Remove:
            if (cell != nullptr) call(cell->remove);
            return;
        case MenuPress::Click:
            return click();
        case MenuPress::Back:
            return back();
    }
}

void Menu::point_at(float x, float y) {
    if (x == pointer_x_ && y == pointer_y_) return;
    pointer_x_ = x;
    pointer_y_ = y;
    if (dragging_) return drag_to(x, y);
    if (const PlacedCell* at = under(x, y)) {
        if (at->place != pages_.back().focus) ++use_.moves;
        pages_.back().focus = at->place;
    }
}

void Menu::drag_to(float x, float y) {
    pointer_x_ = x;
    pointer_y_ = y;
    if (!dragging_ || !open()) return;
    const Cell* cell = cell_at(focus());
    const auto placed = std::ranges::find(layout_.cells, focus(), &PlacedCell::place);
    if (cell == nullptr || placed == layout_.cells.end()) return;
    call(cell->set_fraction,
         std::clamp((x - placed->box.x) / std::max(1.0F, placed->box.width), 0.0F, 1.0F));
}

}  // namespace plumbline::app::ui
