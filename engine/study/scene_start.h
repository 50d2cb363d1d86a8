// A state of a scene that runs go on from: where its bodies are and what they carry, and the things that play put into it. Cloth,
// soft bodies and fragments of what broke in play are as the scene's file has them: how finely they are divided is the
// runs' own.
#pragma once

#include "engine/study/played_scene.h"

#include <filesystem>
#include <string>

namespace plumbline::study {

struct SceneStart {
    double time_s{0};
    std::string
        state{};  ///< serialize_bodies_of_scene(), then the things; either precision reads it
};

SceneStart scene_start_of(scene::Simulation& simulation);

/// Before PlayedScene::start(). The accuracy stays the played scene's own. Refused: the state of another
/// scene, or damaged; then the scene is fit only to be thrown away.
Result<Done> take_up(const SceneStart& start, PlayedScene& scene);

/// For processes of the same program.
Result<Done> write_start(const std::filesystem::path& file, SceneStart start);
Result<SceneStart> read_start(const std::filesystem::path& file);

}  // namespace plumbline::study
