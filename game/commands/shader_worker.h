// Compiles ahead what the light of a scene may come to need: a process that takes the time which others
// leave draws it small and unseen. Drivers keep what they compiled in a cache on disk, where the window
// finds it.
#pragma once

#include "engine/app/session.h"
#include "engine/core/process/process.h"
#include "engine/render/renderer.h"

#include <filesystem>
#include <optional>

namespace plumbline::game {

/// `shader-worker SCENE DONE`: draws all that the scene shows in every light that play may switch on, at
/// every quality level; then makes the file DONE.
ExitCode run_shader_worker(const std::filesystem::path& scene, const std::filesystem::path& done);

/// The worker of the scene that is played: at most one.
class ShadersAhead {
public:
    /// Ends the one before. None is started where one came to its end with these shaders, this scene and
    /// this driver, and where the file that says so could not be kept.
    void start(const app::Session& session,
               const std::filesystem::path& shader_folder,
               const render::GlInfo& gl);

private:
    std::optional<ChildProcess> worker_;
};

}  // namespace plumbline::game
