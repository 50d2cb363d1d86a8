#include "game/commands/play_command.h"

#include "engine/app/frame_loop.h"
#include "engine/app/overlay/loading_screen.h"
#include "engine/app/settings/quality_control.h"
#include "engine/core/io/files.h"
#include "engine/core/io/output.h"
#include "engine/core/process/crash_report.h"
#include "engine/core/process/interrupt.h"
#include "engine/core/process/process_memory.h"
#include "engine/effects/saved_game.h"
#include "engine/scene/camera_path.h"
#include "engine/scene/scene_file.h"
#include "game/command_line/hour_option.h"
#include "game/command_line/refuse.h"
#include "game/commands/shader_worker.h"
#include "game/program.h"
#include "game/rules/rules.h"

#include <fmt/format.h>

#include <chrono>
#include <future>
#include <new>
#include <optional>
#include <utility>

namespace plumbline::game {
namespace {

app::LiveConfig read_config(const CommonOptions& common, const DataFolders& folders) {
    const std::filesystem::path shipped = common.safe ? std::filesystem::path() : folders.config;
    app::LiveConfig config(shipped, user_settings_folder(common));
    for (const Diagnostic& fault : config.faults().list())
        log_line(LogLevel::Warning, to_string(fault));
    return config;
}

/// Opens scenes, and remembers the last one between sessions.
class Sessions {
public:
    Sessions(const DataFolders& folders, bool sound) : folders_(folders), sound_(sound) {}

    /// Where memory is refused, what ran before goes on.
    Result<std::unique_ptr<app::Session>> open(const std::string& name,
                                               std::optional<double> hour = {}) const {
        try {
            return open_scene(name, hour);
        } catch (const std::bad_alloc&) {
            return Error{.message = fmt::format("not enough memory for {}", name),
                         .exit_code = ExitCode::OutOfMemory};
        }
    }

    /// The scene of the last session; the first one where there is none, or none any more.
    Result<std::unique_ptr<app::Session>> open_last(std::optional<double> hour) const {
        constexpr std::size_t kLongestPath = 4096;
        const std::filesystem::path file = memory();
        if (!file.empty()) {
            const Result<std::string> last = read_file(file, kLongestPath);
            if (last && std::filesystem::path(*last).is_absolute()) {
                Result<std::unique_ptr<app::Session>> opened = open(*last, hour);
                if (opened) return opened;
            }
        }
        return open(std::string(scene::kFirstScene), hour);
    }

    void remember(const app::Session& session) const {
        const std::filesystem::path file = memory();
        if (file.empty()) return;
        std::error_code ignored;
        const std::filesystem::path scene =
            std::filesystem::absolute(session.description().file, ignored);
        const Result<Done> written = write_file_and_folder(file, scene.string());
        if (!written) log_note("{}", written.error().message);
    }

private:
    Result<std::unique_ptr<app::Session>> open_scene(const std::string& name,
                                                     std::optional<double> hour) const {
        const Result<std::filesystem::path> scene =
            scene::find_scene(name, scene::scene_folders(folders_.assets));
        if (!scene) return scene.error();
        Result<std::unique_ptr<app::Session>> session = app::Session::open(
            {.scene = *scene,
             .folders = folders_,
             .hour = hour,
             .served = {.frame = true, .sound = sound_},
             .make_game = [assets = folders_.assets](
                              scene::Simulation& simulation) -> std::unique_ptr<scene::Game> {
                 return std::make_unique<PlaygroundGame>(simulation, assets);
             }});
        if (session) (*session)->prefetch_images();
        if (session && sound_) (*session)->prefetch_sounds();
        return session;
    }

    static std::filesystem::path memory() {
        const std::filesystem::path folder = user_data_folder();
        return folder.empty() ? folder : folder / "last_scene";
    }

