// What a scene takes of the cores and of the clock with several threads.
#pragma once

#include "engine/study/scenes/scene_plan.h"
#include "engine/study/scenes/scene_reference.h"

#include <span>
#include <vector>

namespace plumbline::study {

/// The scene at 60 Hz with each number of threads (scene::kAutoThreads: by the machine), one after the other, so that nothing
/// else of the study is on the cores meanwhile. Interrupted: those measured by then.
Result<std::vector<ThreadsPoint>> measure_threads(ScenePlan& plan,
                                                  const SceneProbe& probe,
                                                  std::span<const int> threads);

}  // namespace plumbline::study
