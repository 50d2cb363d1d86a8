#include "game/commands/study/saved_start.h"

#include "game/commands/export/restored_scene.h"

namespace plumbline::game {

Result<study::SceneStart> saved_start(const std::filesystem::path& saved_game,
                                      const std::filesystem::path& scene) {
    const Result<std::unique_ptr<RestoredScene>> restored = restored_scene(scene, saved_game);
    if (!restored) return restored.error();
    return study::scene_start_of(*(*restored)->simulation);
}

}  // namespace plumbline::game
