#include "game/commands/other_commands.h"

#include "engine/core/limits.h"
#include "engine/core/log.h"
#include "engine/core/process/interrupt.h"
#include "engine/core/text/printable.h"
#include "engine/scene/scene_file.h"
#include "game/command_line/camera_text.h"
#include "game/command_line/refuse.h"
#include "game/offscreen/offscreen_studio.h"

#include <fmt/format.h>

#include <iostream>

namespace plumbline::game {
namespace {

constexpr double kExplained_s = 1.0;

bool is_binding_file(const std::filesystem::path& file) {
    return file.filename().string().starts_with("bindings") ||
           file.parent_path().filename() == "controls";
}

/// Faults of one file, printed; the exit code that it alone would give.
ExitCode check_file(const std::filesystem::path& file, const DataFolders& folders) {
    Diagnostics faults;
    ExitCode when_bad = ExitCode::BadUsage;
    const bool is_settings = file.filename() == "app.toml" || file.filename() == "app.ui.toml";
    if (is_settings) {
        app::load_app_config({file}, faults);
    } else if (file.filename() == "surfaces.toml") {
        scene::load_surfaces(file, folders.assets, faults);
    } else if (is_binding_file(file)) {
        const Result<std::string> text = read_file(file, limits::kConfigFileBytes);
        if (!text)
            return refuse({.message = text.error().message, .exit_code = ExitCode::BadUsage});
        input::load_bindings({{.name = file.string(), .text = *text}}, {}, faults);
    } else {
        when_bad = ExitCode::Refused;
        const Result<scene::SceneDescription> scene =
            scene::read_description(file, folders.assets, faults);
        // What is wrong with the file as a whole is in the error alone.
        if (!scene && faults.list().empty())
            std::cout << printable_lines(scene.error().message) << '\n';
        if (!scene && !faults.has_errors()) return when_bad;
        if (scene) scene::check_models(*scene, faults);
    }
    for (Diagnostic fault : faults.list()) {
        if (is_settings) fault.file = file.string();  // without its folder in a log of the program
        std::cout << to_string(fault) << '\n';
    }
    const bool config_fault = when_bad == ExitCode::BadUsage && !faults.list().empty();
    return faults.has_errors() || config_fault ? when_bad : ExitCode::Good;
}

}  // namespace

ExitCode run_explain(const std::string& scene_name, bool as_json) {
    const Result<DataFolders> folders = find_data_folders();
    if (!folders) return refuse(folders.error());
    const Result<std::filesystem::path> scene =
        scene::find_scene(scene_name, scene::scene_folders(folders->assets));
    if (!scene) return refuse(scene.error());
    Result<std::unique_ptr<app::Session>> session =
        app::Session::open({.scene = *scene,
                            .folders = *folders,
                            .served = {.frame = true, .sound = true},
                            .make_game = no_game});
    if (!session) return refuse(session.error());
    scene::Simulation& simulation = *(*session)->simulation;
    const auto steps = static_cast<std::uint64_t>(kExplained_s / simulation.step_s());
    const scene::ViewPoint view = first_view(simulation.description());

    Result<std::unique_ptr<app::OffscreenRun>> run = app::OffscreenRun::create(
        **session, {.shader_folder = folders->shaders, .width_px = 640, .height_px = 360});
    if (run) {
        (*run)->simulate(steps);
        if (const Result<Done> drawn = (*run)->draw(view); !drawn) return refuse(drawn.error());
    } else {
        log_note("no image: {}", run.error().message);
        for (std::uint64_t i = 0; i < steps; ++i) {
            effects::advance(simulation, *(*session)->effects, *(*session)->game, {});
        }
    }
    (*session)->effects->sound(simulation, view);
    const std::vector<effects::LedgerLine> ledger = (*session)->effects->ledger();
    std::cout << (as_json ? effects::ledger_json(ledger) + "\n" : effects::ledger_table(ledger));
    return ExitCode::Good;
}

ExitCode run_controls(const CommonOptions& common) {
    const Result<DataFolders> folders = find_data_folders();
    if (!folders) return refuse(folders.error());
    const app::LiveBindings bindings(bindings_def(common, *folders));
    for (const Diagnostic& fault : bindings.faults().list()) std::cerr << to_string(fault) << '\n';
    std::cout << printable_lines(input::print_bindings(bindings.current()));
    return bindings.faults().has_errors() ? ExitCode::BadUsage : ExitCode::Good;
}

ExitCode run_check(const std::vector<std::filesystem::path>& files) {
    const Result<DataFolders> folders = find_data_folders();
    if (!folders) return refuse(folders.error());
    ExitCode worst = ExitCode::Good;
    for (const std::filesystem::path& file : files) {
        if (interrupted()) return ExitCode::Interrupted;
        const ExitCode code = check_file(file, *folders);
        if (code == ExitCode::Good) std::cout << printable(file.string()) << ": good\n";
        if (static_cast<int>(code) > static_cast<int>(worst)) worst = code;
    }
    return worst;
}

}  // namespace plumbline::game
