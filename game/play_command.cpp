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

app::AppConfig read_config(const CommonOptions& common, const DataFolders& folders) {
    Diagnostics faults;
    const std::filesystem::path shipped = common.safe ? std::filesystem::path() : folders.config;
    app::AppConfig config = app::load_app_config(shipped, user_settings_folder(common), faults);
    for (const Diagnostic& fault : faults.list()) log_line(LogLevel::Warning, to_string(fault));
    return config;
}

}  // namespace

ExitCode run_play(const PlayOptions& options, const CommonOptions& common) {
    const Result<DataFolders> folders = find_data_folders();
    if (!folders) return refuse(folders.error());
    const Result<std::filesystem::path> scene = scene::find_scene(options.scene, folders->assets);
    if (!scene) return refuse(scene.error());
    app::PlayDef play{.config = read_config(common, *folders),
                      .shader_folder = folders->shaders,
                      .user_data_folder = user_data_folder(),
                      .sound = !common.no_sound,
                      .audio_device = options.audio_device,
                      .seconds = options.seconds,
                      .record = options.record,
                      .report = options.report,
                      .expect_hash = options.expect_hash,
                      .steps = {.replay = options.replay, .random_seed = options.random_input}};
    if (!options.size.empty() && !parse_size(options.size, play.config.width, play.config.height)) {
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
                                .width = play.config.width,
                                .height = play.config.height,
                                .vsync = play.config.vsync});
    if (!window) return refuse(window.error());
    catch_interrupts();
    app::LiveBindings bindings(bindings_def(common, *folders));
    return app::run(**window, **session, bindings, play);
}

}  // namespace plumbline::game
