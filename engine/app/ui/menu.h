// The menu: which page is shown, what is chosen on it, and what a press does. Draws nothing: a page
// is laid out, drawn and given back by menu_draw.cpp.
//
// Pages are made anew whenever something was chosen, from what the program is now; cells carry what
// they do.
#pragma once

#include "engine/app/ui/menu_input.h"
#include "engine/app/ui/menu_layout.h"
#include "engine/app/ui/menu_page.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace plumbline::app::ui {

/// How often the mark moved and something was chosen, since the program began.
struct MenuUse {
    std::uint64_t moves{0};
    std::uint64_t choices{0};
};

class Menu {
public:
    using MakePage = std::function<Page()>;

    bool open() const { return !pages_.empty(); }
    void close() { pages_.clear(); }
    /// Opens with this page alone. `can_close`: Back on it closes the menu.
    void start(MakePage page, bool can_close);
    void push(MakePage page);
    /// The page below; closes the menu from the first one where it can.
    void back();

    /// Lays the shown page out for this window; before the presses of a frame and before drawing.
    const MenuLayout& lay_out(float width_px, float height_px, float font_px, const TextSize& text);
    const MenuLayout& layout() const { return layout_; }
    const Page& page() const { return page_; }
    CellPlace focus() const { return pages_.empty() ? CellPlace{} : pages_.back().focus; }
    float scroll_px() const { return pages_.empty() ? 0.0F : pages_.back().scroll_px; }

    void press(MenuPress press);
    /// The pointer moved here: what is below it is chosen.
    void point_at(float x, float y);
    void release_drag() { dragging_ = false; }
    const MenuUse& use() const { return use_; }

private:
    struct Shown {
        MakePage make;
        CellPlace focus{};
        float scroll_px{0.0F};
        bool fresh{true};
    };

    void make_page();
    const Cell* cell_at(CellPlace place) const;
    const PlacedCell* under(float x, float y) const;
    void move(int dx, int dy);
    void scroll(float distance_px);
    void click();
    /// Moved with the button down: sliders follow.
    void drag_to(float x, float y);
    /// Calls what a cell does; the page may be another one afterwards.
    template <class... Args>
    void call(const std::function<void(Args...)>& what, Args... args);

    std::vector<Shown> pages_;
    bool can_close_{true};
    bool dragging_{false};
    MenuUse use_{};
    Page page_;
    MenuLayout layout_;
    float font_px_{17.0F};
    float window_width_px_{0.0F};
    float window_height_px_{0.0F};
    const TextSize* text_{nullptr};
    float pointer_x_{-1.0F};
    float pointer_y_{-1.0F};
};

}  // namespace plumbline::app::ui
