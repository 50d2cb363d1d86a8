// Everything drawn over the picture: crosshair, hints, messages, help, statistics, the menu.
// The only user of Dear ImGui. Reads; what the person chose in it is returned.
#pragma once

#include "engine/app/accuracy_control.h"
#include "engine/app/frame_report.h"
#include "engine/core/frame_clock.h"
#include "engine/input/action_latch.h"
#include "engine/platform/window.h"
#include "engine/scene/game.h"
#include "engine/study/gallery/hard_case_judge.h"

#include <memory>
#include <string>

namespace plumbline::app {

/// Which parts are shown.
struct OverlayParts {
    bool hud{true};
    bool help{false};
    bool stats{false};
    bool accuracy{false};
    bool menu{false};
};

/// What was chosen in the menu this frame.
enum class MenuChoice : std::uint8_t { None, Resume, Reset, Controls, Quit };

/// What was asked for in the overlay this frame.
struct OverlayAnswer {
    MenuChoice menu{MenuChoice::None};
    AccuracyRequest accuracy{};
};

/// All that the overlay reads in one frame.
struct OverlayInput {
    const OverlayParts& parts;
    const scene::HudContent& hud;
    const scene::Simulation& simulation;
    const FrameReport& report;
    const FrameClock& clock;
    const input::Bindings& bindings;
    input::LastDevice device;
    const std::vector<effects::LedgerLine>& ledger;
    const AccuracyControl& accuracy;
    const study::HardCaseJudge* judge{nullptr};  ///< of a hard case; null: no such scene
    bool sound_silent{false};
    bool show_hints{true};
    std::size_t lines_not_shown{0};
    double now_s{0};
};

class Overlay {
public:
    /// The window must outlive it. ui_scale 0: from the content scale.
    Overlay(platform::Window& window, float ui_scale);
    ~Overlay();
    Overlay(const Overlay&) = delete;
    Overlay& operator=(const Overlay&) = delete;

    /// Once a frame, after the window was polled: a key that went down and up between two frames
    /// counts as down for one.
    void take_input(const InputSnapshot& input);

    /// A line that fades after some seconds.
    void say(std::string message, double now_s);

    /// Builds and draws into the bound framebuffer.
    OverlayAnswer draw(const OverlayInput& input);

    bool wants_keyboard() const;
    bool wants_mouse() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace plumbline::app
