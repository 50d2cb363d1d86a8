// The settings that a study of a scene tries, and what they will probably cost.
#pragma once

#include "engine/study/setting.h"

#include <string>
#include <vector>

namespace plumbline::study {

enum class GridSize {
    Full,   ///< every solver, rates from 30 to 240 Hz, a few in float64
    Quick,  ///< what `preset = "auto"` chooses from: float32, the solvers that win
};

/// The settings at 60 Hz come first: their measured cost predicts the cost of the others.
std::vector<Setting> scene_grid(GridSize size);

/// The same settings with effects at other fidelities: each alone, and all of them together.
std::vector<Setting> with_fidelities(const Setting& setting,
                                     const std::vector<std::string>& effects);

/// The setting of references: small_step in float64 with four sub-steps, and effects at their most precise.
Setting reference_setting(int step_hz, const std::vector<std::string>& effects = {});

/// A rough guess of CPU time, as a multiple of small_step's at 60 Hz with sub-steps on demand. The plan
/// uses it until a similar setting was measured.
double guessed_cost(const Setting& setting);

/// ... of the runs that a study is not worth much without: the grid up to 120 Hz, and a reference.
double guessed_cost_of_study(GridSize size);

/// Whether one differs from the other in its step rate alone.
bool same_but_rate(const Setting& a, const Setting& b);

}  // namespace plumbline::study
