#include "engine/app/ui/canvas_impl.h"

#include <algorithm>
#include <cmath>

namespace plumbline::app::ui {
namespace {

constexpr ImU32 kInk = IM_COL32(245, 245, 245, 255);
constexpr ImU32 kFaint = IM_COL32(190, 192, 200, 255);
constexpr ImU32 kHead = IM_COL32(255, 209, 115, 255);
constexpr ImU32 kPanel = IM_COL32(22, 24, 30, 238);
constexpr ImU32 kShade = IM_COL32(0, 0, 0, 110);
constexpr ImU32 kCellColor = IM_COL32(52, 56, 68, 255);
constexpr ImU32 kMarked = IM_COL32(38, 92, 138, 255);
constexpr ImU32 kFilled = IM_COL32(46, 104, 152, 255);
constexpr ImU32 kFocus = IM_COL32(255, 209, 115, 255);

ImVec2 corner(const Box& box) {
    return {box.x, box.y};
}

ImVec2 far_corner(const Box& box) {
    return {box.right(), box.bottom()};
}

Box inset(const Box& box, float left, float top) {
    return {box.x + left, box.y + top, box.width - 2 * left, box.height - 2 * top};
}

/// Draws the parts of one page; boxes are given before scrolling.
class MenuPainter {
public:
    MenuPainter(ImDrawList& list, Canvas::Impl& canvas, const Menu& menu)
        : list_(list), canvas_(canvas), menu_(menu), em_(canvas.font_px) {}

    void draw() {
        const MenuLayout& layout = menu_.layout();
        const ImVec2 display = ImGui::GetIO().DisplaySize;
        list_.AddRectFilled({0.0F, 0.0F}, display, kShade);
        list_.AddRectFilled(corner(layout.panel), far_corner(layout.panel), kPanel, em_ * 0.4F);
        canvas_.text(list_, layout.title, kHead, menu_.page().title);
        for (const PlacedCell& cell : layout.cells)
            if (cell.pinned) draw_cell(cell);
        // The frame of what is chosen stands a little outside.
        const Box clip = inset(layout.view, -em_ * 0.15F, -em_ * 0.15F);
        list_.PushClipRect(corner(clip), far_corner(clip), true);
        draw_labels();
        for (const PlacedCell& cell : layout.cells)
            if (!cell.pinned) draw_cell(cell);
        list_.PopClipRect();
        draw_scroll_bar();
    }

private:
    Box scrolled(Box box) const {
        box.y -= menu_.scroll_px();
        return box;
    }

    bool seen(const Box& box) const {
        return box.bottom() >= menu_.layout().view.y && box.y <= menu_.layout().view.bottom();
    }

    void draw_labels() {
        const Page& page = menu_.page();
        for (std::size_t i = 0; i < page.lines.size(); ++i) {
            const Line& line = page.lines[i];
            Box box = scrolled(menu_.layout().labels[i]);
            if (!seen(box)) continue;
            if (line.kind == LineKind::Keys) {
                const float gap = em_ * 0.7F;
                Box words = box;
                words.x = box.right();
                words.width = box.width - gap;
                box.width -= gap;
                canvas_.text(list_, box, kHead, line.label);
                canvas_.text(list_, words, kInk, line.value);
            } else if (line.kind == LineKind::Cells) {
                box.y += em_ * 0.3F;
                box.width -= em_ * 0.7F;
                box.height -= em_ * 0.3F;
                canvas_.text(list_, box, kInk, line.label);
            } else {
                canvas_.text(
                    list_, box, line.kind == LineKind::Heading ? kHead : kFaint, line.label);
            }
        }
    }

    void draw_cell(const PlacedCell& placed) {
        const Line& line = menu_.page().lines[placed.place.line];
        const Cell& cell = line.cells[placed.place.cell];
        const Box box = shown_box(placed, menu_.scroll_px());
        if (!placed.pinned && !seen(box)) return;
        const float round = em_ * 0.3F;
        list_.AddRectFilled(
            corner(box), far_corner(box), cell.marked ? kMarked : kCellColor, round);
        if (cell.fraction) {
            Box filled = box;
            filled.width *= std::clamp(*cell.fraction, 0.0F, 1.0F);
            list_.AddRectFilled(corner(filled), far_corner(filled), kFilled, round);
        }
        if (line.kind == LineKind::Cards) {
            draw_card(cell, box);
        } else {
            draw_words(cell, box, line.kind == LineKind::List);
        }
        if (placed.place == menu_.focus()) {
            list_.AddRect(
                corner(box), far_corner(box), kFocus, round, 0, std::max(1.5F, em_ * 0.13F));
        }
    }

