// What frame_loop.cpp steps through: the parts of a session, wired once. Private to it.
#pragma once

#include "engine/app/capture/video_file.h"
#include "engine/app/controls/camera_path_control.h"
#include "engine/app/controls/frame_controls.h"
#include "engine/app/frame_loop.h"
#include "engine/app/menu_sounds.h"
#include "engine/app/overlay/captions.h"
#include "engine/app/overlay/first_minute.h"
#include "engine/app/overlay/overlay.h"
#include "engine/app/scene_watch.h"
#include "engine/app/settings/quality_control.h"
#include "engine/app/slow_motion.h"
#include "engine/app/ui/menu_control.h"
#include "engine/audio/mixer.h"
#include "engine/core/log.h"
#include "engine/core/time/frame_clock.h"
#include "engine/render/renderer.h"
#include "engine/scene/paths/scene_list.h"

#include <future>
#include <memory>
#include <new>

namespace plumbline::app {

/// So many fields because each part of the frame is one: the frame is what joins them.
class FrameParts {
public:
    static Result<std::unique_ptr<FrameParts>> create(platform::Window& window,
                                                      Session& session,
                                                      LiveBindings& bindings,
                                                      LiveConfig& config,
                                                      const PlayDef& def);

    bool ended(double now_s) const;
    void take_input(const InputSnapshot& input);
    void do_requests();  ///< reset, reload, images, recordings: what frame actions asked for
    void run_steps(const FrameTime& time);
    scene::ViewPoint view(Real blend);
    render::RenderFrame extract(const scene::ViewPoint& view);
    void draw_overlay(const render::RenderFrame& frame);
    void draw_opening();  ///< over the frame, while another scene is read
    void film_frame();    ///< while a film is taken: hands the image to its thread
    void play_sound(const scene::ViewPoint& view, double now_s);
    void finish_frame(double frame_start_s, double present_s);
    /// Writes what was asked for.
    PlayEnd close();
    /// The recording and the report, each once. False where one of them failed.
    bool write_files();

    FrameClock clock;
    input::ActionLatch latch;
    FrameReport report;
    Stepper stepper;
    std::unique_ptr<render::Renderer> renderer;

private:
    FrameParts(platform::Window& window,
               Session& session,
               LiveBindings& bindings,
               LiveConfig& config,
               const PlayDef& def,
               Stepper stepper,
               std::unique_ptr<render::Renderer> renderer);
    void say(std::string line);  ///< to the person, in the overlay
    void say_faults();
    void begin_opening();
    void take_opened();
    void end_with(ExitCode code, const std::string& why);
    void reload_settings(double now_s);
    void reload_shaders();
    /// Those of saved files that are not mended yet, for the screen.
    std::vector<std::string> standing_faults() const;
    bool looks_at_model() const;  ///< a model by itself is turned, nobody plays
    void reset_scene();
    void reload_files();
    void reload_scene();
    void reload_what_was_saved(double now_s);
    void say_slow_motion();
    void save_image();
    void save_game(int slot);
    void load_game(int slot);
    std::vector<ui::SaveSlot> save_slots() const;
    std::filesystem::path file_of_slot(int slot) const;
    void save_recording_so_far();
    void start_or_end_film();
    void end_film();
    std::string scene_name() const;
    /// Puts the settings in force; said once when they cannot be stored.
    void change_config(const AppConfig& wanted);
    void apply_config();
    void change_bindings(const input::Bindings& wanted);
    void do_accuracy(const AccuracyRequest& asked);
    void say_not_stored(const Result<Done>& stored);
    ui::MenuWorld menu_world();
    /// The world stands still from the frame after the one that opened a menu: what was pressed
    /// before it still reaches a step.
    void pause_under_menu();
    /// The person's controls leave the pointer free, and there is something to point at.
    bool pointer_is_free() const;
    std::optional<std::array<float, 2>> pointer_of(const InputSnapshot& input) const;
    void capture_pointer_if_playing(const InputSnapshot& input);
    std::array<std::uint64_t, kActionCount> actions_seen() const;

    platform::Window& window_;
    Session& session_;
    LiveBindings& bindings_;
    LiveConfig& config_;
    const PlayDef& def_;
    FrameControls controls_;
    AccuracyControl accuracy_;
    std::vector<scene::ListedScene> scenes_;
    SceneWatch scene_watch_;
    platform::FileWatch shader_watch_;
    // Why the latest save was refused or has faults; empty: it has none.
    std::string scene_fault_;
    std::string bindings_fault_;
    std::string config_fault_;
    Overlay overlay_;
    CameraPathControl camera_path_;
    Captions captions_;
    MenuSounds menu_sounds_;
    ui::MenuControl menu_;
    FirstMinute first_minute_;
    InputSnapshot devices_;  ///< of this frame
    QualityRequest quality_request_;
    QualityControl quality_control_;
    std::unique_ptr<audio::Mixer> mixer_;      ///< null with --no-sound
    std::vector<effects::LedgerLine> ledger_;  ///< refreshed for the statistics panel
    double start_s_;
    SlowMotion slow_motion_;
    std::unique_ptr<Session> next_;                          ///< that was chosen; null: none
    std::future<Result<std::unique_ptr<Session>>> opening_;  ///< on a thread; invalid: nothing is
    double chosen_s_{0};
    std::string report_text_;
    std::unique_ptr<VideoFile> film_;  ///< null: none is taken
    double film_next_s_{0};            ///< then the next frame is due
    int save_slot_{1};                 ///< used last
    bool resumes_toggles_{true};       ///< before the next step: after a start and a load
    bool closing_{false};
    ExitCode code_{ExitCode::Good};  ///< not good: why it cannot go on
    bool menu_was_open_{false};
    bool paused_before_menu_{false};
    bool written_{false};
    bool wants_pointer_{true};
    bool said_not_stored_{false};
    bool said_software_{false};
};

/// A scene that needs more memory than there is costs a line, not the one that runs.
template <class Build>
Result<Done> within_memory(const Build& build) {
    try {
        return build();
    } catch (const std::bad_alloc&) {
        const char* message = "not enough memory for this scene; the current scene stays open";
        log_error("{}", message);
        return Error{.message = message};
    }
}

/// While it lives, the parts' files are written also when the program ends by exit(): Xlib does that
/// when its display goes, from within whatever called it.
class CloseAtExit {
public:
    explicit CloseAtExit(FrameParts& parts);
    ~CloseAtExit();
    CloseAtExit(const CloseAtExit&) = delete;
    CloseAtExit& operator=(const CloseAtExit&) = delete;
};

}  // namespace plumbline::app
