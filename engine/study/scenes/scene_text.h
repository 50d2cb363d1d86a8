// A study of a scene as people read it in a terminal.
#pragma once

#include "engine/study/findings/pareto.h"
#include "engine/study/scenes/scene_study.h"

#include <string>

namespace plumbline::study {

/// The table of all settings, the cost to reach an error, the error at a budget, the settings that no
/// other beats, and the lines to paste.
std::string scene_study_text(const SceneStudy& study);

inline constexpr double kUsualTolerance = 0.01;

/// What was asked for. At most one has a value; without both, the usual tolerance counts.
struct Wish {
    std::optional<double> tolerance{};
    std::optional<double> budget_ms{};  ///< CPU ms for 1/60 s
};
/// The setting to use. A tolerance is tightened by what the errors are uncertain by, to half of it at
/// most; of a budget a tenth is kept for what costs vary by. Where nothing is within that, what is
/// within the wish itself. Only settings in the program's own precision. None: no setting has an error.
std::optional<Choice> choose(const SceneStudy& study, const Wish& wish);

/// Lines to paste under [accuracy]. Comments above them say what error they reach, or that no setting
/// reaches what was asked for.
std::string wish_text(const SceneStudy& study, const Wish& wish);

/// "small_step 60 Hz x 4, float32: 0.8 % off, 0.12 ms a frame".
std::string point_text(const Point& point);

}  // namespace plumbline::study
