#include "game/offscreen/offscreen_studio.h"

#include "engine/core/io/files.h"

#include <utility>

namespace plumbline::game {

std::unique_ptr<scene::Game> no_game(scene::Simulation& simulation) {
    return std::make_unique<scene::NoGame>(simulation.description().camera);
}

Result<OffscreenStudio> OffscreenStudio::open(const std::filesystem::path& scene) {
    Result<OffscreenStudio> studio = open_undrawn(scene);
    if (!studio) return studio;
    if (const Result<Done> drawn = studio->run->draw(); !drawn) return drawn.error();
    return studio;
}

Result<OffscreenStudio> OffscreenStudio::open_undrawn(const std::filesystem::path& scene,
                                                      app::OffscreenDef def) {
    const Result<DataFolders> folders = find_data_folders();
    if (!folders) return folders.error();
    Result<std::unique_ptr<app::Session>> session = app::Session::open(
        {.scene = scene, .folders = *folders, .served = {.frame = true}, .make_game = no_game});
    if (!session) return session.error();
    OffscreenStudio studio{.session = std::move(*session), .run = nullptr};
    studio.session->prefetch_images();
    if (def.width_px == 0) {
        const auto& viewer = studio.session->description().viewer;
        def.width_px = static_cast<std::uint32_t>(viewer ? viewer->width_px : 1280);
        def.height_px = static_cast<std::uint32_t>(viewer ? viewer->height_px : 720);
    }
    studio.width_px = def.width_px;
    studio.height_px = def.height_px;
    def.shader_folder = folders->shaders;
    Result<std::unique_ptr<app::OffscreenRun>> run =
        app::OffscreenRun::create(*studio.session, def);
    if (!run) return run.error();
    studio.run = std::move(*run);
    return studio;
}

}  // namespace plumbline::game
