// Everything drawn over the image: crosshair, hints, messages, statistics, the accuracy panel and
// the menu. With ui/ the only user of Dear ImGui. Reads; what was chosen in it is returned or, on
// the pages of the menu, done by what the pages were given.
#pragma once

#include "engine/app/accuracy/accuracy_control.h"
#include "engine/app/frame_report.h"
#include "engine/app/overlay/first_minute.h"
#include "engine/core/time/frame_clock.h"
#include "engine/input/action_latch.h"
#include "engine/platform/window.h"
#include "engine/scene/game.h"
#include "engine/study/gallery/hard_case_judge.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace plumbline::app {

namespace ui {
class MenuControl;
}

/// The statistics key goes through them.
enum class StatsPage : std::uint8_t { Off, Summary, FullTable };

constexpr StatsPage next(StatsPage page) {
    return page == StatsPage::FullTable ? StatsPage::Off
                                        : static_cast<StatsPage>(static_cast<int>(page) + 1);
}

/// Which parts are shown.
struct OverlayParts {
    bool hud{true};
    StatsPage stats{StatsPage::Off};
    bool accuracy{false};
};

/// The bar under a model with animations: what it shows, and what was done with it.
struct AnimationBar {
    std::string name;
    double length_s{0};
    double time_s{0};  ///< dragging the bar sets it
    bool paused{false};
    bool next{false};  ///< the next animation was asked for
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
    std::optional<FirstStep> hint{};             ///< what to do next, for who has not yet
    bool sound_silent{false};
    bool reduce_motion{false};
    std::vector<std::string> faults{};  ///< of files that were saved: shown until they are mended
    std::size_t lines_not_shown{0};
    std::vector<std::string> captions{};  ///< of sounds
    std::string camera_path{};            ///< what is done with one; empty: nothing
    AnimationBar* animation{nullptr};     ///< null: the scene is no model that moves
    double now_s{0};
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

    /// A line that fades after some seconds; longer ones stay longer.
    void say(std::string message, double now_s);
    /// The same, in place of one that begins so as far as to its first digit: "light: 80 %".
    void say_latest(std::string message, double now_s);

    /// Builds and draws into the bound framebuffer.
    AccuracyRequest draw(const OverlayInput& input,
                         const InputSnapshot& devices,
                         const ui::MenuControl& menu);

    bool wants_mouse() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace plumbline::app
