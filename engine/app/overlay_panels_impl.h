// The parts of the overlay, one function each. Private to overlay.cpp.
#pragma once

#include "engine/app/overlay.h"

#include <deque>
#include <string>

namespace plumbline::app::panels {

struct Message {
    std::string text;
    double until_s{0};
};

void text(const std::string& line);  ///< as it is, no format characters
void apply_style(float scale);
void draw_crosshair(const scene::HudContent& hud);
/// The keys that matter, by their printed names; shown for the first seconds, then only H's.
void draw_hints(const OverlayInput& input, double shown_s);
/// What is chosen, paused, slowed, lost: only what is not as usual.
void draw_status(const OverlayInput& input);
void draw_verdict(const OverlayInput& input);  ///< of a hard case: how each rule stands
void draw_messages(const std::deque<Message>& messages, double now_s);
void draw_help(const OverlayInput& input);
void draw_stats(const OverlayInput& input);
MenuChoice draw_menu(const OverlayInput& input);
AccuracyRequest draw_accuracy(const AccuracyControl& control, const FrameClock& clock);

}  // namespace plumbline::app::panels
