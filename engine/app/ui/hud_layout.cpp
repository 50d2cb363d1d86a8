#include "engine/app/ui/hud_layout.h"

#include <algorithm>
#include <cmath>

namespace plumbline::app::ui {
namespace {

constexpr float kMargin = 0.8F;  // of the font's size
constexpr float kPad = 0.5F;
constexpr float kPanelGap = 0.5F;
constexpr float kSideWidth = 27.0F;
constexpr float kGraph = 2.4F;  // height

class Placer {
public:
    Placer(float font_px, const TextSize& text) : em_(font_px), text_(text) {}

    /// Lines below each other, no wider than `most_px` with the panel's padding; at the origin.
    /// `scale`: of the font.
    HudPanel stack(const std::vector<HudLine>& lines, float most_px, float scale = 1.0F) const {
        HudPanel panel{.scale = scale};
        if (lines.empty()) return panel;
        const float em = scale * em_;
        const float pad = kPad * em;
        const float wrap = std::max(em, most_px - 2 * pad);
        float widest = 0.0F;
        float y = pad;
        for (const HudLine& line : lines) {
            const bool is_wide = !line.value.empty() || !line.graph.empty();
            const float width =
                is_wide ? wrap
                        : std::min(wrap, std::ceil(scale * text_.width_px(line.text)) + 1.0F);
            const float for_value = line.value.empty() ? 0.0F : text_.width_px(line.value) + em_;
            const float graph = line.graph.empty() ? 0.0F : kGraph * em;
            const float height =
                scale * text_.height_px(line.text, std::max(em_, width / scale - for_value)) +
                graph;
            panel.texts.push_back({line, {pad, y, width, height}});
            widest = std::max(widest, width);
            y += height + em * 0.1F;
        }
        panel.box = {0.0F, 0.0F, widest + 2 * pad, y + pad};
        return panel;
    }

    static void move(HudPanel& panel, float x, float y) {
        for (PlacedText& text : panel.texts) {
            text.box.x += x - panel.box.x;
            text.box.y += y - panel.box.y;
        }
        panel.box.x = x;
        panel.box.y = y;
    }

private:
    float em_;
    const TextSize& text_;
};

/// As many columns as it takes for no line to stand below `most_height_px`.
HudPanel columns_of(const std::vector<HudLine>& lines,
                    const Placer& place,
                    float column_px,
                    float most_width_px,
                    float most_height_px) {
    const auto most =
        static_cast<std::size_t>(std::max(1.0F, std::floor(most_width_px / column_px)));
    const float width = std::min(column_px, most_width_px);
    for (std::size_t columns = 1;; ++columns) {
        const std::size_t each = (lines.size() + columns - 1) / columns;
        HudPanel all;
        float x = 0.0F;
        for (std::size_t first = 0; first < lines.size(); first += each) {
            const std::size_t last = std::min(lines.size(), first + each);
            HudPanel column = place.stack({lines.begin() + static_cast<std::ptrdiff_t>(first),
                                           lines.begin() + static_cast<std::ptrdiff_t>(last)},
                                          width);
            Placer::move(column, x, 0.0F);
            x = column.box.right();
            all.box.width = x;
            all.box.height = std::max(all.box.height, column.box.height);
            all.texts.insert(all.texts.end(), column.texts.begin(), column.texts.end());
        }
        if (all.box.height <= most_height_px || columns >= most) return all;
    }
}

/// Where captions and messages may be, px.
struct MessageRoom {
    float middle_x;
    float width;
    float height;  ///< of the window
    float above_hint;
    float gap;
    float font;
};

/// Messages grow upwards from the captions and stay clear of what the crosshair names. Where there is
/// no room the oldest go, of the messages first.
void place_messages(const HudTexts& texts,
                    const Placer& place,
                    const MessageRoom& room,
                    HudLayout& out) {
    std::vector<HudLine> captions = texts.captions;
    std::vector<HudLine> messages = texts.messages;
    const float top =
        texts.side.empty() ? room.height * 0.5F + room.font * 3.4F : room.height * 0.72F;
    float bottom = 0.0F;
    for (;;) {
        out.captions = place.stack(captions,
                                   std::min(room.width, room.font * 40.0F),
                                   std::max(1.0F, kLeastCaption_px / room.font));
        Placer::move(out.captions,
                     room.middle_x - out.captions.box.width * 0.5F,
                     room.above_hint - out.captions.box.height);
        const float above_captions =
            captions.empty() ? room.height * 0.86F : out.captions.box.y - room.gap;
        bottom = texts.hint.empty() || !captions.empty()
                     ? std::min(above_captions, room.height * 0.86F)
                     : out.hint.box.y - room.gap;
        out.messages = place.stack(messages, std::min(room.width, room.font * 56.0F));
        if (out.messages.box.height <= bottom - top) break;
        std::vector<HudLine>& longer = messages.size() > 1 ? messages : captions;
        if (longer.size() <= 1) break;
        longer.erase(longer.begin());
    }
    Placer::move(out.messages,
                 room.middle_x - out.messages.box.width * 0.5F,
                 bottom - out.messages.box.height);
}

}  // namespace

HudLayout layout_of(const HudTexts& texts,
                    float width_px,
                    float height_px,
                    float font_px,
                    float right_taken_px,
                    const TextSize& text) {
    const Placer place(font_px, text);
    const float margin = kMargin * font_px;
    const float gap = kPanelGap * font_px;
    const float free_width = width_px - 2 * margin - right_taken_px;
    const float middle_x = margin + free_width * 0.5F;
    HudLayout out;
    out.status = place.stack(texts.status, free_width);
    Placer::move(out.status, margin, margin);

    out.hint = place.stack(texts.hint, free_width);
    Placer::move(
        out.hint, middle_x - out.hint.box.width * 0.5F, height_px - margin - out.hint.box.height);

    out.target = place.stack(texts.target, width_px * 0.5F);
    Placer::move(
        out.target, (width_px - out.target.box.width) * 0.5F, height_px * 0.5F + font_px * 0.9F);

    const float above_hint =
        texts.hint.empty() ? height_px - margin - font_px : out.hint.box.y - gap;
    place_messages(texts,
                   place,
                   {.middle_x = middle_x,
                    .width = free_width,
                    .height = height_px,
                    .above_hint = above_hint,
                    .gap = gap,
                    .font = font_px},
                   out);

    const float below_status = texts.status.empty() ? margin : out.status.box.bottom() + gap;
    out.verdict = place.stack(texts.verdict, std::min(free_width, font_px * 34.0F));
    Placer::move(out.verdict, margin, below_status);

    const float side_top = texts.verdict.empty() ? below_status : out.verdict.box.bottom() + gap;
    float lowest = height_px - margin;
    for (const HudPanel* below : {&out.messages, &out.captions, &out.hint})
        if (!below->texts.empty()) lowest = std::min(lowest, below->box.y - gap);
    out.side = columns_of(
        texts.side, place, kSideWidth * font_px, free_width, std::max(0.0F, lowest - margin));
    const float side_x = margin + free_width - out.side.box.width;
    const bool clear = side_x > std::max(out.status.box.right(), out.verdict.box.right());
    if (!clear) {
        out.side = columns_of(
            texts.side, place, kSideWidth * font_px, free_width, std::max(0.0F, lowest - side_top));
    }
    Placer::move(out.side, margin + free_width - out.side.box.width, clear ? margin : side_top);
    return out;
}

}  // namespace plumbline::app::ui
