// Where the HUD's texts stand: pure arithmetic, so that a test can ask for any window.
#pragma once

#include "engine/app/ui/menu_layout.h"

#include <cstdint>
#include <string>
#include <vector>

namespace plumbline::app::ui {

enum class Tone : std::uint8_t { Plain, Head, Good, Bad, Faint };

struct HudLine {
    std::string text;
    Tone tone{Tone::Plain};
    float alpha{1.0F};
    std::string value{};         ///< at the right edge; such a line is as wide as its panel may be
    float share{0.0F};           ///< how much of the line is filled behind the text: a bar
    std::vector<float> graph{};  ///< columns below the text, oldest first; as wide as may be
    float graph_top{1.0F};       ///< value at the graph's upper edge
    float graph_budget{0.0F};    ///< value at which a line goes across
};

/// What is written over the image; an empty list: nothing of it.
struct HudTexts {
    std::vector<HudLine> status;    ///< top left: what is not as usual
    std::vector<HudLine> verdict;   ///< below it: how a hard case stands
    std::vector<HudLine> side;      ///< top right: frame statistics
    std::vector<HudLine> target;    ///< below the crosshair: what is looked at
    std::vector<HudLine> messages;  ///< above the captions, newest last; the oldest go first
    std::vector<HudLine> captions;  ///< above the hint: what is heard
    std::vector<HudLine> hint;      ///< at the bottom
};

struct PlacedText {
    HudLine line;
    Box box;  ///< wraps at its width
};

/// Who reads captions does not hear: in small windows they are larger than the rest.
inline constexpr float kLeastCaption_px = 14.0F;

struct HudPanel {
    Box box;
    float scale{1.0F};  ///< of the font
    std::vector<PlacedText> texts;
};

struct HudLayout {
    HudPanel status;
    HudPanel verdict;
    HudPanel side;
    HudPanel target;
    HudPanel messages;
    HudPanel captions;
    HudPanel hint;
};

/// `right_taken_px`: at the right edge, for a panel with things to choose in it.
HudLayout layout_of(const HudTexts& texts,
                    float width_px,
                    float height_px,
                    float font_px,
                    float right_taken_px,
                    const TextSize& text);

}  // namespace plumbline::app::ui
