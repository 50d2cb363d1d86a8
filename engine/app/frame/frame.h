// The phases of a frame, wired once: input, world, view, sound, present. Each owns its state; what one
// hands to the next is named in frame_loop.cpp.
#pragma once

#include "engine/app/frame/film.h"
#include "engine/app/frame/input_phase.h"
#include "engine/app/frame/present_phase.h"
#include "engine/app/frame/scene_opening.h"
#include "engine/app/frame/sound_phase.h"
#include "engine/app/frame/view_phase.h"
#include "engine/app/frame/world_phase.h"

#include <memory>

namespace plumbline::app {

struct Frame {
    static Result<std::unique_ptr<Frame>> create(platform::Window& window, const Play& play);
    Frame(platform::Window& window_shown,
          const Play& play,
          Stepper stepper,
          std::unique_ptr<render::Renderer> renderer);

    bool ended() const;
    /// The recording and the report, each once. False where one of them failed.
    bool write_files();
    /// Writes what was asked for.
    PlayEnd close();

    platform::Window& window;
    FrameState state;
    WorldPhase world;
    SceneOpening opening;
    SoundPhase sound;
    ViewPhase view;
    InputPhase input;
    PresentPhase present;
    Film film;
    std::optional<std::string> report_text{};  ///< once the files are written
};

/// Does what was asked for since the frame before, in order, and empties the list. The one place where
/// keys of the frame, the menu and the panels change the world or the program.
void apply(Requests& requests, Frame& frame);

/// While it lives, the frame's files are written also when the program ends by exit(): Xlib does that
/// when its display goes, from within whatever called it.
class CloseAtExit {
public:
    explicit CloseAtExit(Frame& frame);
    ~CloseAtExit();
    CloseAtExit(const CloseAtExit&) = delete;
    CloseAtExit& operator=(const CloseAtExit&) = delete;
};

}  // namespace plumbline::app
