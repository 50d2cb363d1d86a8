// What the presets of [accuracy] mean for each kind of solver.
#pragma once

#include "engine/physics/physics_world.h"
#include "engine/scene/scene_description.h"

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace plumbline::scene {

/// What [accuracy] takes at most.
inline constexpr int kMostSubsteps = 64;
inline constexpr int kMostIterations = 1'000;
inline constexpr int kMostThreads = 64;
/// As many threads as the machine has cores, but one, and at most four.
inline constexpr int kAutoThreads = 0;
/// What `asked` means here: as it is, but for kAutoThreads.
int thread_count(int asked);

/// Settings that the command line may put over the scene's own.
struct SimulationOverrides {
    std::optional<physics::Solver> solver{};
    std::optional<int> step_hz{};
    std::optional<int> substeps{};  ///< exactly so many, or the least if there is a most
    std::optional<int> substeps_max{};
    std::optional<int> iterations{};
    std::vector<EffectFidelity> fidelity{};
    std::optional<int> threads{};  ///< kAutoThreads: by the machine
    std::uint64_t seed{1};
};

/// Writes them into what a scene says, as if its file said so itself.
void put_over(const SimulationOverrides& overrides, Accuracy& accuracy);

/// Effects that come in three fidelities: those that bodies feel first, then those of the image.
std::span<const std::string_view> effects_with_fidelity();
/// Of one of them; null: it has none.
Fidelity* fidelity_of(SceneDescription& description, std::string_view effect);
const Fidelity* fidelity_of(const SceneDescription& description, std::string_view effect);

/// A word for a set of numbers. small_step chooses the sub-steps of each island between two bounds;
/// for bullet_* a sub-step is a whole step of Bullet's.
struct Preset {
    std::string_view name;
    int step_hz;
    int small_least;
    int small_most;
    int small_iterations;
    int bullet_substeps;
    int bullet_iterations;
};
std::span<const Preset> presets();
/// "balanced" for names that are none.
const Preset& preset_of(std::string_view name);

/// The world that a scene asks for. Numbers that the scene gives for one kind of solver do not
/// carry over when the command line chooses the other kind: the preset's are used.
physics::WorldDef world_def(const SceneDescription& description,
                            const SimulationOverrides& overrides);

}  // namespace plumbline::scene
