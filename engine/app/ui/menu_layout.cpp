#include "engine/app/ui/menu_layout.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumbline::app::ui {
namespace {

constexpr float kLine = 1.35F;        // of the font's size
constexpr float kCellHeight = 1.75F;  // a cell with its padding
constexpr float kPadding = 0.7F;      // beside the text of a cell
constexpr float kCellGap = 0.35F;     // between cells
constexpr float kCardWidth = 14.5F;   // at least
constexpr float kSlider = 11.0F;
constexpr float kKeysWidth = 26.0F;  // of a column of keys, at least

class Layouter {
public:
    Layouter(MenuLayout& layout, float font_px, const TextSize& text, bool pins = false)
        : out_(layout), em_(font_px), text_(text), y_(layout.view.y), pins_(pins) {}

    void add(const Line& line, std::size_t index) {
        if (line.kind != LineKind::Keys) finish_keys();
        switch (line.kind) {
            case LineKind::Heading:
                y_ += em_ * 0.5F;
                label(out_.view.x, out_.view.width, line.label, kLine * em_);
                break;
            case LineKind::Text:
                label(out_.view.x, out_.view.width, line.label, 0.0F);
                break;
            case LineKind::Cells:
                add_cells(line, index);
                break;
            case LineKind::List:
                label(out_.view.x, out_.view.width, {}, 0.0F);
                for (std::size_t i = 0; i < line.cells.size(); ++i) {
                    const float height = list_height(line.cells[i]);
                    put({index, i}, {out_.view.x, y_, out_.view.width, height});
                    y_ += height + em_ * kCellGap;
                }
                break;
            case LineKind::Cards:
                label(out_.view.x, out_.view.width, {}, 0.0F);
                add_cards(line, index);
                break;
            case LineKind::Keys:
                add_keys(line);
                break;
        }
    }

    void finish() {
        finish_keys();
        out_.content_height = y_ - out_.view.y;
    }

private:
    void put(CellPlace place, const Box& box) { out_.cells.push_back({place, box, pins_}); }

    void label(float x, float width, const std::string& text, float least_height) {
        const float height =
            text.empty() ? 0.0F : std::max(least_height, text_.height_px(text, width) + em_ * 0.2F);
        out_.labels.push_back({x, y_, width, height});
        y_ += height;
    }

    float list_height(const Cell& cell) const {
        const float text_width = out_.view.width - 2 * kPadding * em_;
        const float note = cell.note.empty() ? 0.0F : text_.height_px(cell.note, text_width);
        return std::max(kCellHeight * em_, text_.height_px(cell.text, text_width) + 0.5F * em_) +
               note;
    }

    float cell_width(const Cell& cell) const {
        if (cell.set_fraction) return kSlider * em_;
        const float icon = cell.icon == Icon::None ? 0.0F : 1.4F * em_;
        return std::ceil(text_.width_px(cell.text)) + icon + 2 * kPadding * em_;
    }

    void add_cells(const Line& line, std::size_t index) {
        const float right = out_.view.right();
        const float label_width =
            line.label.empty() ? 0.0F : std::min(out_.view.width * 0.42F, 17.0F * em_);
        const float first = out_.view.x + label_width;
        const float label_height =
            line.label.empty()
                ? 0.0F
                : text_.height_px(line.label, label_width - kPadding * em_) + 0.4F * em_;
        out_.labels.push_back({out_.view.x, y_, label_width, label_height});
        float x = first;
        float y = y_;
        for (std::size_t i = 0; i < line.cells.size(); ++i) {
            const float width = std::min(cell_width(line.cells[i]), right - first);
            if (x > first && x + width > right) {
                x = first;
                y += (kCellHeight + kCellGap) * em_;
            }
            put({index, i}, {x, y, width, kCellHeight * em_});
            x += width + kCellGap * em_;
        }
        const float cells_bottom = line.cells.empty() ? y_ : y + kCellHeight * em_;
        y_ = std::max(cells_bottom, y_ + label_height) + kCellGap * em_;
    }

    void add_cards(const Line& line, std::size_t index) {
        const float gap = kCellGap * em_;
        const float columns =
            std::clamp(std::floor((out_.view.width + gap) / (kCardWidth * em_ + gap)), 1.0F, 6.0F);
        const float width = (out_.view.width - gap * (columns - 1)) / columns;
        float x = out_.view.x;
        float row_height = 0.0F;
        for (std::size_t i = 0; i < line.cells.size(); ++i) {
            if (i > 0 && i % static_cast<std::size_t>(columns) == 0) {
                x = out_.view.x;
                y_ += row_height + gap;
                row_height = 0.0F;
            }
            const Cell& cell = line.cells[i];
            const float text_width = width - 2 * kPadding * em_;
            const float image = cell.thumbnail.empty() ? 0.0F : width * 9.0F / 16.0F;
            const float height = image + text_.height_px(cell.text, text_width) +
                                 text_.height_px(cell.note, text_width) + kPadding * em_;
            put({index, i}, {x, y_, width, height});
            row_height = std::max(row_height, height);
            x += width + gap;
        }
        y_ += row_height + gap;
    }

    // Pairs flow over the columns row by row; a row is as high as its highest value.
    void add_keys(const Line& line) {
        const float columns =
            std::clamp(std::floor(out_.view.width / (kKeysWidth * em_)), 1.0F, 3.0F);
        const float width = out_.view.width / columns;
        if (key_column_ == static_cast<int>(columns)) finish_keys();
        const float x = out_.view.x + width * static_cast<float>(key_column_);
        const float half = width * 0.5F;
        const float text_width = half - kPadding * em_;
        const float height = std::max(text_.height_px(line.label, text_width),
                                      text_.height_px(line.value, text_width)) +
                             0.15F * em_;
        out_.labels.push_back({x, y_, half, height});
        keys_height_ = std::max(keys_height_, height);
        ++key_column_;
    }

