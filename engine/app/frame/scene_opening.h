// Another scene, read on a thread beside the one that runs.
#pragma once

#include "engine/app/frame/play_def.h"

#include <future>
#include <memory>

namespace plumbline::app {

class SceneOpening {
public:
    /// Nothing happens while one is being opened.
    void begin(const PlayDef& def, const std::filesystem::path& file);
    /// Once a frame. The error is why the scene was refused: the one that runs goes on.
    Result<Done> update();

    bool running() const { return opening_.valid(); }
    bool opened() const { return next_ != nullptr; }
    std::unique_ptr<Session> take() { return std::move(next_); }
    double chosen_s() const { return chosen_s_; }  ///< by wall_s()

private:
    std::unique_ptr<Session> next_;
    std::future<Result<std::unique_ptr<Session>>> opening_;
    double chosen_s_{0};
};

}  // namespace plumbline::app
