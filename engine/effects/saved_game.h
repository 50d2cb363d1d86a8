// Saved games: a running scene, its effects and its game as one file, from which they go on bit for
// bit as if they had never stopped.
#pragma once

#include "engine/effects/effect_runtime.h"
#include "engine/scene/game.h"
#include "engine/scene/open_scene.h"
#include "engine/scene/simulation.h"

#include <filesystem>
#include <string>
#include <vector>

namespace plumbline::effects {

/// What is saved, and where it is put back.
struct RunningGame {
    const scene::OpenedScene& opened;  ///< that the simulation was built from
    scene::Simulation& simulation;
    EffectRuntime& effects;
    scene::Game& game;
};

/// What a saved game says of itself.
struct SavedGame {
    std::filesystem::path scene;  ///< the scene's file, as it was when it was saved
    std::string precision;        ///< "float32"
    std::string build;            ///< of the program
    std::string game;             ///< Game::kind()
    double time_s{0};
    std::uint64_t steps{0};  ///< of the session, across resets: where its recording stood
    /// Every file that decides how the scene moves, and the hash of its bytes.
    struct File {
        std::string name;
        std::uint64_t hash{0};

        void serialize(Archive& archive) { archive(name, hash); }
    };
    std::vector<File> files{};
    /// Of effects that did not run at what the scene's file says: the scene is to be built so.
    std::vector<scene::EffectFidelity> fidelity{};
    std::string state{};  ///< the rest, for put_back()
};

/// Written atomically. Nothing of what runs changes. Refused: a scene whose files were changed since
/// they were read, as nobody could go on from there.
Result<Done> save_game(const std::filesystem::path& file,
                       const RunningGame& running,
                       std::uint64_t steps);
/// Refused (exit code 4): what is no saved game, cut, damaged, of another format or precision. The
/// message names the file and what was expected.
Result<SavedGame> read_saved_game(const std::filesystem::path& file);
/// ... of bytes that are there already; `file` is for the message.
Result<SavedGame> saved_game_from(std::string_view bytes, const std::filesystem::path& file);
/// `running` is freshly built. Refused: another scene, other files, another kind of game; then it is fit
/// only to be thrown away, as it is when the error comes later.
Result<Done> put_back(const SavedGame& saved,
                      const std::filesystem::path& file,
                      const RunningGame& running);

inline constexpr int kSaveSlots = 9;
/// Where slot 1 to kSaveSlots of a scene is kept, below the user's data folder: two scenes share none,
/// whatever they are called. `assets`: the folder of the scenes that come with the program.
std::filesystem::path save_slot(const std::filesystem::path& user_data,
                                const std::filesystem::path& assets,
                                const std::filesystem::path& scene,
                                int slot);

}  // namespace plumbline::effects