    void finish_keys() {
        if (key_column_ == 0) return;
        y_ += keys_height_;
        key_column_ = 0;
        keys_height_ = 0.0F;
    }

    MenuLayout& out_;
    float em_;
    const TextSize& text_;
    float y_;
    bool pins_;
    int key_column_{0};
    float keys_height_{0.0F};
};

const PlacedCell* find(const MenuLayout& layout, CellPlace place) {
    const auto found = std::ranges::find(layout.cells, place, &PlacedCell::place);
    return found == layout.cells.end() ? nullptr : &*found;
}

/// What scrolls begins below it.
void pin_first_line(const Line& line, float font_px, const TextSize& text, MenuLayout& layout) {
    Layouter layouter(layout, font_px, text, true);
    layouter.add(line, 0);
    layouter.finish();
    const float taken = layout.content_height + font_px * 0.3F;
    layout.view.y += taken;
    layout.view.height -= taken;
}

float middle_x(const Box& box) {
    return box.x + box.width * 0.5F;
}

}  // namespace

bool overlap(const Box& a, const Box& b) {
    constexpr float kTouch_px = 0.01F;
    return a.x + kTouch_px < b.right() && b.x + kTouch_px < a.right() &&
           a.y + kTouch_px < b.bottom() && b.y + kTouch_px < a.bottom();
}

Box shown_box(const PlacedCell& cell, float scroll_px) {
    Box box = cell.box;
    if (!cell.pinned) box.y -= scroll_px;
    return box;
}

MenuLayout layout_of(const Page& page,
                     float window_width_px,
                     float window_height_px,
                     float font_px,
                     const TextSize& text) {
    MenuLayout layout;
    const float margin = font_px * 0.8F;
    const float width = std::min(window_width_px - 2 * margin, font_px * page.most_width);
    const float pad = font_px * 0.9F;
    layout.panel = {(window_width_px - width) * 0.5F, margin, width, window_height_px - 2 * margin};
    layout.title = {layout.panel.x + pad,
                    layout.panel.y + pad * 0.6F,
                    width - 2 * pad,
                    text.height_px(page.title, width - 2 * pad)};
    const float top = layout.title.bottom() + font_px * 0.5F;
    layout.view = {
        layout.title.x, top, layout.title.width, layout.panel.bottom() - pad * 0.6F - top};
    const std::size_t pinned_lines = page.pins_first_line && !page.lines.empty() ? 1 : 0;
    if (pinned_lines > 0) pin_first_line(page.lines.front(), font_px, text, layout);
    Layouter layouter(layout, font_px, text);
    for (std::size_t i = pinned_lines; i < page.lines.size(); ++i) layouter.add(page.lines[i], i);
    layouter.finish();
    if (pinned_lines > 0) return layout;
    // A page that needs less than the window is as high as it needs, in the middle.
    const float spare = layout.view.height - layout.content_height;
    if (spare >= 0.0F) {
        layout.content_height = layout.view.height - spare;
        const float down = spare * 0.5F;
        layout.panel.y += down;
        layout.panel.height -= spare;
        layout.title.y += down;
        layout.view.y += down;
        layout.view.height = layout.content_height;
        for (Box& label : layout.labels) label.y += down;
        for (PlacedCell& cell : layout.cells) cell.box.y += down;
    }
    return layout;
}

CellPlace neighbour(const MenuLayout& layout, CellPlace from, int dx, int dy) {
    const PlacedCell* start = find(layout, from);
    if (start == nullptr) return layout.cells.empty() ? from : layout.cells.front().place;
    CellPlace best = from;
    float best_distance = std::numeric_limits<float>::max();
    for (const PlacedCell& cell : layout.cells) {
        const bool same_row = cell.box.y < start->box.bottom() && start->box.y < cell.box.bottom();
        if (dx != 0 && (!same_row || cell.place == from)) continue;
        const float ahead_x = (middle_x(cell.box) - middle_x(start->box)) * static_cast<float>(dx);
        const float ahead_y = (cell.box.y - start->box.y) * static_cast<float>(dy);
        const float ahead = dx != 0 ? ahead_x : ahead_y;
        if (ahead <= 0.0F || (dy != 0 && same_row)) continue;
        // The next row first, and in it the first cell that stands above or below.
        const float sideways =
            std::max({0.0F, cell.box.x - start->box.right(), start->box.x - cell.box.right()});
        const float distance = dx != 0 ? ahead : ahead * 1000.0F + sideways;
        if (distance >= best_distance) continue;
        best_distance = distance;
        best = cell.place;
    }
    return best;
}

float clamp_scroll(const MenuLayout& layout, float scroll_px) {
    return std::clamp(scroll_px, 0.0F, std::max(0.0F, layout.content_height - layout.view.height));
}

float scroll_to(const MenuLayout& layout, CellPlace place, float scroll_px) {
    const PlacedCell* cell = find(layout, place);
    if (cell == nullptr) return clamp_scroll(layout, scroll_px);
    if (cell->pinned) return clamp_scroll(layout, scroll_px);
    // The first line of cells brings what stands above it along.
    const auto first = std::ranges::find(layout.cells, false, &PlacedCell::pinned);
    if (cell->place == first->place) return 0.0F;
    const float above = cell->box.y - layout.view.y;
    const float below = cell->box.bottom() - layout.view.bottom();
    return clamp_scroll(layout, std::clamp(scroll_px, std::min(below, above), above));
}

}  // namespace plumbline::app::ui
