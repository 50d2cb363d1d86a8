// The camera's path in play: recorded, played and read again. It moves the image alone; the world and
// whoever walks in it know nothing of it.
#pragma once

#include "engine/input/action_latch.h"
#include "engine/scene/camera_path.h"
#include "engine/scene/game.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace plumbline::app {

struct CameraPathDef {
    std::filesystem::path folder;  ///< where recordings go: FOLDER/SCENE.path; empty: nowhere
    std::string scene;
    std::filesystem::path file;  ///< read in place of the recording; it plays at once; empty: none
};

class CameraPathControl {
public:
    using Say = std::function<void(std::string)>;

    CameraPathControl(CameraPathDef def, Say say);

    /// Once a frame, before see(): what was pressed. Walking ends a path that plays.
    void apply(input::ActionLatch& latch, double now_s);
    /// Where the frame is seen from: from the path while one plays. Keeps the view while one is
    /// recorded. Time that passes while `held` is none.
    scene::ViewPoint see(const scene::ViewPoint& view, double now_s, bool held);
    /// "recording the camera: 3.2 s", or empty.
    std::string status() const;
    /// Saves what is being recorded, if anything is.
    void end_recording();

    bool recording() const { return recording_.has_value(); }
    bool playing() const { return playing_; }
    const scene::CameraPath& path() const { return path_; }

private:
    void begin_recording();
    void play(const std::string& record_key);
    /// What is in use stays where the file cannot be read.
    bool read();
    std::filesystem::path file() const;
    /// As read() finds it; an earlier one gets another name.
    Result<Done> save();

    CameraPathDef def_;
    Say say_;
    scene::CameraPath path_;
    std::optional<scene::CameraPath> recording_{};
    bool playing_{false};
    double at_s_{0};  ///< since the recording or the playing began
    std::optional<double> last_s_{};
};

}  // namespace plumbline::app
