// resolve_auto() of the program plumbline-f64, which studies nothing: studies are the other program's.
#include "engine/study/auto_preset/auto_accuracy.h"
#include "engine/study/auto_preset/auto_fallback.h"

namespace plumbline::study {

scene::Accuracy resolve_auto(const scene::OpenedScene& scene) {
    const scene::SceneDescription& description = scene.description;
    if (!leaves_a_choice(description.accuracy)) return description.accuracy;
    return balanced(description, "studies are the float32 program's");
}

}  // namespace plumbline::study
