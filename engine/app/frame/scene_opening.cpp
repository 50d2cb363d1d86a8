#include "engine/app/frame/scene_opening.h"

#include "engine/core/time/stopwatch.h"

#include <chrono>

namespace plumbline::app {

void SceneOpening::begin(const PlayDef& def, const std::filesystem::path& file) {
    if (running()) return;
    chosen_s_ = wall_s();
    opening_ = std::async(std::launch::async | std::launch::deferred,
                          [open = def.open_scene, file] { return open(file); });
}

Result<Done> SceneOpening::update() {
    if (!running() || opening_.wait_for(std::chrono::seconds(0)) == std::future_status::timeout)
        return Done{};
    Result<std::unique_ptr<Session>> opened = opening_.get();
    if (!opened) return opened.error();
    next_ = std::move(*opened);
    return Done{};
}

}  // namespace plumbline::app
