#include "game/offscreen/offscreen_studio.h"

#include "engine/core/io/files.h"

#include <utility>

namespace plumbline::game {

Result<OffscreenStudio> OffscreenStudio::open(const std::filesystem::path& scene) {
    Result<OffscreenStudio> studio = open_undrawn(scene);
    if (!studio) return studio;
    if (const Result<Done> drawn = studio->run->draw(); !drawn) return drawn.error();
    return studio;
}

Result<OffscreenStudio> OffscreenStudio::open_undrawn(const std::filesystem::path& scene) {
    const Result<DataFolders> folders = find_data_folders();
    if (!folders) return folders.error();
    OffscreenStudio studio;
    Result<std::unique_ptr<app::Session>> session = app::Session::open(
        {.scene = scene,
         .folders = *folders,
         .served = {.frame = true},
         .make_game = [](scene::Simulation& simulation) -> std::unique_ptr<scene::Game> {
             return std::make_unique<scene::NoGame>(simulation.description().camera);
         }});
    if (!session) return session.error();
    studio.session = std::move(*session);
    studio.session->prefetch_images();
    Result<std::unique_ptr<app::OffscreenRun>> run =
        app::OffscreenRun::create(*studio.session,
                                  {.shader_folder = folders->shaders,
                                   .width_px = kStudioWidth_px,
                                   .height_px = kStudioHeight_px});
    if (!run) return run.error();
    studio.run = std::move(*run);
    return studio;
}

}  // namespace plumbline::game