    void draw_words(const Cell& cell, const Box& box, bool wide) {
        const float pad = em_ * 0.7F;
        Box text = inset(box, pad, 0.0F);
        if (cell.icon != Icon::None) {
            draw_icon(list_,
                      cell.icon,
                      {text.x + em_ * 0.45F, box.y + std::min(box.height, em_ * 1.75F) * 0.5F},
                      em_ * 0.85F,
                      kInk);
            text.x += em_ * 1.4F;
            text.width -= em_ * 1.4F;
        }
        const float height = canvas_.text_size.height_px(cell.text, text.width);
        const float note_height =
            cell.note.empty() ? 0.0F : canvas_.text_size.height_px(cell.note, text.width);
        text.y = box.y + std::max(0.0F, (box.height - height - note_height) * 0.5F);
        text.height = height;
        if (cell.fraction && !wide) {
            const float width =
                std::min(text.width, std::ceil(canvas_.text_size.width_px(cell.text)) + 2.0F);
            text.x += (text.width - width) * 0.5F;
            text.width = width;
        }
        if (text.bottom() > box.bottom() + 1.5F) canvas_.cut.push_back(cell.text);
        canvas_.text(list_, text, kInk, cell.text);
        text.y += height;
        text.height = note_height;
        canvas_.text(list_, text, kFaint, cell.note);
    }

    void draw_card(const Cell& cell, const Box& box) {
        Box image = box;
        image.height = cell.thumbnail.empty() ? 0.0F : box.width * 9.0F / 16.0F;
        if (const auto uv = canvas_.thumbnail(cell.thumbnail)) {
            list_.AddImageRounded(ImGui::GetIO().Fonts->TexID,
                                  corner(image),
                                  far_corner(image),
                                  uv->from,
                                  uv->to,
                                  IM_COL32_WHITE,
                                  em_ * 0.3F,
                                  ImDrawFlags_RoundCornersTop);
        } else if (image.height > 0.0F) {
            draw_icon(list_,
                      Icon::Scenes,
                      {image.x + image.width * 0.5F, image.y + image.height * 0.5F},
                      em_ * 3.0F,
                      kFaint);
        }
        Box text = inset(box, em_ * 0.7F, 0.0F);
        text.y = image.bottom() + em_ * 0.25F;
        text.height = canvas_.text_size.height_px(cell.text, text.width);
        canvas_.text(list_, text, kInk, cell.text);
        text.y = text.bottom();
        text.height = canvas_.text_size.height_px(cell.note, text.width);
        if (text.bottom() > box.bottom() + 1.5F) canvas_.cut.push_back(cell.note);
        canvas_.text(list_, text, kFaint, cell.note);
    }

    void draw_scroll_bar() {
        const MenuLayout& layout = menu_.layout();
        if (layout.content_height <= layout.view.height) return;
        const float share = layout.view.height / layout.content_height;
        const float at = menu_.scroll_px() / layout.content_height;
        const float x = layout.panel.right() - em_ * 0.45F;
        const float width = em_ * 0.22F;
        list_.AddRectFilled(
            {x, layout.view.y}, {x + width, layout.view.bottom()}, kCellColor, width * 0.5F);
        const float top = layout.view.y + layout.view.height * at;
        list_.AddRectFilled(
            {x, top}, {x + width, top + layout.view.height * share}, kFaint, width * 0.5F);
    }

    ImDrawList& list_;
    Canvas::Impl& canvas_;
    const Menu& menu_;
    float em_;
};

}  // namespace

void Canvas::draw(const Menu& menu) {
    if (!menu.open()) return;
    MenuPainter(*ImGui::GetForegroundDrawList(), *impl_, menu).draw();
}

}  // namespace plumbline::app::ui
