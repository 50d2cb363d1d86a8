// The parts of the overlay, one function each. Private to overlay.cpp.
#pragma once

#include "engine/app/overlay/overlay.h"
#include "engine/app/ui/hud_layout.h"
#include "engine/study/scenes/scene_text.h"

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
    double tolerance{study::kUsualTolerance};  ///< to begin with
};
/// What settings cost and how far off they are in this scene, and the buttons that measure it.
void draw_study(const AccuracyPanel& shown, Requests& requests);
/// A paragraph.
void draw_text(const std::string& text);
/// What a ghost of it runs at: four times the rate, twice the sub-steps, double precision.
study::Setting finer(study::Setting setting);
/// Returns how much of the right edge it needs, in pixels.
float draw_accuracy(const AccuracyPanel& shown, float font_px, Requests& requests);

}  // namespace plumbline::app::panels
