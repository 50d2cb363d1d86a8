// The parts of the overlay, one function each. Private to overlay.cpp.
#pragma once

#include "engine/app/overlay/overlay.h"
#include "engine/app/ui/hud_layout.h"

#include <deque>
#include <string>
#include <string_view>

namespace plumbline::app::panels {

struct Message {
    std::string text;
    double until_s{0};
};

/// What a line says before its first digit.
constexpr std::string_view stem_of(std::string_view text) {
    return text.substr(0, text.find_first_of("0123456789"));
}

/// All that is written over the image in play, but for messages.
ui::HudTexts hud_texts(const OverlayInput& input);
/// The statistics page that is on; none: empty.
std::vector<ui::HudLine> stats_lines(const OverlayInput& input);
std::vector<ui::HudLine> message_lines(const std::deque<Message>& messages,
                                       double now_s,
                                       bool reduce_motion);
/// The aim, the charge of a throw around it, and signs of what is switched on.
void draw_crosshair(const OverlayInput& input, float font_px);
/// At the bottom, in the middle; the height that it takes from the rest, in pixels.
float draw_animation_bar(AnimationBar& bar, float width_px, float height_px, float font_px);
/// `taken_px`: how much of the right edge it needs.
AccuracyRequest draw_accuracy(const AccuracyControl& control,
                              const FrameClock& clock,
                              float font_px,
                              float& taken_px);

}  // namespace plumbline::app::panels
