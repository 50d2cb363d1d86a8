// The setting of one run of a study: solver, step rate, sub-steps, iterations, precision.
#pragma once

#include "engine/physics/physics_world.h"
#include "engine/scene/accuracy.h"
#include "engine/study/words.h"

#include <string>
#include <vector>

namespace plumbline::study {

enum class Precision { Float32, Float64 };
inline constexpr std::array kPrecisions{Precision::Float32, Precision::Float64};
template <>
inline constexpr std::array<std::string_view, 2> kWords<Precision>{"float32", "float64"};

template <>
inline constexpr std::array<std::string_view, 3> kWords<scene::Fidelity>{
    "draft", "balanced", "precise"};

/// A point of the grid of settings.
struct Setting {
    physics::Solver solver{physics::Solver::SmallStep};
    int step_hz{60};
    /// Exactly so many; 0 (small_step only): each island what it asks for, up to substeps_max.
    int substeps{0};
    int substeps_max{16};
    int iterations{1};
    Precision precision{Precision::Float32};
    /// Of effects that do not run at the scene's own.
    std::vector<scene::EffectFidelity> fidelity{};

    friend bool operator==(const Setting&, const Setting&) = default;
};

/// "small_step 60 Hz x 4, float32, cloth draft"; sub-steps on demand: "x 2-16"; bullet_*: "60 Hz x 1, 10 it".
std::string setting_text(const Setting& setting);
/// "cloth draft, buoyancy precise": of its effects.
std::string fidelity_text(const Setting& setting);
/// The keys to paste under [accuracy], one a line.
std::string accuracy_lines(const Setting& setting);
/// The setting as a WorldDef, for scenarios, which build their own world. Gravity and everything else
/// keep their defaults.
physics::WorldDef world_def(const Setting& setting);
/// The setting as overrides of a scene file. They do not hold the precision, which is the program's.
scene::SimulationOverrides overrides(const Setting& setting);

}  // namespace plumbline::study
