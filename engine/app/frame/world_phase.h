// The world in play: its fixed steps, and all that changes it between them.
#pragma once

#include "engine/app/accuracy/accuracy_control.h"
#include "engine/app/frame/frame_state.h"
#include "engine/app/frame/saved_games.h"
#include "engine/app/request.h"
#include "engine/app/scene_watch.h"
#include "engine/app/settings/best_results.h"
#include "engine/app/slow_motion.h"
#include "engine/scene/paths/scene_list.h"

#include <string>
#include <vector>

namespace plumbline::app {

class WorldPhase {
public:
    /// The state must outlive it.
    WorldPhase(FrameState& state, Stepper stepper);

    // What was asked for, one function each; each tells the person what became of it.
    void apply(const WorldRequest& request);
    bool reload_scene();  ///< true: the world is another one
    void save_game(int slot);
    void load_game(int slot);
    void save_recording();
    void adopt_accuracy();
    void save_level();
    void start_ghost(const StartGhost& asked);
    void start_picture_study();

    /// Adds a request where a file of the scene was saved.
    void note_saved_files(double now_s, Requests& requests);
    void run_steps(const FrameTime& time, input::ActionLatch& latch);
    /// The world waits for its ghost, so that both begin together.
    bool waits_for_ghost() const;

    Stepper stepper;
    AccuracyControl accuracy;
    SavedGames saves;
    BestResults results;
    std::vector<scene::ListedScene> scenes;  ///< for the menu
    std::string scene_fault;  ///< why the latest save of the scene was refused; empty: it was not

private:
    bool refuses_in_replay();
    void watch_slow_motion(const input::ActionLatch& latch);

    FrameState& state_;
    Session& session_;
    SceneWatch scene_watch_;
    SlowMotion slow_motion_;
    bool resumes_toggles_{true};  ///< before the next step: after a start and a load
};

}  // namespace plumbline::app
