// The parts of the overlay, one function each. Private to overlay.cpp.
#pragma once

#include "engine/app/overlay/overlay.h"
#include "engine/app/ui/hud_layout.h"

#include <string>

namespace plumbline::app::panels {

/// All that is written over the image in play, but for messages.
ui::HudTexts hud_texts(const OverlayInput& input);
/// The statistics page that is on; none: empty.
std::vector<ui::HudLine> stats_lines(const OverlayInput& input);
/// The aim, the charge of a throw around it, and signs of what is switched on.
void draw_crosshair(const OverlayInput& input, float font_px);
/// At the bottom, in the middle; returns the height that it takes from the rest, in pixels.
float draw_animation_bar(const AnimationBar& bar, float font_px, Requests& requests);

/// What the accuracy panel shows.
struct AccuracyPanel {
    const AccuracyControl& control;
    const FrameClock& clock;
    bool replaying{false};
    bool is_hard_case{false};
};
/// Returns how much of the right edge it needs, in pixels.
float draw_accuracy(const AccuracyPanel& shown, float font_px, Requests& requests);

}  // namespace plumbline::app::panels
