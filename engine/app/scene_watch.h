// Tells when a file of the running scene was saved, whichever it is.
#pragma once

#include "engine/platform/file_watch.h"
#include "engine/scene/open_scene.h"

#include <memory>
#include <string>
#include <vector>

namespace plumbline::app {

class SceneWatch {
public:
    explicit SceneWatch(const std::vector<scene::FileStamp>& files) { watch(files); }

    /// From now on these. What is no longer as its stamp says counts as saved.
    void watch(const std::vector<scene::FileStamp>& files);
    /// True once for every save, when it has settled. Never blocks.
    bool saved(double now_s);

private:
    std::unique_ptr<platform::FileWatch> watch_;
    bool saved_before_{false};
};

}  // namespace plumbline::app
