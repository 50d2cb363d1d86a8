// Everything drawn over the image: crosshair, hints, messages, statistics, the accuracy panel and
// the menu. With ui/ the only user of Dear ImGui. Reads the world; what is chosen becomes requests.
#pragma once

#include "engine/app/accuracy/accuracy_control.h"
#include "engine/app/controls/frame_controls.h"
#include "engine/app/frame_report.h"
#include "engine/app/overlay/first_minute.h"
#include "engine/app/request.h"
#include "engine/app/ui/canvas.h"
#include "engine/core/time/frame_clock.h"
#include "engine/input/action_latch.h"
#include "engine/platform/window.h"
#include "engine/scene/game.h"
#include "engine/study/gallery/hard_case_judge.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace plumbline::app {

namespace ui {
class MenuControl;
}

/// The bar under a model with animations.
struct AnimationBar {
    std::string name;
    double length_s{0};
    double time_s{0};
    bool paused{false};
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
    std::optional<double> best_s{};              ///< in which the scene's goal was reached before
    bool replaying{false};
    std::optional<FirstStep> hint{};  ///< what to do next, for who has not yet
    bool reduce_motion{false};
    std::vector<ui::HudLine> messages{};
    std::vector<std::string> faults{};  ///< of files that were saved: shown until they are mended
    std::size_t lines_not_shown{0};
    std::vector<std::string> captions{};      ///< of sounds
    std::string camera_path{};                ///< what is done with one; empty: nothing
    std::optional<AnimationBar> animation{};  ///< absent: the scene is no model that moves
};

class Overlay {
public:
    /// The window must outlive it. `thumbnails`: a folder of NAME.jpg for scenes NAME.
    Overlay(platform::Window& window, const std::filesystem::path& thumbnails);
    ~Overlay();
    Overlay(const Overlay&) = delete;
    Overlay& operator=(const Overlay&) = delete;

    /// Once a frame, after the window was polled: letters and pages for the window as it is now.
    void follow_window(float ui_scale, ui::MenuControl& menu);

    /// Builds and draws into the bound framebuffer; adds what was chosen.
    void draw(const OverlayInput& input,
              const InputSnapshot& devices,
              const ui::MenuControl& menu,
              Requests& requests);

    /// A panel of the last frame lies there, or holds the pointer: a click is not for the game.
    bool takes_pointer(double x_px, double y_px) const;
    /// A list of choices is open: arrows, Enter and Escape are for it.
    bool takes_keys() const;

private:
    platform::Window& window_;
    ui::Canvas canvas_;
};

}  // namespace plumbline::app
