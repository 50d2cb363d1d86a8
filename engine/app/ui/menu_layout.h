// Where the parts of a page stand: pure arithmetic in pixels, so that a test can ask for any window.
#pragma once

#include "engine/app/ui/menu_page.h"

#include <vector>

namespace plumbline::app::ui {

struct Box {
    float x{0.0F};
    float y{0.0F};
    float width{0.0F};
    float height{0.0F};

    float right() const { return x + width; }
    float bottom() const { return y + height; }
    bool contains(float at_x, float at_y) const {
        return at_x >= x && at_x < right() && at_y >= y && at_y < bottom();
    }
};

bool overlap(const Box& a, const Box& b);

/// A cell by its place in the page.
struct CellPlace {
    std::size_t line{0};
    std::size_t cell{0};

    friend bool operator==(const CellPlace&, const CellPlace&) = default;
};

struct PlacedCell {
    CellPlace place;
    Box box;
    bool pinned{false};  ///< does not scroll
};

struct MenuLayout {
    Box panel;                      ///< in the window
    Box title;                      ///< in the panel's head, never scrolled
    Box view;                       ///< what scrolls is seen through it
    std::vector<Box> labels;        ///< of each line, before scrolling; Keys: label and value
    std::vector<PlacedCell> cells;  ///< before scrolling, in the page's order
    float content_height{0.0F};     ///< more than view.height: it scrolls
};

/// Where the cell is seen when the page is scrolled so far.
Box shown_box(const PlacedCell& cell, float scroll_px);

/// How wide a text is and how high it stands when wrapped at a width.
struct TextSize {
    std::function<float(const std::string&)> width_px;
    std::function<float(const std::string&, float wrap_px)> height_px;
};

MenuLayout layout_of(const Page& page,
                     float window_width_px,
                     float window_height_px,
                     float font_px,
                     const TextSize& text);

/// The cell to go to from `from` when up, down, left or right (dx, dy: one of them -1 or +1) is
/// pressed; `from` itself where there is none.
CellPlace neighbour(const MenuLayout& layout, CellPlace from, int dx, int dy);

/// The scroll at which the cell is wholly seen, as near to `scroll_px` as can be.
float scroll_to(const MenuLayout& layout, CellPlace place, float scroll_px);
float clamp_scroll(const MenuLayout& layout, float scroll_px);

}  // namespace plumbline::app::ui
