// What one run of a study is made at: the knobs whose price and worth the study measures.
#pragma once

#include "engine/physics/physics_world.h"
#include "engine/scene/accuracy.h"

#include <string>
#include <string_view>

namespace plumbline::study {

enum class Precision { Float32, Float64 };
std::string_view precision_name(Precision precision);  ///< "float32"

/// A point of the grid of settings.
struct Setting {
    physics::Solver solver{physics::Solver::SmallStep};
    int step_hz{60};
    /// Exactly so many; 0 (small_step only): each island what it asks for, up to substeps_max.
    int substeps{0};
    int substeps_max{16};
    int iterations{1};
    Precision precision{Precision::Float32};

    friend bool operator==(const Setting&, const Setting&) = default;
};

/// "small_step 60 Hz x 4, float32"; sub-steps on demand: "x 2-16"; bullet_*: "60 Hz x 1, 10 it".
std::string setting_text(const Setting& setting);
/// The keys to paste under [accuracy], one a line.
std::string accuracy_lines(const Setting& setting);
/// For scenarios that build their own world. Gravity and the rest stay at their defaults.
physics::WorldDef world_def(const Setting& setting);
/// For scenes: over what the file says. The precision is the program's, not the world's.
scene::SimulationOverrides overrides(const Setting& setting);

}  // namespace plumbline::study
