// The program `plumbline`: words on the command line to commands.

#include "engine/assets/foreign/decoder.h"
#include "engine/core/process/crash_report.h"
#include "engine/core/process/interrupt.h"
#include "engine/study/study_worker.h"
#include "game/command_line/command_line.h"
#include "game/command_line/option_ranges.h"
#include "game/command_line/parse_error.h"
#include "game/command_line/program_words.h"
#include "game/commands/export/export_command.h"
#include "game/commands/other_commands.h"
#include "game/commands/play_command.h"
#include "game/commands/render_command.h"
#include "game/commands/scenes_command.h"
#include "game/commands/shader_worker.h"
#include "game/commands/simulate_cli.h"
#include "game/commands/stability_command.h"
#include "game/commands/study/study_command.h"
#include "game/program.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace plumbline::game {
namespace {

/// Everything that a command line may fill in.
struct Words {
    CommonOptions common;
    PlayOptions play;
    RenderOptions render;
    TourOptions tour;
    SimulateOptions simulate;
    StabilityOptions stability;
    StudyOptions study;
    ExportOptions exported;
    std::string explained_scene;
    bool explain_as_json{false};
    bool list_as_json{false};
    std::string decoded_kind;
    std::size_t decoded_bytes{0};
    std::string decoded_name;
    std::filesystem::path shader_scene;
    std::filesystem::path shaders_done;
    std::vector<std::filesystem::path> checked;
};

/// A word of the command line, with its options, and what it does.
struct Command {
    const CLI::App* word;
    std::function<ExitCode()> run;
};

CLI::App* add_play(CLI::App& app, PlayOptions& options) {
    CLI::App* play =
        app.add_subcommand("play", "Play a scene in a window (short form: plumbline SCENE)");
    play->add_option(
        "scene",
        options.scene,
        "Scene (.toml, .json), model (.glb .gltf .obj .ply .stl .dae .fbx), or scene name from "
        "assets/scenes");
    play->add_option("--size", options.size, "Window size, WIDTHxHEIGHT");
    play->add_option("--level", options.level, "Image quality: auto, low, medium or high")
        ->check(CLI::IsMember({"auto", "low", "medium", "high"}));
    play->add_option("--hour", options.hour, "Time of day in hours, for scenes with [time]")
        ->check(between(0, 24));
    play->add_option("--seconds", options.seconds, "Exit after this time in seconds")
        ->check(positive_up_to(kLongestRun_s));
    play->add_option("--load",
                     options.load,
                     "Continue from a saved game; without SCENE, in the scene it was saved in");
    play->add_option("--record", options.record, "Record all input to this file");
    play->add_option("--replay", options.replay, "Replay a recorded input file")
        ->excludes("--record");
    play->add_option("--report", options.report, "Write a performance report (JSON)");
    play->add_option("--camera-path", options.camera_path, "Play a recorded camera path");
    play->add_option("--random-input", options.random_input, "Generate random input from this seed")
        ->excludes("--replay");
    play->add_option("--expect-hash",
                     options.expect_hash,
                     "Exit with code 5 unless the final state has this hash");
    play->add_option("--audio-device", options.audio_device, "Sound device name");
    return play;
}

CLI::App* add_viewer(CLI::App& app, PlayOptions& options) {
    CLI::App* viewer = app.add_subcommand(
        "viewer", "Same as play with model viewer controls, for JSON scenes and models");
    viewer->add_option("scene", options.scene, "JSON scene, or as for play")->required();
    viewer->add_option("--size", options.size, "Window size, WIDTHxHEIGHT");
    viewer->add_option("--seconds", options.seconds, "Exit after this time in seconds")
        ->check(positive_up_to(kLongestRun_s));
    return viewer;
}

CLI::App* add_render(CLI::App& app, RenderOptions& options) {
    constexpr double kMostFrames = 1e9;
    constexpr double kMostTurn_deg = 36'000;
    CLI::App* render = app.add_subcommand("render", "Render a scene to an image without a window");
    render->add_option("scene", options.scene, "As for play")->required();
    render->add_option(
        "--out",
        options.out,
        "PNG file, or - for standard output; default without --report: a new file in "
        "~/.local/share/plumbline/shots");
    render->add_option("--size",
                       options.size,
                       "Image size, WIDTHxHEIGHT; default: 1280x720, or the size in a JSON scene");
    render
        ->add_option(
            "--level", options.level, "Image quality: low, medium or high; default: everything on")
        ->check(CLI::IsMember({"low", "medium", "high"}));
    render
        ->add_option("--render-scale",
                     options.render_scale,
                     "With --level: render scale, instead of that of the level")
        ->check(between(0.4, 1.0));
    render->add_option("--at", options.at_s, "Simulated seconds before the image is rendered")
        ->check(between(0.0, kLongestRun_s));
    render->add_option(
        "--camera", options.camera, "Camera as x,y,z,yaw,pitch in metres and degrees");
    render->add_option(
        "--shading", options.shading, "Shading of all materials: pbr, blinn_phong or unlit");
    render
        ->add_option("--frames",
                     options.frames,
                     "Render this many frames, one step each; if --out is a folder, every frame is "
                     "written to it")
        ->check(between(1.0, kMostFrames));
    render
        ->add_option("--camera-path",
                     options.camera_path,
                     "Move the camera along this path, one frame per step")
        ->excludes("--camera");
    render->add_option("--video", options.video, "Video (.mp4) of all frames, written with ffmpeg");
    render->add_option("--orbit", options.orbit_deg, "Degrees the camera orbits over all frames")
        ->check(between(-kMostTurn_deg, kMostTurn_deg))
        ->excludes("--camera-path");
    render->add_option("--sun-turn", options.sun_degps, "Sun rotation in degrees per second")
        ->check(between(-kMostTurn_deg, kMostTurn_deg));
    render->add_option("--hour", options.hour, "Time of day in hours, for scenes with [time]")
        ->check(between(0, 24));
    render->add_option("--report", options.report, "Write a performance report (JSON)");
    render->add_flag("--textures", options.textures, "Enable the textures of a JSON scene");
    render->add_flag("--shadows", options.shadows, "Enable sun shadows in a JSON scene");
    render->add_flag("--flashlight", options.flashlight, "Turn the flashlight on");
    render->add_flag("--fog", options.fog, "Turn fog on");
    return render;
}

CLI::App* add_tour(CLI::App& app, TourOptions& options) {
    CLI::App* tour =
        app.add_subcommand("tour", "Render a tour of a scene into a folder, without a window");
    tour->add_option("scene", options.scene, "As for play");
    tour->add_option("--out", options.out, "Output folder");
    tour->add_option("--size", options.size, "WIDTHxHEIGHT");
    return tour;
}

CLI::App* add_scenes(CLI::App& app, Words& words) {
    CLI::App* scenes = app.add_subcommand("scenes", "List the scenes that play accepts by name");
    scenes->add_flag("--json", words.list_as_json, "Print as JSON");
    return scenes;
}

CLI::App* add_explain(CLI::App& app, Words& words) {
    CLI::App* explain =
        app.add_subcommand("explain", "List the effects a scene uses, why, and their cost");
    explain->add_option("scene", words.explained_scene, "As for play")->required();
    explain->add_flag("--json", words.explain_as_json, "Print as JSON");
    return explain;
}

CLI::App* add_check(CLI::App& app, Words& words) {
    CLI::App* check =
        app.add_subcommand("check", "Check scenes and config files and list every error");
    check->add_option("files", words.checked, "Scenes or config files")->required();
    return check;
}

/// The one table of commands. What has an empty group is not in the help.
std::vector<Command> add_commands(CLI::App& app, Words& words) {
    std::vector<Command> commands;
    const auto add = [&](const CLI::App* word, std::function<ExitCode()> run) {
        commands.push_back({.word = word, .run = std::move(run)});
    };
    add(add_play(app, words.play), [&] { return run_play(words.play, words.common); });
    add(add_viewer(app, words.play), [&] {
        if (words.common.profile.empty()) words.common.profile = "viewer";
        return run_play(words.play, words.common);
    });
    add(add_scenes(app, words), [&] { return run_scenes(words.list_as_json); });
    add(add_render(app, words.render), [&] { return run_render(words.render, words.common); });
    add(add_tour(app, words.tour), [&] { return run_tour(words.tour, words.common); });
    add(add_simulate(app, words.simulate), [&] { return run_simulate(words.simulate); });
    add(add_stability(app, words.stability), [&] { return run_stability(words.stability); });
    add(add_study(app, words.study), [&] {
        words.study.quiet = words.common.quiet;
        return run_study(words.study);
    });
    add(add_export(app, words.exported), [&] { return run_export(words.exported); });
    add(add_explain(app, words),
        [&] { return run_explain(words.explained_scene, words.explain_as_json); });
    add(app.add_subcommand("controls",
                           "List the binding of every action and the file it comes from"),
        [&] { return run_controls(words.common); });
    add(add_check(app, words), [&] { return run_check(words.checked); });
    add(app.add_subcommand("study-worker", "Internal: run jobs for a study")->group(""), [] {
        study::run_study_worker();
        return ExitCode::Good;
    });
    CLI::App* reader = app.add_subcommand("decoder", "Internal: decode a foreign file")->group("");
    reader->add_option("kind", words.decoded_kind)->required();
    reader->add_option("bytes", words.decoded_bytes)->required();
    reader->add_option("name", words.decoded_name)->required();
    add(reader, [&] {
        return assets::run_decoder(words.decoded_kind, words.decoded_bytes, words.decoded_name);
    });
    CLI::App* shaders =
        app.add_subcommand("shader-worker", "Internal: compile shaders in advance")->group("");
    shaders->add_option("scene", words.shader_scene)->required();
    shaders->add_option("done", words.shaders_done)->required();
    add(shaders, [&] { return run_shader_worker(words.shader_scene, words.shaders_done); });
    return commands;
}

/// "plumbline garden.toml --seconds 3" means play: the word is put in where no command stands.
std::vector<std::string> with_command(const CLI::App& app, int argc, char** argv) {
    std::vector<std::string> words(argv + 1, argv + argc);
    const bool has_command = std::ranges::any_of(words, [&](const std::string& word) {
        const auto is_named_so = [&](const CLI::App* command) { return command->check_name(word); };
        return word == "--help" || word == "-h" || word == "--version" ||
               !app.get_subcommands(is_named_so).empty();
    });
    if (!has_command) words.insert(words.begin(), "play");
    std::ranges::reverse(words);  // CLI11 takes them from the back
    return words;
}

int run_commands(int argc, char** argv) {
    CLI::App app("Plumbline: a physics playground with measurable accuracy", "plumbline");
    app.require_subcommand(1);
    app.fallthrough();
    Words words;
    const std::string typed = fmt::format("plumbline {}", fmt::join(argv + 1, argv + argc, " "));
    words.stability.command = typed;
    words.study.command = typed;
    add_common_options(app, words.common);
    const std::vector<Command> commands = add_commands(app, words);
    add_program_words(app);
    try {
        app.parse(with_command(app, argc, argv));
    } catch (const CLI::ParseError& error) {
        return static_cast<int>(answer_parse_error(app, error));
    }
    apply_log_level(words.common);
    const auto chosen = std::ranges::find_if(
        commands, [](const Command& command) { return command.word->parsed(); });
    const bool is_hidden = chosen->word->get_group().empty();
    if (!is_hidden) {
        report_crashes(user_state_folder(), version_text() + "\n" + typed);
        catch_interrupts();
    }
    return static_cast<int>(chosen->run());
}

}  // namespace
}  // namespace plumbline::game

int main(int argc, char** argv) {
    return plumbline::game::run_program(plumbline::game::run_commands, argc, argv);
}
