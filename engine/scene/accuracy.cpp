#include "engine/scene/accuracy.h"

#include "engine/core/io/archive.h"
#include "engine/core/threads/team.h"

#include <algorithm>
#include <array>

namespace plumbline::scene {
namespace {

// docs/SCENE-FORMAT.md has the same table.
constexpr std::array<Preset, 5> kPresets{{{"draft", 60, 1, 4, 1, 1, 4},
                                          {"balanced", 60, 2, 16, 1, 1, 10},
                                          {"precise", 120, 4, 32, 1, 1, 20},
                                          {"reference", 240, 8, 64, 2, 4, 50},
                                          {"auto", 60, 2, 16, 1, 1, 10}}};
constexpr const Preset& kBalanced = kPresets[1];

/// In the order of effects_with_fidelity().
template <class Description>
auto place_of_fidelity(Description& description, std::string_view effect) {
    auto& fields = description.forces.fidelity;
    auto& screen = description.screen_fidelity;
    const std::array places{&fields.wind,
                            &fields.drag,
                            &fields.buoyancy,
                            &fields.water,
                            &fields.explosion,
                            &fields.fracture,
                            &fields.conveyor,
                            &fields.magnets,
                            &fields.rope,
                            &fields.cloth,
                            &fields.soft,
                            &fields.vehicles,
                            &description.fountain_fidelity,
                            &screen.occlusion,
                            &screen.shafts,
                            &screen.focus,
                            &screen.shutter};
    const auto names = effects_with_fidelity();
    const auto found = std::ranges::find(names, effect);
    return found == names.end() ? nullptr
                                : places.at(static_cast<std::size_t>(found - names.begin()));
}

/// At lower rates as many as keep the preset's shortest sub-step.
int most_substeps(const Preset& preset, int step_hz) {
    const int kept = (preset.small_most * preset.step_hz + step_hz - 1) / step_hz;
    return std::clamp(kept, preset.small_most, kMostSubsteps);
}

/// One core is left to who draws, and to the rest of the machine; more threads than these were never measured.
constexpr int kMostAutoThreads = 4;

}  // namespace

int thread_count(int asked) {
    return asked == kAutoThreads ? std::clamp(usable_cores() - 1, 1, kMostAutoThreads) : asked;
}

std::span<const Preset> presets() {
    return kPresets;
}

const Preset& preset_of(std::string_view name) {
    const auto found = std::ranges::find(kPresets, name, &Preset::name);
    return found != kPresets.end() ? *found : kBalanced;
}

void put_over(const SimulationOverrides& overrides, Accuracy& accuracy) {
    if (overrides.solver) {
        const bool small = *overrides.solver == physics::Solver::SmallStep;
        // The other kind of solver takes none of these numbers.
        if (small != (accuracy.solver == physics::Solver::SmallStep))
            accuracy.substeps = accuracy.substeps_max = accuracy.iterations = {};
        accuracy.solver = *overrides.solver;
        accuracy.solver_given = true;
    }
    if (overrides.step_hz) {
        accuracy.step_hz = *overrides.step_hz;
        accuracy.step_hz_given = true;
    }
    if (overrides.substeps) accuracy.substeps = accuracy.substeps_max = overrides.substeps;
    if (overrides.substeps_max) accuracy.substeps_max = overrides.substeps_max;
    if (overrides.iterations) accuracy.iterations = overrides.iterations;
    if (overrides.threads) accuracy.threads = overrides.threads;
}

void EffectFidelity::serialize(Archive& archive) {
    auto number = static_cast<std::uint8_t>(fidelity);
    archive(effect, number);
    fidelity = static_cast<Fidelity>(number);
    archive.expect(
        fidelity <= Fidelity::Precise &&
            std::ranges::find(effects_with_fidelity(), effect) != effects_with_fidelity().end(),
        "the fidelity of an effect");
}

std::span<const std::string_view> effects_with_fidelity() {
    static constexpr std::array<std::string_view, 17> kNames{"wind",
                                                             "drag",
                                                             "buoyancy",
                                                             "water",
                                                             "explosion",
                                                             "fracture",
                                                             "conveyor",
                                                             "magnets",
                                                             "rope",
                                                             "cloth",
                                                             "soft",
                                                             "vehicles",
                                                             "fountain",
                                                             "ambient_occlusion",
                                                             "sun_shafts",
                                                             "depth_of_field",
                                                             "motion_blur"};
    return kNames;
}

Fidelity* fidelity_of(SceneDescription& description, std::string_view effect) {
    return place_of_fidelity(description, effect);
}

const Fidelity* fidelity_of(const SceneDescription& description, std::string_view effect) {
    return place_of_fidelity(description, effect);
}

physics::WorldDef world_def(const SceneDescription& description,
                            const SimulationOverrides& overrides) {
    const Accuracy& accuracy = description.accuracy;
    const Preset& preset = preset_of(accuracy.preset);
    const physics::Solver solver = overrides.solver.value_or(accuracy.solver);
    const bool small = solver == physics::Solver::SmallStep;
    const bool same_kind = small == (accuracy.solver == physics::Solver::SmallStep);
    const Accuracy own = same_kind ? accuracy : Accuracy{};

    const int step_hz = overrides.step_hz.value_or(accuracy.step_hz);
    physics::WorldDef def{
        .gravity_mps2 = description.gravity_mps2,
        .step_s = 1.0 / static_cast<double>(step_hz),
        .substeps = own.substeps.value_or(small ? preset.small_least : preset.bullet_substeps),
        .iterations =
            own.iterations.value_or(small ? preset.small_iterations : preset.bullet_iterations),
        .solver = solver,
        .joints = accuracy.joints,
        .seed = static_cast<std::uint32_t>(overrides.seed),
        .threads = thread_count(overrides.threads.value_or(accuracy.threads.value_or(1)))};
    if (small) {
        // A number of sub-steps alone means exactly so many.
        def.substeps_max = own.substeps_max.value_or(own.substeps ? *own.substeps
                                                                  : most_substeps(preset, step_hz));
        def.substeps = std::min(def.substeps, def.substeps_max);
    }
    if (overrides.substeps) def.substeps = def.substeps_max = *overrides.substeps;
    if (overrides.substeps_max) def.substeps_max = *overrides.substeps_max;
    if (overrides.iterations) def.iterations = *overrides.iterations;
    return def;
}

}  // namespace plumbline::scene
