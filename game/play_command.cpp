#include "game/play_command.h"

#include "engine/app/frame_loop.h"
#include "engine/core/interrupt.h"
#include "engine/core/log.h"
#include "game/rules.h"

#include <fmt/format.h>

namespace plumbline::game {
namespace {

ExitCode refuse(const Error& error) {
    log_error("{}", error.message);
    return error.exit_code;
}

app::LiveConfig read_config(const CommonOptions& common, const DataFolders& folders) {
    const std::filesystem::path shipped = common.safe ? std::filesystem::path() : folders.config;
    app::LiveConfig config(shipped, user_settings_folder(common));
    for (const Diagnostic& fault : config.faults().list())
        log_line(LogLevel::Warning, to_string(fault));
    return config;
}

}  // namespace

ExitCode run_play(const PlayOptions& options, const CommonOptions& common) {
    const Result<DataFolders> folders = find_data_folders();
    if (!folders) return refuse(folders.error());
    const Result<std::filesystem::path> scene = scene::find_scene(options.scene, folders->assets);
    if (!scene) return refuse(scene.error());
    app::LiveConfig config = read_config(common, *folders);
    app::PlayDef play{.shader_folder = folders->shaders,
                      .user_data_folder = user_data_folder(),
                      .sound = !common.no_sound,
                      .audio_device = options.audio_device,
                      .seconds = options.seconds,
                      .record = options.record,
                      .report = options.report,
                      .expect_hash = options.expect_hash,
                      .steps = {.replay = options.replay, .random_seed = options.random_input}};
    int width = config.current().width;
    int height = config.current().height;
    if (!options.size.empty() && !parse_size(options.size, width, height)) {
        return refuse({.message = fmt::format("--size {}: expected WIDTHxHEIGHT, 1 to 16384 each",
                                              options.size),
                       .exit_code = ExitCode::BadUsage});
    }
    const std::filesystem::path assets = folders->assets;
    Result<std::unique_ptr<app::Session>> session = app::Session::open(
        {.scene = *scene,
         .folders = *folders,
         .served = {.picture = true, .sound = !common.no_sound},
         .make_game = [assets](scene::Simulation& simulation) -> std::unique_ptr<scene::Game> {
             return std::make_unique<PlaygroundGame>(simulation, assets);
         }});
    if (!session) return refuse(session.error());
    (*session)->library.prefetch_images();
    const std::string title = (*session)->description.title;
    Result<std::unique_ptr<platform::Window>> window =
        platform::Window::open({.title = title.empty() ? "Plumbline" : title + " - Plumbline",
                                .width = width,
                                .height = height,
                                .vsync = config.current().vsync});
    if (!window) return refuse(window.error());
    catch_interrupts();
    app::LiveBindings bindings(bindings_def(common, *folders));
    return app::run(**window, **session, bindings, config, play);
}

}  // namespace plumbline::game
