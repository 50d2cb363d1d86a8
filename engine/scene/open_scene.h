// The one way from a file to a running scene: for the window, simulate, workers, tests and
// benchmarks alike. Also what was read on the way, so that caches and watching miss none of it.
#pragma once

#include "engine/core/io/files.h"
#include "engine/core/text/diagnostics.h"
#include "engine/scene/accuracy.h"
#include "engine/scene/simulation.h"

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace plumbline::scene {

enum class FileUse : std::uint8_t {
    Scene,     ///< the scene file itself and what it includes
    Surfaces,  ///< config/surfaces.toml
    Model,
    Image,  ///< a material's map, a face of the sky
    Sound,
};

/// A file that takes part in a scene, as it lay there when the scene was opened.
struct FileStamp {
    std::filesystem::path path;
    FileUse use{FileUse::Scene};
    std::uintmax_t bytes{0};  ///< 0 also where it is not there
    std::filesystem::file_time_type written{};

    friend bool operator==(const FileStamp&, const FileStamp&) = default;
};
FileStamp stamp_of(const std::filesystem::path& path, FileUse use);
/// True while all of them lie there as they did.
bool unchanged(std::span<const FileStamp> files);

/// A scene as read, with everything that a world of it is built from but the loaded assets.
struct OpenedScene {
    /// Overrides applied. preset = "auto" is the numbers of "balanced", unless better ones are put in
    /// before build().
    SceneDescription description{};
    SurfaceTable surfaces{};
    SimulationOverrides overrides{};
    std::vector<std::string> warnings{};  ///< of the files, as messages show them
    std::vector<FileStamp> files{};       ///< each once; the scene's own first

    /// A new world, from its start. The files' warnings are among the simulation's. Refused: what
    /// build_simulation() refuses. Models and materials are added to `library`, which outlives it.
    Result<std::unique_ptr<Simulation>> build(assets::AssetLibrary& library) const;

    /// Of all bytes that decide how it moves: scene, includes, surfaces, models. Reads the files.
    std::uint64_t motion_hash() const;
};

struct OpenOptions {
    DataFolders folders;
    SimulationOverrides overrides{};
};

/// Reads a scene file or a model. Every fault of the files goes to `faults`; the error (exit code 4)
/// is the first of those that refuse the scene.
Result<OpenedScene> open_scene(const std::filesystem::path& file,
                               const OpenOptions& options,
                               Diagnostics& faults);

}  // namespace plumbline::scene
