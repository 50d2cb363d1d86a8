#include "engine/app/scene_watch.h"

#include <utility>

namespace plumbline::app {

void SceneWatch::watch(const std::vector<scene::FileStamp>& files) {
    std::vector<std::filesystem::path> paths;
    paths.reserve(files.size());
    for (const scene::FileStamp& file : files) paths.push_back(file.path);
    watch_ = std::make_unique<platform::FileWatch>(std::move(paths));
    // Between reading a file and watching it somebody may have saved it.
    saved_before_ = !scene::unchanged(files);
}

bool SceneWatch::saved(double now_s) {
    const bool now = !watch_->take_changed(now_s).empty();
    return std::exchange(saved_before_, false) || now;
}

}  // namespace plumbline::app
