// The reference of a scene's runs: float64 at rising step rates until two agree. For a chaotic scene it
// is the statistics of many copies that start a millionth of a metre apart.
#pragma once

#include "engine/study/scenes/scene_errors.h"
#include "engine/study/scenes/scene_plan.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace plumbline::study {

/// How far apart copies start, m and m/s: enough where a scene is chaotic.
inline constexpr double kShift_m = 1e-6;
/// Where halving the step changes much and so small a shift does not: of a body's size.
inline constexpr double kWideShift = 1e-3;

struct SceneReference {
    bool chaotic{false};
    /// Chaotic: the copies. Else one trace, the finest.
    SceneAnswer answer{};
    Scales scales{};
    double shift_m{0};  ///< of the copies
    /// How well it is known, in the worst metric: the difference between the two finest, or, of
    /// copies, the standard error of their medians. Errors below it are not told apart.
    double uncertainty{0};
    std::string text{};  ///< the method in one sentence
    std::vector<std::string> notes{};
};

/// What is known of a scene before its reference is made.
struct SceneProbe {
    std::filesystem::path scene{};
    std::filesystem::path start{};  ///< SceneRun::start
    std::vector<int> moments{};
    std::vector<std::string> effects{};  ///< SceneAnswer::effects
    double second_cpu_s{0};              ///< small_step at 60 Hz: CPU seconds per simulated one
};

/// Handed the reference as the first two rates give it, where runs can be compared with it one by one: something to
/// measure against while nothing better is there.
using UseRoughReference = std::function<Result<Done>(const SceneReference&)>;

/// Spends up to `share` of the plan's wall time, what `use_rough` takes not counted. None: interrupted. Refused: every try
/// ended early; the message says how.
Result<std::optional<SceneReference>> make_reference(ScenePlan& plan,
                                                     const SceneProbe& probe,
                                                     double share,
                                                     const UseRoughReference& use_rough);

/// Errors of an answer's runs against the reference, in the order of metrics_of().
std::vector<double> errors_against(const SceneReference& reference, const SceneAnswer& answer);
std::vector<Metric> metrics_of(const SceneReference& reference);

}  // namespace plumbline::study
