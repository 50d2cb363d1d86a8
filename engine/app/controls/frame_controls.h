// Actions that belong to frames, not to steps: they change how the world is shown or how its clock
// runs, never the world itself.
#pragma once

#include "engine/app/overlay/overlay.h"
#include "engine/core/time/frame_clock.h"
#include "engine/input/action_latch.h"
#include "engine/platform/window.h"
#include "engine/render/render_frame.h"
#include "engine/scene/game.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace plumbline::app {

/// What the frame actions have set so far, and what they ask for once.
struct FrameControls {
    OverlayParts parts{};
    render::FillMode fill_mode{render::FillMode::Filled};
    bool collision_shapes{false};
    bool collision_boxes{false};
    render::DepthTest depth_test{render::DepthTest::Less};

    // Asked for in this frame; the loop does them and clears them.
    bool quit{false};
    bool reset{false};
    bool reload{false};
    bool screenshot{false};
    bool save_recording{false};
    bool film{false};
    std::optional<int> save_slot;  ///< 0: the one used last
    std::optional<int> load_slot;
    std::filesystem::path open_scene;  ///< chosen in the menu, or dropped

    void clear_requests() {
        quit = reset = reload = screenshot = save_recording = film = false;
        save_slot.reset();
        load_slot.reset();
        open_scene.clear();
    }
};

/// Applies this frame's presses. `say`: one line for the person.
void apply_frame_actions(input::ActionLatch& latch,
                         FrameControls& controls,
                         FrameClock& clock,
                         platform::Window& window,
                         const std::function<void(std::string)>& say);

/// Puts what is toggled (grab, crouch) where a saved game has it: its keys need not be pressed again.
void resume_toggles(const scene::Game& game, input::ActionLatch& latch);

}  // namespace plumbline::app