    const DataFolders& folders_;
    bool sound_;
};

std::string title_of(const app::Session& session) {
    const std::string& title = session.description().title;
    return title.empty() ? "Plumbline" : title + " - Plumbline";
}

app::PlayDef play_def(const PlayOptions& options,
                      const CommonOptions& common,
                      const DataFolders& folders) {
    const bool unattended = options.seconds || options.random_input || !options.replay.empty();
    return {.shader_folder = folders.shaders,
            .user_data_folder = user_data_folder(),
            .thumbnails = folders.assets / "thumbnails",
            .start_page = options.scene.empty() && options.load.empty() && !unattended,
            .unattended = unattended,
            .camera_path = options.camera_path,
            .sound = !common.no_sound,
            .audio_device = options.audio_device,
            .seconds = options.seconds,
            .record = options.record,
            .report = options.report,
            .expect_hash = options.expect_hash,
            .steps = {.replay = options.replay, .random_seed = options.random_input}};
}

/// A saved game knows its scene.
Result<std::string> scene_of(const PlayOptions& options) {
    if (!options.scene.empty() || options.load.empty()) return options.scene;
    const Result<effects::SavedGame> saved = effects::read_saved_game(options.load);
    if (!saved) return saved.error();
    return saved->scene.string();
}

/// Until the scene is read.
void show_bar(platform::Window& window,
              std::future<Result<std::unique_ptr<app::Session>>>& reading,
              int width,
              int height) {
    constexpr std::chrono::milliseconds kLook{10};
    app::LoadingScreen screen(window);
    bool is_shown = false;
    while (reading.wait_for(is_shown ? kLook : 0 * kLook) == std::future_status::timeout) {
        if (!is_shown) window.show("Plumbline", width, height);
        is_shown = true;
        screen.show_waiting();
    }
}

/// What an earlier run left that did not end as it should.
void tidy_up() {
    for (const std::filesystem::path& folder :
         {user_config_folder(), user_data_folder(), user_state_folder(), user_cache_folder()})
        if (!folder.empty()) remove_stale_saves_below(folder);
    const std::filesystem::path report = take_crash_report(user_state_folder());
    if (report.empty()) return;
    log_warning("the last run crashed: {}; start with --safe to use built-in settings only",
                report.string());
}

/// Scene after scene, until the person leaves.
ExitCode play_on(platform::Window& window,
                 std::unique_ptr<app::Session> session,
                 const Sessions& sessions,
                 app::LiveBindings& bindings,
                 app::LiveConfig& config,
                 app::PlayDef play) {
    ShadersAhead shaders;
    play.after_first_frame = [&](const app::Session& open, const render::GlInfo& gl) {
        shaders.start(open, play.shader_folder, gl);
    };
    ExitCode code = ExitCode::Good;
    for (;;) {
        sessions.remember(*session);
        bindings.use_usual_profile(session->description().controls);
        app::PlayEnd end = app::run(
            window, {.session = *session, .bindings = bindings, .config = config, .def = play});
        if (code == ExitCode::Good) code = end.code;
        if (!end.next) return code;
        app::continue_with_next(play, end);
        session = std::move(end.next);
        window.set_title(title_of(*session));
    }
}

}  // namespace

ExitCode run_play(const PlayOptions& options, const CommonOptions& common) {
    return_large_blocks_early();
    tidy_up();
    for (const std::filesystem::path& file : {options.record, options.report}) {
        if (const Result<Done> open = check_output(file); !open) return refuse(open.error());
    }
    if (!options.camera_path.empty()) {
        const auto path = scene::CameraPath::read(options.camera_path);
        if (!path) return refuse(path.error());
    }
    const Result<DataFolders> folders = find_data_folders();
    if (!folders) return refuse(folders.error());
    app::LiveConfig config = read_config(common, *folders);
    if (const auto level = app::quality_level_named(options.level)) config.put_level(*level);
    int width = config.current().width;
    int height = config.current().height;
    if (!options.size.empty() && !parse_size(options.size, width, height)) {
        return refuse({.message = fmt::format("--size {}: expected WIDTHxHEIGHT, 1 to 16384 each",
                                              options.size),
                       .exit_code = ExitCode::BadUsage});
    }
    const Result<std::string> scene = scene_of(options);
    if (!scene) return refuse(scene.error());
    const Sessions sessions{*folders, !common.no_sound};
    // The driver takes as long as the scene: each on a thread of its own. What is refused meanwhile
    // needs no window, and none is seen.
    std::future<Result<std::unique_ptr<app::Session>>> reading =
        std::async(std::launch::async | std::launch::deferred, [&] {
            return scene->empty() ? sessions.open_last(options.hour)
                                  : sessions.open(*scene, options.hour);
        });
    Result<std::unique_ptr<platform::Window>> window = platform::Window::open(
        {.width = width, .height = height, .vsync = config.current().vsync, .visible = false});
    if (window) show_bar(**window, reading, width, height);
    Result<std::unique_ptr<app::Session>> session = reading.get();
    if (!session) return refuse(session.error());
    if (!window) return refuse(window.error());
    app::PlayDef play = play_def(options, common, *folders);
    if (!options.load.empty()) {
        const Result<std::uint64_t> loaded = (*session)->load(options.load);
        if (!loaded) return refuse(loaded.error());
        play.steps.first_step = *loaded;
    }
    if (const Result<Done> set = set_hour(options.hour, *(*session)->simulation); !set)
        return refuse(set.error());
    if (const auto& viewer = (*session)->description().viewer; viewer && options.size.empty()) {
        width = viewer->width_px;
        height = viewer->height_px;
    }
    (*window)->show(title_of(**session), width, height);
    const PollsInterrupts polls;
    app::LiveBindings bindings(bindings_def(common, *folders));
    play.open_scene = [&](const std::filesystem::path& file) {
        return sessions.open(file.string());
    };
    return play_on(**window, std::move(*session), sessions, bindings, config, std::move(play));
}

}  // namespace plumbline::game
