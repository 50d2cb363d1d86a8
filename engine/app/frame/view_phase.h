// What a frame shows: the world read into a RenderFrame, and the overlay over it.
#pragma once

#include "engine/app/controls/camera_path_control.h"
#include "engine/app/controls/frame_controls.h"
#include "engine/app/frame/scene_opening.h"
#include "engine/app/frame/sound_phase.h"
#include "engine/app/frame/world_phase.h"
#include "engine/app/overlay/first_minute.h"
#include "engine/app/overlay/overlay.h"
#include "engine/app/settings/quality_control.h"
#include "engine/app/ui/menu_control.h"
#include "engine/platform/window.h"

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace plumbline::app {

/// Input as it was in this frame, for the overlay.
struct FrameInput {
    const InputSnapshot& devices;
    const input::ActionLatch& latch;
    const ui::MenuControl& menu;
    std::vector<std::string> faults;  ///< of settings and bindings that were saved, not mended yet
};

/// What the overlay tells of the other phases.
struct OverlayWorld {
    const WorldPhase& world;
    const SoundPhase& sound;
};

class ViewPhase {
public:
    /// State and window must outlive it.
    ViewPhase(FrameState& state,
              platform::Window& window,
              std::unique_ptr<render::Renderer> renderer);

    /// Where the frame is seen from.
    scene::ViewPoint point(Real blend, const FrameInput& input);
    /// The world, read-only, as plain data; the ghost in outlines.
    render::RenderFrame extract(const scene::ViewPoint& view,
                                const FrameInput& input,
                                const AccuracyControl& accuracy);
    void draw_overlay(const render::RenderFrame& frame,
                      const FrameInput& input,
                      const OverlayWorld& world,
                      Requests& requests);
    /// A bar over the frame, while another scene is read.
    void draw_opening(const SceneOpening& opening);
    /// After each frame: chooses what the next one may cost.
    void note_cost(const FrameCost& cost);

    void reload_shaders();
    /// Adds a request where a shader was saved.
    void note_saved_files(double now_s, Requests& requests);
    void save_image();

    /// The person's controls leave the pointer free, and there is something to point at.
    bool pointer_is_free(const input::ActionLatch& latch) const;
    /// Where a free pointer is, as Actions has it.
    std::optional<std::array<float, 2>> pointer_of(const InputSnapshot& input,
                                                   const input::ActionLatch& latch) const;

    render::Renderer& renderer() { return *renderer_; }
    ViewSettings settings;
    Overlay overlay;
    CameraPathControl camera_path;
    FirstMinute hints;

private:
    Real fov_rad(const scene::ViewPoint& view) const;

    FrameState& state_;
    Session& session_;
    platform::Window& window_;
    std::unique_ptr<render::Renderer> renderer_;
    platform::FileWatch shader_watch_;
    QualityRequest quality_request_;
    QualityControl quality_;
    bool said_software_{false};
};

}  // namespace plumbline::app
