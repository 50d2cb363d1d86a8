#include "game/commands/export/export_command.h"

#include "engine/core/io/files.h"
#include "engine/core/log.h"
#include "engine/scene/gltf_scene/gltf_export.h"
#include "engine/scene/scene_file.h"
#include "game/command_line/refuse.h"
#include "game/commands/export/restored_scene.h"

#include <CLI/CLI.hpp>

namespace plumbline::game {

CLI::App* add_export(CLI::App& app, ExportOptions& options) {
    CLI::App* word =
        app.add_subcommand("export", "Write a scene as a glTF file with physics (.glb)");
    word->add_option("scene", options.scene, "As for play")->required();
    word->add_option("--out", options.out, "Output file, .glb")->required();
    word->add_option("--load", options.load, "Saved game to begin from");
    return word;
}

ExitCode run_export(const ExportOptions& options) {
    if (options.out.extension() != ".glb")
        return refuse({.message = "--out: expected a file that ends in .glb",
                       .exit_code = ExitCode::BadUsage});
    const Result<DataFolders> folders = find_data_folders();
    if (!folders) return refuse(folders.error());
    const Result<std::filesystem::path> file =
        scene::find_scene(options.scene, scene::scene_folders(folders->assets));
    if (!file) return refuse(file.error());
    const Result<std::string> surroundings = scene::surroundings_of(*file, folders->assets);
    if (!surroundings) return refuse(surroundings.error());
    const Result<std::unique_ptr<RestoredScene>> restored = restored_scene(*file, options.load);
    if (!restored) return refuse(restored.error());
    const scene::GltfExport written = scene::gltf_of(*(*restored)->simulation, *surroundings);
    for (const std::string& note : written.notes) log_note("export: {}", note);
    const Result<Done> saved = write_file_atomically(options.out, written.glb);
    return saved ? ExitCode::Good : refuse(saved.error());
}

}  // namespace plumbline::game
