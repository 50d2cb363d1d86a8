#include "engine/effects/saved_game.h"

#include "engine/core/hash.h"
#include "engine/core/io/archive.h"
#include "engine/core/io/saved_file.h"
#include "engine/core/limits.h"
#include "engine/core/text/printable.h"
#include "engine/scene/simulation/simulation_archive.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumbline::effects {
namespace fs = std::filesystem;
namespace {

constexpr const char* kBuild = PL_VERSION;

/// Images and sounds play no part in how a scene moves.
bool decides(const scene::FileStamp& file) {
    return file.use == scene::FileUse::Scene || file.use == scene::FileUse::Surfaces ||
           file.use == scene::FileUse::Model;
}

std::uint64_t hash_of(const fs::path& file) {
    const Result<std::string> bytes = read_file(file, limits::kModelFileBytes);
    Hasher hasher;
    if (bytes) hasher.add(bytes->data(), bytes->size());
    return hasher.digest();
}

std::vector<SavedGame::File> files_of(const scene::OpenedScene& opened) {
    std::vector<SavedGame::File> files;
    for (const scene::FileStamp& file : opened.files) {
        if (decides(file))
            files.push_back({.name = file.path.filename().string(), .hash = hash_of(file.path)});
    }
    return files;
}

void serialize_head(Archive& archive, SavedGame& saved) {
    std::string scene = saved.scene.generic_string();
    archive(saved.precision,
            saved.build,
            scene,
            saved.game,
            saved.time_s,
            saved.steps,
            saved.files,
            saved.fidelity);
    if (archive.reads()) saved.scene = scene;
}

void serialize_state(Archive& archive, const RunningGame& running) {
    running.game.serialize(archive, running.simulation);
    serialize_state(running.simulation, archive);
    if (archive.failed()) return;
    if (archive.reads()) running.effects.refresh(running.simulation);
    running.effects.serialize(archive);
    archive.expect(!archive.reads() || archive.left() == 0, "its state goes on after its end");
}

/// Why the files of a saved game are not those of the scene here; empty: they are.
std::string fault_of_files(const SavedGame& saved, const scene::OpenedScene& opened) {
    const std::vector<SavedGame::File> here = files_of(opened);
    const std::string scene = opened.description.file.filename().string();
    if (saved.scene.filename() != opened.description.file.filename())
        return fmt::format("a saved game of {}, not of {}", saved.scene.filename().string(), scene);
    for (const SavedGame::File& file : saved.files) {
        const auto same_name = [&](const SavedGame::File& other) {
            return other.name == file.name;
        };
        const auto found = std::ranges::find_if(here, same_name);
        if (found == here.end())
            return fmt::format(
                "a saved game of {} with {}, which it no longer uses", scene, file.name);
        // Several may be called the same.
        const auto same = [&](const SavedGame::File& other) {
            return same_name(other) && other.hash == file.hash;
        };
        if (std::ranges::none_of(here, same))
            return fmt::format("a saved game of {} when {} had the hash {}; now it has {}",
                               scene,
                               file.name,
                               hex_of(file.hash),
                               hex_of(found->hash));
    }
    if (here.size() == saved.files.size()) return {};
    return fmt::format(
        "a saved game of {} with {} files; now it has {}", scene, saved.files.size(), here.size());
}

/// Below the folder of saves; none for what comes with the program, unless it is called as a scene above
/// it. `scene`: canonical.
fs::path folder_of_slots(const fs::path& assets, const fs::path& scene) {
    std::error_code ignored;
    const fs::path shipped = fs::weakly_canonical(assets / "scenes", ignored);
    const fs::path inside = scene.lexically_relative(shipped);
    if (inside.empty() || *inside.begin() == "..") {
        const std::string folder = scene.parent_path().generic_string();
        Hasher hasher;
        hasher.add(folder.data(), folder.size());
        return hex_of(hasher.digest());
    }
    const bool has_twin =
        inside.has_parent_path() && fs::exists(shipped / inside.filename(), ignored);
    return has_twin ? inside.parent_path() : fs::path();
}

Error refusal(const fs::path& file, const std::string& why) {
    return {fmt::format("{}: {}", file.generic_string(), why), ExitCode::Refused};
}

}  // namespace

Result<Done> save_game(const fs::path& file, const RunningGame& running, std::uint64_t steps) {
    std::vector<scene::FileStamp> files = running.opened.files;
    std::erase_if(files, [](const scene::FileStamp& stamp) { return !decides(stamp); });
    if (!scene::unchanged(files))
        return Error{fmt::format("{}: not saved: a file of the scene was changed since it was read",
                                 file.generic_string())};
    SavedGame saved{.scene = running.opened.description.file,
                    .precision = kPrecisionName,
                    .build = kBuild,
                    .game = std::string(running.game.kind()),
                    .time_s = running.simulation.time_s(),
                    .steps = steps,
                    .files = files_of(running.opened),
                    .fidelity = running.simulation.description().accuracy.fidelity};
    Archive archive;
    serialize_head(archive, saved);
    serialize_state(archive, running);
    if (archive.failed()) return Error{archive.fault()};
    return write_file_and_folder(file, shelled(archive.written()));
}

Result<SavedGame> read_saved_game(const fs::path& file) {
    const Result<std::string> bytes = read_file(file, kSavedFileBytes);
    if (!bytes) return Error{bytes.error().message, ExitCode::Refused};
    return saved_game_from(*bytes, file);
}

Result<SavedGame> saved_game_from(std::string_view bytes, const fs::path& file) {
    const Result<std::string_view> content = unshelled(bytes, file);
    if (!content) return content.error();
    SavedGame saved;
    Archive archive(*content);
    serialize_head(archive, saved);
    if (archive.failed()) return refusal(file, "a damaged saved game: " + archive.fault());
    if (saved.precision != kPrecisionName)
        return refusal(file,
                       fmt::format("a saved game of {}; this program computes in {}",
                                   saved.precision,
                                   kPrecisionName));
    if (saved.build != kBuild)
        return refusal(file,
                       fmt::format("saved by version {} of the program; this is version {}",
                                   printable(saved.build),
                                   kBuild));
    saved.state = content->substr(content->size() - archive.left());
    return saved;
}

Result<Done> put_back(const SavedGame& saved, const fs::path& file, const RunningGame& running) {
    if (saved.game != running.game.kind())
        return refusal(file,
                       fmt::format("saved by {}, which alone goes on from it; this is {}",
                                   saved.game,
                                   running.game.kind()));
    if (const std::string fault = fault_of_files(saved, running.opened); !fault.empty())
        return refusal(file, fault);
    Archive archive(saved.state);
    serialize_state(archive, running);
    if (!archive.failed()) return Done{};
    return refusal(file, "a saved game that this build cannot go on from: " + archive.fault());
}

fs::path save_slot(const fs::path& user_data,
                   const fs::path& assets,
                   const fs::path& scene,
                   int slot) {
    std::error_code ignored;
    const fs::path file = fs::weakly_canonical(scene, ignored);
    const bool is_toml = file.extension() == ".toml";
    const std::string name = (is_toml ? file.stem() : file.filename()).string();
    return user_data / "saves" / folder_of_slots(assets, file) /
           fmt::format("{}-{}.save", name, slot);
}

}  // namespace plumbline::effects
