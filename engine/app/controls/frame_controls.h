// Actions that belong to frames, not to steps: they change how the world is shown or how its clock
// runs, never the world itself.
#pragma once

#include "engine/app/request.h"
#include "engine/core/time/frame_clock.h"
#include "engine/input/action_latch.h"
#include "engine/render/render_frame.h"
#include "engine/scene/game.h"

#include <cstdint>
#include <functional>
#include <string>

namespace plumbline::app {

/// The statistics key goes through them.
enum class StatsPage : std::uint8_t { Off, Summary, FullTable };

constexpr StatsPage next(StatsPage page) {
    return page == StatsPage::FullTable ? StatsPage::Off
                                        : static_cast<StatsPage>(static_cast<int>(page) + 1);
}

/// Which parts of the overlay are shown.
struct OverlayParts {
    bool hud{true};
    StatsPage stats{StatsPage::Off};
    bool accuracy{false};
};

/// How the world is shown.
struct ViewSettings {
    OverlayParts parts{};
    render::FillMode fill_mode{render::FillMode::Filled};
    bool collision_shapes{false};
    bool collision_boxes{false};
    render::DepthTest depth_test{render::DepthTest::Less};
};

/// Applies this frame's presses, and adds what they ask for. `say`: one line for the person.
void apply_frame_actions(input::ActionLatch& latch,
                         ViewSettings& view,
                         FrameClock& clock,
                         Requests& requests,
                         const std::function<void(std::string)>& say);

/// Puts what is toggled (grab, crouch) where a saved game has it: its keys need not be pressed again.
void resume_toggles(const scene::Game& game, input::ActionLatch& latch);

}  // namespace plumbline::app
