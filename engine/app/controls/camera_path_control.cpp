#include "engine/app/controls/camera_path_control.h"

#include "engine/app/capture/screenshot.h"
#include "engine/app/controls/key_labels.h"
#include "engine/core/io/files.h"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace plumbline::app {
namespace {

constexpr std::array kWalking{Action::Forward,
                              Action::Back,
                              Action::Left,
                              Action::Right,
                              Action::MoveMode,
                              Action::RotateLeft,
                              Action::RotateRight};

constexpr const char* kNoFolder =
    "no folder for camera paths: neither XDG_DATA_HOME nor HOME is set";

bool walks(input::ActionLatch& latch) {
    bool any = false;
    for (const Action action : kWalking) any = latch.take_frame_presses(action) > 0 || any;
    return any;
}

}  // namespace

CameraPathControl::CameraPathControl(CameraPathDef def, Say say)
    : def_(std::move(def)), say_(std::move(say)) {
    playing_ = !def_.file.empty() && read();
}

std::filesystem::path CameraPathControl::file() const {
    if (!def_.file.empty()) return def_.file;
    return def_.folder.empty() ? def_.folder : def_.folder / (def_.scene + ".path");
}

bool CameraPathControl::read() {
    if (file().empty()) {
        say_(kNoFolder);
        return false;
    }
    Result<scene::CameraPath> path = scene::CameraPath::read(file());
    if (!path) {
        say_(path.error().message);
        return false;
    }
    path_ = std::move(*path);
    playing_ = false;  // where it had got to was a place on the former path
    say_(fmt::format("camera path loaded ({:.1f} s): {}", path_.length_s(), file().string()));
    return true;
}

void CameraPathControl::begin_recording() {
    playing_ = false;
    if (def_.folder.empty()) return say_(kNoFolder);
    recording_.emplace();
    at_s_ = 0;
    say_("recording the camera path; press the same key to stop");
}

Result<Done> CameraPathControl::save() {
    def_.file.clear();  // from now on the recording is the path in use
    std::error_code failed;
    if (std::filesystem::exists(file(), failed)) {
        // Nothing that was recorded is lost by recording again.
        std::filesystem::rename(file(), unused_file(def_.folder, def_.scene, ".path"), failed);
        if (failed)
            return Error{.message = fmt::format("{}: {}", file().string(), failed.message())};
    }
    return write_file_and_folder(file(), path_.text());
}

void CameraPathControl::end_recording() {
    if (!recording_) return;
    scene::CameraPath recorded = std::move(*recording_);
    recording_.reset();
    if (recorded.size() < 2) return say_("empty camera path: nothing was recorded");
    path_ = std::move(recorded);
    const Result<Done> saved = save();
    say_(saved ? fmt::format("camera path saved ({:.1f} s): {}", path_.length_s(), file().string())
               : saved.error().message);
}

void CameraPathControl::play(const std::string& record_key) {
    end_recording();
    std::error_code ignored;
    if (path_.empty() && !file().empty() && std::filesystem::exists(file(), ignored)) read();
    if (path_.empty())
        return say_(
            fmt::format("this scene has no camera path yet; record one with {}", record_key));
    playing_ = true;
    at_s_ = 0;
}

void CameraPathControl::apply(input::ActionLatch& latch, double now_s) {
    const bool walked = walks(latch);
    if (playing_ && walked) playing_ = false;
    if (latch.take_frame_presses(Action::CameraReload) > 0 && !recording_) read();
    if (latch.take_frame_presses(Action::CameraRecord) % 2 == 1) {
        if (recording_)
            end_recording();
        else
            begin_recording();
    }
    if (latch.take_frame_presses(Action::CameraPlay) % 2 == 1) {
        if (playing_)
            playing_ = false;
        else
            play(hint_for(latch.bindings(), Action::CameraRecord, latch.last_device()));
    }
    if (!last_s_) last_s_ = now_s;
}

scene::ViewPoint CameraPathControl::see(const scene::ViewPoint& view, double now_s, bool held) {
    const double passed_s = held || !last_s_ ? 0.0 : now_s - *last_s_;
    last_s_ = now_s;
    if (recording_) {
        if (!recording_->empty()) at_s_ += passed_s;
        const bool full = recording_->size() >= scene::CameraPath::kMostPoses;
        if (!held) recording_->add(at_s_, view.world_from_camera);
        if (full) end_recording();
        return view;
    }
    if (!playing_) return view;
    scene::ViewPoint seen = view;
    seen.world_from_camera = path_.at(at_s_);
    const Pose camera_from_hand = compose(invert(view.world_from_camera), view.world_from_hand);
    seen.world_from_hand = compose(seen.world_from_camera, camera_from_hand);
    seen.velocity_mps = {0, 0, 0};
    if (at_s_ >= path_.length_s()) playing_ = false;
    at_s_ += passed_s;
    return seen;
}

std::string CameraPathControl::status() const {
    if (recording_) return fmt::format("recording camera path: {:.1f} s", at_s_);
    if (!playing_) return {};
    return fmt::format("playing camera path: {:.1f} / {:.1f} s", at_s_, path_.length_s());
}

}  // namespace plumbline::app
