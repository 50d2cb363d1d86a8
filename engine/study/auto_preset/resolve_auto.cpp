#include "engine/core/log.h"
#include "engine/study/auto_preset/auto_accuracy.h"

namespace plumbline::study {
namespace {

/// Whether the preset is "auto" and the rest of [accuracy] leaves it anything to choose.
bool leaves_a_choice(const scene::Accuracy& asked) {
    const bool all_given =
        asked.solver_given && asked.step_hz_given && asked.substeps && asked.iterations;
    return asked.preset == "auto" && !all_given;
}

}  // namespace

scene::Accuracy resolve_auto(const scene::OpenedScene& scene) {
    const scene::SceneDescription& description = scene.description;
    if (!leaves_a_choice(description.accuracy)) return description.accuracy;
    const Result<scene::Accuracy> found = studied_accuracy(scene);
    if (found) return *found;
    log_warning("{}: preset \"auto\" falls back to \"balanced\": {}",
                description.file.filename().string(),
                found.error().message);
    scene::Accuracy accuracy = description.accuracy;
    accuracy.preset = "balanced";
    return accuracy;
}

}  // namespace plumbline::study
